"""Numbers in the pages: exact where the results are, up to a factor where a machine is measured."""

import runpy
from pathlib import Path

import pytest

from benchmarks.classes import CLASSES
from benchmarks.uses import ONE, START, STREAM, SURFACES
from thirdbody.data.tables import TABLES, write_csv

TOOL = Path(__file__).parents[2] / "docs" / "readme_numbers.py"
RTOLS = [1e-2, 1e-3, 1e-6, 1e-9, 1e-11]
BLOCK = "<!-- accuracy -->\n{}\n<!-- /accuracy -->\n"


@pytest.fixture
def tool():
    """The tool's names; its functions see what is changed in them."""
    return runpy.run_path(TOOL)["main"].__globals__


def write_results(folder, rtols, microseconds):
    """Tables of an accuracy run in which every error is a tenth of ``rtol``."""
    given = [
        (method, rtol)
        for method in ("library", "library_grid", "elementwise_roots")
        for rtol in rtols
    ]
    rows = [
        {"method": method, "rtol": rtol, **kind._asdict(), "points": 64}
        for method, rtol in [*given, ("nested_roots", None)]
        for kind in CLASSES
    ]
    filled = {"variable": "separation", "unsolved": 0, "beyond_rtol": 0, "percentile_99_error": 0.0}
    errors = [{**row, **filled, "largest_error": 0.1 * (row["rtol"] or 0.0)} for row in rows]
    cost = {"library": microseconds, "library_grid": 0.2, "elementwise_roots": 12.0}
    cost["nested_roots"] = 2e3
    times = [{**row, "microseconds_per_point": cost[row["method"]]} for row in rows]
    write_csv(folder / "errors.csv", errors, TABLES["errors"])
    write_csv(folder / "times.csv", times, TABLES["times"])
    uses = {ONE: 400.0, SURFACES: 30.0, STREAM: 1.5, START: 4e5}
    same = {"points": 1, "rtol": 1e-9, "seconds": 1.0, "resident_memory_MB": 100.0}
    table = [{"use": use, **same, "microseconds_per_point": each} for use, each in uses.items()]
    write_csv(folder / "uses.csv", table, TABLES["uses"])


@pytest.mark.parametrize(
    ("page", "run", "same"),
    [
        ("takes 1.2 µs", "takes 1.2 µs", True),
        ("takes 1.2 µs", "takes  3.5 µs", True),
        ("takes 1.2 µs", "takes 3.7 µs", False),
        ("takes 1.2 µs", "took 1.2 µs", False),
        ("1e-05 of 0", "2e-05 of 0", True),
        ("1e-05 of 0", "1e-04 of 0", False),
        ("1e-05 of 0", "1e-05 of 1", False),
        ("1 and 2", "1 and", False),
    ],
)
def test_texts_agree_if_their_words_do_and_their_numbers_nearly(tool, page, run, same):
    assert tool["agree"](page, run) == same


def test_a_page_is_stale_if_the_run_says_something_else(tool, tmp_path):
    page = tmp_path / "page.md"
    page.write_text(BLOCK.format("old"), encoding="utf-8")
    tool.update(ACCURACY=tmp_path, PAGES=[page], BLOCKS={})
    write_results(tmp_path, RTOLS, 0.5)
    assert tool["main"]([]) == 1
    tool["main"](["--write"])
    written = page.read_text(encoding="utf-8")
    assert "| 0.5 " in written
    write_results(tmp_path, RTOLS, 0.8)
    assert tool["main"]([]) == 0
    write_results(tmp_path, RTOLS, 5.0)
    assert tool["main"]([]) == 1
    assert page.read_text(encoding="utf-8") == written
