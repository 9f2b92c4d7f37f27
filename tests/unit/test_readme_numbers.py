"""Numbers in the pages: exact where the results are, up to a factor where a machine is measured."""

import runpy
from pathlib import Path

import pytest

from benchmarks.classes import CLASSES
from benchmarks.uses import ONE, START, STREAM, SURFACES
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.study.calibration import Unknown

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


def test_the_page_has_five_choices_with_time_and_error(tool, tmp_path):
    tool["ACCURACY"] = tmp_path
    write_results(tmp_path, RTOLS, 0.5)
    assert tool["is_measured"]()
    header, _, *lines, empty, sentence = tool["accuracy_block"]().splitlines()
    cells = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines]
    assert [row[1] for row in cells] == ["0.01", "0.001", "1e-06", "1e-09", "1e-11"]
    assert [row[3] for row in cells] == ["0.2", "0.2", "0.5", "0.5", "0.5"]
    assert cells[3][0] == "`tb.solve`" and cells[3][4] == "1e-10"
    assert "take 2 ms a point and `find_root` on arrays 12 µs" in sentence
    assert "one point takes 0.4 ms, a point on a surface of its own 30 µs" in sentence
    assert "first answer after 0.4 s" in sentence
    assert header.count("|") == 7 and empty == ""


def test_the_page_tells_how_many_points_of_all_interpretations_are_wrong(tool, tmp_path):
    tool["ACCURACY"] = tmp_path
    assert not tool["is_compared"]()
    row = {"place": "anywhere", "rtol": 1e-9, "points": 1000}
    row |= {"without_values": 40, "not_converged": 15, "beyond_bound": 0, "wrong": 0}
    row |= {"largest_error": 5e-10}
    other = row | {
        "place": "next to kinks",
        "beyond_bound": 2,
        "wrong": 1,
        "largest_error": 7.1e-10,
    }
    write_csv(tmp_path / "oracle.csv", [row, other], TABLES["oracle"])
    assert tool["is_compared"]() and not tool["is_measured"]()
    text = tool["oracle_block"]()
    assert "of 2,000 solutions in all combinations of interpretations" in text
    assert "1 are wrong and 2 are beyond their bound. 1.5 % have" in text
    assert "4.0 % have no values" in text and "the others is 0.71 of `rtol`" in text


def test_seeds_differ_by_a_share_of_what_they_draw(tool):
    ratio = Unknown("gap_ratio", (0.0, 4.0), (1.0, 2.0), logarithmic=False)
    found = {"median_of_each_seed": [1.5, 1.6], "range_of_each_seed": [[1.0, 2.0], [1.0, 2.2]]}
    assert tool["disagreement"](ratio, found) == pytest.approx(0.2 / 1.1)


def test_a_page_keeps_what_it_says_without_a_full_accuracy_run(tool, tmp_path, capsys):
    page = tmp_path / "page.md"
    page.write_text(BLOCK.format("old"), encoding="utf-8")
    tool.update(ACCURACY=tmp_path, PAGES=[page], BLOCKS={})
    for rtols in ([], [1e-3]):
        if rtols:
            write_results(tmp_path, rtols, 0.5)
        assert tool["main"](["--write"]) == 0
        assert page.read_text(encoding="utf-8") == BLOCK.format("old")
        assert "make accuracy" in capsys.readouterr().out


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
