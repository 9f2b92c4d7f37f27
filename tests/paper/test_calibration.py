"""The search for the unprinted inputs: what it minimises, what it finds, what it may not see."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import yaml
from numpy.testing import assert_allclose

from chenhorng.calibration.adoption import calibrated_text, library_text
from chenhorng.calibration.calibration import (
    Interpretation,
    Objective,
    Unknown,
    loss,
    make_folds,
)
from chenhorng.calibration.choice import (
    Candidate,
    excess_over,
    largest_summit_parameter,
    left_out_losses,
    printed_numbers,
    rank_interpretations,
)
from chenhorng.calibration.profile import (
    Held,
    along_the_means,
    largest_size,
    mean_square,
    profile,
    quantity,
)
from chenhorng.calibration.results import fold_members, summary
from chenhorng.calibration.search import (
    _loss,
    _wide_loss,
    best_of,
    find_inputs,
    nearby_starts,
    posterior_sample,
    rank_starts,
    scattered_starts,
    search,
)
from chenhorng.claims.claim import Verdict
from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge
from chenhorng.claims.kinds import Absence, Value, Window
from chenhorng.configuration.inputs import uncalibrated_values
from chenhorng.tables import TABLES
from thirdbody.core.parameters import Parameters
from thirdbody.files import read_yaml
from thirdbody.inputs import CALIBRATED_FILE, load_parameters

CONFIG = Path(__file__).parents[2] / "config"
CLAIMS = load_claims(CONFIG / "claims.yaml")
SETTINGS = read_yaml(CONFIG / "calibration.yaml")
NAMES = list(SETTINGS["interpretations"])
LINEAR = Unknown("mean_ratio", (0.0, 4.0), (1.0, 2.0), False)
RADIUS = Unknown("summit_radius", (1e-6, 1e-2), (1e-5, 1e-4), True)
TWO = Interpretation("two", {}, (LINEAR, RADIUS))
BUDGET = {"scattered": 40, "evaluations": 100, "elastic_radius": 5e-5}
BUDGET |= {"starts": 3, "descents": 1, "hops": 1, "iterations": 20}


HALVES = slice(40), slice(40, None)


def valley(interpretation, positions):
    """Least where two inputs are 1.5 and 1e-4, of which the second is hardly seen."""
    values = interpretation.values(positions)
    second = np.log10(values["summit_radius"]) + 4.0
    return float((4.0 * (values["mean_ratio"] - 1.5)) ** 2 + (0.02 * second) ** 2)


def searched(seed=1):
    return search(TWO, valley, np.array([0.1, 0.9]), BUDGET, seed)


@pytest.mark.parametrize("unknown", [LINEAR, RADIUS])
def test_positions_and_values_are_inverse_and_span_the_bounds(unknown):
    assert_allclose([unknown.value(0.0), unknown.value(1.0)], unknown.bounds)
    for position in np.linspace(0.0, 1.0, 7):
        assert unknown.position(unknown.value(position)) == pytest.approx(position, abs=1e-12)


def test_unusual_values_are_penalised():
    assert LINEAR.penalty(1.0) == LINEAR.penalty(2.0) == 0.0
    assert LINEAR.penalty(4.0) == pytest.approx(4.0)  # two widths beyond
    assert RADIUS.penalty(1e-6) == pytest.approx(1.0)  # a decade below
    assert TWO.penalty({"mean_ratio": 4.0, "summit_radius": 1e-6}) == pytest.approx(5.0)


def test_the_loss_grows_with_the_score_and_no_miss_outweighs_the_others():
    losses = loss(np.linspace(0.0, 10.0, 200))
    assert losses[0] == 0.0 and losses[-1] < 2.5
    assert (np.diff(losses) > 0.0).all()


def test_the_objective_adds_up_weighted_losses_and_penalties(parameters):
    objective = Objective.of(CLAIMS, SETTINGS, parameters.as_dict())
    assert not any(claim.aside for claim in objective.claims)
    interpretation = Interpretation.of(NAMES[0], SETTINGS)
    inputs = {each.name: (each.usual[1] + each.bounds[1]) / 2 for each in interpretation.unknowns}
    inputs = interpretation.values(interpretation.positions(inputs))
    scores = objective.scores(interpretation, inputs)
    expected = interpretation.penalty(inputs) + objective.weights @ loss(scores)
    assert objective(interpretation, interpretation.positions(inputs)) == pytest.approx(expected)
    parts = [objective.losses(scores[part], objective.claims[part]) for part in HALVES]
    assert interpretation.penalty(inputs) + np.concatenate(parts).sum() == pytest.approx(expected)


def test_statements_that_repeat_one_another_share_one_weight(parameters):
    objective = Objective.of(CLAIMS, SETTINGS, parameters.as_dict())
    clusters = {}
    for claim, weight in zip(objective.claims, objective.weights, strict=True):
        of_kind = SETTINGS["weights"].get(claim.kind, 1.0)
        clusters.setdefault(claim.counted_as, []).append(weight / of_kind)
    assert max(map(len, clusters.values())) > 2
    assert_allclose([sum(shares) for shares in clusters.values()], 1.0)
    assert sum(clusters["window-on-300nm"]) == pytest.approx(1.0)
    assert len(clusters["window-on-300nm"]) > 1


@pytest.mark.parametrize("name", NAMES)
def test_an_interpretation_searches_what_it_does_not_fix(name):
    interpretation = Interpretation.of(name, SETTINGS)
    searched = [unknown.name for unknown in interpretation.unknowns]
    assert searched == [each for each in SETTINGS["always"] if each not in interpretation.fixed]
    # with what is printed or assumed, that is all inputs
    known = uncalibrated_values().keys()
    assert not known & set(searched)
    assert known | set(searched) | interpretation.fixed.keys() == {*Parameters.names()}


def spoilt_number(published):
    """The field ``published`` of a statement with other content of its kind; none for one
    without."""
    if published is None:
        return {}
    if isinstance(published, float):
        return {"published": 1e9}
    return {"published": ["full_film"] if isinstance(published[0], str) else [1e8, 1e9]}


def test_no_fold_sees_what_it_is_judged_on(parameters):
    folds = make_folds(CLAIMS, SETTINGS["folds"])
    left_out = [claim.id for fold in folds for claim in fold.left_out]
    assert sorted(left_out) == sorted(claim.id for claim in CLAIMS)  # each exactly once
    base = parameters.as_dict()
    every = Objective.without(None, CLAIMS, SETTINGS, base).claims
    assert every == [claim for claim in CLAIMS if not (claim.aside or claim.impossible)]
    for number, (figures, fold) in enumerate(zip(SETTINGS["folds"], folds, strict=True)):
        seen = Objective.without(number, CLAIMS, SETTINGS, base).claims
        assert seen == [claim for claim in fold.fitted if claim in every]
        names = {claim.counted_as for claim in fold.left_out}
        for claim in fold.fitted:
            assert not claim.all_figures & set(figures), claim.id
            assert claim.counted_as not in names, claim.id
        # whatever the judged statements say, the search minimises the same
        wrong = {"statement": "wrong", "tolerance": 1e-9, "tolerance_kind": "absolute"}
        spoilt = [
            replace(claim, **wrong, **spoilt_number(claim.published)) for claim in fold.left_out
        ]
        spoilt += [claim for claim in CLAIMS if claim not in fold.left_out]
        again = make_folds(spoilt, [figures])[0].fitted
        one, other = (
            Objective.of(each, SETTINGS, parameters.as_dict()) for each in (fold.fitted, again)
        )
        assert one.claims == other.claims
        assert np.array_equal(one.weights, other.weights)


def test_a_search_finds_what_minimises_the_objective():
    rows = searched()
    best = TWO.values(rows[np.argmin(rows[:, -1]), :-1])
    assert best["mean_ratio"] == pytest.approx(1.5, abs=0.03)
    assert len(rows) < (2 * BUDGET["evaluations"] + 20)  # the last generation may exceed it
    assert np.array_equal(rows, searched())  # the seed fixes every evaluation
    assert not np.array_equal(rows[:9], searched(2)[:9])


class Valley:
    """Two statements, whose scores vanish at 1.5 and 1e-4, and a third that never holds."""

    weights = np.array([1.0, 1.0, 1.0])

    def scores(self, interpretation, inputs):
        second = np.log10(inputs["summit_radius"]) + 4.0
        return np.abs([8.0 * (inputs["mean_ratio"] - 1.5), 3.0 * second, 10.0])

    def value(self, penalty, scores):
        return float(penalty + self.weights @ loss(scores))

    def __call__(self, interpretation, positions):
        inputs = interpretation.values(positions)
        return self.value(0.0, self.scores(interpretation, inputs))


def test_descents_and_evolutions_find_the_deepest_valley():
    starts = np.array([[0.05, 0.9], [0.9, 0.1], [0.5, 0.95]])
    found = find_inputs(TWO, Valley(), starts, BUDGET, 1, seed=1)
    best = TWO.values(best_of(found)[:-1])
    assert best["mean_ratio"] == pytest.approx(1.5, abs=0.01)
    assert np.log10(best["summit_radius"]) == pytest.approx(-4.0, abs=0.02)
    assert np.array_equal(found, find_inputs(TWO, Valley(), starts, BUDGET, 1, seed=1))


def test_starts_are_ranked_by_the_statements_that_a_search_may_see(parameters):
    every = Objective.of(CLAIMS, SETTINGS, parameters.as_dict())
    fitted = make_folds(CLAIMS, SETTINGS["folds"])[0].fitted
    objective = Objective.of(fitted, SETTINGS, parameters.as_dict())
    scores = np.random.default_rng(1).random((5, len(every.claims)))
    seen = objective.take(every, scores)
    assert seen.shape == (5, len(objective.claims))
    hidden = [claim.id not in {each.id for each in objective.claims} for claim in every.claims]
    scores[:, hidden] = 9.0
    assert np.array_equal(seen, objective.take(every, scores))
    ranking = rank_starts(objective, np.outer([3.0, 1.0, 2.0], np.ones(len(objective.claims))))
    assert ranking.tolist() == [1, 2, 0]


def test_every_seed_has_starts_of_its_own_and_a_fold_those_of_all(parameters):
    every = Objective.of(CLAIMS, SETTINGS, parameters.as_dict())
    settings = SETTINGS | {"seeds": [7, 8], "budget": {"starts": 2}}
    places = np.arange(6.0)[:, None] * [0.1, 0.01]
    order = [4, 1, 5, 0, 2, 3]  # the best first
    scores = np.outer(1.0 + np.argsort(order), np.ones(len(every.claims)))
    rows = np.hstack([places, scores])
    for seeds, expected in (([7], [4, 5]), ([8], [1, 0]), ([7, 8], [4, 5, 1, 0])):
        starts = scattered_starts(every, every, rows, settings, seeds)
        assert_allclose(starts, places[expected])
    # statements of the fold, here all but the first, do not choose its starts
    scores[3] = 0.0
    scores[3, 0] = 9.0
    rows = np.hstack([places, scores])
    fold = Objective.of([every.claims[0]], SETTINGS, parameters.as_dict())
    assert_allclose(scattered_starts(fold, every, rows, settings, [7])[0], places[4])
    assert_allclose(scattered_starts(every, every, rows, settings, [7])[0], places[3])


def test_a_search_starts_where_what_it_is_near_to_is_best():
    wide = Unknown("mean_ratio", (0.0, 8.0), (1.0, 2.0), False)
    other = Interpretation("other", {"summit_radius": 1e-4}, (wide,))
    rows = np.array([[0.1, 5.0], [0.25, 1.0], [0.9, 3.0]])
    (start,) = nearby_starts(TWO, other, rows)
    assert TWO.values(start) == pytest.approx({"mean_ratio": 2.0, "summit_radius": 1e-4})


@pytest.mark.parametrize("loss_of", [_loss, _wide_loss])
def test_losses_of_least_squares_have_their_derivatives(loss_of):
    squares, step = np.geomspace(1e-4, 90.0, 40), 1e-6
    _, first, second = loss_of(squares)
    ahead, behind = loss_of(squares * (1.0 + step)), loss_of(squares * (1.0 - step))
    assert_allclose((ahead[0] - behind[0]) / (2.0 * step * squares), first, rtol=1e-5)
    assert_allclose((ahead[1] - behind[1]) / (2.0 * step * squares), second, rtol=1e-4, atol=1e-7)
    assert_allclose(_loss(squares)[0], loss(np.sqrt(squares)), rtol=1e-12)


def test_samples_have_the_density_that_the_objective_gives():
    starts = np.random.default_rng(0).random((16, 2))
    drawn, again = (posterior_sample(TWO, valley, starts, 300, 1) for _ in range(2))
    assert np.array_equal(drawn, again)
    assert drawn.shape == (225 * 16, 3)
    ratio = np.array([TWO.values(row)["mean_ratio"] for row in drawn[:, :-1]])
    assert ratio.mean() == pytest.approx(1.5, abs=0.05)
    assert (4.0 * ratio).std() == pytest.approx(np.sqrt(0.5), rel=0.1)
    assert_allclose(drawn[:, -1], [valley(TWO, row[:-1]) for row in drawn], rtol=1e-12)


def test_walkers_start_at_one_largest_size_and_one_mean_square():
    free = Interpretation.of("free", SETTINGS)
    inputs = {"mean_ratio": 0.1, "spread_ratio": 0.37, "participation": 0.5}
    inputs |= {
        unknown.name: unknown.value(0.5) for unknown in free.unknowns if unknown.name not in inputs
    }
    known = free.fixed | inputs
    rows = [free.fixed | free.values(row) for row in along_the_means(free, inputs, 5)]
    assert [row["mean_ratio"] for row in rows] == pytest.approx([0.0, 0.15, 0.3, 0.45, 0.6])
    assert_allclose([largest_size(row) for row in rows], largest_size(known), rtol=1e-12)
    squares = [quantity("mean_square", row) for row in rows]
    assert_allclose(squares, quantity("mean_square", known), rtol=1e-9)
    assert len({row["summit_radius"] for row in rows}) == 1


def test_a_summary_is_a_valid_file_with_the_best_of_all_seeds_and_of_each_fold(tmp_path):
    searches = [searched(seed) for seed in (1, 2)]
    folds = [searches[0][:50]] * len(SETTINGS["folds"])
    found = summary(TWO, searches, folds, CLAIMS, SETTINGS)
    assert found["inputs"]["mean_ratio"] == pytest.approx(1.5, abs=0.1)
    least = min(rows[:, -1].min() for rows in searches)
    assert found["objective"] == pytest.approx(least, rel=1e-5)
    assert found["objective"] == min(found["objective_of_each_seed"])
    assert [fold["figures"] for fold in found["folds"]] == SETTINGS["folds"]
    left_out = [id for fold in found["folds"] for id in fold["left_out"]]
    assert sorted(left_out) == sorted(claim.id for claim in CLAIMS)
    path = tmp_path / "two.yaml"
    path.write_text(yaml.safe_dump(found))
    assert read_yaml(path) == found


def test_members_come_evenly_from_each_fold_and_say_what_they_have_not_seen():
    one, other = (np.column_stack([np.linspace(low, low + 0.4, 41)] * 3) for low in (0.0, 0.5))
    members = fold_members(replace(TWO, fixed={"film_load": "fluid"}), [one, other], [[3], [4]], 3)
    assert [member["unseen"] for member in members] == [[3]] * 3 + [[4]] * 3
    ratios = [member["inputs"]["mean_ratio"] for member in members]
    assert ratios == pytest.approx([4.0 * place for place in (0.0, 0.2, 0.4, 0.5, 0.7, 0.9)])
    assert {member["inputs"]["film_load"] for member in members} == {"fluid"}


def test_the_members_of_a_fold_are_of_different_walkers():
    budget, count = SETTINGS["budget"], SETTINGS["ensemble"]["of_each_fold"]
    walkers = np.tile(np.arange(budget["walkers"]), budget["steps"] - budget["steps"] // 4)
    places = Interpretation("one", {}, (Unknown("mean_ratio", (0.0, 24.0), (0.0, 24.0), False),))
    rows = np.column_stack([walkers / 24.0, walkers])
    members = fold_members(places, [rows], [[3]], count)
    assert len({member["inputs"]["mean_ratio"] for member in members}) == count


def test_the_mean_square_of_the_sizes_is_that_of_the_truncated_distribution():
    inputs = {"mean_ratio": 0.3, "spread_ratio": 0.2, "truncation": 3.0}
    sizes = np.linspace(0.0, 0.9, 200_001)
    density = np.exp(-0.5 * ((sizes - 0.3) / 0.2) ** 2)
    expected = np.sum(density * sizes**2) / np.sum(density)
    assert mean_square(inputs) == pytest.approx(expected, rel=1e-4)


SIZES = Interpretation(
    "sizes",
    {"truncation": 4.0},
    (
        Unknown("mean_ratio", (0.0, 1.0), (0.0, 1.0), False),
        Unknown("spread_ratio", (0.02, 2.5), (0.02, 1.0), True),
        Unknown("elastic_depth_ratio", (0.01, 5.0), (0.01, 5.0), True),
        Unknown("participation", (0.002, 1.0), (0.002, 1.0), True),
    ),
)
BEST = {"mean_ratio": 0.4, "spread_ratio": 0.3, "elastic_depth_ratio": 2.8, "participation": 0.2}


def test_the_mean_moves_while_the_largest_size_stays():
    places = SIZES.positions(BEST)
    for mean in (0.0, 0.2, 0.6):
        inputs = SIZES.values([mean, *places[1:]])
        assert inputs["mean_ratio"] == mean
        assert largest_size({**SIZES.fixed, **inputs}) == pytest.approx(1.6)
    assert SIZES.positions(SIZES.values(places)) == pytest.approx(places)


@pytest.mark.parametrize(
    ("along", "level"), [("mean_ratio", 0.3), ("reach", 4.2), ("mean_square", 0.05)]
)
def test_what_is_held_has_its_level_wherever_the_others_are(along, level):
    held = Held.at(SIZES, along, level)
    assert len(held.unknowns) == 3
    for positions in 0.5 + 0.2 * np.random.default_rng(1).random((5, 3)):
        inputs = {**SIZES.fixed, **held.values(positions)}
        assert inputs["spread_ratio"] > 0.0
        assert quantity(along, inputs) == pytest.approx(level)


class OnTheReach:
    """An objective with scores for the reach, which shall be 4.4, and for the mean, 0.4."""

    weights = np.ones(2)

    def scores(self, interpretation, inputs):
        reach = quantity("reach", {**interpretation.fixed, **inputs})
        return np.array([20.0 * abs(reach - 4.4), 0.1 * abs(inputs["mean_ratio"] - 0.4)])

    def value(self, penalty, scores):
        return penalty + float(np.sum(loss(scores)))

    def __call__(self, interpretation, positions):
        inputs = interpretation.values(positions)
        return self.value(0.0, self.scores(interpretation, inputs))


def test_a_profile_is_narrow_in_what_is_determined_and_wide_in_what_others_make_up_for():
    levels = [0.0, 0.2, 0.4, 0.6, 0.8]
    wide = profile(SIZES, OnTheReach(), BEST, "mean_ratio", levels)
    assert [row["level"] for row in wide] == levels
    assert max(row["objective"] for row in wide) < 0.1
    # the others follow
    assert [quantity("reach", {**SIZES.fixed, **row}) for row in wide] == pytest.approx(
        [4.4] * 5, abs=0.02
    )
    narrow = profile(SIZES, OnTheReach(), BEST, "reach", [4.2, 4.4, 4.6])
    low, best, high = (row["objective"] for row in narrow)
    assert low > 0.9 and high > 0.9 and best < 0.05


def test_a_statement_that_was_in_no_search_is_not_predicted(parameters):
    """One of a reader's own, on a curve of the paper."""
    own = replace(CLAIMS[0], id="one-of-my-own")
    judge = Judge([CLAIMS[0], own], parameters.as_dict(), SETTINGS["newtons"])
    fold = {"figures": [4], "left_out": [CLAIMS[0].id], "inputs": {}}
    candidate = Candidate.of(judge, {"inputs": {}, "folds": [fold]})
    assert candidate.predicted.keys() == {CLAIMS[0].id}
    assert candidate.verdicts.keys() == {CLAIMS[0].id, own.id}


CURVE = {"viscosity_cSt": 0, "particle_diameter_nm": 0, "roughness_nm": 300}
CURVE["particle_density_per_m2"] = 0


def said(name, figure, made=Value, **fields):
    """A statement on a figure; one of a value prints 2, unless it is given what is
    ``published``."""
    fields = {
        "conditions": CURVE,
        "statement": "",
        "kind": "value",
        "quote": "",
        "reason": "",
    } | fields
    fields |= {"tolerance": 0.1, "tolerance_kind": "absolute"}
    if made is Value:
        fields = {"published": 2.0, "extreme": "minimum"} | fields
    if made is not Window:
        fields["quantity"] = "total_contact_area"
    return made(id=name, place=f"Figure {figure}A", **fields)


def missed_by(distance, *numbers):
    return Verdict("", distance, 0.0, numbers)


# losses of scores 1 and 2, and the distance with a score of 2
ONE, TWICE = 0.6, 16.0 / 17.0 + 0.2
E = float(np.e)


def test_what_was_left_out_is_lost_by_figure_with_the_weights_of_the_objective(parameters):
    claims = [
        said("four", 4),
        said("twin", 5, cluster="twins"),
        said("other", 5, cluster="twins"),
        said("also", 9, figures=[5]),
        said("aside", 4, aside="why", contradicts=["four"]),
        said("unseen", 6),
    ]
    settings = SETTINGS | {"weights": {"value": 4.0}}
    objective = Objective.of(claims, settings, parameters.as_dict())
    distances = {"four": 1.0, "twin": E, "other": 0.0, "also": 1.0, "aside": 9.0}
    predicted = {name: missed_by(distance) for name, distance in distances.items()}
    losses = left_out_losses(objective, predicted)
    assert losses.to_dict() == pytest.approx({4: 4.0 * ONE, 5: 2.0 * TWICE + 4.0 * ONE})
    assert left_out_losses(objective, {}).empty


def test_the_excess_has_the_standard_error_of_the_differences_by_figure():
    losses, least = (pd.Series(each, [4, 5, 6]) for each in ([3.0, 5.0, 1.0], [2.0, 2.0, 2.0]))
    # differences of 1, 3 and -1: variance 4, that of their sum 12
    assert excess_over(losses, least) == pytest.approx((3.0, 12.0**0.5))
    assert excess_over(least, least) == (0.0, 0.0)


class Told:
    """Judges statements by what is told of them in the inputs: the distance of each, and its
    number.
    """

    claims = tuple(said(f"in {figure}", figure) for figure in (4, 5, 6))
    newtons = 0.04, 80.0

    def __init__(self, parameters):
        self.base = parameters.as_dict()

    def __call__(self, inputs, effort=None, claims=None):
        some = self.claims if claims is None else claims
        told = zip(self.claims, inputs["distances"], strict=True)
        distances = {claim.id: distance for claim, distance in told}
        return {each.id: missed_by(distances[each.id], inputs["number"]) for each in some}


USUAL = {name: unknown["usual"][0] for name, unknown in SETTINGS["unknowns"].items()}


def made_up(name, predicted=(0.0, 0.0, 0.0), number=2.0, fitted=(0.0, 0.0, 0.0), **inputs):
    """A calibrated file; in its folds the statements are missed by the distances ``predicted``."""
    told = USUAL | inputs | {"distances": fitted, "number": number}
    folds = [
        {"left_out": [f"in {figure}"], "inputs": told | {"distances": predicted}}
        for figure in (4, 5, 6)
    ]
    return {
        "interpretation": name,
        "inputs": told,
        "folds": folds if predicted else [],
    }


MADE_UP = SETTINGS | {
    "interpretations": {
        name: {"fixed": {}} for name in ("least", "near", "far", "farther", "unseen")
    },
    "weights": {},
    "headline": ["in 4"],
}


@pytest.fixture
def told(parameters):
    return Told(parameters)


def ranked(judge, contents, settings=MADE_UP):
    candidates = [Candidate.of(judge, content) for content in contents]
    return rank_interpretations(judge, candidates, settings).set_index("interpretation")


CONTENTS = [
    made_up("unseen", predicted=(), number=2.0),
    made_up("farther", (E, E, E), number=2.0),
    made_up("far", (1.0, 1.0, 1.0), number=2.0),
    made_up("least", (0.0, 1.0, 0.0), number=2.4),
    made_up("near", (E, 0.0, 0.0), number=1.8, fitted=(0.5, E, 0.0)),
]


def test_interpretations_within_one_standard_error_of_the_least_loss_are_equal(told):
    """Of equals with as many unknowns the one with the least loss is first; the others follow by
    their losses."""
    table = ranked(told, CONTENTS)
    assert list(table.index) == ["least", "near", "far", "farther", "unseen"]
    assert table["equal"].tolist() == [True, True, False, False, False]
    losses = [ONE, TWICE, 3.0 * ONE, 3.0 * TWICE]
    assert table["left_out_loss"].tolist()[:4] == pytest.approx(losses, abs=0.005)
    excess = np.subtract(losses, ONE)
    assert table["above_least"].tolist()[:4] == pytest.approx(excess.tolist(), abs=0.005)
    differences = [[0.0] * 3, [TWICE, -ONE, 0.0], [ONE, 0.0, ONE], [TWICE, TWICE - ONE, TWICE]]
    errors = 3.0**0.5 * np.std(differences, axis=1, ddof=1)
    assert table["standard_error"].tolist()[:4] == pytest.approx(errors.tolist(), abs=0.005)
    assert table.loc["unseen", ["left_out_loss", "above_least", "standard_error"]].isna().all()


def test_the_table_of_interpretations_has_counts_and_deviations(told):
    table = ranked(told, CONTENTS)
    assert table["predicted"].tolist() == ["3/3", "2/3", "3/3", "0/3", "not cross-validated"]
    assert table.loc["near", ["fitted", "headline"]].tolist() == ["2/3", "1/1"]
    assert table["mean_deviation"].tolist() == pytest.approx([0.2, 0.1, 0.0, 0.0, 0.0])
    assert (table["mean_deviation"] == table["median_deviation"]).all()
    assert (table["unknowns"] == len(SETTINGS["always"])).all() and (table["penalty"] == 0.0).all()
    # the loss of scores 0.5, 2 and 0
    half = 0.5**4 / (1.0 + 0.5**4) + 0.05
    assert table.loc["near", "objective"] == pytest.approx(half + TWICE, abs=0.005)


def test_of_equals_the_most_parsimonious_is_first_then_the_least_loss_then_the_least_penalty(told):
    fewer = {"fixed": {"mean_ratio": 0.0, "participation": 0.5}}
    settings = MADE_UP | {
        "interpretations": {each: {"fixed": {}} for each in "abc"} | {"d": fewer, "e": fewer}
    }
    unusual = {"summit_parameter": 0.2}  # a penalty of the square of log10(2)
    contents = [
        made_up("a", (0.4, 0.0, 0.0), **unusual),
        made_up("b", (0.4, 0.0, 0.0)),
        made_up("c", (0.0, 0.5, 0.0)),
        made_up("d", (0.0, 0.0, 0.5)),
        made_up("e", (0.0, 0.42, 0.0)),
    ]
    table = ranked(told, contents, settings)
    assert table["equal"].all()
    assert list(table.index) == ["e", "d", "b", "a", "c"]
    every = len(SETTINGS["always"])
    assert table["unknowns"].tolist() == [every - 2, every - 2, every, every, every]
    assert table["penalty"].tolist() == pytest.approx([0.0, 0.0, 0.0, 0.09, 0.0])


@pytest.mark.parametrize(("exponent", "largest"), [(0.0, 0.05), (1.0, 0.25 / 3), (-1.0, 0.15)])
def test_the_largest_summit_parameter_is_that_at_an_end_of_the_roughness(exponent, largest):
    inputs = {"summit_parameter": 0.05, "summit_parameter_exponent": exponent}
    inputs |= {"reference_roughness": 300e-9}
    settings = {"roughness_nm": [100, 500]}
    assert largest_summit_parameter(inputs, settings) == pytest.approx(largest)


def test_each_printed_number_has_its_deviation_and_minus_one_if_the_model_has_none():
    missing = float("nan")
    window = said("window", 9, Window, published=[0.8, 1.25])
    claims = [
        said("value", 4),
        said("change", 4, published=-0.5),
        said("none", 5, published=-0.5),
        window,
        replace(window, id="half"),
        replace(window, id="no window"),
        said("wordless", 5, Absence),
        said("not asked", 5),
    ]
    verdicts = {
        "value": Verdict("", 1.0, 0.2, (2.0, 2.2), worst=1),
        "change": missed_by(1.0, -0.4),
        "none": missed_by(9.0),
        "window": missed_by(1.0, 1.0, 1.0),
        "half": missed_by(9.0, 0.8, missing),
        "no window": missed_by(9.0, missing, missing),
        "wordless": missed_by(0.0, 3.0),
        "not asked": missed_by(0.0, 3.0),
    }
    table = printed_numbers(claims, verdicts, [each.id for each in claims[:-1]])
    windows = ["window", "window", "half", "half", "no window", "no window"]
    assert table["id"].tolist() == ["value", "change", "none", *windows]
    assert table["printed"].tolist() == [2.0, -0.5, -0.5, *[0.8, 1.25] * 3]
    computed = [2.2, -0.4, missing, 1.0, 1.0, 0.8, missing, missing, missing]
    assert_allclose(table["computed"], computed)
    expected = [0.1, -0.2, -1.0, 0.25, -0.2, 0.0, -1.0, -1.0, -1.0]
    assert table["deviation"].tolist() == pytest.approx(expected, abs=1e-12)
    assert table["inside"].tolist() == ["no", "yes", *["no"] * 3, "yes", *["no"] * 3]
    assert table["place"].tolist()[-1] == "Figure 9A"
    assert [*table] == [column.name for column in TABLES["deviations"]]


def test_the_files_that_were_adopted_are_those_that_an_adoption_writes():
    default = read_yaml(CONFIG / "config.yaml")["calibrated"]
    library = CALIBRATED_FILE.read_text(encoding="utf-8")
    assert library == library_text(read_yaml(CONFIG.parent / default))
    for path in sorted(CONFIG.glob("calibrated/*.yaml")):
        assert path.read_text(encoding="utf-8") == calibrated_text(read_yaml(path)), path.name


def test_the_library_has_the_inputs_and_the_ensemble_of_the_default():
    default = load_parameters(CONFIG.parent / read_yaml(CONFIG / "config.yaml")["calibrated"])
    assert load_parameters() == default
    assert load_parameters().members == default.members
