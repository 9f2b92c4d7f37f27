"""The figure of the verdicts."""

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex, to_rgb

from chenhorng.claims import words
from chenhorng.claims.claims import load_claims
from chenhorng.figures import claims
from chenhorng.places import part_of_paper

pytestmark = pytest.mark.usefixtures("style")

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def rows():
    """Scores over their whole range, with each verdict among them."""
    statements = load_claims(ROOT / "config" / "claims.yaml")
    rows = []
    for claim, score in zip(statements, np.linspace(0.0, 10.0, len(statements)), strict=True):
        verdict = words.HOLDS if score <= 1.0 else words.FAILS
        if claim.aside:
            verdict = words.CONTRADICTED
        elif 3.0 < score < 3.5:
            verdict = words.NOT_TESTED
        row = {"id": claim.id, "place": claim.place, "verdict": verdict, "cluster": claim.cluster}
        row["statement"] = claim.statement
        predicted = "holds" if score < 0.5 else "fails"
        if verdict not in (words.HOLDS, words.FAILS):
            predicted = verdict
        row |= {"score": score, "predicted": predicted}
        rows.append(row | {"ensemble_agree": 3.0, "ensemble_size": 12.0})
    return rows


def test_bars_count_the_statements_in_the_colours_of_their_verdicts(rows):
    drawing = claims.plot(rows)
    (bars,) = drawing.axes
    parts = [label.get_text() for label in bars.get_yticklabels()]
    found = {
        (parts[int(place)], series.name): count
        for series in drawing.panels[0].series
        for count, place in zip(series.x, series.y, strict=True)
    }
    expected = Counter((part_of_paper(row["place"]), row["verdict"]) for row in rows)
    assert {key: count for key, count in found.items() if count} == expected
    widths = sum(bar.get_width() for bar in bars.patches)
    assert widths == len(rows)
    shown = {
        bar.get_label().rpartition(" (")[0]: to_hex(bar.patches[0].get_facecolor()).upper()
        for bar in bars.containers
    }
    assert shown == words.COLOURS
    grey = [np.dot(to_rgb(colour), (0.299, 0.587, 0.114)) for colour in words.COLOURS.values()]
    assert np.diff(sorted(grey)).min() > 0.03
