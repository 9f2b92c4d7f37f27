"""The figure of what the headline numbers cost."""

from pathlib import Path

import matplotlib.style
from numpy.testing import assert_allclose

from thirdbody.figures import fronts as drawing

ROOT = Path(__file__).parents[2]


def test_each_number_has_a_panel_and_each_interpretation_a_line():
    with matplotlib.style.context(ROOT / "src/thirdbody/figures/paper.mplstyle", after_reset=True):
        readings = [
            {"reading": "one", "fronts": {"a": [[0.5, 9.0], [2.0, 4.0]], "b": [[0.1, 5.0]]}},
            {"reading": "two", "fronts": {"a": [[0.4, 8.0]], "b": []}},
        ]
        figure = drawing.plot(readings)
    assert len(figure.axes) == 2
    lines = {line.get_label(): line for line in figure.axes[0].lines}
    assert_allclose(lines["one"].get_xydata()[:2], [[0.5, 9.0], [2.0, 4.0]])
    assert lines["one"].get_ydata()[-1] == 4.0  # near enough for what is farther off
    assert [text.get_text() for text in figure.legends[0].texts] == ["one", "two"]
