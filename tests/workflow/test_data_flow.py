"""Data flows one way, and nothing heavy is imported where it is not used."""

import ast

import pytest
from workspace import ROOT

LIBRARY = ROOT / "src" / "thirdbody"
# each layer imports from itself and from those above it
LAYERS = (
    {
        "__init__",
        "files",
        "custody",
        "closure",
        "parameters",
        "roots",
        "tabulation",
        "regimes",
        "places",
    },
    {"bracketing", "bytecode", "compiled_loop"},
    {"configuration"},
    {"scene"},
    {"asperity", "particles", "film"},
    {"balance"},
    {"solution"},
    {"compiled_tables"},
    {"compiled"},
    {"interface"},
    {"dataset"},
    {"turning_point", "transitions", "streaming"},
    {"extraction"},
    {"tables", "paper_tables", "band"},
    {"accuracy"},
    {"claims"},
    {"checks"},
    {"evidence"},
    {"calibration"},
    {"posterior", "verdicts", "sensitivity", "sobol", "conflict"},
    {"verdict_text"},
    {"figures"},
    {"release"},
)
MODULES = sorted(str(path.relative_to(LIBRARY)) for path in LIBRARY.rglob("*.py"))
HEAVY = {"scipy", "xarray", "netCDF4", "pandas", "matplotlib"}


def word(module):
    """The word under which ``LAYERS`` knows a file or a dotted name."""
    return module.removesuffix(".py").replace("/", ".").partition(".")[0]


def imports(module):
    """Every name that the import statements of a library module name."""
    for node in ast.walk(ast.parse((LIBRARY / module).read_bytes())):
        if isinstance(node, ast.ImportFrom):
            yield node.module or ""
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)


def layer(module):
    places = [index for index, names in enumerate(LAYERS) if word(module) in names]
    assert places, f"{module} has no place among the layers"
    return places[0]


@pytest.mark.parametrize("module", MODULES)
def test_a_module_imports_nothing_from_its_right(module):
    words = {word(module)}.union(*LAYERS)
    inside = {name.removeprefix("thirdbody.") for name in imports(module) if "thirdbody." in name}
    right = {name for name in inside if word(name) in words and layer(name) > layer(module)}
    assert not right


@pytest.mark.parametrize("module", [name for name in MODULES if word(name) != "figures"])
def test_only_figures_import_matplotlib(module):
    assert "matplotlib" not in {name.partition(".")[0] for name in imports(module)}


@pytest.mark.parametrize("module", MODULES)
def test_the_library_knows_nothing_of_snakemake(module):
    assert "snakemake" not in {name.partition(".")[0] for name in imports(module)}


def test_importing_the_package_loads_nothing_heavy_and_writes_nothing(finished):
    files = {path: path.stat().st_mtime_ns for path in finished.root.rglob("*")}
    told = finished.python(
        "import sys; sys.dont_write_bytecode = True; before = set(sys.modules)\n"
        "import thirdbody; print(*sorted(set(sys.modules) - before))"
    )
    assert told.stdout.split() == ["thirdbody"]
    assert files == {path: path.stat().st_mtime_ns for path in finished.root.rglob("*")}


def test_reading_the_workflow_loads_nothing_heavy(sources, tmp_path):
    """Snakemake's own YAML reader takes numpy where there is one: it gets none here."""
    told = sources.copied_to(tmp_path / "thirdbody").python(
        "import sys; sys.modules['numpy'] = None\n"
        "from snakemake.cli import main\n"
        "try:\n    main(['--dry-run', '--quiet'])\n"
        "except SystemExit as end:\n    print(end.code, *sorted(sys.modules))"
    )
    code, *modules = told.stdout.splitlines()[-1].split()
    assert code == "0", told.stdout + told.stderr
    assert HEAVY.isdisjoint(modules)
