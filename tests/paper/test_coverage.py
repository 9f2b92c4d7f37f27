"""How often ranges are right about what their members have not seen."""

from dataclasses import replace

import numpy as np
import pandas as pd

from chenhorng.claims.claim import Verdict
from chenhorng.claims.claims import load_claims
from chenhorng.coverage import VARIABLES, printed_and_ranges, random_conditions, sets_and_ranges
from chenhorng.home import config_directory
from chenhorng.tables import TABLES
from thirdbody.ensembles import PAPER_SETUP, Ensemble
from thirdbody.files import read_yaml

CLAIMS = load_claims(config_directory() / "claims.yaml")
SETTINGS = read_yaml(config_directory() / "calibration.yaml")["coverage"]
IDS = "fig09-window", "fig11a-peak-ratio"  # of Figures 9 and 11


def verdicts(low, high, peak):
    """A member with a window and a peak on three curves."""
    return {
        "fig09-window": Verdict("", 0.0, 0.0, (low, high)),
        "fig11a-peak-ratio": Verdict("", 0.0, 0.0, (peak,) * 3),
    }


NUMBERS = pd.DataFrame(
    {
        "id": ["fig09-window", "fig09-window", "fig11a-peak-ratio"],
        "place": ["Figure 9", "Figure 9", "Figure 11A"],
        "statement": "statement",
        "printed": [0.83, 1.33, 0.2],
        "computed": [0.8, 1.3, 0.19],
    }
)


def test_a_number_is_held_against_the_members_that_have_not_seen_its_figure():
    best = verdicts(0.83, 1.33, 0.2)
    members = [best, *(verdicts(0.7 + 0.1 * k, 1.4 + 0.1 * k, 0.5) for k in range(5))]
    members += [verdicts(9.0, 9.0, 0.1 + 0.1 * k) for k in range(3)]
    unseen = [[], *[[9, 10]] * 5, *[[11]] * 3]
    rows = [*printed_and_ranges(CLAIMS, NUMBERS, members, unseen)]
    assert [row["members"] for row in rows] == [5, 5, 3]
    assert [row["inside"] for row in rows] == ["yes", "no", "yes"]
    # 5 and 95 % of 0.7, ..., 1.1, to three digits
    assert (rows[0]["low"], rows[0]["high"]) == (0.72, 1.08)
    assert (rows[2]["low"], rows[2]["high"]) == (0.11, 0.29)
    assert [*rows[0]] == [column.name for column in TABLES["coverage"]]


def test_a_range_has_the_digits_of_the_print():
    numbers = NUMBERS.iloc[:1].assign(printed=1.0)
    members = [verdicts(0.99999994 + 1e-9 * k, 1.0, 0.0) for k in range(4)]
    (row,) = printed_and_ranges(CLAIMS, numbers, members, [[9]] * 4)
    assert (row["low"], row["high"], row["inside"]) == (1.0, 1.0, "yes")


def test_random_conditions_lie_within_the_ends():
    conditions = random_conditions(SETTINGS | {"conditions": 50})
    for name, values in conditions.items():
        low, high = SETTINGS[name]
        assert len(values) == 50 and low <= values.min() < values.max() <= high
    again = random_conditions(SETTINGS | {"conditions": 50})
    assert all(np.array_equal(conditions[name], again[name]) for name in conditions)


def test_a_set_lies_within_the_range_of_its_like_and_another_does_not(parameters):
    spreads = np.linspace(0.95, 1.05, 9) * parameters.spread_ratio
    members = [replace(parameters, spread_ratio=spread) for spread in spreads]
    sets = {"same": parameters, "far": replace(parameters, spread_ratio=2 * spreads[-1])}
    conditions = random_conditions(SETTINGS | {"conditions": 20})
    rows = [*sets_and_ranges(Ensemble(members, PAPER_SETUP), sets, conditions)]
    assert [row["variable"] for row in rows] == [*VARIABLES] * 2
    shares = {(row["set"], row["variable"]): row["inside"] / row["conditions"] for row in rows}
    assert min(shares["same", name] for name in VARIABLES) > 0.9
    assert max(shares["far", name] for name in VARIABLES) < 0.5
    assert all(row["relative_width"] > 0.0 for row in rows)
    assert [*rows[0]] == [column.name for column in TABLES["coverage_of_sets"]]
