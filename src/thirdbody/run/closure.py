"""Which modules of this package a file needs: the rules list them as inputs."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent


def import_closure(script) -> list[str]:
    """Files of this package that ``script`` imports, directly or not.

    ``script`` and the result are relative to the root of the repository.  Snakemake reruns a rule
    whose listed inputs changed; with these it follows the library.
    """
    found: set[Path] = set()
    root = PACKAGE.parents[1]
    waiting = list(_imported(root / script))
    while waiting:
        module = waiting.pop()
        if module not in found:
            found.add(module)
            waiting.extend(_imported(module))
    return sorted(str(path.relative_to(root)) for path in found)


@cache
def _imported(path: Path) -> tuple[Path, ...]:
    """Modules of this package that stand in the import statements of ``path``."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_bytes())):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "thirdbody":
            names.add(node.module)
            names.update(f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
    parents = {name.rpartition(".")[0] for name in names}
    files = (_file(name) for name in names | parents if name.split(".")[0] == "thirdbody")
    return tuple(file for file in files if file is not None)


def _file(name: str) -> Path | None:
    base = PACKAGE.parent.joinpath(*name.split("."))
    for candidate in (base.with_suffix(".py"), base / "__init__.py"):
        if candidate.is_file():
            return candidate
    return None
