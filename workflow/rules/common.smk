# What the rules share: where the project's files lie, and which modules a script imports.
import ast
from pathlib import Path

import grimp

from thirdbody.project import HOME, PACKAGE, configuration_folder, project_file

CONFIG = configuration_folder()
IMPORTS = grimp.build_graph("thirdbody", exclude_type_checking_imports=True, cache_dir=None)
STYLE = project_file("src/thirdbody/figures/paper.mplstyle")


def modules_of(script):
    """Files of all modules of the library that a script imports, directly or not.

    They are inputs of the rule that runs it, so that an edit reruns what depends on it.
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
    return sorted(project_file(f"src/{path}") for path in map(module_file, modules | packages))


def module_file(name):
    """Where a module of the library lies below ``src/``."""
    path = Path(*name.split("."))
    if IMPORTS.find_children(name):
        return path / "__init__.py"
    return path.with_suffix(".py")
