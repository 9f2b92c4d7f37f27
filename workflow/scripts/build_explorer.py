"""Build the explorer, a web page, from figures, statements and inputs of the run."""

import json
from pathlib import Path

from thirdbody.configuration.inputs import read_entries
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.explorer.page import page_content, page_text
from thirdbody.figures.captions import read_caption
from thirdbody.figures.curves import CURVE_FIGURES
from thirdbody.job_log import job
from thirdbody.study.claims import load_claims

with job(snakemake) as output:
    parameters = snakemake.params.parameters
    unknowns = snakemake.params.calibration["unknowns"]
    entries = read_entries()
    interpretations = [read_yaml(path) for path in snakemake.params.calibrated]
    inputs = {
        name: entry | unknowns.get(name, {}) | {"value": parameters[name]}
        for name, entry in entries.items()
    }
    drawn, captions = snakemake.input.points, map(read_caption, snakemake.input.captions)
    least = [max(each.least for each in CURVE_FIGURES[Path(path).stem].contents) for path in drawn]
    content = page_content(
        zip(drawn, captions, least, strict=True),
        load_claims(snakemake.params.claims),
        json.loads(Path(snakemake.input.verdicts).read_text(encoding="utf-8")),
        inputs,
        {each["interpretation"]: each["inputs"] for each in interpretations},
        snakemake.params.ensemble,
        {row["symbol"]: row["printed"] for row in read_yaml(snakemake.params.tables)["table2"]},
    )
    output.page.write_text(page_text(content), encoding="utf-8")
    print(f"{output.page.stat().st_size} bytes")
