"""Bytecode of the library that can be loaded: compiled when a run starts, for all its jobs.

On a full disk CPython 3.11 keeps as much of a file of bytecode as fits and cannot import the module
from then on, not even when there is room again.  The Snakefile runs this file by its path, before
it imports anything of the package: that needs no bytecode.
"""

from __future__ import annotations

import compileall
import marshal
import os
import sys
from importlib.util import cache_from_source
from pathlib import Path

HEADER = 16  # bytes before the code


def prepare_bytecode(*folders) -> None:
    """Compile what changed in ``folders``; if it cannot be kept, no job of this run tries to."""
    remove_broken(*folders)
    if not sys.dont_write_bytecode:
        compiled = all(compileall.compile_dir(folder, quiet=2) for folder in folders)
        if remove_broken(*folders) or not compiled:
            sys.dont_write_bytecode = True
            os.environ["PYTHONDONTWRITEBYTECODE"] = "1"


def remove_broken(*folders) -> list[Path]:
    """Remove the bytecode of modules in ``folders`` that cannot be loaded; the modules."""
    modules = [module for folder in folders for module in Path(folder).rglob("*.py")]
    broken = [module for module in modules if _is_broken(_bytecode(module))]
    for module in broken:
        _bytecode(module).unlink(missing_ok=True)
    return broken


def _bytecode(module) -> Path:
    return Path(cache_from_source(module))


def _is_broken(path) -> bool:
    try:
        marshal.loads(path.read_bytes()[HEADER:])
    except OSError:  # absent, or not to be read: Python compiles the module
        return False
    except (EOFError, ValueError, TypeError):
        return True
    return False
