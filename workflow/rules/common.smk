# Shared by the rules: files of the project, and what a job depends on.
import ast
import json
import sys
from functools import cache
from hashlib import sha256
from pathlib import Path

import grimp

import thirdbody
from thirdbody.plain_yaml import config_directory
from thirdbody.plain_yaml import read_yaml

PACKAGE = Path(thirdbody.__file__).resolve().parent
HOME = config_directory().parent  # the repository, or the installed package
LIBRARY = "src/thirdbody/"
BESIDE = Path(workflow.basedir).parent / LIBRARY  # the library of this checkout
if BESIDE.is_dir() and not BESIDE.samefile(PACKAGE):
    sys.exit(f"the library is {PACKAGE}; allowed: that of this checkout, by PYTHONPATH=src")


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
IMPORTS = grimp.build_graph("thirdbody", exclude_type_checking_imports=True, cache_dir=None)


def figure_files(figure, category):
    """The files of a figure by kind; the PNG goes into Snakemake's report."""
    files = {kind: f"<results>/figures/{figure}.{kind}" for kind in FIGURE_KINDS}
    caption, labels = "../report/product.rst", {"figure": figure}
    return files | {"png": report(files["png"], caption, category=category, labels=labels)}


def sources_of(script, *modules):
    """A text for each file that a script runs: the script, ``modules``, those that it imports, all their
    imports, and the data beside them.

    As parameters of a rule, they rerun it after an edit, for the reason of which Snakemake names the file.
    """
    file, named = HOME / "workflow/scripts" / script, set(modules)
    for statement in ast.walk(ast.parse(file.read_bytes())):
        if isinstance(statement, ast.ImportFrom):
            named.add(statement.module)
            named |= {f"{statement.module}.{each.name}" for each in statement.names}
    used = named & IMPORTS.modules
    for name in list(used):
        used |= IMPORTS.find_upstream_modules(name)
    packages = {name.rpartition(".")[0] for name in used}
    modules = [module_file for name in used | packages for module_file in module_files(name)]
    return sorted(map(file_text, {file, *modules}))


@cache
def module_files(name):
    """A module, and the data beside it under the same name; templates are inputs of rules."""
    path = PACKAGE.parent.joinpath(*name.split("."))
    beside = path.parent.glob(f"{path.name}.*")
    return [file for file in beside if file.suffix not in (".j2", ".html")] or [
        path / "__init__.py"
    ]


@cache
def file_text(file):
    """The name of a file, and the first digits of its SHA-256."""
    name = Path(file).relative_to(HOME) if Path(file).is_relative_to(HOME) else file
    return f"{name} {sha256(Path(file).read_bytes()).hexdigest()[:8]}"


@cache
def settings_text(path, kind=dict):
    """The name of a file of the configuration, and the first digits of the SHA-256 of its content, which a
    comment does not change."""
    try:
        content = json.dumps(read_yaml(path, kind), default=str)
    except ValueError as error:
        sys.exit(str(error))
    return f"{path} {sha256(content.encode()).hexdigest()[:8]}"
