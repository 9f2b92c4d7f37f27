"""A run is alone in its folder, and may write to it."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path
from typing import IO


def hold_alone(path: str | Path) -> IO[str]:
    """Lock the file ``path`` for this process.

    Parameters
    ----------
    path
        The file, which is made if it is not there, and with it its folder.

    Returns
    -------
    IO[str]
        The open file.  The kernel frees the lock when it is closed or the process ends, however it
        ends: a lock is never stale.

    Raises
    ------
    OSError
        While another process holds the lock.
    """
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    held = open(path, "a", encoding="ascii")  # noqa: SIM115, it stays open
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        held.close()
        raise OSError("another run is under way in this folder; wait for its end") from None
    return held


def require_writable(folder: str | Path) -> None:
    """Require the right to read and write ``folder`` and every folder in it, or to make it.

    Raises
    ------
    OSError
        Naming the first folder that may not be written to, or what is in the place of one.
    """
    if not os.path.lexists(folder):
        folder = Path(folder).parent
        within = [folder]
    elif Path(folder).is_dir():
        inner = (os.path.join(path, name) for path, names, _ in os.walk(folder) for name in names)
        within = [folder, *inner]
    else:
        raise OSError(f"{folder} is no folder; move it away: a run makes a folder of that name")
    for path in within:
        if not os.access(path, os.R_OK | os.W_OK | os.X_OK):
            raise OSError(f"{path} may not be written to; allow it, or run in a folder of your own")
