# Shared by the rules: the settings, where files are, and what a job depends on.
import ast
import json
import logging
import os
import re
import sys
from functools import cache
from hashlib import sha256
from pathlib import Path

# in one line, before anything else: whether the library is there, and whether it is that of this checkout
BESIDE = Path(workflow.basedir) / "src/thirdbody"
INSTALL = f'pip install "{workflow.basedir if BESIDE.is_dir() else "thirdbody"}[workflow]"'
try:
    import thirdbody
except ModuleNotFoundError:
    sys.exit(f"thirdbody is not installed for {sys.executable}; allowed: {INSTALL}")
if BESIDE.is_dir() and not BESIDE.samefile(Path(thirdbody.__file__).parent):
    sys.exit(
        f"the library is {Path(thirdbody.__file__).parent}; allowed: that of this checkout, by PYTHONPATH=src"
    )
try:
    import grimp

    from thirdbody import version
    from thirdbody.paper.configuration.settings import read_settings
    from thirdbody.plain_yaml import config_directory, read_yaml
except ModuleNotFoundError as missing:
    sys.exit(f"{missing.name} is not installed for {sys.executable}; allowed: {INSTALL}")

# ---- where files are

PACKAGE = Path(thirdbody.__file__).resolve().parent
HOME = config_directory().parent  # the repository, or the installed package
LIBRARY = "src/thirdbody/"

# Snakemake does not quote the interpreter of a script
if not re.fullmatch(r"[\w/.,:@%+~-]+", sys.executable):
    sys.exit(
        f"the path {sys.executable} has a blank or a sign of the shell; allowed: a folder whose path has none"
    )


def project_file(name):
    """The path of a file of the project, relative if the current folder is its repository."""
    in_library = str(name).startswith(LIBRARY)
    path = PACKAGE / str(name).removeprefix(LIBRARY) if in_library else HOME / name
    return str(path.relative_to(HOME) if Path.cwd() == HOME else path)


# snakedeploy copies the configuration into the folder of the user's workflow
CONFIG = "config" if Path("config/config.yaml").is_file() else project_file("config")
CLAIMS = f"{CONFIG}/claims.yaml"
PAPER_TABLES = f"{CONFIG}/paper_tables.yaml"
INPUTS = f"{CONFIG}/inputs.yaml"
STYLE = project_file("src/thirdbody/plotting/paper.mplstyle")

# ---- the settings, before Snakemake reads their files: its errors do not name the file

try:
    settings = read_settings(config, CONFIG, *workflow.overwrite_configfiles)
except ValueError as error:
    sys.exit(str(error))

# a named run keeps all its files in results/NAME
RESULTS = f"results/{settings['run']}" if settings["run"] else "results"
LOGS = f"{RESULTS}/logs" if settings["run"] else "logs"
for folder in [RESULTS, LOGS]:
    if Path(folder).is_dir() and not os.access(folder, os.W_OK):
        sys.exit(f"{folder} is read-only; allowed: a writable folder")
# without its record, Snakemake takes products of another configuration for those of this one
if (
    workflow.is_main_process
    and Path(RESULTS, "datasets").is_dir()
    and not Path(".snakemake/metadata").is_dir()
):
    sys.exit(
        f"{RESULTS} has products without .snakemake, which records what they were made of; allowed: both or none"
    )

# on a full disk, lines that do not fit into Snakemake's log are dropped
logging.raiseExceptions = False

FILES_NAMED = 3  # in the reason of a job; a first run would name all files of the workflow


def in_a_line(record):
    """Whether a record of Snakemake is to be printed: not that jobs are selected, and reasons with few files."""
    shortened = []
    for clause in filter(None, (getattr(record, "reason", None) or "").split("; ")):
        what, _, files = clause.partition(": ")
        first, others = files.split(", ")[:FILES_NAMED], files.split(", ")[FILES_NAMED:]
        named = ", ".join(first) + (f" and {len(others)} more" if others else "")
        shortened.append(f"{what}: {named}" if files else what)
    if shortened:
        record.reason = "; ".join(shortened)
    return not str(record.msg).startswith(("Select jobs to execute", "Execute "))


logging.getLogger("snakemake.logging").addFilter(in_a_line)

# ---- what a job depends on, as parameters of its rule: Snakemake names the text that has changed

SOFTWARE = settings["software"]
IMPORTS = grimp.build_graph("thirdbody", exclude_type_checking_imports=True, cache_dir=None)


def sources_of(script):
    """A text for each file that a script runs."""
    return sorted(map(file_text, files_of(script)))


@cache
def files_of(script):
    """The files that a script runs: itself, the modules that it imports, all that these import, and the data
    beside them."""
    path, imported = HOME / "workflow/scripts" / script, set()
    for statement in ast.walk(ast.parse(path.read_bytes())):
        if isinstance(statement, ast.Import):
            imported.update(alias.name for alias in statement.names)
        if isinstance(statement, ast.ImportFrom):
            names = [f"{statement.module}.{alias.name}" for alias in statement.names]
            imported.update([statement.module, *names])
    modules = imported & IMPORTS.modules
    modules = modules.union(*map(IMPORTS.find_upstream_modules, modules))
    packages = {name.rpartition(".")[0] for name in modules}
    return {path}.union(*map(module_files, modules | packages))


# the scripts that compute the numbers of products
COMPUTED_BY = {
    "datasets": ["solve_scene.py"],
    "bands": ["solve_scene.py", "solve_ensemble.py"],
    "schematics": ["compute_schematic.py"],
    "tpca_loads": ["solve_scene.py", "extract_curves.py"],
    "transitions": ["solve_scene.py", "extract_curves.py"],
    "tpca_windows": ["find_windows.py"],
    "sensitivity": ["compute_sensitivities.py"],
    "table1": ["recompute_paper_tables.py"],
    "table2": ["recompute_paper_tables.py"],
    "deviations": ["judge_departures.py"],
    "departures": ["judge_departures.py"],
    "index": [
        *["solve_scene.py", "solve_ensemble.py", "compute_schematic.py", "extract_curves.py"],
        *["find_windows.py", "compute_sensitivities.py", "recompute_paper_tables.py"],
        *["judge_claims.py", "judge_departures.py"],
    ],
    "atlas": ["solve_chunk.py"],
}


@cache
def version_of(product):
    """The version of what computes a product: that of the last commit that changed one of its files. A release
    has no commits, and stores it."""
    stored = version.stored_content().get("products", {})
    files = set().union(*map(files_of, COMPUTED_BY[product]))
    names = sorted(str(file.relative_to(HOME)) for file in files)
    return stored.get(product) or list(version.of_files(*names))


@cache
def module_files(name):
    """A module, and the data beside it under the same name; templates are inputs of rules."""
    path = PACKAGE.parent.joinpath(*name.split("."))
    beside = path.parent.glob(f"{path.name}.*")
    return [file for file in beside if file.suffix not in (".j2", ".html")] or [
        path / "__init__.py"
    ]


@cache
def file_text(path):
    """The name of a file, and the first digits of its SHA-256."""
    name = path.relative_to(HOME) if path.is_relative_to(HOME) else path
    return f"{name} {sha256(path.read_bytes()).hexdigest()[:8]}"


@cache
def settings_text(path, kind=dict):
    """The name of a file of the configuration, and the first digits of the SHA-256 of its content, which a
    comment does not change."""
    try:
        content = json.dumps(read_yaml(path, kind), default=str)
    except ValueError as error:
        sys.exit(str(error))
    return f"{path} {sha256(content.encode()).hexdigest()[:8]}"


# ---- the files of a figure


def figure_files(figure, category):
    """The files of a figure by kind; the PNG goes into Snakemake's report."""
    files = {kind: f"<results>/figures/{figure}.{kind}" for kind in FIGURE_KINDS}
    caption, labels = "../report/product.rst", {"figure": figure}
    return files | {"png": report(files["png"], caption, category=category, labels=labels)}


# ---- the searches of the calibration

CALIBRATION = settings["calibration"]
SEEDS = CALIBRATION["seeds"]
FOLDS = range(len(CALIBRATION["folds"]))
SEARCHED_WIDELY = [
    name for name, entry in CALIBRATION["interpretations"].items() if "nearby" not in entry
]


def settings_of(wildcards):
    """The settings for one interpretation, independent of the others."""
    names = [wildcards.interpretation, *nearby(wildcards)]
    return {
        **CALIBRATION,
        "interpretations": {name: CALIBRATION["interpretations"][name] for name in names},
    }


def nearby(wildcards):
    """The interpretation from whose best inputs that of a job is searched, if there is one."""
    entry = CALIBRATION["interpretations"][wildcards.interpretation]
    return [entry["nearby"]] if "nearby" in entry else []


def start_of(wildcards):
    """The files with the inputs from which a search starts."""
    for name in nearby(wildcards):
        if "fold" in wildcards.keys():
            return [f"{RESULTS}/calibration/{name}/fold{wildcards.fold}.csv"]
        return searches_of(name)
    return [f"{RESULTS}/calibration/{wildcards.interpretation}/scattered.csv"]


def searches_of(name):
    """The files of the searches over all statements of an interpretation."""
    seeds = SEEDS if name in shortlisted() else SEEDS[:1]
    return [f"{RESULTS}/calibration/{name}/seed{seed}.csv" for seed in seeds]


def shortlisted():
    chosen = checkpoints.shortlist.get().output.chosen
    return json.loads(Path(chosen).read_text(encoding="utf-8"))


def is_cross_validated(wildcards):
    """Whether an interpretation, or the one from which its starts come in the end, is on the shortlist."""
    name = wildcards.interpretation
    while "nearby" in CALIBRATION["interpretations"][name]:
        name = CALIBRATION["interpretations"][name]["nearby"]
    return name in shortlisted()
