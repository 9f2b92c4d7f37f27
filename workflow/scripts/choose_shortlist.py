"""Choose the interpretations that are searched from all seeds and cross-validated."""

import json
from pathlib import Path

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.study.calibration import read_rows
from thirdbody.study.results import shortlist

with logged(snakemake.log[0]):
    least = {
        path.parent.name: read_rows(path)[:, -1].min()
        for path in map(Path, snakemake.input.evaluations)
    }
    names = shortlist(least, snakemake.params.within, snakemake.params.most)
    for name in sorted(least, key=least.__getitem__):
        print(f"{name}: {least[name]:.2f}{', on the shortlist' if name in names else ''}")
    with atomic_write(snakemake.output.chosen) as part:
        part.write_text(json.dumps(names, indent=1) + "\n", encoding="utf-8")
