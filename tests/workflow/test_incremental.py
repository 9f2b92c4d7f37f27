"""A change is followed by what depends on it, and by nothing else."""

import pytest
from workspace import ROOT

from thirdbody.configuration.plain_yaml import read_yaml

DEFAULT = read_yaml(ROOT / "config/config.yaml")["calibrated"]
FIGURE = (
    "datasets/{0}.nc",
    "bands/{0}.nc",
    "accuracy/solver_cost/{0}.csv",
    "extracted/*/{0}.csv",
    "figures/{0}.*",
)
ALL_CURVES = (
    "datasets/*",
    "bands/*",
    "accuracy/solver_cost/*",
    "extracted/tpca_loads/*",
    "extracted/transitions/*",
    "figures/fig0[3-9].*",
    "figures/fig1?.*",
)
GATHERED = ("accuracy/solver_cost.csv", "tables/tpca_loads.*", "tables/transitions.*")
WINDOWS = ("extracted/tpca_windows/*", "tables/tpca_windows.*")
SHOWING_WINDOWS = ("figures/fig09.*", "figures/fig10.*")
PRINTED = (  # what stands beside the paper's numbers
    "extracted/printed/*",
    "figures/fig0[3-9].*",
    "figures/fig1?.*",
    "tables/tpca_*",
    "tables/transitions.*",
)
PAPER_TABLES = ("extracted/table[12]/*", "tables/table[12].*")
SCHEMATICS = ("schematics/*", "figures/fig0[12].*")
SENSITIVITY = ("extracted/sensitivity/*", "tables/sensitivity.*", "figures/sensitivity.*")
CLAIMS = ("claims/*", "figures/claims.*")
PAGE = ("explorer/*",)


def of_figure(name):
    return tuple(pattern.format(name) for pattern in FIGURE)


def remade(workspace, *arguments):
    """Products that a real run writes again."""
    before = workspace.stamps()
    run = workspace.snakemake(*arguments)
    assert run.returncode == 0, run.stdout + run.stderr
    return {name for name, stamp in workspace.stamps().items() if before.get(name) != stamp}


def followers(recorded, changed):
    """What depends on the file ``changed`` by the inputs that the run recorded."""
    inputs = {
        f"results/{row['output_file']}": set(row["input-file(s)"].split(",")) for row in recorded
    }
    known = {changed}
    while more := {output for output, needed in inputs.items() if needed & known} - known:
        known |= more
    return {name.removeprefix("results/") for name in known - {changed}}


def test_another_scene_remakes_its_figure_and_the_tables_that_gather_it(workspace):
    workspace.put("config/scenes.yaml", "scenes/fig08/curves/0/viscosity_cSt", [0, 80])
    assert remade(workspace) == workspace.products(*of_figure("fig08"), *GATHERED, *PAGE)
    assert not workspace.pending()


def test_another_style_draws_again_and_solves_nothing(workspace):
    workspace.rewrite(
        "src/thirdbody/figures/paper.mplstyle", lambda text: text + "\nlines.linewidth: 0.7\n"
    )
    assert workspace.pending() == workspace.products("figures/*", *PAGE)
    drawn = remade(workspace, "results/figures/fig03.png")
    assert drawn == workspace.products("figures/fig03.*")


def test_another_formula_of_the_paper_tables_remakes_these_tables(workspace):
    module = "src/thirdbody/data/paper_tables.py"
    told = "import sys\nprint('these tables are from', __file__, file=sys.__stderr__)\n"
    workspace.rewrite(module, lambda text: f"{text}\n{told}")
    before = workspace.stamps()
    run = workspace.snakemake()
    changed = {name for name, stamp in workspace.stamps().items() if before[name] != stamp}
    assert changed == workspace.products(*PAPER_TABLES)
    assert f"these tables are from {workspace.root / module}" in run.stdout + run.stderr


@pytest.mark.parametrize("module", ["model/film", "data/tables", "figures/sheet/saving"])
def test_another_library_module_reruns_what_imports_it(workspace, recorded, module):
    path = f"src/thirdbody/{module}.py"
    expected = followers(recorded, path)
    assert expected
    workspace.rewrite(path, lambda text: f"{text}\n# changed\n")
    assert workspace.pending() == expected


def test_the_figures_solve_nothing_and_the_film_enters_no_paper_table(finished, recorded):
    drawn = followers(recorded, "src/thirdbody/figures/sheet/saving.py")
    assert drawn == finished.products("figures/*", *PAGE)
    film = followers(recorded, "src/thirdbody/model/film.py")
    assert film >= finished.products(*ALL_CURVES, *WINDOWS)
    assert film.isdisjoint(finished.products(*PAPER_TABLES))


def test_touching_a_module_without_changing_it_reruns_nothing(workspace):
    (workspace.root / "src/thirdbody/model/film.py").touch()
    assert not workspace.pending()


def test_missing_products_are_made_again_and_no_others(workspace):
    for name in ("tables/table2.tex", "figures/fig07.svg", "accuracy/solver_cost.csv"):
        (workspace.root / "results" / name).unlink()
    made = remade(workspace)
    assert made == workspace.products("tables/table2.*", "figures/fig07.*", GATHERED[0], *PAGE)


def test_a_missing_dataset_is_solved_again_and_what_is_made_from_it_follows(workspace):
    expected = workspace.products(*of_figure("fig05"), *GATHERED, *PAGE)
    (workspace.root / "results/datasets/fig05.nc").unlink()
    assert workspace.pending() == expected


@pytest.mark.parametrize(
    ("file", "key", "value", "patterns"),
    [
        ("config/config.yaml", "rtol", 1e-8, (*ALL_CURVES, *GATHERED, *PAGE)),
        (
            "config/config.yaml",
            "windows/roughness_nm",
            [100, 300],
            (*WINDOWS, *SHOWING_WINDOWS, *PAGE),
        ),
        ("config/claims.yaml", "0/statement", "Particles matter.", (*CLAIMS, *PRINTED, *PAGE)),
        (
            "config/config.yaml",
            "schematics/fig01/0/load_N",
            21.0,
            ("schematics/fig01.nc", "figures/fig01.*"),
        ),
        (
            "config/scenes.yaml",
            "load_axis/load_N",
            [0.05, 80.0],
            (*ALL_CURVES, *GATHERED, *WINDOWS, *PAGE),
        ),
        (
            "config/inputs.yaml",
            # an input that no calibrated file gives
            "yield_pressure_ratio/value",
            0.41,
            (
                *(*ALL_CURVES, *GATHERED, *WINDOWS, *PAPER_TABLES, *SCHEMATICS),
                *(*CLAIMS, *SENSITIVITY, *PAGE),
            ),
        ),
        (
            DEFAULT,
            "inputs/truncation",
            1.8,
            (
                *(*ALL_CURVES, *GATHERED, *WINDOWS, *PAPER_TABLES, *SCHEMATICS),
                *(*CLAIMS, *SENSITIVITY, *PAGE, "figures/fronts.*"),
            ),
        ),
        ("config/paper_tables.yaml", "table1/0/property", "Modulus", (*PAPER_TABLES, *PAGE)),
    ],
    ids=[
        "rtol",
        "windows",
        "a statement",
        "a drawing",
        "load axis",
        "an input",
        "calibrated",
        "printed tables",
    ],
)
def test_another_setting_reruns_what_it_enters(workspace, file, key, value, patterns):
    workspace.put(file, key, value)
    assert workspace.pending() == workspace.products(*patterns)


def test_a_comment_in_the_configuration_reruns_nothing(workspace):
    for file in ("config/config.yaml", "config/scenes.yaml"):
        workspace.rewrite(file, lambda text: f"# a remark\n{text}")
    assert not workspace.pending()
