"""The files that developers edit: what one names, another has."""

from pathlib import Path

import pytest

from chenhorng.claims.departures import read_departures
from thirdbody.core.parameters import Parameters
from thirdbody.files import read_yaml
from thirdbody.inputs import ensemble_of

ROOT = Path(__file__).parents[2]
CONFIG = ROOT / "config"
CLAIMS = read_yaml(CONFIG / "claims.yaml", list)


def test_contradictions_are_settled():
    by_id = {claim["id"]: claim for claim in CLAIMS}
    for claim in CLAIMS:
        for other in claim.get("contradicts", []):
            assert claim["id"] in by_id[other]["contradicts"]
            assert "aside" in claim or "aside" in by_id[other], (claim["id"], other)


def test_inputs_that_are_searched_have_bounds():
    calibration = read_yaml(CONFIG / "calibration.yaml")
    interpretations = calibration["interpretations"].values()
    searched = [calibration["always"], *(one.get("unknowns", []) for one in interpretations)]
    assert {name for names in searched for name in names} <= calibration["unknowns"].keys()
    assert calibration["unknowns"].keys() <= {*Parameters.names()}
    for unknown in calibration["unknowns"].values():
        for low, high in (unknown["bounds"], unknown["usual"]):
            assert low < high


def test_what_the_calibration_names_is_there():
    calibration = read_yaml(CONFIG / "calibration.yaml")
    assert set(calibration["headline"]) <= {claim["id"] for claim in CLAIMS}
    assert calibration["kept"] <= len(calibration["interpretations"])
    for name in calibration["interpretations"]:
        way = [name]  # to the search from scattered sets, from which all others come in the end
        while nearby := calibration["interpretations"][way[-1]].get("nearby"):
            assert nearby not in way
            way.append(nearby)


@pytest.mark.parametrize(
    "path", sorted(CONFIG.glob("calibrated/*.yaml")), ids=lambda path: path.stem
)
def test_each_calibrated_file_has_all_inputs_and_members_within_bounds(path):
    content = read_yaml(path)
    assert content["interpretation"] == path.stem
    assert content["inputs"].keys() == {*Parameters.names()}
    assert len(content["ensemble"]) == len(content["unseen"])
    ensemble_of(content)  # refuses a number out of bounds


def test_each_departure_is_from_the_default():
    calibration, config = (read_yaml(CONFIG / f"{name}.yaml") for name in ("calibration", "config"))
    inputs = read_yaml(ROOT / config["calibrated"])["inputs"]
    for departure in read_departures(calibration, inputs):
        for name, value in departure["inputs"].items():
            assert inputs[name] != value, departure["name"]
