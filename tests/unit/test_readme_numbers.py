"""Numbers in the pages: exact where the results are, up to a factor where a machine is measured."""

import runpy
from pathlib import Path

import pytest

from benchmarks.classes import CLASSES
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.study.calibration import Unknown

TOOL = Path(__file__).parents[2] / "docs" / "readme_numbers.py"
BLOCK = "<!-- accuracy -->\n{}\n<!-- /accuracy -->\n"


@pytest.fixture
def tool():
    """The tool's names; its functions see what is changed in them."""
    return runpy.run_path(TOOL)["main"].__globals__


def write_results(folder, rtols, microseconds):
    """Tables of an accuracy run in which every error is a tenth of what is asked for."""
    given = [("library", rtol) for rtol in rtols] + [("nested_roots", None)]
    rows = [
        {"method": method, "rtol": rtol, **kind._asdict()}
        for method, rtol in given
        for kind in CLASSES
    ]
    filled = {
        "variable": "separation",
        "points": 64,
        "unsolved": 0,
        "beyond_rtol": 0,
        "percentile_99_error": 0.0,
        "setup_seconds": None,
        "peak_memory_MB": None,
    }
    errors = [{**row, **filled, "largest_error": 0.1 * (row["rtol"] or 0.0)} for row in rows]
    cost = {"library": microseconds, "nested_roots": 2e3}
    times = [{**row, **filled, "microseconds_per_point": cost[row["method"]]} for row in rows]
    write_csv(folder / "errors.csv", errors, TABLES["errors"])
    write_csv(folder / "times.csv", times, TABLES["times"])
    starts = [
        {
            "points": 1,
            "start": start,
            "way": way,
            "seconds": seconds,
            "over_best": 1.0,
            "remark": "",
        }
        for start, way, seconds in (
            ("cold", "compiled", 1.9),
            ("warm", "compiled", 0.9),
            ("warm", "tables", 0.4),
        )
    ]
    write_csv(folder / "starts.csv", starts, TABLES["starts"])
    cost = {"points": 1e6, "rtol": 1e-9, "microseconds_per_point": microseconds}
    surfaces = [
        {"surfaces": number, "tables": tables, **cost, "ratio": ratio}
        for number, tables, ratio in ((1, "ready", 1.0), (1000, "ready", 2.0), (1000, "new", 9.0))
    ]
    write_csv(folder / "surfaces.csv", surfaces, TABLES["surfaces"])
    threads = {"axis": "threads", "processes": 1, **cost}
    scaling = [
        {**threads, "threads": number, "ratio": 1.0 + 0.7 * (number > 1)} for number in (1, 2)
    ]
    calls = {**threads, "threads": 1, "ratio": 1.0}
    scaling += [
        {**calls, "axis": axis, "microseconds_per_point": each, "points": count}
        for axis, each, count in (
            ("first_calls", 1400.0, 301),
            ("calls", 98.0, 1),
            ("new_calls", 150.0, 1),
        )
    ]
    write_csv(folder / "scaling.csv", scaling, TABLES["scaling"])


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


def test_the_page_tells_what_each_rtol_costs_and_buys(tool, tmp_path):
    tool["ACCURACY"] = tmp_path
    write_results(tmp_path, [1e-3, 1e-6, 1e-9, 1e-11], 0.5)
    assert tool["is_measured"]()
    header, _, *lines, empty, sentence = tool["accuracy_block"]().splitlines()
    assert [line.split("|")[1].strip() for line in lines] == ["0.001", "1e-06", "1e-09", "1e-11"]
    assert [line.split("|")[3].strip() for line in lines] == ["0.5"] * 4
    assert lines[2].split("|")[4].strip() == "1e-10"
    assert "2.0 ms: 4000 times" in sentence
    assert "1.5 s once to compile, and 0.5 s in a process" in sentence
    assert "up to 1,000 surfaces, in no order, take at most 2.0 times as long" in sentence
    assert (
        "takes 1.4 ms; after 301 of them the process loads the loop, and one takes 0.098 ms"
        in sentence
    )
    assert "Two threads solve them 1.70 times as fast" in sentence
    assert header.count("|") == 6 and empty == ""


def test_the_page_tells_how_many_points_of_all_readings_are_wrong(tool, tmp_path):
    tool["ACCURACY"] = tmp_path
    assert not tool["is_compared"]()
    reading = dict(zip(tool["OF_READING"], ["centred", "summit", "printed", "printed", "total"]))
    row = {"place": "anywhere", "way": "tables", "rtol": 1e-9, **reading, "points": 1000}
    row |= {"without_values": 40, "not_converged": 15, "beyond_bound": 0, "wrong": 0}
    row |= {"largest_error": 5e-10, "over_rtol": 0.5}
    other = row | {"film_load": "fluid", "beyond_bound": 2, "wrong": 1, "over_rtol": 0.71}
    write_csv(tmp_path / "oracle.csv", [row, other], TABLES["oracle"])
    assert tool["is_compared"]() and not tool["is_measured"]()
    text = tool["oracle_block"]()
    assert "of 2,000 solutions in all 2 combinations of readings" in text
    assert "1 are wrong and 2 beyond their bound. 1.5 % are" in text
    assert "4.0 % have no values" in text and "the others is 0.71 of that asked for" in text


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
    write_results(tmp_path, list(tool["USES"]), 0.5)
    assert tool["main"]([]) == 1
    tool["main"](["--write"])
    written = page.read_text(encoding="utf-8")
    assert "| 0.5 " in written
    write_results(tmp_path, list(tool["USES"]), 0.8)
    assert tool["main"]([]) == 0
    write_results(tmp_path, list(tool["USES"]), 5.0)
    assert tool["main"]([]) == 1
    assert page.read_text(encoding="utf-8") == written
