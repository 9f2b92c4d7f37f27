"""`snakemake calibrate` for real, with a small budget: same seeds, same files; nothing done twice."""

import json

import yaml
from workspace import INTERPRETATIONS, Workspace


def files(workspace: Workspace, pattern):
    return {path.name: path.read_bytes() for path in (workspace.root / pattern).glob("*.yaml")}


def test_what_is_found_is_adopted_for_the_default_run(calibrated):
    found = files(calibrated, "results/calibration")
    assert set(found) == {f"{name}.yaml" for name in INTERPRETATIONS}
    adopted = files(calibrated, "config/calibrated")
    chosen = json.loads((calibrated.root / "results/calibration/chosen.json").read_text())
    for name, content in found.items():
        expected = yaml.safe_load(content)
        expected |= chosen if expected["interpretation"] == chosen["interpretation"] else {}
        assert yaml.safe_load(adopted[name]) == expected
    assert len(chosen["ensemble"]) == len(chosen["ensemble_interpretations"])


def test_an_interruption_loses_no_finished_search(calibrated, tmp_path):
    again = calibrated.copied_to(tmp_path / "thirdbody")
    searches = again.root / "results/calibration/surface_natural"
    (searches / "seed2.csv").unlink()
    for follower in ("surface_natural.yaml", "chosen.json", "adopted.txt"):
        (again.root / "results/calibration" / follower).unlink()
    before = again.stamps()
    run = again.snakemake("calibrate")
    assert run.returncode == 0, run.stdout + run.stderr
    after = again.stamps()
    searched = {name for name in after if name.endswith(".csv") and before.get(name) != after[name]}
    # samples begin at what the searches of all seeds have found
    names = ("seed2", "seed1_samples", "seed2_samples")
    assert searched == {f"calibration/surface_natural/{name}.csv" for name in names}
    assert files(again, "results/calibration") == files(calibrated, "results/calibration")
