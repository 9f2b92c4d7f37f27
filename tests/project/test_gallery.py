"""The figures of the gallery, drawn by its own recipes."""

import re
from pathlib import Path

import pytest
from collisions import collisions

import thirdbody as tb

PAGE = Path(__file__).parents[2] / "docs" / "gallery.md"
CELL = re.compile(r"```\{code-cell\}\n((?::[^\n]*\n)*)(.*?)```", re.DOTALL)


@pytest.fixture(scope="module")
def calls():
    """Arguments of all calls of ``tb.plot`` that a reader sees."""
    found: list = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(tb, "plot", lambda *given, **options: found.append((given, options)))
        names: dict = {}
        for options, cell in CELL.findall(PAGE.read_text(encoding="utf-8")):
            if "remove-cell" not in options:
                exec(cell, names)
    return found


@pytest.mark.parametrize("width_mm", [84, 174])
def test_no_text_is_over_an_axis_a_tick_a_rule_or_another_text(calls, width_mm):
    assert len(calls) == 10
    for given, options in calls:
        assert not collisions(tb.plot(*given, **options | {"width_mm": width_mm}))
