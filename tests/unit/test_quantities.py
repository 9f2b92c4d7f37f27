"""The table of variables agrees with the solver and with the page that explains the symbols."""

import re
import runpy
from pathlib import Path

from thirdbody.data.conditions import AXES
from thirdbody.data.quantities import FLAGS, NORMAL_LOAD, STATUS_MEANINGS, VARIABLES
from thirdbody.model.regimes import WITHOUT_VALUES

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "nomenclature.md").read_text(encoding="utf-8")


def test_the_page_has_every_condition_and_variable_as_the_files_have_them():
    tool = runpy.run_path(DOCS / "readme_numbers.py")
    assert tool["renewed"](PAGE, {"variables": tool["variables_block"]}) == PAGE
    for each in (*AXES.values(), NORMAL_LOAD, *VARIABLES.values()):
        assert f"`{each.name}`" in PAGE


def test_the_page_and_the_files_explain_each_status_once_and_alike():
    rows = re.findall(r"^\| `(\w+)` \| ([^|]+) \| (given|nan; regime and mode -1) \|$", PAGE, re.M)
    assert [(name, text) for name, text, _ in rows] == list(STATUS_MEANINGS.items())
    assert tuple(name for name, _, values in rows if values != "given") == WITHOUT_VALUES
    flag = FLAGS["solution_status"]
    assert flag.meanings == tuple(STATUS_MEANINGS)
    assert flag.comment.split("; ") == [": ".join(row[:2]) for row in rows]
