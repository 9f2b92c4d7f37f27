"""The figure of the verdicts: every statement once, where its score is."""

from pathlib import Path

import matplotlib.style
import numpy as np
import pytest
from numpy.testing import assert_allclose

from thirdbody.data.places import part_of_paper
from thirdbody.figures import claims
from thirdbody.figures.drawing import STYLE
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
    with matplotlib.style.context(STYLE, after_reset=True):
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
        if claim.is_withheld:
            score, verdict = None, verdicts.WITHHELD
        rows.append(
            {"id": claim.id, "place": claim.place, "role": claim.role, "verdict": verdict}
            | {
                "cluster": claim.cluster,
                "score": score,
                "ensemble_agree": 3.0,
                "ensemble_size": 12.0,
            }
        )
    return rows


@pytest.fixture(scope="module")
def drawing(rows):
    return claims.plot(rows)


@pytest.mark.parametrize(("place", "part"), PLACES)
def test_parts_of_the_paper(place, part):
    assert part_of_paper(place) == part


def test_every_statement_is_drawn_at_its_score(rows, drawing):
    places = {one.label: float(one.x[0]) for panel in drawing.panels for one in panel.series}
    assert places.keys() == {row["id"] for row in rows}
    for row in rows:
        wanted = claims.NO_SCORE if row["score"] is None else min(row["score"], claims.LAST)
        assert places[row["id"]] == wanted


def test_statements_that_do_not_hold_are_named(rows, drawing):
    names = {text.get_text() for axes in drawing.figure.axes for text in axes.texts}
    wanted = (verdicts.HOLDS, verdicts.WITHHELD)
    assert names == {row["id"] for row in rows if row["verdict"] not in wanted}


def test_counts_stand_beside_their_part(rows, drawing):
    texts = [
        text.get_text() for axes in drawing.figure.axes for text in axes.yaxis.get_ticklabels()
    ]
    for part in {part_of_paper(row["place"]) for row in rows}:
        words = [row["verdict"] for row in rows if part_of_paper(row["place"]) == part]
        held = words.count(verdicts.HOLDS)
        assert f"{part}\n{held} of {held + words.count(verdicts.FAILS)} hold" in texts


def test_the_page_counts_by_the_parts_that_the_figure_draws(rows):
    counted = verdicts.counts(rows, "figure")
    assert [row.pop("figure") for row in counted] == list(claims._groups(rows))
    assert sum(row[word] for row in counted for word in claims.COLOURS) == len(rows)
    by_role = {
        row["role"]: sum(row[word] for word in claims.COLOURS)
        for row in verdicts.counts(rows, "role")
    }
    assert by_role == {role: sum(row["role"] == role for row in rows) for role in by_role}


def test_every_verdict_and_role_has_its_look():
    words = verdicts.HOLDS, verdicts.FAILS, verdicts.NOT_TESTED
    assert list(claims.COLOURS) == [*words, verdicts.CONTRADICTED, verdicts.WITHHELD]
    assert claims.MARKERS.keys() == {"calibration", "validation", "withheld"}


def test_a_statement_of_which_the_ensemble_is_sure_is_filled(rows):
    few = rows[:20]
    sure = [row | {"ensemble_agree": 12.0} for row in few]
    for some, hollow in ((few, True), (sure, False)):
        lines = [line for axes in claims.plot(some).figure.axes for line in axes.lines]
        marked = [line for line in lines if line.get_marker() in claims.MARKERS.values()]
        assert all((line.get_markerfacecolor() == "white") == hollow for line in marked)


def test_distances_are_logarithmic_beyond_one_tolerance():
    assert_allclose([claims.score_of(each) for each in (0.0, 0.3, 1.0)], [0.0, 0.3, 1.0])
    assert_allclose(claims.score_of(10.0) - claims.score_of(1.0), np.log(10.0))
