"""Whether the compiled loop is at hand, told without importing numba, which takes long by itself."""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec
from pathlib import Path

SOURCES = Path(__file__).parent / "compiled"


def is_installed() -> bool:
    """Whether there is a compiler, which comes with the extra ``compiled``."""
    return find_spec("numba") is not None


def is_loaded() -> bool:
    """Whether this process has imported what calls the loop."""
    return "thirdbody.solver.compiled.points" in sys.modules


def is_kept() -> bool:
    """Whether an earlier process left the loop on disk, where numba will look for it.

    That is ``NUMBA_CACHE_DIR``, or else ``__pycache__``: an index named after the module, the
    function and the version of Python.  It may be of an earlier version of the loop, which is then
    compiled once more: a wrong answer only costs time.
    """
    given = os.environ.get("NUMBA_CACHE_DIR")
    folder, folders = (Path(given), "*/") if given else (SOURCES / "__pycache__", "")
    version = "".join(map(str, sys.version_info[:2]))
    return any(folder.glob(f"{folders}loop.solve_points-*.py{version}*.nbi"))
