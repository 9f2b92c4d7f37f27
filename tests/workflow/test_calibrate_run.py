"""`snakemake calibrate` for real, with a small budget: same seeds, same files; nothing done
twice."""

import csv
import json
import re
from pathlib import Path

import yaml
from workspace import INTERPRETATIONS, MINIMAL, NEARBY, ROOT, Workspace

from chenhorng.calibration.adoption import library_text
from thirdbody.inputs import load_parameters

CONFIG = yaml.safe_load((ROOT / "config/config.yaml").read_text(encoding="utf-8"))


def files(workspace: Workspace, pattern):
    return {path.name: path.read_bytes() for path in (workspace.root / pattern).glob("*.yaml")}


def chosen_of(workspace):
    return json.loads((workspace.root / "results/calibration/chosen.json").read_text())


def test_what_is_found_is_adopted_for_the_default_run(calibrated):
    found = files(calibrated, "results/calibration")
    assert set(found) == {f"{name}.yaml" for name in INTERPRETATIONS}
    adopted = files(calibrated, "config/calibrated")
    # what is not in the ranking is kept no longer, but for what the configuration names
    assert set(adopted) == {*found, Path(CONFIG["calibrated"]).name}
    chosen = chosen_of(calibrated)
    for name, content in found.items():
        expected = yaml.safe_load(content)
        expected |= chosen if expected["interpretation"] == chosen["interpretation"] else {}
        content = yaml.safe_load(adopted[name])
        inputs = content.pop("inputs")  # with those that no search finds
        assert inputs.items() >= expected.pop("inputs").items()
        assert content == expected
        parameters = load_parameters(calibrated.root / "config/calibrated" / name)
        assert inputs.items() <= parameters.as_dict().items()


def test_the_library_takes_the_default_of_the_ranking(calibrated):
    name = chosen_of(calibrated)["interpretation"]
    content = yaml.safe_load((calibrated.root / f"config/calibrated/{name}.yaml").read_text())
    library = calibrated.root / "src/thirdbody/calibrated.yaml"
    assert library.read_text(encoding="utf-8") == library_text(content)


def test_the_ensemble_has_as_many_members_of_each_that_the_ranking_calls_equal(calibrated):
    chosen = chosen_of(calibrated)
    with open(calibrated.root / "results/calibration/ranking.csv", newline="") as stream:
        ranking = list(csv.DictReader(stream))
    assert {row["interpretation"] for row in ranking} == set(INTERPRETATIONS)
    assert chosen["interpretation"] == ranking[0]["interpretation"]
    equals = [row["interpretation"] for row in ranking if row["equal"] == "True"]
    for row in ranking:
        is_equal = float(row["above_least"]) <= float(row["standard_error"])
        assert (row["equal"] == "True") == is_equal
    names = chosen["ensemble_interpretations"]
    least = yaml.safe_load((calibrated.root / "config/calibration.yaml").read_text())["ensemble"]
    assert len(names) == len(chosen["ensemble"]) >= least
    assert list(dict.fromkeys(names)) == equals
    assert len({names.count(name) for name in equals}) == 1


def test_an_interruption_loses_no_finished_search(calibrated, tmp_path):
    again = calibrated.copied_to(tmp_path / "thirdbody")
    name = chosen_of(again)["interpretation"]
    again.put("config/config.yaml", "calibrated", f"config/calibrated/{name}.yaml")
    searches = again.root / "results/calibration" / NEARBY
    (searches / "seed1.csv").unlink()
    for follower in (f"{NEARBY}.yaml", "chosen.json", "ranking.csv", "adopted.txt"):
        (again.root / "results/calibration" / follower).unlink()
    before = again.stamps()
    run = again.snakemake("calibrate", *MINIMAL)
    assert run.returncode == 0, run.stdout + run.stderr
    after = again.stamps()
    searched = {name for name in after if name.endswith(".csv") and before.get(name) != after[name]}
    # samples begin at what the search has found
    names = ("seed1", "seed1_samples", "seed2_samples")
    made = {f"calibration/{NEARBY}/{name}.csv" for name in names}
    assert searched == made | {"calibration/ranking.csv"}
    assert files(again, "results/calibration") == files(calibrated, "results/calibration")


def test_a_held_out_statement_that_changes_searches_nothing_again(calibrated, tmp_path):
    again = calibrated.copied_to(tmp_path / "thirdbody")

    def jobs_after(file):
        again.rewrite(file, lambda text: text.replace("statement: ", "statement: Indeed, ", 1))
        asked = again.snakemake("calibrate", "--dry-run", "--quiet", "host", *MINIMAL)
        assert asked.returncode == 0, asked.stdout + asked.stderr
        return re.findall(r"^ *(?:check|local)?rule (\w+):", asked.stdout, re.MULTILINE)

    before = again.snakemake("calibrate", "--dry-run", "--quiet", "host", *MINIMAL).stdout
    searches = {"scatter_inputs", "search_inputs", "search_fold", "sample_inputs"}
    searches |= {"summarise_inputs", "choose_default"}
    assert not [name for name in searches if name in before]
    asked = jobs_after("config/held_out.yaml")
    assert searches.isdisjoint(asked)
    assert not searches.isdisjoint(jobs_after("config/claims.yaml"))
