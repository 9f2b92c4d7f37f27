"""Tables and costs that the workflow made."""

import csv
from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.curves.transitions import LIMITS
from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.data.conditions import Condition
from thirdbody.data.tables import TABLES, read_csv
from thirdbody.model.regimes import SOLUTION_STATUSES

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


def test_each_printed_number_is_drawn_on_its_figure(results):
    printed = read_csv(results / "extracted" / "printed" / "all.csv", TABLES["printed"])
    figures = {row["figure"] for row in printed if row["figure"]}
    assert len(figures) > 5
    for figure in figures:
        with open(results / "figures" / f"{figure}.csv", newline="") as stream:
            drawn = {row["curve"] for row in csv.DictReader(stream)}
        ids = {row["id"] for row in printed if row["figure"] == figure}
        assert {f"printed; {name}" for name in ids} <= drawn
        assert {f"tolerance; {name}" for name in ids} <= drawn


def test_each_figure_has_its_caption_and_alternative_text(results):
    figures = sorted((results / "figures").glob("*.png"))
    assert len(figures) >= 15
    for figure in figures:
        caption, seen = figure.with_suffix(".md").read_text(encoding="utf-8").split("\n\n")
        assert caption.startswith("**")
        assert seen.startswith("**Alternative text.** ")


def test_the_papers_numbers_stand_beside_those_of_the_model(results):
    printed = read_csv(results / "extracted" / "printed" / "all.csv", TABLES["printed"])
    loads = (results / "tables" / "tpca_loads.md").read_text()
    (dry,) = (row for row in printed if row["id"] == "fig11a-turning-point-load-dry")
    assert f"{1e6 * dry['value']:.3g} ± " in loads
    windows = (results / "tables" / "tpca_windows.md").read_text()
    for row in printed:
        if row["quantity"].startswith("window") and row["roughness_m"] in (1e-7, 3e-7, 5e-7):
            assert f"{row['value']:.3g} ± " in windows


def test_what_occurs_at_the_default_responds_to_every_input_by_both_measures(results):
    rows = read_csv(results / "tables" / "sensitivity.csv", TABLES["sensitivity"])
    responses = [row for row in rows if row["value"] is not None]
    assert {row["measure"] for row in responses} == {"elasticity", "sobol_total"}
    assert [row for row in responses if row["sensitivity"] is None] == []


@pytest.mark.parametrize("name", ["tpca_loads", "transitions"])
def test_each_row_says_how_to_take_it(results, tables, defaults, name):
    conditions = Condition(*columns(tables[name], CONDITIONS))._asdict()
    (load,) = columns(tables[name], ("load",))
    status = tb.solve(load=load, **conditions, parameters=defaults).solution_status
    named = [SOLUTION_STATUSES[index] for index in status]
    assert [row["solution_status"] for row in tables[name]] == named
    text = (results / "tables" / f"{name}.md").read_text(encoding="utf-8")
    assert ("status" in text.splitlines()[2]) == (set(named) != {"converged"})


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


def test_the_written_load_is_within_its_written_error(tables, datasets, defaults):
    from thirdbody.curves.turning_point import turning_points

    rows = [row for row in tables["tpca_loads"] if row["figure"] == "fig11"]
    conditions = columns(rows, CONDITIONS)
    loads = datasets["fig11"]["load"].values[:, None]
    separation = tb.solve(
        load=loads, **Condition(*conditions)._asdict(), parameters=defaults, rtol=1e-11
    ).separation
    best = turning_points(separation, *conditions, defaults, 1e-11)
    load, error = columns(rows, ("load", "load_error"))
    assert (np.abs(load - best.load) <= error + best.load_error).all()


def test_each_dry_curve_of_figure_11_turns_where_its_lubricated_ones_do(tables):
    rows = [row for row in tables["tpca_loads"] if row["figure"] == "fig11"]
    assert len(rows) >= 2
    (separation,) = columns(rows, ("separation_m",))
    # A_sa,t* depends on the separation alone
    assert_allclose(separation, separation[0], rtol=DIGITS)


def test_a_more_viscous_lubricant_turns_at_no_lower_load(tables):
    rows = [row for row in tables["tpca_loads"] if row["figure"] == "fig11"]
    rows.sort(key=lambda row: row["viscosity_m2_per_s"])
    for thin, thick in pairwise(rows):  # the same wherever solids bear all
        assert thin["load"] <= thick["load"]
        assert thin["solid_load_fraction"] >= thick["solid_load_fraction"]
    assert thick["load"] > 2.0 * rows[0]["load"]


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


def test_inside_a_window_there_is_a_turning_point_and_outside_it_there_is_none(tables, defaults):
    newtons = defaults.newtons_per_load
    dense = np.geomspace(0.04, 80.0, 4001)[:, None] / newtons
    for row in tables["tpca_windows"]:
        # the scan's loads miss a peak by far less than its height changes with such a step
        step = max(2.0 * row["error"], 1e-3)
        inward = step if row["end"] == "low" else -step
        ratios = row["diameter_over_roughness"] + np.array([inward, -inward])
        solution = tb.solve(
            load=dense,
            viscosity=0.0,
            particle_diameter=ratios * row["roughness_m"],
            roughness=row["roughness_m"],
            particle_density=row["particle_density_per_m2"],
            parameters=defaults,
            rtol=1e-11,
        )
        ratio = solution.particle_contact_area_ratio
        before = ratio - np.minimum.accumulate(ratio)
        after = ratio - np.minimum.accumulate(ratio[::-1])[::-1]
        turns = np.minimum(before, after).max(axis=0) >= PROMINENCE
        assert turns.tolist() == [True, False], row


# ---- the paper's tables


@pytest.mark.parametrize("name", ["table1", "table2"])
def test_each_derived_entry_of_the_papers_tables_is_judged(tables, name):
    for row in tables[name]:
        assert row["verdict"] in ("agrees", "differs", "input")
        assert (row["recomputed_low"] is None) == (row["verdict"] == "input")
        assert (row["verdict"] != "differs") or "printed" in row["remark"]
