# Shared by the rules: the settings, where files are, and what a job depends on.
import ast
import json
import os
import sys
from functools import cache
from hashlib import sha256
from pathlib import Path

# ---- where files are

PACKAGES = (
    Path(thirdbody.__file__).resolve().parents[1]
)  # src/, or where both packages are installed
HOME = config_directory().parent  # the repository, or the installed package


def project_file(name):
    """The path of a file of the project, relative if the current folder is its repository."""
    path = (
        PACKAGES / str(name).removeprefix("src/") if str(name).startswith("src/") else HOME / name
    )
    return str(path.relative_to(HOME) if Path.cwd() == HOME else path)


# snakedeploy copies the configuration into the folder of the user's workflow
CONFIG = "config" if Path("config/config.yaml").is_file() else project_file("config")
CLAIMS = f"{CONFIG}/claims.yaml"
PAPER_TABLES = f"{CONFIG}/paper_tables.yaml"
INPUTS = f"{CONFIG}/inputs.yaml"

# ---- the settings: Snakemake reads none of their files, as its errors do not name the file

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

# ---- what a job depends on, as parameters of its rule: Snakemake names the text that has changed

SOFTWARE = settings["software"]
IMPORTS = grimp.build_graph(
    "thirdbody", "chenhorng", exclude_type_checking_imports=True, cache_dir=None
)


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


@cache
def module_files(name):
    """A module, and the data beside it under the same name; templates are inputs of rules."""
    path = PACKAGES.joinpath(*name.split("."))
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
