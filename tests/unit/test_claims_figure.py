"""The figure of the verdicts: every statement once, where its score is."""

from pathlib import Path

import matplotlib.style
import numpy as np
import pandas as pd
import pytest
from numpy.testing import assert_allclose

from thirdbody.data.places import part_of_paper
from thirdbody.figures import claims
from thirdbody.figures.sheet.saving import drawn_points
from thirdbody.study import verdicts
from thirdbody.study.claims import load_claims

ROOT = Path(__file__).parents[2]
PLACES = [
    ("Figure 3A, section 3.3", "Figure 3"),
    ("Figures 4B and 4C, section 3.3", "Figure 4"),
    ("Figure 5B and the discussion of Figure 12C, section 3.3", "Figure 5"),
    ("Figures 9 to 13, section 3.3", "Figure 9"),
    ("Figure 12C, section 3.3", "Figure 12"),
    ("Conclusion 4", "Conclusions"),
    ("Abstract", "Abstract"),
]


@pytest.fixture(autouse=True, scope="module")
def style():
    with matplotlib.style.context(ROOT / "src/thirdbody/figures/paper.mplstyle", after_reset=True):
        yield


@pytest.fixture(scope="module")
def statements():
    return load_claims(ROOT / "config" / "claims.yaml")


@pytest.fixture(scope="module")
def rows(statements):
    """Scores over their whole range, with each verdict among them."""
    scores = np.linspace(0.0, 10.0, len(statements))
    rows = []
    for claim, score in zip(statements, scores, strict=True):
        verdict = verdicts.HOLDS if score <= 1.0 else verdicts.FAILS
        if claim.aside:
            verdict = verdicts.CONTRADICTED
        elif 3.0 < score < 3.5:
            verdict = verdicts.NOT_TESTED
        rows.append(
            {"id": claim.id, "place": claim.place, "verdict": verdict}
            | {
                "cluster": claim.cluster,
                "predicted": "holds" if score < 0.5 else "fails",
                "score": score,
                "ensemble_agree": 3.0,
                "ensemble_size": 12.0,
            }
        )
    return rows


@pytest.fixture(scope="module")
def figure(rows):
    return claims.plot(rows)


def drawn(figure):
    """Place of each labelled point over all panels."""
    return {label: x for panel in figure.axes for label, ((x, _),) in drawn_points(panel)}


@pytest.mark.parametrize(("place", "part"), PLACES)
def test_parts_of_the_paper(place, part):
    assert part_of_paper(place) == part


def test_every_statement_is_drawn_at_its_score(rows, figure):
    places = drawn(figure)
    assert places.keys() == {row["id"] for row in rows}
    for row in rows:
        wanted = claims.NO_SCORE if row["score"] is None else min(row["score"], claims.LAST)
        assert places[row["id"]] == wanted


def test_statements_that_do_not_hold_are_named(rows, figure):
    names = [text.get_text() for panel in figure.axes for text in panel.texts]
    for row in rows:
        tail = row["id"].split("-", 1)[-1]
        named = any(name.endswith(tail) for name in names)
        assert named or row["verdict"] == verdicts.HOLDS


def test_counts_stand_beside_their_part(rows, figure):
    texts = [text.get_text() for panel in figure.axes for text in panel.texts]
    for part in {part_of_paper(row["place"]) for row in rows}:
        judged = [
            row
            for row in rows
            if part_of_paper(row["place"]) == part
            and row["verdict"] in (verdicts.HOLDS, verdicts.FAILS)
        ]
        held = sum(row["verdict"] == verdicts.HOLDS for row in judged)
        assert f"{part}\n{held} of {len(judged)} hold" in texts


def test_the_page_counts_by_the_parts_that_the_figure_draws(rows):
    counted = verdicts.counts_by_figure(pd.DataFrame(rows))
    assert counted["figure"].tolist() == list(claims._groups(rows))
    assert counted[list(claims.COLOURS)].to_numpy().sum() == len(rows)


def test_a_statement_that_is_not_predicted_is_a_diamond(rows, figure):
    diamonds = set()
    for panel in figure.axes:
        for line in panel.lines:
            if line.get_marker() == claims.OTHER_MARKER:
                diamonds |= set(line.names)
    assert diamonds == {row["id"] for row in rows if row["predicted"] == "fails"}


def test_a_statement_of_which_the_ensemble_is_sure_is_filled(rows):
    few = rows[:20]
    sure = [row | {"ensemble_agree": 12.0} for row in few]
    for some, hollow in ((few, True), (sure, False)):
        lines = [line for panel in claims.plot(some).axes for line in panel.lines]
        marked = [line for line in lines if not line.get_label().startswith("_")]
        assert all((line.get_markerfacecolor() == "white") == hollow for line in marked)


def test_distances_are_logarithmic_beyond_one_tolerance():
    assert_allclose([claims.score_of(each) for each in (0.0, 0.3, 1.0)], [0.0, 0.3, 1.0])
    assert_allclose(claims.score_of(10.0) - claims.score_of(1.0), np.log(10.0))
