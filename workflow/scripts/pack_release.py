"""Pack the folder of a release into one archive file, and record its provenance beside it."""

import getpass
import json
import platform
import socket
import sys
from datetime import UTC, datetime
from importlib.metadata import distributions
from pathlib import Path

from chenhorng.archive.staging import pack
from chenhorng.job_log import job
from thirdbody.files import digest
from thirdbody.version import current


def provenance(archive, name):
    """The provenance of the file ``archive``, named ``name``: time, place, user and software."""
    try:
        user = getpass.getuser()
    except (OSError, KeyError):  # in a container a user may have no name
        user = "unknown"
    version = current()
    return {
        "archive": {"name": name, "bytes": archive.stat().st_size, "sha256": digest(archive)},
        "time": datetime.now(UTC).isoformat(timespec="seconds"),
        "host": socket.gethostname(),
        "user": user,
        "system": platform.platform(),
        "processor": platform.machine(),
        "python": sys.version,
        "version": version.text,
        "commit": version.commit,
        "packages": dict(sorted((one.name, one.version) for one in distributions()))
        | {"thirdbody": version.text},
    }


with job(snakemake) as output:
    pack(Path(snakemake.input.sealed).parent, output.archive)
    record = json.dumps(provenance(output.archive, Path(snakemake.output.archive).name), indent=1)
    output.provenance.write_text(record + "\n", encoding="utf-8")
