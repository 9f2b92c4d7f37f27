"""When, where, by whom and with what a release was made: a file beside the archive, not in it."""

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

from thirdbody.data.sums import digest
from thirdbody.release.bag import ALGORITHMS


def provenance(archive: Path) -> dict[str, Any]:
    """Content of ``provenance.json`` for the file ``archive``, made now on this machine."""
    sums = {algorithm: digest(archive, algorithm) for algorithm in ALGORITHMS}
    return {
        "archive": {"name": archive.name, "bytes": archive.stat().st_size, **sums},
        "time": datetime.now(UTC).isoformat(timespec="seconds"),
        "host": socket.gethostname(),
        "user": _user(),
        "system": platform.platform(),
        "processor": platform.machine(),
        "python": sys.version,
        "commit": _commit(),
        "packages": dict(sorted((one.name, one.version) for one in distributions())),
    }


def _user() -> str:
    try:
        return getpass.getuser()
    except (OSError, KeyError):  # in a container a user may have no name
        return "unknown"


def _commit() -> str:
    """Git commit of the current folder, with ``-dirty`` if it was changed."""
    command = ["git", "describe", "--always", "--dirty", "--abbrev=40"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "not in a repository"
    return done.stdout.strip()
