"""The figure of what the headline numbers cost."""

import matplotlib.style
import numpy as np
from numpy.testing import assert_allclose

from thirdbody.figures.drawing import STYLE
from thirdbody.figures.fronts import plot


def test_each_headline_number_has_a_panel_and_each_interpretation_a_line():
    interpretations = [
        {"interpretation": "one", "fronts": {"a": [[0.5, 9.0], [2.0, 4.0]], "b": [[0.1, 5.0]]}},
        {"interpretation": "two", "fronts": {"a": [[0.4, 8.0]], "b": []}},
    ]
    with matplotlib.style.context(STYLE, after_reset=True):
        drawing = plot(interpretations)
    assert [panel.title for panel in drawing.panels] == ["a", "b"]
    one, two = drawing.panels[0].series
    assert (one.name, two.name) == ("one", "two")
    # what is good near the statement is good farther off
    assert_allclose(np.column_stack([one.x, one.y])[:2], [[0.5, 9.0], [2.0, 4.0]])
    assert one.y[-1] == 4.0
    texts = [text.get_text() for text in drawing.figure.legends[0].get_texts()]
    assert texts == ["one", "two"]
