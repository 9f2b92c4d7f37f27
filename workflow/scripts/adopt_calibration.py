"""Copy the calibrated inputs of the best interpretations to the files that the default run and the
library read.
"""

import json
from pathlib import Path

import pandas as pd

from chenhorng.calibration.adoption import calibrated_text, library_text
from chenhorng.job_log import job
from thirdbody.files import read_yaml

FOLDER, LIBRARY = Path("config/calibrated"), Path("src/thirdbody/calibrated.yaml")

with job(snakemake) as output:
    FOLDER.mkdir(parents=True, exist_ok=True)
    default = json.loads(Path(snakemake.input.chosen).read_text(encoding="utf-8"))
    ranking = pd.read_csv(snakemake.input.ranking)["interpretation"]
    kept = set(ranking[: snakemake.params.kept])
    for old in FOLDER.glob("*.yaml"):
        if old.stem not in {*kept, Path(snakemake.params.default).stem}:
            old.unlink()
    for source in map(Path, snakemake.input.calibrated):
        content = read_yaml(source)
        if content["interpretation"] not in kept:
            continue
        is_default = content["interpretation"] == default["interpretation"]
        if is_default:
            content |= default
        content["inputs"] = {**snakemake.params.base, **content["inputs"]}
        (FOLDER / source.name).write_text(calibrated_text(content), encoding="utf-8")
        if is_default and LIBRARY.is_file():  # in the repository
            LIBRARY.write_text(library_text(content), encoding="utf-8")
    line = f"{FOLDER / default['interpretation']}.yaml is the default by the rule"
    output.adopted.write_text(line + "\n", encoding="utf-8")
    print(f"{line}: set it as calibrated in config/config.yaml")
