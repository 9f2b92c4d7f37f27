# What the rules share: where the project's files lie, and which modules a script imports.
import ast
from functools import cache
from hashlib import sha256
from pathlib import Path

import grimp

import thirdbody
from thirdbody.configuration.schema import config_directory

PACKAGE = Path(thirdbody.__file__).resolve().parent
HOME = config_directory().parent  # the repository, or the installed package that holds its files
LIBRARY = "src/thirdbody/"


def project_file(name):
    """The path of a file of the project, relative if the current folder is its repository."""
    in_library = str(name).startswith(LIBRARY)
    path = PACKAGE / str(name).removeprefix(LIBRARY) if in_library else HOME / name
    return str(path.relative_to(HOME) if Path.cwd() == HOME else path)


# snakedeploy copies the configuration into the folder of a user's own workflow
CONFIG = "config" if Path("config/config.yaml").is_file() else project_file("config")
IMPORTS = grimp.build_graph("thirdbody", exclude_type_checking_imports=True, cache_dir=None)
STYLE = project_file("src/thirdbody/figures/paper.mplstyle")


def sources_of(script):
    """SHA-256 of the modules of the library that a script imports, directly or not.

    As a parameter of a rule it makes an edit of any of them rerun the rule.
    """
    statements = ast.walk(ast.parse((HOME / "workflow/scripts" / script).read_bytes()))
    named = {
        (
            f"{statement.module}.{name.name}"
            if f"{statement.module}.{name.name}" in IMPORTS.modules
            else statement.module
        )
        for statement in statements
        if isinstance(statement, ast.ImportFrom)
        for name in statement.names
    }
    modules = named & IMPORTS.modules
    for name in list(modules):
        modules |= IMPORTS.find_upstream_modules(name)
    packages = {name.rpartition(".")[0] for name in modules}
    return digest(project_file(f"src/{module_file(name)}") for name in modules | packages)


def digest(files):
    """SHA-256 of the content of all ``files`` together."""
    return sha256("".join(sorted(map(file_sum, files))).encode()).hexdigest()


@cache
def file_sum(file):
    return sha256(Path(file).read_bytes()).hexdigest()


def module_file(name):
    """Where a module of the library lies below ``src/``."""
    path = Path(*name.split("."))
    if IMPORTS.find_children(name):
        return path / "__init__.py"
    return path.with_suffix(".py")
