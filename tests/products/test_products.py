"""Tables that the workflow made."""

import json
from pathlib import Path

import pytest

from chenhorng.claims.claims import load_claims
from chenhorng.claims.words import FAILS, HOLDS, NOT_TESTED
from chenhorng.tables import TABLES, read_csv
from thirdbody.core.transitions import LIMITS

ROOT = Path(__file__).parents[2]
pytestmark = [pytest.mark.results, pytest.mark.filterwarnings("error")]

NAMES = (
    "table1",
    "table2",
    "tpca_loads",
    "tpca_windows",
    "transitions",
    "deviations",
    "departures",
    "apparent_area",
    "limits",
    "held_out",
)
COLUMNS = TABLES | {"table1": TABLES["paper_table"], "table2": TABLES["paper_table"]}
COLUMNS["held_out"] = TABLES["own_claims"]


@pytest.fixture(scope="module")
def tables(results):
    """Rows of each table."""
    return {name: read_csv(results / "tables" / f"{name}.csv", COLUMNS[name]) for name in NAMES}


def test_what_occurs_at_the_default_responds_to_every_input(results):
    rows = read_csv(results / "tables" / "sensitivity.csv", TABLES["sensitivity"])
    responses = [row for row in rows if row["value"] is not None]
    assert responses and [row for row in responses if row["elasticity"] is None] == []


def test_each_crossing_of_the_curves_is_a_row(tables, figure, dataset, curves):
    _, values = curves
    for quantity, level in LIMITS:
        above = values[quantity] > level
        crossings = (above[1:] != above[:-1]).sum()
        rows = [
            row
            for row in tables["transitions"]
            if (row["figure"], row["quantity"], row["level"]) == (figure, quantity, level)
        ]
        assert len(rows) == crossings


def test_each_roughness_has_a_window_with_two_ends(tables):
    windows = {}
    for row in tables["tpca_windows"]:
        windows.setdefault(row["roughness_m"], {})[row["end"]] = row
    assert sorted(windows) == [1e-7, 3e-7, 5e-7]
    for ends in windows.values():
        assert set(ends) == {"low", "high"}
        low, high = (ends[end]["diameter_over_roughness"] for end in ("low", "high"))
        assert 0.0 < low < high


def test_each_printed_number_has_its_deviation(tables, results):
    content = json.loads((results / "claims" / "claims.json").read_text(encoding="utf-8"))
    rows = {row["id"]: row for row in content["statements"]}
    assert len(tables["deviations"]) >= 22
    for row in tables["deviations"]:
        expected = -1.0 if row["computed"] is None else row["computed"] / row["printed"] - 1.0
        assert row["deviation"] == pytest.approx(expected, abs=1e-8)
        assert row["computed"] in (None, *map(pytest.approx, rows[row["id"]]["numbers"]))


def test_departures_begin_with_what_the_claims_say(tables, results):
    content = json.loads((results / "claims" / "claims.json").read_text(encoding="utf-8"))
    first, *others = tables["departures"]
    assert (first["holds"], first["judged"]) == (content["held"], content["judged"])
    reached = [row for row in content["headline"] if row["verdict"] == "holds"]
    assert first["headline"] == len(reached)
    sizes = [abs(row["deviation"]) for row in tables["deviations"]]
    assert first["mean_deviation"] == pytest.approx(sum(sizes) / len(sizes))
    assert all(0 <= row["holds"] <= row["judged"] for row in others)


@pytest.mark.parametrize("name", ["table1", "table2"])
def test_each_derived_entry_of_the_papers_tables_is_judged(tables, name):
    for row in tables[name]:
        assert row["verdict"] in ("agrees", "differs", "input")
        assert (row["recomputed_low"] is None) == (row["verdict"] == "input")
        assert (row["verdict"] != "differs") or "printed" in row["remark"]


def test_held_out_statements_are_judged_apart(tables, results):
    content = json.loads((results / "claims" / "claims.json").read_text(encoding="utf-8"))
    held_out = load_claims(ROOT / "config" / "held_out.yaml")
    assert [row["id"] for row in tables["held_out"]] == [claim.id for claim in held_out]
    assert {row["verdict"] for row in tables["held_out"]} <= {HOLDS, FAILS, NOT_TESTED}
    assert {row["id"] for row in content["statements"]}.isdisjoint(
        row["id"] for row in tables["held_out"]
    )
