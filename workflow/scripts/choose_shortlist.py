"""Choose the interpretations to search from all seeds and to cross-validate."""

import json
from pathlib import Path

from chenhorng.calibration.calibration import read_rows
from chenhorng.calibration.results import shortlist
from chenhorng.job_log import job

with job(snakemake) as output:
    least = {
        path.parent.name: read_rows(path)[:, -1].min()
        for path in map(Path, snakemake.input.evaluations)
    }
    names = shortlist(least, snakemake.params.within, snakemake.params.most)
    for name in sorted(least, key=least.__getitem__):
        print(f"{name}: {least[name]:.2f}{', on the shortlist' if name in names else ''}")
    output.chosen.write_text(json.dumps(names, indent=1) + "\n", encoding="utf-8")
