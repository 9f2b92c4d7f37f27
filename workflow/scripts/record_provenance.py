"""Record when, where and by whom a release was made."""

from thirdbody.run.job import logged

import json
from pathlib import Path

from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.release.provenance import provenance


def record(archive, cost, place):
    """Write the provenance of the file ``archive``, and what solving cost, to ``place``."""
    content = provenance(Path(archive), read_csv(cost, TABLES["solver_cost"]))
    with whole(place) as part:
        part.write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        record(
            snakemake.input.archive,
            snakemake.input.cost,
            snakemake.output.provenance,
        )
