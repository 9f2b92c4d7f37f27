"""`snakemake accuracy` on few points: every table, what each says, and that times are taken alone."""

import itertools

import pytest
import yaml
from workspace import ROOT

from benchmarks.oracle import WORDS
from tests.oracle.comparison import PLACES, ROUND
from tests.oracle.extended import why_not
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.solver.plan import WAYS

NAMES = (
    *(
        "errors",
        "extremes",
        "oracle",
        "times",
        "omissions",
        "scaling",
        "surfaces",
        "starts",
        "streaming",
    ),
    "bars",
)
PRODUCTS = {
    *(f"accuracy/{name}.csv" for name in NAMES),
    "accuracy/bars.md",
    "accuracy/accuracy.nc",
    *(f"figures/accuracy.{kind}" for kind in ("svg", "pdf", "png", "csv", "md")),
}
BUDGET = yaml.safe_load((ROOT / "config" / "accuracy_minimal.yaml").read_text(encoding="utf-8"))
CLASSES = set(
    itertools.product(("dry", "lubricated"), ("two_body", "three_body"), ("usual", "extremes"))
)
METHODS = {(method, rtol) for method in ("library", "elementwise_roots") for rtol in BUDGET["rtol"]}
METHODS |= {("nested_roots", None)}


@pytest.fixture(scope="module")
def measured(sources, tmp_path_factory):
    """The repository after a run of the accuracy target alone."""
    workspace = sources.copied_to(tmp_path_factory.mktemp("measured") / "thirdbody")
    run = workspace.snakemake("accuracy")
    assert run.returncode == 0, run.stdout + run.stderr
    return workspace


@pytest.fixture(scope="module")
def tables(measured):
    """Rows of each table."""
    folder = measured.root / "results" / "accuracy"
    return {name: read_csv(folder / f"{name}.csv", TABLES[name]) for name in NAMES}


def of_class(row):
    return row["medium"], row["bodies"], row["span"]


def test_it_makes_its_products_and_no_others(measured):
    assert set(measured.stamps()) == PRODUCTS


def test_the_default_run_makes_none_of_them(sources):
    listed = (sources.root / "workflow/Snakefile").read_text(encoding="utf-8")
    assert not [name for name in PRODUCTS if f"results/{name}" in listed]


def test_what_is_timed_leaves_no_share_to_others(measured):
    rules = measured.rules()
    timed = {name for name, text in rules.items() if "quiet=100" in text}
    assert timed == {name for name in rules if name.startswith("time_")} != set()
    profile = yaml.safe_load((measured.root / "workflow/profiles/default/config.yaml").read_text())
    assert profile["resources"] == ["quiet=100"]
    assert "quiet=1" in profile["default-resources"]


@pytest.mark.parametrize("name", ["errors", "times"])
def test_each_class_has_each_method_at_each_rtol(tables, name):
    found = {(row["method"], row["rtol"], *of_class(row)) for row in tables[name]}
    assert found == {(*method, *kind) for method in METHODS for kind in CLASSES}


def test_errors_are_taken_at_500_points_or_more(tables):
    rows = [row for row in tables["errors"] if row["method"] == "library"]
    some = [r for r in rows if r["rtol"] == 1e-9 and r["variable"] == "separation"]
    assert sum(row["points"] for row in some) >= 500
    assert not [row for row in rows if row["beyond_rtol"]]
    # float64 does not hold eleven digits of every point, nor nine next to where particles touch or
    # where a film bears nearly nothing or nearly all
    allowed = {rtol: 0.04 if rtol >= 1e-9 else 0.15 for rtol in {row["rtol"] for row in rows}}
    assert not [row for row in rows if row["unsolved"] > allowed[row["rtol"]] * row["points"]]
    assert not [row for row in rows if row["percentile_99_error"] > row["largest_error"]]


def test_the_library_tells_its_preparation_and_memory(tables):
    rows = [row for row in tables["times"] if row["method"] == "library"]
    assert all(0.0 < row["setup_seconds"] < 0.2 for row in rows)
    assert all(row["peak_memory_MB"] > 0.0 for row in rows)


def test_every_extreme_has_a_verdict_at_each_rtol(tables):
    golden = (ROOT / "tests" / "golden" / "extremes.csv").read_text(encoding="utf-8")
    assert len(tables["extremes"]) == (golden.count("\n") - 1) * len(BUDGET["rtol"])
    kinds = {row["verdict"].partition(":")[0] for row in tables["extremes"]}
    assert {"right", "refused"} <= kinds <= {"right", "refused", "wrong"}


def test_all_readings_are_compared_with_extended_precision(tables):
    if why_not() is not None:
        assert not tables["oracle"]
        return
    rows = tables["oracle"]
    names = "place", "way", "rtol", *WORDS
    assert len({tuple(row[name] for name in names) for row in rows}) == len(rows)
    assert len(rows) == len(PLACES) * len(WAYS) * ROUND
    assert {row["points"] for row in rows} == {BUDGET["oracle"]["points"]}
    assert not [row for row in rows if row["beyond_bound"] or row["wrong"]]
    assert not [row for row in rows if row["over_rtol"] > 1.0]
    assert sum(row["without_values"] + row["not_converged"] for row in rows) < 0.5 * len(rows)
    (bar,) = (row for row in tables["bars"] if "all readings" in row["what"])
    assert (bar["measured"], bar["verdict"]) == (0.0, "holds")


def test_sweeps_hold_what_was_asked_for(tables):
    sizes = [row["points"] for row in tables["scaling"] if row["axis"] == "points"]
    assert sizes == BUDGET["sizes"]["points"]
    calls = [row["points"] for row in tables["scaling"] if row["axis"].endswith("calls")]
    assert calls[0] > calls[1] == calls[2] == 1
    processes = [row["processes"] for row in tables["scaling"] if row["axis"] == "processes"]
    assert processes == [1, BUDGET["processes"]["workers"]]
    threads = [row["threads"] for row in tables["scaling"] if row["axis"] == "threads"]
    assert threads == [1, BUDGET["threads"]["threads"]]
    numbers = [row["surfaces"] for row in tables["surfaces"]]
    assert numbers == 2 * BUDGET["surfaces"]["surfaces"]
    assert [row["ratio"] for row in tables["surfaces"] if row["surfaces"] == 1] == [1.0, 1.0]
    assert tables["omissions"][0]["left_out"] == "nothing"
    readings = ["nothing, film_load fluid", "nothing, film_load total"]
    assert [row["left_out"] for row in tables["omissions"][-2:]] == readings
    assert [row["what"] for row in tables["streaming"]] == ["streaming", "solving", "writing"]
    assert tables["streaming"][0]["points"] == 1000
    assert tables["streaming"][0]["resident_memory_MB"] < 1000.0


def test_every_start_is_timed_by_every_way_or_said_to_be_left_out(tables):
    rows = tables["starts"]
    assert [row["points"] for row in rows[::8]] == BUDGET["starts"]["points"]
    for first in range(0, len(rows), 4):
        same = rows[first : first + 4]
        assert [row["way"] for row in same] == ["compiled", "tables", "quadrature", "automatic"]
        assert len({(row["points"], row["start"]) for row in same}) == 1
        timed = [row for row in same if row["seconds"]]
        best = min(row["seconds"] for row in timed if row["way"] != "automatic")
        assert best > 0.1
        for row in timed:
            assert row["over_best"] == pytest.approx(row["seconds"] / best)
        assert all(row["remark"].startswith("left out") for row in same if row not in timed)


def test_every_bar_is_judged_by_what_was_measured(tables):
    assert len(tables["bars"]) == 17
    for row in tables["bars"]:
        if row["measured"] is None:
            assert why_not() is not None and row["verdict"] == "not measured"
            continue
        holds = (
            row["measured"] >= row["bar"]
            if row["sense"] == "at least"
            else row["measured"] <= row["bar"]
        )
        assert row["verdict"] == ("holds" if holds else "fails")
    times = {
        (row["method"], row["rtol"]): row["microseconds_per_point"]
        for row in tables["times"]
        if of_class(row) == ("lubricated", "three_body", "usual")
    }
    ratio = times["nested_roots", None] / times["library", 1e-9]
    assert tables["bars"][0]["measured"] == pytest.approx(ratio)
    fluid, total = (row["microseconds_per_point"] for row in tables["omissions"][-2:])
    (bar,) = (row for row in tables["bars"] if "film_load" in row["what"])
    assert bar["measured"] == pytest.approx(total / fluid)
    assert (bar["sense"], bar["bar"]) == ("at most", 1.1)


def test_the_dataset_holds_the_tables(measured, tables):
    xr = pytest.importorskip("xarray")
    with xr.open_dataset(measured.root / "results" / "accuracy" / "accuracy.nc") as dataset:
        for row in tables["times"]:
            place = {name: row[name] for name in ("method", "rtol", "medium", "bodies", "span")}
            place["rtol"] = row["rtol"] or BUDGET["rtol"][0]
            cost = dataset["microseconds_per_point"].sel(place)
            assert float(cost) == row["microseconds_per_point"]
        assert all("units" in dataset[name].attrs for name in dataset.data_vars)


def test_the_figure_draws_every_class_and_method(measured):
    text = (measured.root / "results" / "figures" / "accuracy.csv").read_text(encoding="utf-8")
    labels = {tuple(line.split(",")[:2]) for line in text.splitlines()[1:]}
    assert len(labels) == len(CLASSES) * 3
