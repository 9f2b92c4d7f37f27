"""`snakemake calibrate` for real, with a small budget: same seeds, same files; nothing done
twice."""

import csv
import json
from pathlib import Path

import pytest
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
    members = chosen_of(calibrated)["members"]
    for name, content in found.items():
        expected = yaml.safe_load(content)
        own = expected.pop("inputs")
        expected["ensemble"] = [own, *(member["inputs"] for member in members)]
        expected["unseen"] = [[], *(member["unseen"] for member in members)]
        content = yaml.safe_load(adopted[name])
        inputs = content.pop("inputs")  # with those that no search finds
        assert inputs.items() >= own.items()
        assert content == expected
        parameters = load_parameters(calibrated.root / "config/calibrated" / name)
        assert inputs.items() <= parameters.best.as_dict().items()


def test_the_library_takes_the_default_of_the_ranking(calibrated):
    name = chosen_of(calibrated)["interpretation"]
    content = yaml.safe_load((calibrated.root / f"config/calibrated/{name}.yaml").read_text())
    library = calibrated.root / "src/thirdbody/calibrated.yaml"
    assert library.read_text(encoding="utf-8") == library_text(content)


def test_the_first_of_the_ranking_is_chosen_and_no_member_has_seen_all_figures(calibrated):
    chosen = chosen_of(calibrated)
    with open(calibrated.root / "config/calibrated/ranking.csv", newline="") as stream:
        ranking = list(csv.DictReader(stream))
    assert {row["interpretation"] for row in ranking} == set(INTERPRETATIONS)
    assert chosen["interpretation"] == ranking[0]["interpretation"]
    for row in ranking:
        is_equal = float(row["above_least"]) <= float(row["standard_error"])
        assert (row["equal"] == "True") == is_equal
    settings = yaml.safe_load((calibrated.root / "config/calibration.yaml").read_text())
    unseen = [member["unseen"] for member in chosen["members"]]
    assert unseen == [figures for figures in settings["folds"] for _ in range(2)]


def test_the_profile_is_kept_beside_the_calibrated_files(calibrated):
    with open(calibrated.root / "config/calibrated/profiles.csv", newline="") as stream:
        (row,) = csv.DictReader(stream)
    assert (row["interpretation"], row["along"], float(row["level"])) == (NEARBY, "reach", 4.4)
    inputs = {name: float(row[name]) for name in ("mean_ratio", "spread_ratio") if name in row}
    spread, mean = inputs["spread_ratio"], inputs.get("mean_ratio", 0.0)
    assert mean + 4.0 * spread + float(row["elastic_depth_ratio"]) == pytest.approx(4.4, rel=1e-4)


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
    # the profile begins at what the search has found
    made = {f"calibration/{NEARBY}/{name}.csv" for name in ("seed1", "profile_reach")}
    assert searched == made | {"calibration/ranking.csv"}
    assert files(again, "results/calibration") == files(calibrated, "results/calibration")


def test_a_held_out_statement_that_changes_searches_nothing_again(calibrated, tmp_path):
    again = calibrated.copied_to(tmp_path / "thirdbody")

    searches = "Scatter inputs", "Search inputs", "Sample inputs", "Summarise", "Choose the default"

    def is_searched_after(file):
        again.rewrite(file, lambda text: text.replace("statement: ", "statement: Indeed, ", 1))
        asked = again.snakemake("calibrate", "--dry-run", *MINIMAL)
        assert asked.returncode == 0, asked.stdout + asked.stderr
        return any(words in asked.stdout + asked.stderr for words in searches)

    assert not is_searched_after("config/held_out.yaml")
    assert is_searched_after("config/claims.yaml")
