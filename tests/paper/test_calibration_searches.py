"""Which searches a calibration has, and from what each starts."""

import pytest

from chenhorng.calibration.searches import Searches

SETTINGS = {
    "seeds": [1, 2],
    "interpretations": {"wide": {}, "near": {"nearby": "wide"}, "far": {"nearby": "near"}},
    "profiles": [
        {"of": "near", "along": "reach", "levels": [4.0]},
        {"of": "far", "along": "reach", "levels": [5.0]},
    ],
}
FOLDER = "<results>/calibration"


@pytest.fixture
def searches():
    return Searches(SETTINGS)


def test_a_wide_search_starts_from_scattered_inputs_and_another_from_what_was_found(searches):
    assert searches.starts("wide") == [f"{FOLDER}/wide/scattered.csv"]
    assert searches.starts("near") == [f"{FOLDER}/wide/seed{seed}.csv" for seed in (1, 2)]
    assert searches.starts("far") == [f"{FOLDER}/near/seed1.csv"]  # a nearby search has one seed


def test_a_fold_starts_from_scattered_inputs_or_from_the_same_fold(searches):
    assert searches.starts_of_fold("wide", 0) == [f"{FOLDER}/wide/scattered.csv"]
    assert searches.starts_of_fold("near", 0) == [f"{FOLDER}/wide/fold0.csv"]
    assert searches.starts_of_fold("far", 1) == [f"{FOLDER}/near/fold1.csv"]


def test_a_job_has_the_settings_of_its_interpretation_and_of_that_where_it_starts(searches):
    settings = searches.settings_of("near")
    assert settings["interpretations"] == {"near": {"nearby": "wide"}, "wide": {}}
    assert settings["seeds"] == [1, 2]


def test_a_profile_has_the_levels_of_its_entry(searches):
    assert searches.levels("near", "reach") == [4.0]
    assert searches.levels("far", "reach") == [5.0]
