"""Tables 1 and 2 as printed, each derived entry from the others, and the printed numbers as
rows."""

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from chenhorng.claims.claims import load_claims, printed_rows
from chenhorng.claims.paper_tables import paper_table
from chenhorng.home import config_directory
from chenhorng.tables import TABLES, read_csv, write_csv
from thirdbody.files import read_yaml
from thirdbody.variables import AXES, CONDITION_AXES

PRINTED = Path(__file__).parents[2] / "config" / "paper_tables.yaml"


@pytest.fixture(scope="module")
def tables(parameters):
    """Rows of both tables by their symbols."""
    return {
        name: {row["symbol"]: row for row in paper_table(rows, parameters)}
        for name, rows in read_yaml(PRINTED).items()
    }


@pytest.mark.parametrize("axis", AXES.values(), ids=AXES)
def test_the_ends_that_the_library_takes_from_the_paper_are_printed(axis):
    (row,) = [
        row for row in read_yaml(PRINTED)["table2"] if row["symbol"] == axis.symbol.strip("*")
    ]
    assert (row["unit"], tuple(row["printed"])) == (axis.alias_unit, axis.paper)


@pytest.mark.parametrize(
    ("table", "symbol", "expected", "verdict"),
    [
        ("table2", "W", [8.857e-4, 1.7715], "differs"),  # printed 0.00086
        ("table2", "sigma*", [1.574803, 7.874016], "agrees"),
        ("table1", "E_ss", [111.9118, np.nan], "agrees"),  # 1/E = 2 (1 - 0.29^2)/205 GPa
        ("table1", "E_sa", [111.9118, np.nan], "agrees"),
        ("table2", "eta_a", [np.nan, np.nan], "input"),
    ],
)
def test_a_derived_entry_follows_from_the_others(tables, table, symbol, expected, verdict):
    row = tables[table][symbol]
    found = np.array([row["recomputed_low"], row["recomputed_high"]], float)
    assert_allclose(found, expected, rtol=1e-4)
    assert row["verdict"] == verdict


def recomputed(parameters, printed, roughnesses=(100, 500)):
    """The row of the printed numbers sigma* in a table with sigma [nm]."""
    row = {"property": "", "symbol": "", "unit": "1e-5", "printed": printed, "digits": 3}
    source = row | {"symbol": "sigma", "unit": "nm", "printed": roughnesses}
    found = paper_table([row | {"recompute": "roughness_parameter"}, source], parameters)
    return found[0]


@pytest.mark.parametrize(
    ("printed", "verdict"), [([1.57, 7.87], "agrees"), ([1.58, 7.87], "differs")]
)
def test_agreement_is_judged_to_the_printed_digits(parameters, printed, verdict):
    assert recomputed(parameters, printed)["verdict"] == verdict


def test_an_entry_follows_from_the_printed_numbers_of_the_file(parameters):
    found = recomputed(parameters, [1.57, 7.87], roughnesses=[200, 500])
    assert (found["recomputed_low"], found["verdict"]) == (pytest.approx(2e-7 / 6.35e-8), "differs")


def test_an_entry_whose_source_is_missing_is_refused(parameters):
    row = {"symbol": "W", "recompute": "load_parameter"}
    with pytest.raises(KeyError, match="F_t"):
        paper_table([row | {"printed": [1.0]}], parameters)


@pytest.fixture(scope="module")
def claims():
    return {claim.id: claim for claim in load_claims(config_directory() / "claims.yaml")}


def test_a_number_has_a_row_for_each_curve_with_its_tolerance(claims):
    claim = claims["fig11a-turning-point-load-below-90cst"]
    rows = printed_rows([claim])
    assert len(rows) == len(claim.curves) > 1
    assert claim.tolerance_kind == "factor"
    for row, condition in zip(rows, claim.curves, strict=True):
        assert tuple(row[axis.column] for axis in CONDITION_AXES) == condition
        assert (row["figure"], row["quantity"]) == ("fig11", claim.quantity)
        assert row["value"] == claim.published
        assert row["high"] == pytest.approx(claim.tolerance * claim.published)
        assert row["low"] == pytest.approx(claim.published / claim.tolerance)


def test_a_window_has_a_row_for_each_end_and_no_curve(claims):
    claim = claims["fig10a-window-100nm"]
    low, high = printed_rows([claim])
    assert [low["quantity"], high["quantity"]] == ["window_low", "window_high"]
    assert [low["value"], high["value"]] == claim.published
    assert low["value"] - low["low"] == pytest.approx(claim.tolerance)
    assert low["viscosity_m2_per_s"] is None
    assert low["roughness_m"] == 1e-7


def test_only_printed_numbers_have_rows(claims):
    wordy = [claim for claim in claims.values() if claim.kind in ("ordering", "trend", "absence")]
    change = claims["fig04c-area-decrease-at-50-percent-90cst"]
    assert printed_rows([*wordy, change]) == []


def test_the_table_keeps_them(claims, tmp_path):
    rows = printed_rows(claims.values())
    write_csv(tmp_path / "printed.csv", rows, TABLES["printed"])
    again = read_csv(tmp_path / "printed.csv", TABLES["printed"])
    assert [row["id"] for row in again] == [row["id"] for row in rows]
    for written, row in zip(again, rows, strict=True):
        assert written["value"] == pytest.approx(row["value"], rel=1e-9)
        assert written["load_max_N"] == row["load_max_N"]
