"""Which modules of this repository a file needs: the rules list them as inputs."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from thirdbody.run.home import HOME, PACKAGE, is_current_folder

# where each package lies
HOMES = {"thirdbody": PACKAGE.parent, "benchmarks": HOME, "tests": HOME}
BLOCKS = ("body", "orelse", "finalbody", "handlers", "cases")  # of a statement


def import_closure(script) -> list[str]:
    """Modules of this repository that ``script`` imports, directly or not.

    ``script`` is its place in the repository; so are the results of a run in the repository, else
    they are where the modules lie.  Snakemake reruns a rule whose listed inputs changed; with these
    it follows the library.
    """
    found: set[Path] = set()
    waiting = list(_imported(HOME / script))
    while waiting:
        module = waiting.pop()
        if module not in found:
            found.add(module)
            waiting.extend(_imported(module))
    at_home = is_current_folder()
    return sorted(str(path.relative_to(HOME) if at_home else path) for path in found)


@cache
def _imported(path: Path) -> tuple[Path, ...]:
    """Modules of this repository that stand in the import statements of ``path``."""
    names: set[str] = set()
    for node in _statements(ast.parse(path.read_bytes())):
        if isinstance(node, ast.ImportFrom) and _package(node.module or "") in HOMES:
            names.add(node.module)
            names.update(f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
    files = (_file(each) for name in names for each in _with_parents(name))
    return tuple(file for file in files if file is not None)


def _statements(block: ast.AST) -> Iterator[ast.AST]:
    """The statements of ``block`` and of all blocks in it; what they compute is not looked at."""
    for part in BLOCKS:
        for node in getattr(block, part, ()):
            yield node
            yield from _statements(node)


def _package(name: str) -> str:
    return name.partition(".")[0]


def _with_parents(name: str) -> list[str]:
    """``a.b.c`` with ``a.b`` and ``a``, whose ``__init__`` Python runs first."""
    words = name.split(".")
    return [".".join(words[: count + 1]) for count in range(len(words))]


@cache
def _file(name: str) -> Path | None:
    """The file of a module of this repository; None for any other name."""
    if _package(name) not in HOMES:
        return None
    base = HOMES[_package(name)].joinpath(*name.split("."))
    for candidate in (base.with_suffix(".py"), base / "__init__.py"):
        if candidate.is_file():
            return candidate
    return None
