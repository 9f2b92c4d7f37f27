"""Fronts: what it costs the other statements that one of them holds, and how that is drawn."""

from pathlib import Path

import matplotlib.style
import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.figures.drawing import STYLE
from thirdbody.figures.fronts import plot as drawing_of
from thirdbody.study.calibration import Found, Objective, loss
from thirdbody.study.claims import VALIDATION, load_claims
from thirdbody.study.fronts import POINTS, Witness, merged

ROOT = Path(__file__).parents[2]
SETTINGS = read_yaml(ROOT / "config" / "calibration.yaml")
CLAIMS = load_claims(ROOT / "config" / "claims.yaml")
CHIEF = "fig11a-peak-ratio", "fig09-window", "fig05b-mixed-above-70cst"


@pytest.fixture
def objective(parameters):
    return Objective.of(CLAIMS, SETTINGS, parameters)


def found_with(objective, scores, beside=()):
    """What is found of inputs whose penalties are 0.5 and of all statements, whose scores are given."""
    ends = np.column_stack([scores, scores])
    return Found(0.5 + objective.weights @ loss(scores), ends, np.array(beside))


def test_a_witness_keeps_what_no_other_evaluation_surpasses(objective):
    witness = Witness(objective, CHIEF)
    name = next(iter(witness.fronts))
    place = [claim.id for claim in objective.claims].index(name)
    cluster = objective.claims[place].counted_as
    own = np.array([claim.counted_as == cluster for claim in objective.claims])
    for score, others in ((0.8, 0.9), (1.6, 0.5), (1.7, 0.6), (0.9, 1.2)):
        witness.see(found_with(objective, np.where(own, score, others)))
    front = witness.fronts[name][np.argsort(witness.fronts[name][:, 0])]
    assert_allclose(front[:, 0], [0.8, 1.6], rtol=1e-3)
    rest = 0.5 + (objective.weights[~own, None] * loss(np.array([0.9, 0.5]))).sum(axis=0)
    assert_allclose(front[:, 1], rest)


def test_a_witness_leaves_out_statements_that_are_not_fitted(objective):
    fitted = {claim.id for claim in objective.claims}
    other = next(claim.id for claim in CLAIMS if claim.id not in fitted)
    assert list(Witness(objective, [*CHIEF, other]).fronts) == [n for n in CHIEF if n in fitted]


def test_a_witness_sees_the_validation_against_all_that_is_fitted(parameters):
    objective = Objective.of(CLAIMS, SETTINGS, parameters, watched=True)
    names = [claim.id for claim in CLAIMS if claim.role == VALIDATION]
    assert [claim.id for claim in objective.beside] == names
    witness, fitted = Witness(objective, CHIEF), np.full(objective.weights.size, 0.9)
    for beside, scores in ((2.0, fitted), (0.5, 1.2 * fitted), (0.6, 1.3 * fitted)):
        witness.see(found_with(objective, scores, np.full(len(names), beside)))
    seen = [found_with(objective, scores).objective for scores in (1.2 * fitted, fitted)]
    for name in names:
        front = witness.fronts[name][np.argsort(witness.fronts[name][:, 0])]
        assert_allclose(front, np.column_stack([[0.5, 2.0], seen]))


def test_a_merged_front_falls_and_is_thinned_to_its_ends():
    scores = np.linspace(0.0, 3.0, 50)
    front = merged([np.column_stack([scores, 9.0 - scores]), np.array([[1.0, 20.0]])])
    assert len(front) == POINTS
    assert (np.diff(front, axis=0) * [1.0, -1.0] > 0.0).all()
    assert_allclose(front[[0, -1]], [[0.0, 9.0], [3.0, 6.0]])


def test_each_headline_statement_has_a_panel_and_each_interpretation_a_line():
    readings = [
        {"reading": "one", "fronts": {"a": [[0.5, 9.0], [2.0, 4.0]], "b": [[0.1, 5.0]]}},
        {"reading": "two", "fronts": {"a": [[0.4, 8.0]], "b": []}},
    ]
    with matplotlib.style.context(STYLE, after_reset=True):
        drawing = drawing_of(readings)
    assert [panel.title for panel in drawing.panels] == ["a", "b"]
    one, two = drawing.panels[0].series
    assert (one.name, two.name) == ("one", "two")
    # what is good near the statement is good farther off
    assert_allclose(np.column_stack([one.x, one.y])[:2], [[0.5, 9.0], [2.0, 4.0]])
    assert one.y[-1] == 4.0
    texts = [text.get_text() for text in drawing.figure.legends[0].get_texts()]
    assert texts == ["one", "two"]
