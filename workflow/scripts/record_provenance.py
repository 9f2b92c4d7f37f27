"""Record when, where, by whom and with what a release was made: a file beside the archive, not in it."""

import getpass
import json
import platform
import socket
import subprocess
import sys
from datetime import UTC, datetime
from importlib.metadata import distributions
from pathlib import Path

from thirdbody.data.files import atomic_write
from thirdbody.data.sums import digest
from thirdbody.job_log import logged


def provenance(archive):
    """What is recorded of the file ``archive``, made now on this machine."""
    try:
        user = getpass.getuser()
    except (OSError, KeyError):  # in a container a user may have no name
        user = "unknown"
    # ends with -dirty if sources were changed
    command = ["git", "describe", "--always", "--dirty", "--abbrev=40"]
    described = subprocess.run(command, capture_output=True, text=True, check=False)
    sums = {algorithm: digest(archive, algorithm) for algorithm in ("sha256", "sha512")}
    return {
        "archive": {"name": archive.name, "bytes": archive.stat().st_size, **sums},
        "time": datetime.now(UTC).isoformat(timespec="seconds"),
        "host": socket.gethostname(),
        "user": user,
        "system": platform.platform(),
        "processor": platform.machine(),
        "python": sys.version,
        "commit": described.stdout.strip() or "not in a repository",
        "packages": dict(sorted((one.name, one.version) for one in distributions())),
    }


if __name__ == "__main__":
    with logged(snakemake.log[0]), atomic_write(snakemake.output.provenance) as part:
        record = provenance(Path(snakemake.input.archive))
        part.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
