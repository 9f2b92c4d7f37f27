"""Tables and costs that the workflow made."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.curves.transitions import LIMITS
from thirdbody.data.conditions import Condition
from thirdbody.data.tables import TABLES, read_csv

pytestmark = [pytest.mark.results, pytest.mark.filterwarnings("error")]

NAMES = ("table1", "table2", "tpca_loads", "tpca_windows", "transitions")
CONDITIONS = ("viscosity_m2_per_s", "particle_diameter_m", "roughness_m", "particle_density_per_m2")
COLUMNS = TABLES | {"table1": TABLES["paper_table"], "table2": TABLES["paper_table"]}
DIGITS = 1e-9  # ten digits are written: half a unit of the last is at most 5e-10


@pytest.fixture(scope="module")
def tables(results):
    """Rows of each table."""
    return {name: read_csv(results / "tables" / f"{name}.csv", COLUMNS[name]) for name in NAMES}


def columns(rows, names):
    return np.array([[row[name] for row in rows] for name in names], dtype=float)


# ---- form


def test_what_occurs_at_the_default_responds_to_every_input_by_both_measures(results):
    rows = read_csv(results / "tables" / "sensitivity.csv", TABLES["sensitivity"])
    responses = [row for row in rows if row["value"] is not None]
    assert {row["measure"] for row in responses} == {"elasticity", "sobol_total"}
    assert [row for row in responses if row["sensitivity"] is None] == []


# ---- turning points


def test_turning_points_lie_on_their_curves(tables, defaults):
    load, ratio, share, separation = columns(
        tables["tpca_loads"], ("load", "peak_ratio", "solid_load_fraction", "separation_m")
    )
    solution = tb.solve(
        load=load,
        **Condition(*columns(tables["tpca_loads"], CONDITIONS))._asdict(),
        parameters=defaults,
    )
    # the load is rounded to ten digits; L_s follows it with a power that stays below ten
    assert_allclose(solution.separation, separation, rtol=2.0 * DIGITS)
    assert_allclose(solution.solid_load_fraction, share, rtol=10.0 * DIGITS)
    assert_allclose(solution.particle_contact_area_ratio, ratio, rtol=2.0 * DIGITS)


# ---- transitions


def test_at_each_transition_the_quantity_has_its_level(tables, defaults):
    rows = tables["transitions"]
    load, level = columns(rows, ("load", "level"))
    solution = tb.solve(
        load=load, **Condition(*columns(rows, CONDITIONS))._asdict(), parameters=defaults
    )
    for index, row in enumerate(rows):
        value = getattr(solution, row["quantity"])[index]
        # its logarithm changes at most some two hundred times as fast as that of the load
        assert value == pytest.approx(level[index], rel=200.0 * DIGITS), row


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


# ---- windows


def test_each_roughness_has_a_window_with_two_ends(tables):
    windows = {}
    for row in tables["tpca_windows"]:
        windows.setdefault(row["roughness_m"], {})[row["end"]] = row
    assert sorted(windows) == [1e-7, 3e-7, 5e-7]
    for ends in windows.values():
        assert set(ends) == {"low", "high"}
        low, high = (ends[end]["diameter_over_roughness"] for end in ("low", "high"))
        assert 0.0 < low < high


# ---- the paper's tables


@pytest.mark.parametrize("name", ["table1", "table2"])
def test_each_derived_entry_of_the_papers_tables_is_judged(tables, name):
    for row in tables[name]:
        assert row["verdict"] in ("agrees", "differs", "input")
        assert (row["recomputed_low"] is None) == (row["verdict"] == "input")
        assert (row["verdict"] != "differs") or "printed" in row["remark"]
