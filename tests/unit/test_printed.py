"""The numbers that the paper prints, as rows: whose they are, and how far their tolerances reach."""

import pytest

from thirdbody.configuration.schema import config_directory
from thirdbody.data.conditions import CONDITION_AXES
from thirdbody.data.tables import TABLES, read_csv, write_csv
from thirdbody.study.claims import load_claims
from thirdbody.study.printed import printed_rows


@pytest.fixture(scope="module")
def claims():
    return {claim.id: claim for claim in load_claims(config_directory() / "claims.yaml")}


def rows_of(claim):
    return printed_rows([claim])


def test_a_number_has_a_row_for_each_curve_with_its_relative_tolerance(claims):
    claim = claims["fig11a-turning-point-load-below-90cst"]
    rows = rows_of(claim)
    assert len(rows) == len(claim.curves) > 1
    assert claim.relative
    for row, condition in zip(rows, claim.curves, strict=True):
        assert tuple(row[axis.column] for axis in CONDITION_AXES) == condition
        assert (row["figure"], row["quantity"]) == ("fig11", claim.quantity)
        assert row["value"] == claim.published
        assert row["high"] - row["value"] == pytest.approx(claim.tolerance * claim.published)
        assert row["value"] - row["low"] == pytest.approx(claim.tolerance * claim.published)


def test_a_window_has_a_row_for_each_end_and_no_curve(claims):
    claim = claims["fig10a-window-100nm"]
    low, high = rows_of(claim)
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
