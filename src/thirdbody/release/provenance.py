"""What differs from run to run: when, where and by whom a release was made."""

from __future__ import annotations

import getpass
import platform
import socket
import subprocess
import sys
from datetime import UTC, datetime
from importlib.metadata import distributions
from pathlib import Path

from thirdbody.release.bag import ALGORITHMS, digest


def provenance(archive: Path, cost: list[dict]) -> dict:
    """Record of the making of ``archive``; ``cost`` are rows of what solving took."""
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
        "solver_cost": cost,
    }


def user() -> str:
    """Name of the user, if the system knows one."""
    try:
        return getpass.getuser()
    except (OSError, KeyError):
        return "unknown"


def commit() -> str:
    """The git commit of the sources, if they are in a repository."""
    command = ["git", "describe", "--always", "--dirty", "--abbrev=40"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "not in a repository"
    return done.stdout.strip()
