"""The search for the unprinted inputs: what it minimises, what it finds, what it may not see."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml
from numpy.testing import assert_allclose

from thirdbody.configuration.inputs import read_calibrated, read_entries
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.study.calibration import Interpretation, Objective, Unknown, loss, make_folds
from thirdbody.study.choice import choose_default, mixed_ensemble, price_front
from thirdbody.study.claim import Verdict
from thirdbody.study.claims import load_claims
from thirdbody.study.judge import Judge
from thirdbody.study.results import acceptable, shortlist, summary
from thirdbody.study.search import (
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
from thirdbody.study.verdicts import Candidate

CONFIG = Path(__file__).parents[2] / "config"
CLAIMS = load_claims(CONFIG / "claims.yaml")
SETTINGS = read_yaml(CONFIG / "calibration.yaml")
DEFAULT = "fluid_natural"
LINEAR = Unknown("mean_ratio", (0.0, 4.0), (1.0, 2.0), False)
RADIUS = Unknown("summit_radius", (1e-6, 1e-2), (1e-5, 1e-4), True)
TWO = Interpretation("two", {}, (LINEAR, RADIUS))
BUDGET = {"scattered": 40, "evaluations": 100, "elastic_radius": 5e-5, "walkers": 16, "steps": 300}
BUDGET |= {"starts": 3, "descents": 1, "hops": 1, "nearby_hops": 1, "iterations": 20}


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
    interpretation = Interpretation.of(DEFAULT, SETTINGS)
    inputs = {each.name: (each.usual[1] + each.bounds[1]) / 2 for each in interpretation.unknowns}
    inputs = interpretation.values(interpretation.positions(inputs))
    losses = loss(objective.scores(interpretation, inputs))
    expected = interpretation.penalty(inputs) + objective.weights @ losses
    assert objective(interpretation, interpretation.positions(inputs)) == pytest.approx(expected)


def test_statements_that_repeat_one_another_share_one_weight(parameters):
    objective = Objective.of(CLAIMS, SETTINGS, parameters.as_dict())
    clusters = {}
    for claim, weight in zip(objective.claims, objective.weights, strict=True):
        of_kind = SETTINGS["weights"].get(claim.kind, 1.0)
        clusters.setdefault(claim.counted_as, []).append(weight / of_kind)
    assert max(map(len, clusters.values())) > 2
    assert_allclose([sum(shares) for shares in clusters.values()], 1.0)
    chosen = [claim.counted_as == "window-on-300nm" for claim in objective.claims]
    assert objective.repeating("fig09-window").tolist() == chosen


def test_an_interpretation_searches_what_it_does_not_fix():
    for name in SETTINGS["interpretations"]:
        interpretation = Interpretation.of(name, SETTINGS)
        assert not {unknown.name for unknown in interpretation.unknowns} & set(interpretation.fixed)
    natural = Interpretation.of("fluid_natural", SETTINGS)
    assert len(natural.unknowns) == 8
    values = {"apparent_area": 4.5e-6, "participation": 0.63662, "truncation": 4.0}
    assert values.items() <= natural.fixed.items()


def test_no_fold_sees_what_it_is_judged_on(parameters):
    folds = make_folds(CLAIMS, SETTINGS["folds"])
    left_out = [claim.id for fold in folds for claim in fold.left_out]
    assert sorted(left_out) == sorted(claim.id for claim in CLAIMS)  # each exactly once
    for figures, fold in zip(SETTINGS["folds"], folds, strict=True):
        names = {claim.counted_as for claim in fold.left_out}
        for claim in fold.fitted:
            assert not claim.all_figures & set(figures), claim.id
            assert claim.counted_as not in names, claim.id
        # whatever the judged statements say, the search minimises the same
        wrong = {"statement": "wrong", "tolerance": 1e-9}
        spoilt = [
            replace(claim, **wrong, **({"published": 1e9} if claim.published is not None else {}))
            for claim in fold.left_out
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


def test_the_shortlist_has_the_least_objectives_and_not_too_many():
    least = {"a": 70.0, "b": 58.0, "c": 61.0, "d": 90.0}
    assert shortlist(least, 20.0, 2) == ["b", "c"]
    assert shortlist(least, 5.0, 4) == ["b", "c"]


def test_samples_have_the_density_that_the_objective_gives():
    rows = searched()
    drawn = posterior_sample(TWO, valley, rows, BUDGET, 1)
    again = posterior_sample(TWO, valley, rows, BUDGET, 1)
    assert np.array_equal(drawn, again)
    assert drawn.shape == (225 * 16, 3)
    ratio = np.array([TWO.values(row)["mean_ratio"] for row in drawn[:, :-1]])
    assert ratio.mean() == pytest.approx(1.5, abs=0.05)
    assert (4.0 * ratio).std() == pytest.approx(np.sqrt(0.5), rel=0.1)


def test_acceptable_sets_are_near_the_best_each_once():
    rows = np.array([[0.1, 3.0], [0.2, 1.0], [0.2, 1.0], [0.3, 2.5], [0.4, 9.0]])
    assert acceptable(rows, 2.0).tolist() == [[0.2, 1.0], [0.3, 2.5], [0.1, 3.0]]


def test_a_summary_is_a_valid_file_and_reports_what_is_identified(tmp_path, parameters):
    searches = [searched(seed) for seed in (1, 2)]
    folds = [searches[0][:50]] * len(SETTINGS["folds"])
    samples = [rows[-40:] for rows in searches]
    settings = SETTINGS | {"acceptance": 0.02, "ensemble": 4}
    judge = Judge([], parameters.as_dict(), SETTINGS["newtons"])
    found = summary(TWO, judge, searches, samples, folds, settings)
    assert found["inputs"]["mean_ratio"] == pytest.approx(1.5, abs=0.1)
    assert found["identification"]["mean_ratio"]["identified"]
    assert not found["identification"]["summit_radius"]["identified"]
    assert [fold["figures"] for fold in found["folds"]] == SETTINGS["folds"]
    assert len(found["ensemble"]) == len(found["ensemble_interpretations"]) == 4
    path = tmp_path / "two.yaml"
    path.write_text(yaml.safe_dump(found))
    assert read_calibrated(path, read_entries()) == found


def test_the_price_of_a_number_is_a_front_that_falls(parameters):
    interpretation = Interpretation.of(DEFAULT, SETTINGS)
    objective = Objective.of(CLAIMS[:12], SETTINGS, parameters.as_dict())
    count, name = len(interpretation.unknowns), objective.claims[0].id
    rows = np.column_stack([np.random.default_rng(1).random((6, count)), np.arange(6.0)])
    start = interpretation.values(np.full(count, 0.5))
    front = np.array(price_front(interpretation, objective, name, rows, start))
    assert front.shape[1] == 2 and len(front) >= 1
    assert (np.diff(front[:, 0]) > 0.0).all() and (np.diff(front[:, 1]) < 0.0).all()


def test_an_ensemble_over_interpretations_takes_those_that_predict_as_much():
    shares = {"best": [0.9, 0.7], "near": [0.75, 0.75], "far": [0.5, 0.5]}
    ensemble = [{"truncation": 3.0}] * 4
    contents = [
        {"interpretation": name, "inputs": {"film_load": name}, "ensemble": ensemble}
        for name in shares
    ]
    members, labels = mixed_ensemble(contents, shares, 16)
    assert set(labels) == {"best", "near"} and labels.count("best") == 8
    assert [member["film_load"] for member in members] == labels


def test_predicted_statements_are_counted_in_the_fold_that_leaves_them_out():
    folds = make_folds(CLAIMS, SETTINGS["folds"])
    predicted = {claim.id: Verdict("", 9.0, 0.0) for claim in CLAIMS}
    predicted |= {claim.id: Verdict("", 0.0, 0.0) for claim in folds[1].left_out}
    found = Candidate(content={}, verdicts={}, predicted=predicted, folds=folds)
    first, (held, tested), *others = found.fold_counts
    assert held == tested == len({each.counted_as for each in folds[1].left_out if not each.aside})
    assert all(none == 0 < some for none, some in (first, *others))


def test_the_choice_is_what_predicts_most_and_prices_what_it_misses(parameters):
    dry, outside = "fig11a-turning-point-load-dry", "fig09a-no-turning-point-outside"
    claims = [claim for claim in CLAIMS if claim.id in (dry, outside)]
    settings = SETTINGS | {"ensemble": 3, "headline": [dry, outside]}
    settings["budget"] = {"evaluations": 2}
    content = read_yaml(CONFIG / "calibrated" / f"{DEFAULT}.yaml")
    right = content["inputs"]
    wrong = right | {"elastic_depth_ratio": 0.5}  # misses the load of the dry turning point
    figures = [9], [11]
    contents = [
        {"interpretation": name, "inputs": wrong, "ensemble": [{}]}
        | {"folds": [{"figures": each, "inputs": inputs} for each in figures]}
        for name, inputs in (("fluid_natural_all", wrong), (DEFAULT, right))
    ]
    judge = Judge(claims, parameters.as_dict(), SETTINGS["newtons"])
    chosen, table = choose_default(judge, contents, settings)
    assert table["interpretation"].tolist() == [DEFAULT, "fluid_natural_all"]
    assert table["predicted"].tolist() == ["2/2", "1/2"]
    assert chosen["interpretation"] == DEFAULT
    assert list(chosen["fronts"]) == [dry] and len(chosen["fronts"][dry]) >= 1
    assert chosen["ensemble"] == [wrong] * 3
    assert chosen["ensemble_interpretations"] == [DEFAULT] * 3
