"""The search for the unprinted inputs: what it minimises, what it finds, what it may not see."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.study.calibration import (
    Found,
    Objective,
    Reading,
    Unknown,
    acceptable,
    loss,
    spread_out,
)
from thirdbody.study.checks import MISSING_SCORE
from thirdbody.study.claims import VALIDATION, load_claims, referenced_conditions
from thirdbody.study.posterior import summary
from thirdbody.study.sampling import posterior_sample
from thirdbody.study.search import search

CONFIG = Path(__file__).parents[2] / "config"
CLAIMS = load_claims(CONFIG / "claims.yaml")
SETTINGS = read_yaml(CONFIG / "calibration.yaml")
BUDGET = {"scattered": 9, "population": 8, "evaluations": 300, "walkers": 8, "steps": 10}
LINEAR = Unknown("gap_ratio", (0.0, 4.0), (1.0, 2.0), False)
LOGARITHMIC = Unknown("summit_radius", (1e-6, 1e-2), (1e-5, 1e-4), True)
READING = Reading("two", {}, (LINEAR, LOGARITHMIC))


class Squares:
    """An objective that is the sum of the squares of its ``scores``."""

    def found(self, reading, positions):
        ends = np.repeat(self.scores(reading, positions)[:, None], 2, axis=1)
        return Found(self.value(reading, positions, ends), ends)

    def value(self, reading, positions, ends):
        return float(np.sum(np.abs(ends).max(axis=1) ** 2))


class Valley(Squares):
    """Two inputs are to be 1.5 and 1e-4, the second is hardly seen."""

    def scores(self, reading, positions):
        values = reading.values(positions)
        second = np.log10(values["summit_radius"]) + 4.0
        return np.array([4.0 * (values["gap_ratio"] - 1.5), 0.02 * second])


# ---- the objective


@pytest.mark.parametrize("unknown", [LINEAR, LOGARITHMIC])
def test_positions_and_values_are_inverse_and_span_the_bounds(unknown):
    assert_allclose([unknown.value(0.0), unknown.value(1.0)], unknown.bounds)
    for position in np.linspace(0.0, 1.0, 7):
        assert unknown.position(unknown.value(position)) == pytest.approx(position, abs=1e-12)


def test_what_is_unusual_is_penalised_and_what_is_usual_is_not():
    assert LINEAR.penalty(1.0) == LINEAR.penalty(1.7) == LINEAR.penalty(2.0) == 0.0
    assert LINEAR.penalty(4.0) == pytest.approx(4.0)  # two widths beyond
    assert LOGARITHMIC.penalty(1e-6) == pytest.approx(1.0)  # a decade below
    assert LOGARITHMIC.penalty(1e-2) == pytest.approx(4.0)


def test_the_loss_grows_with_the_score_and_lets_no_miss_drown_the_others():
    scores = np.linspace(0.0, 10.0, 200)
    assert loss(0.0) == 0.0
    assert (np.diff(loss(scores)) > 0.0).all()
    assert loss(10.0) < 2.5


def test_validation_statements_never_enter_the_objective(parameters):
    objective = Objective.of(CLAIMS, SETTINGS, parameters)
    assert {claim.role for claim in objective.claims} == {"calibration"}
    fitted = [claim for claim in CLAIMS if claim.role == "calibration" and not claim.aside]
    assert list(objective.claims) == fitted
    # neither by what they say nor by the conditions that they speak of
    spoilt = tuple(
        replace(claim, published=1e9, tolerance=1e-9) if claim.role == VALIDATION else claim
        for claim in CLAIMS
    )
    other = Objective.of(spoilt, SETTINGS, parameters)
    assert other.claims == objective.claims
    assert objective.asked == referenced_conditions(objective.claims)


def test_the_objective_adds_up_losses_by_weight_and_penalties(parameters):
    objective = Objective.of(CLAIMS, SETTINGS, parameters)
    scores = np.linspace(0.0, 3.0, len(objective.claims))
    ends, losses = np.column_stack([-scores, 0.5 * scores]), objective.weights @ loss(scores)
    assert objective.value(READING, [0.3, 0.5], ends) == pytest.approx(losses)
    assert objective.value(READING, [0.3, 0.5], -ends) == pytest.approx(losses)
    beyond = sum(map(Unknown.penalty, READING.unknowns, READING.values([1.0, 1.0]).values()))
    assert objective.value(READING, [1.0, 1.0], ends) == pytest.approx(losses + beyond)


def test_scores_tell_on_which_side_of_a_published_number_they_are(parameters):
    """A turning point at a lower and one at a higher load are told apart, and not in the objective."""
    reading = Reading.of("uncentred_summit_wide_full_total", SETTINGS)
    dry = next(claim for claim in CLAIMS if claim.id == "fig11a-turning-point-load-dry")
    default = [unknown.position(getattr(parameters, unknown.name)) for unknown in reading.unknowns]
    low, high = (
        Objective.of([replace(dry, published=load)], SETTINGS, parameters).found(reading, default)
        for load in (1.0, 1e-12)
    )
    assert low.ends.min() < -1.0
    assert high.ends.min() > 1.0
    assert low.objective > 1.0
    assert high.objective > 1.0


def test_statements_that_are_watched_change_nothing_of_what_is_minimised(parameters):
    reading = Reading.of("uncentred_summit_wide_full_total", SETTINGS)
    middle = np.full(len(reading.unknowns), 0.5)
    alone, beside = (
        Objective.of(CLAIMS, SETTINGS, parameters, watched=watched).found(reading, middle)
        for watched in (False, True)
    )
    assert np.array_equal(alone.ends, beside.ends)
    assert alone.beside.size == 0
    assert beside.beside.size == sum(claim.role == VALIDATION for claim in CLAIMS)
    assert (beside.beside >= 0.0).all()


def test_inputs_without_a_surface_miss_every_statement(parameters):
    reading = Reading.of("uncentred_summit_wide_full", SETTINGS)
    reading = replace(reading, fixed=reading.fixed | {"summit_offset": True})
    objective = Objective.of(CLAIMS, SETTINGS, replace(parameters, summit_parameter_exponent=0.0))
    corner = np.zeros(len(reading.unknowns))  # summits too few for the offset to leave a variance
    corner[1] = 1.0
    found = objective.found(reading, corner)
    assert (found.ends == MISSING_SCORE).all()
    assert found.objective == objective.value(reading, corner, found.ends)
    assert np.isfinite(found.objective)


def test_statements_that_repeat_one_another_share_one_weight(parameters):
    objective = Objective.of(CLAIMS, SETTINGS, parameters)
    clusters = {}
    for claim, weight in zip(objective.claims, objective.weights, strict=True):
        of_kind = SETTINGS["weights"].get(claim.kind, 1.0)
        clusters.setdefault(claim.cluster or claim.id, []).append(weight / of_kind)
    assert max(map(len, clusters.values())) > 2
    assert_allclose([sum(shares) for shares in clusters.values()], 1.0)


def test_what_a_reading_fixes_it_does_not_search():
    exact = Reading.of("uncentred_surface_wide_full_exact", SETTINGS)
    names = {unknown.name for unknown in exact.unknowns}
    assert names == {*SETTINGS["always"], "elastic_depth_ratio"} - exact.fixed.keys()
    for name in SETTINGS["readings"]:
        reading = Reading.of(name, SETTINGS)
        for unknown in reading.unknowns:
            assert unknown.name not in reading.fixed, (name, unknown.name)


# ---- the search


def test_a_search_finds_what_minimises_the_objective():
    rows = search(READING, Valley(), BUDGET, 1, report=lambda line: None)
    best = READING.values(rows[np.argmin(rows[:, -1]), :-1])
    assert best["gap_ratio"] == pytest.approx(1.5, abs=0.03)
    assert len(rows) < BUDGET["evaluations"] + 8 * BUDGET["population"]


def test_a_seed_fixes_every_evaluation():
    rows = [search(READING, Valley(), BUDGET, seed, report=lambda line: None) for seed in (1, 1, 2)]
    assert np.array_equal(rows[0], rows[1])
    assert not np.array_equal(rows[0][: len(rows[2])], rows[2][: len(rows[0])])


def test_progress_is_told():
    told = []
    search(READING, Valley(), BUDGET, 1, report=told.append)
    assert told
    assert told[0].startswith("two seed 1: 50 evaluations, best ")


def test_a_search_of_the_real_model_repeats_itself(parameters):
    settings = SETTINGS | {"always": ["summit_parameter", "spread_ratio"]}
    settings["readings"] = {"few": {**SETTINGS["readings"]["uncentred_summit_wide_full"]}}
    reading = Reading.of("few", settings)
    objective = Objective.of(CLAIMS, settings, parameters)
    budget = BUDGET | {"scattered": 3, "population": 5, "evaluations": 15, "walkers": 6, "steps": 2}
    one, other = (search(reading, objective, budget, 3, report=lambda line: None) for _ in range(2))
    assert np.array_equal(one, other)
    assert one[:, -1].min() < one[0, -1] + 1e-12
    drawn = [
        posterior_sample(reading, objective, one, budget, 3, report=lambda line: None)
        for _ in range(2)
    ]
    assert np.array_equal(*drawn)
    assert drawn[0].shape == (12, len(reading.unknowns) + 1)


# ---- what it found


def test_acceptable_sets_are_near_the_best_each_once():
    rows = np.array([[0.1, 3.0], [0.2, 1.0], [0.2, 1.0], [0.3, 2.5], [0.4, 9.0]])
    assert acceptable(rows, 2.0).tolist() == [[0.2, 1.0], [0.3, 2.5], [0.1, 3.0]]


def test_an_ensemble_starts_with_the_best_and_spreads():
    rows = np.array([[0.5, 1.0], [0.51, 1.1], [0.0, 1.2], [1.0, 1.3]])
    assert spread_out(rows, 3)[:, 0].tolist() in ([0.5, 0.0, 1.0], [0.5, 1.0, 0.0])
    assert len(spread_out(rows, 9)) == 4


def test_samples_have_the_density_that_the_objective_gives():
    """The scores of the valley are standard normal deviates: so are the samples."""
    budget = BUDGET | {"walkers": 16, "steps": 300}
    rows = search(READING, Valley(), BUDGET, 1, report=lambda line: None)
    drawn = posterior_sample(READING, Valley(), rows, budget, 1, report=lambda line: None)
    ratio = np.array([READING.values(row)["gap_ratio"] for row in drawn[:, :-1]])
    scores = 4.0 * (ratio - 1.5)
    assert ratio.mean() == pytest.approx(1.5, abs=0.05)
    assert scores.std() == pytest.approx(np.sqrt(0.5), rel=0.1)


def test_few_evaluations_are_lost_where_others_tell_what_they_give():
    """Scores that are straight lines are guessed well: most steps that are evaluated are taken."""
    asked = []

    class Counted(Valley):
        def found(self, reading, positions):
            asked.append(positions)
            return super().found(reading, positions)

    rows = search(READING, Valley(), BUDGET, 1, report=lambda line: None)
    budget = BUDGET | {"walkers": 20, "steps": 200}
    drawn = posterior_sample(READING, Counted(), rows, budget, 1, report=lambda line: None)
    last = len(drawn) // 2
    assert len(np.unique(drawn[-last:], axis=0)) > 0.7 * last
    assert len(asked) <= 20 * 201


def test_samples_pass_from_one_valley_to_another():
    """Two valleys that no small step joins hold as many samples as their widths say."""

    class Valleys(Squares):
        def scores(self, reading, positions):
            narrow, wide = (positions - [0.2, 0.5]) / 0.02, (positions - [0.8, 0.5]) / 0.04
            return np.array([min(np.linalg.norm(narrow), np.linalg.norm(wide))])

    # a search saw both, and most of it the narrow one
    starts = np.array(
        [[0.2, 0.5, 0.0], *([0.2, 0.5 + 0.002 * n, 0.01] for n in range(6)), [0.8, 0.5, 0.0]]
    )
    budget = BUDGET | {"walkers": 16, "steps": 400}
    drawn = posterior_sample(READING, Valleys(), starts, budget, 1, report=lambda line: None)
    assert len(drawn) == 16 * 300
    assert (drawn[:, 0] > 0.5).mean() == pytest.approx(0.8, abs=0.04)  # areas as 4 to 1


def test_samples_tell_their_progress():
    told = []
    rows = search(READING, Valley(), BUDGET, 1, report=lambda line: None)
    posterior_sample(READING, Valley(), rows, BUDGET | {"steps": 20}, 1, report=told.append)
    assert told == [f"two seed 1: 20 of 20 steps of {BUDGET['walkers']} walkers"]


def test_a_summary_tells_what_is_identified_and_what_is_not():
    searches = [
        search(READING, Valley(), BUDGET, seed, report=lambda line: None) for seed in (1, 2)
    ]
    samples = [
        posterior_sample(READING, Valley(), rows, BUDGET, seed, report=lambda line: None)
        for seed, rows in enumerate(searches)
    ]
    fronts = [{"one": [[0.5, 9.0], [2.0, 4.0]]}, {"one": [[1.0, 9.5], [1.5, 5.0]]}]
    settings = {"acceptance": 0.02, "ensemble": 4}
    found = summary(READING, searches, samples, fronts, settings, lambda sets: sets[0])
    assert found["fronts"] == {"one": [[0.5, 9.0], [1.5, 5.0], [2.0, 4.0]]}
    assert found["inputs"]["gap_ratio"] == pytest.approx(1.5, abs=0.03)
    assert found["identification"]["gap_ratio"]["identified"]
    assert not found["identification"]["summit_radius"]["identified"]
    assert found["evaluations"] == sum(map(len, searches))
    assert found["objective"] == min(found["objective_of_each_seed"])
    assert len(found["ensemble"]) == 4
    assert found["objective_of_each_member"][0] == found["objective"]
    low, high = found["identification"]["summit_radius"]["acceptable"]
    assert all(low <= member["summit_radius"] <= high for member in found["ensemble"])
