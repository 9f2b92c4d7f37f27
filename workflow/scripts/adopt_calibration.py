"""Copy the calibrated inputs of the best interpretations to where the default run reads them."""

import json
from pathlib import Path

import pandas as pd
import yaml

from chenhorng.job_log import job
from thirdbody.plain_yaml import read_yaml

PLACE = Path("config/calibrated")
HEADER = "# Calibrated inputs of one interpretation, made by `snakemake -c2 calibrate`; not edited by hand.\n"

with job(snakemake) as output:
    PLACE.mkdir(parents=True, exist_ok=True)
    default = json.loads(Path(snakemake.input.chosen).read_text(encoding="utf-8"))
    ranking = pd.read_csv(snakemake.input.ranking)["interpretation"]
    kept = set(ranking[: snakemake.params.kept])
    for old in PLACE.glob("*.yaml"):
        if old.stem not in {*kept, Path(snakemake.params.default).stem}:
            old.unlink()
    for source in map(Path, snakemake.input.calibrated):
        content = read_yaml(source)
        if content["interpretation"] not in kept:
            continue
        if content["interpretation"] == default["interpretation"]:
            content |= default
        content["inputs"] = {**snakemake.params.base, **content["inputs"]}
        with open(PLACE / source.name, "w", encoding="utf-8") as stream:
            stream.write(HEADER)
            yaml.safe_dump(content, stream, sort_keys=False, width=100, default_flow_style=None)
    line = f"{PLACE / default['interpretation']}.yaml is the default by the rule"
    output.adopted.write_text(line + "\n", encoding="utf-8")
    print(f"{line}: set it as calibrated in config/config.yaml")
