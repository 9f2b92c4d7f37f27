"""Bytecode of the library that can be loaded: compiled when a run begins, for all its jobs.

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
NOWHERE = os.devnull  # a file, so that no folder of bytecode can lie in it


class Bytecode:
    """The bytecode of the modules in some folders, as one process sees it.

    Parameters
    ----------
    *folders
        Folders of modules, searched with all folders in them.
    """

    def __init__(self, *folders: str | Path) -> None:
        self.folders = folders
        self._before = sys.dont_write_bytecode, sys.pycache_prefix

    def leave_as_it_is(self) -> None:
        """From now on this process writes no bytecode, and reads none if some is broken.

        It then compiles in memory what it imports.
        """
        sys.dont_write_bytecode = True
        if self._broken():
            sys.pycache_prefix = NOWHERE

    def prepare(self) -> None:
        """Compile what changed and replace what is broken, for this process and its jobs.

        If bytecode cannot be kept, none is left that is broken, and no job tries to write any.
        """
        sys.dont_write_bytecode, sys.pycache_prefix = self._before
        self._remove_broken()
        if not sys.dont_write_bytecode:
            compiled = all(compileall.compile_dir(folder, quiet=2) for folder in self.folders)
            if self._remove_broken() or not compiled:
                sys.dont_write_bytecode = True
                os.environ["PYTHONDONTWRITEBYTECODE"] = "1"

    def _broken(self) -> list[Path]:
        """Files of bytecode that cannot be loaded."""
        modules = [module for folder in self.folders for module in Path(folder).rglob("*.py")]
        return [path for path in map(_bytecode, modules) if _is_broken(path)]

    def _remove_broken(self) -> bool:
        """Remove bytecode that cannot be loaded; whether there was any."""
        broken = self._broken()
        for path in broken:
            path.unlink(missing_ok=True)
        return bool(broken)


def _bytecode(module: Path) -> Path:
    return Path(cache_from_source(module))


def _is_broken(path: Path) -> bool:
    try:
        marshal.loads(path.read_bytes()[HEADER:])
    except OSError:  # absent, or not to be read: Python compiles the module
        return False
    except (EOFError, ValueError, TypeError):
        return True
    return False
