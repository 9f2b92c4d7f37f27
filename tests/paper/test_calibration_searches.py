"""Which searches a calibration has, and from what each starts."""

import json

import pytest

from chenhorng.calibration.searches import Searches

SETTINGS = {
    "seeds": [1, 2],
    "interpretations": {
        "wide": {},
        "near": {"nearby": "wide"},
        "far": {"nearby": "near"},
        "lone": {},
    },
}
FOLDER = "<results>/calibration"


@pytest.fixture
def searches(tmp_path):
    """Searches with one interpretation on the shortlist."""
    (tmp_path / "shortlist.json").write_text(json.dumps(["wide"]))
    return Searches(SETTINGS, lambda: str(tmp_path / "shortlist.json"))


def test_a_wide_search_starts_from_scattered_inputs_and_another_from_what_was_found(searches):
    assert searches.wide() == ["wide", "lone"]
    assert searches.starts("wide") == [f"{FOLDER}/wide/scattered.csv"]
    assert searches.starts("near") == [f"{FOLDER}/wide/seed{seed}.csv" for seed in (1, 2)]
    assert searches.starts("far") == [f"{FOLDER}/near/seed1.csv"]  # not on the shortlist: one seed
    assert searches.starts_of_fold("wide", 0) == [f"{FOLDER}/wide/scattered.csv"]
    assert searches.starts_of_fold("near", 0) == [f"{FOLDER}/wide/fold0.csv"]


def test_what_starts_from_the_shortlist_is_cross_validated(searches):
    checked = [name for name in SETTINGS["interpretations"] if searches.is_cross_validated(name)]
    assert checked == ["wide", "near", "far"]


def test_a_job_has_the_settings_of_its_interpretation_and_of_that_where_it_starts(searches):
    settings = searches.settings_of("near")
    assert settings["interpretations"] == {"near": {"nearby": "wide"}, "wide": {}}
    assert settings["seeds"] == [1, 2]
