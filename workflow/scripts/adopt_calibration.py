"""Copy the calibrated inputs of the best interpretations, the ranking of all and the profiles to
where the default run and the library read them.
"""

import json
import shutil
from pathlib import Path

import pandas as pd

from chenhorng.calibration.adoption import calibrated_text, library_text
from chenhorng.job_log import job
from thirdbody.files import read_yaml

FOLDER, LIBRARY = Path("config/calibrated"), Path("src/thirdbody/calibrated.yaml")

with job(snakemake) as output:
    FOLDER.mkdir(parents=True, exist_ok=True)
    chosen = json.loads(Path(snakemake.input.chosen).read_text(encoding="utf-8"))
    default, members = chosen["interpretation"], chosen["members"]
    ranking = pd.read_csv(snakemake.input.ranking)
    # a search with another A_n than the deduced one is there to be compared
    usable = ranking["apparent_area"].eq(snakemake.params.base["apparent_area"])
    kept = {*ranking["interpretation"][usable][: snakemake.params.kept]}
    for old in FOLDER.glob("*.yaml"):
        if old.stem not in {*kept, Path(snakemake.params.default).stem}:
            old.unlink()
    for source in map(Path, snakemake.input.calibrated):
        content = read_yaml(source)
        if content["interpretation"] not in kept:
            continue
        known = {**snakemake.params.base, **content["inputs"]}
        content["ensemble"] = [content["inputs"], *(member["inputs"] for member in members)]
        content["unseen"] = [[], *(member["unseen"] for member in members)]
        content["inputs"] = known
        (FOLDER / source.name).write_text(calibrated_text(content), encoding="utf-8")
        if content["interpretation"] == default and LIBRARY.is_file():  # in the repository
            LIBRARY.write_text(library_text(content), encoding="utf-8")
    profiles = pd.concat(map(pd.read_csv, snakemake.input.profiles))
    profiles.to_csv(FOLDER / "profiles.csv", index=False, float_format="%.6g")
    shutil.copyfile(snakemake.input.ranking, FOLDER / "ranking.csv")
    line = f"{FOLDER / default}.yaml is the default by the rule"
    output.adopted.write_text(line + "\n", encoding="utf-8")
    print(f"{line}: set it as calibrated in config/config.yaml")
