"""When, where, by whom and with what a release was made: what differs from run to run.

It stands in a file of its own beside the archive, so that the archive itself is always the same.
"""

from __future__ import annotations

import getpass
import platform
import socket
import subprocess
import sys
from datetime import UTC, datetime
from importlib.metadata import distributions
from pathlib import Path
from typing import Any

from thirdbody.release.bag import ALGORITHMS, digest


def provenance(archive: Path) -> dict[str, Any]:
    """Record the making of an archive, now and on this machine.

    Parameters
    ----------
    archive : Path
        The archive file, which is read for its sums.

    Returns
    -------
    dict
        Content of ``provenance.json``.
    """
    sums = {algorithm: digest(archive, algorithm) for algorithm in ALGORITHMS}
    return {
        "archive": {"name": archive.name, "bytes": archive.stat().st_size, **sums},
        "time": datetime.now(UTC).isoformat(timespec="seconds"),
        "host": socket.gethostname(),
        "user": user(),
        "system": platform.platform(),
        "processor": platform.machine(),
        "python": sys.version,
        "commit": commit(),
        "packages": dict(sorted((one.name, one.version) for one in distributions())),
    }


def user() -> str:
    """Name of the user, or ``unknown`` if the system has none."""
    try:
        return getpass.getuser()
    except (OSError, KeyError):
        return "unknown"


def commit() -> str:
    """Git commit of the current folder, or that there is none; ``-dirty`` if it was changed."""
    command = ["git", "describe", "--always", "--dirty", "--abbrev=40"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "not in a repository"
    return done.stdout.strip()
