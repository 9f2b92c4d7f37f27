"""The figure of the verdicts."""

from pathlib import Path

import numpy as np
import pytest

from thirdbody.paper.claims import verdicts
from thirdbody.paper.claims.claims import load_claims
from thirdbody.paper.figures import claims
from thirdbody.paper.places import part_of_paper
from thirdbody.paper.typeset import mathtext

pytestmark = pytest.mark.usefixtures("style")

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def rows():
    """Scores over their whole range, with each verdict among them."""
    statements = load_claims(ROOT / "config" / "claims.yaml")
    rows = []
    for claim, score in zip(statements, np.linspace(0.0, 10.0, len(statements)), strict=True):
        verdict = verdicts.HOLDS if score <= 1.0 else verdicts.FAILS
        if claim.aside:
            verdict = verdicts.CONTRADICTED
        elif 3.0 < score < 3.5:
            verdict = verdicts.NOT_TESTED
        row = {"id": claim.id, "place": claim.place, "verdict": verdict, "cluster": claim.cluster}
        row["statement"] = claim.statement
        predicted = "holds" if score < 0.5 else "fails"
        if verdict not in (verdicts.HOLDS, verdicts.FAILS):
            predicted = verdict
        row |= {"score": score, "predicted": predicted}
        rows.append(row | {"ensemble_agree": 3.0, "ensemble_size": 12.0})
    return rows


def test_every_statement_is_drawn_at_its_score_and_misses_are_named(rows):
    drawing = claims.plot(rows)
    (axes,), (panel,) = drawing.axes, drawing.panels
    texts = [text.get_text() for text in axes.get_yticklabels()]
    tested = [row for row in rows if row["verdict"] != verdicts.NOT_TESTED]
    assert {one.name for one in panel.series} == {row["id"] for row in tested}
    assert sum("(not tested): " in text for text in texts) == len(rows) - len(tested) > 0
    lines = {one.name: (float(one.x[0]), texts[int(one.y[0])]) for one in panel.series}
    for row in tested:
        score, text = lines[row["id"]]
        assert score == min(row["score"], claims.LAST)
        part = part_of_paper(row["place"])
        words = [one["verdict"] for one in rows if part_of_paper(one["place"]) == part]
        held = words.count(verdicts.HOLDS)
        judged = held + words.count(verdicts.FAILS)
        is_named = row["verdict"] != verdicts.HOLDS
        if is_named:
            place, _, sentence = text.replace("\n", " ").partition(": ")
            assert row["place"].startswith(place)
            assert mathtext(row["statement"]).startswith(sentence.removesuffix(" …"))
        else:
            assert text == f"{part}: {held} of {judged} hold"


def markers_at(drawing):
    """Marker and filling of each statement, by its name."""
    (axes,), (panel,) = drawing.axes, drawing.panels
    looks = {
        place: (line.get_marker(), line.get_markerfacecolor())
        for line in axes.lines
        for place in zip(line.get_xdata(), line.get_ydata(), strict=True)
    }
    return {one.name: looks[float(one.x[0]), int(one.y[0])] for one in panel.series}


def test_a_statement_that_is_not_predicted_is_a_diamond(rows):
    markers = markers_at(claims.plot(rows))
    diamonds = {name for name, (marker, _) in markers.items() if marker == "D"}
    assert diamonds == {row["id"] for row in rows if row["predicted"] == "fails"}


def test_a_statement_of_which_the_ensemble_is_sure_is_filled(rows):
    few = rows[:20]
    sure = [row | {"ensemble_agree": 12.0} for row in few]
    for some, hollow in ((few, True), (sure, False)):
        fillings = [filling for _, filling in markers_at(claims.plot(some)).values()]
        assert len(fillings) == len(few)
        assert all((filling == "white") == hollow for filling in fillings)
