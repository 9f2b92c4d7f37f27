"""Choose the interpretations that are searched from all seeds and cross-validated."""

import json
from pathlib import Path

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.study.record import read_rows
from thirdbody.study.results import shortlist


def choose(evaluations, within, most, chosen):
    """Write the names of the interpretations of the least objectives, best first."""
    least = {path.parent.name: read_rows(path)[:, -1].min() for path in map(Path, evaluations)}
    names = shortlist(least, within, most)
    for name in sorted(least, key=least.__getitem__):
        print(f"{name}: {least[name]:.2f}{', on the shortlist' if name in names else ''}")
    with atomic_write(chosen) as part:
        part.write_text(json.dumps(names, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        choose(
            snakemake.input.evaluations,
            snakemake.params.within,
            snakemake.params.most,
            snakemake.output.chosen,
        )
