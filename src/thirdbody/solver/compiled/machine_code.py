"""How the loop becomes machine code, which numba compiles and keeps on disk for later processes."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from contextlib import suppress
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import Any

from numba import config, njit, typeof
from numba.core.caching import FunctionCache, IndexDataCacheFile

# A quotient by zero is infinite or nan; a product and a sum may be rounded once instead of twice.
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}, "nogil": True}

stage = njit(**OPTIONS, no_cpython_wrapper=True, no_cfunc_wrapper=True)  # called by the loop alone


class MachineCode:
    """A function in machine code, compiled when it is first called with arguments of a kind.

    numba would look at each call at what the arguments are, which takes longer than to solve a point.
    So who calls says what arguments are of one kind: all of the same types.

    It is kept on disk where there is a folder that can be written to: in ``NUMBA_CACHE_DIR``, in
    ``__pycache__`` beside the file of the function, or in the user's cache.
    """

    def __init__(self, function: Callable):
        self._dispatcher = njit(**OPTIONS)(function)
        with suppress(RuntimeError):  # no such folder
            self._dispatcher._cache = KeptCode(function)
        self._entries: dict[Hashable, Callable] = {}

    @property
    def loaded(self) -> int:
        """For how many kinds the code was found on disk."""
        return sum(self._dispatcher.stats.cache_hits.values())

    def __call__(self, kind: Hashable, *arguments: Any) -> Any:
        """Call the function with ``arguments`` of a ``kind``."""
        entry = self._entries.get(kind)
        if entry is None:
            entry = self._dispatcher.compile(tuple(map(typeof, arguments)))
            self._entries[kind] = entry
        return entry(*arguments)


compiled = lru_cache(maxsize=1)(MachineCode)  # of a function: compiled once


class KeptCode(FunctionCache):
    """Machine code on disk, which a process can do without.

    numba's own class takes code for up to date as long as the file of its function is unchanged, and
    fails wherever a file that it left behind is damaged.  Here code is compiled anew when any file of
    the function's folder has changed, and when it cannot be loaded.
    """

    def __init__(self, function: Callable):
        config.reload_config()  # NUMBA_CACHE_DIR as it is now: numba looks when it compiles
        super().__init__(function)
        self._cache_file = IndexDataCacheFile(
            self._cache_path, self._impl.filename_base, _stamp(Path(function.__code__.co_filename))
        )

    def load_overload(self, sig, target_context):
        """The code for a signature, or None if there is none that can be loaded."""
        try:
            return super().load_overload(sig, target_context)
        except Exception:  # of whatever kind: half a pickle raises many
            with suppress(OSError):
                self.flush()
            return None

    def save_overload(self, sig, data):
        """Keep the code for a signature, if that is possible."""
        with suppress(Exception):  # a full disk, a damaged index that cannot be removed
            super().save_overload(sig, data)


def _stamp(path):
    """What changes whenever a file in the folder of ``path`` does."""
    files = sorted(path.parent.glob("*.py"))
    return [(file.name, sha256(file.read_bytes()).hexdigest()) for file in files]
