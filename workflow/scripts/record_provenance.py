"""Record when, where and by whom a release was made."""

import json
from pathlib import Path

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.release.provenance import provenance


def record(archive, place):
    """Write the provenance of the file ``archive`` to ``place``."""
    with atomic_write(place) as part:
        part.write_text(json.dumps(provenance(Path(archive)), indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        record(snakemake.input.archive, snakemake.output.provenance)
