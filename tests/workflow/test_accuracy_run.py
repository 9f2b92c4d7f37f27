"""`snakemake accuracy` on few points: every table, what each says, and that times are taken
alone."""

import pytest
import yaml
from workspace import MINIMAL, ROOT

from benchmarks.classes import CLASSES, TIMED
from chenhorng.tables import TABLES, read_csv
from tests.oracle.comparison import PLACES, RTOLS
from tests.oracle.extended import why_not

NAMES = "errors", "extremes", "oracle", "times", "uses"
PRODUCTS = {f"accuracy/{name}.csv" for name in NAMES} | {"accuracy/work_precision.png"}
BUDGET = yaml.safe_load((ROOT / "config" / "accuracy_minimal.yaml").read_text(encoding="utf-8"))
BY_RTOL = "library", "library_grid"
METHODS = {(method, rtol) for method in BY_RTOL for rtol in BUDGET["rtol"]}
METHODS.add(("nested_roots", None))


@pytest.fixture(scope="module")
def measured(sources, tmp_path_factory):
    """The repository after a run of the accuracy target alone."""
    workspace = sources.copied_to(tmp_path_factory.mktemp("measured") / "thirdbody")
    run = workspace.snakemake("accuracy", *MINIMAL)
    assert run.returncode == 0, run.stdout + run.stderr
    return workspace


@pytest.fixture(scope="module")
def tables(measured):
    """Rows of each table."""
    folder = measured.root / "results" / "accuracy"
    return {name: read_csv(folder / f"{name}.csv", TABLES[name]) for name in NAMES}


def test_it_makes_its_products_and_no_others(measured):
    assert set(measured.stamps()) == PRODUCTS


@pytest.mark.parametrize(("name", "classes"), [("errors", CLASSES), ("times", TIMED)])
def test_each_class_has_each_method_at_each_rtol(tables, name, classes):
    keys = "method", "rtol", "medium", "bodies", "span"
    found = {tuple(row[key] for key in keys) for row in tables[name]}
    assert found == {(*method, *kind) for method in METHODS for kind in classes}


def test_errors_are_taken_at_500_points_or_more(tables):
    rows = [row for row in tables["errors"] if row["method"].startswith("library")]
    some = [r for r in rows if r["rtol"] == 1e-9 and r["variable"] == "separation"]
    assert sum(row["points"] for row in some) >= 500
    assert not [row for row in rows if row["beyond_rtol"]]
    # float64 does not hold eleven digits of every point, nor nine next to where particles touch or
    # where a film bears nearly nothing or nearly all
    allowed = {rtol: 0.04 if rtol >= 1e-9 else 0.15 for rtol in {row["rtol"] for row in rows}}
    assert not [row for row in rows if row["unsolved"] > allowed[row["rtol"]] * row["points"]]
    assert not [row for row in rows if row["percentile_99_error"] > row["largest_error"]]


def test_every_extreme_has_a_verdict_at_each_rtol(tables):
    golden = (ROOT / "tests" / "golden" / "extremes.csv").read_text(encoding="utf-8")
    assert len(tables["extremes"]) == (golden.count("\n") - 1) * len(BUDGET["rtol"])
    kinds = {row["verdict"].partition(":")[0] for row in tables["extremes"]}
    assert {"right", "refused"} <= kinds <= {"right", "refused", "wrong"}


def test_all_interpretations_are_compared_with_extended_precision(tables):
    if why_not() is not None:
        assert not tables["oracle"]
        return
    rows = tables["oracle"]
    assert len({(row["place"], row["rtol"]) for row in rows}) == len(PLACES) * len(RTOLS)
    every = len(PLACES) * BUDGET["oracle"]["surfaces"] * BUDGET["oracle"]["points"]
    assert sum(row["points"] for row in rows) == every
    assert not [row for row in rows if row["beyond_bound"] or row["wrong"]]
    assert not [row for row in rows if row["largest_error"] > row["rtol"]]
    unknown = sum(row["without_values"] + row["not_converged"] for row in rows)
    assert unknown < 0.13 * sum(row["points"] for row in rows)
