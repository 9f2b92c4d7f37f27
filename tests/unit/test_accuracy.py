"""What measures the accuracy is itself right: errors, verdicts, baselines, times."""

import time
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import thirdbody as tb
from benchmarks.baselines import ElementwiseRoots, NestedRoots, load_plain_model
from benchmarks.classes import CLASSES, HEAVIEST, ROUGHNESS, SPANS, random_conditions
from benchmarks.errors import error_rows
from benchmarks.extremes import beyond_float64, judge_extremes, verdict
from benchmarks.library import solutions
from benchmarks.measuring import least_seconds, peak_megabytes, wall_seconds
from benchmarks.points import (
    VARIABLES,
    grouped,
    read_rows,
    relative_error,
    relative_errors,
)
from benchmarks.streams import stream_rows
from thirdbody.solver.plan import WAYS

ROOT = Path(__file__).parents[2]
GOLDEN = ROOT / "tests" / "golden"
USUAL = [kind for kind in CLASSES if kind.span == "usual"]


@pytest.fixture(scope="module")
def plain():
    return load_plain_model(ROOT / "verification" / "plain_model.py")


# ---- errors


def test_a_relative_error_is_relative_and_never_nan():
    expected = np.array([2.0, 0.0, 0.0, 1.0, 1e-320, -4.0])
    value = np.array([2.2, 0.0, 1e-320, np.nan, 0.0, -3.0])
    error = relative_error(value, expected)
    np.testing.assert_allclose(error, [0.1, 0.0, 0.0, np.inf, 0.0, 0.25])
    assert relative_error(np.array(1e-300), np.array(0.0)) > 1.0


def test_golden_points_are_grouped_by_what_they_share():
    rows = read_rows(GOLDEN / "accuracy_points.csv")
    groups = grouped(rows)
    assert sum(len(group.rows) for group in groups) == len(rows) >= 500
    for group in groups:
        assert len(set(group.conditions["roughness"])) == 1
        assert all(values.shape == (len(group.rows),) for values in group.expected.values())


@pytest.mark.parametrize("off", [0.0, 1e-6])
def test_an_error_that_is_put_in_is_the_error_that_is_found(off, plain, monkeypatch):
    rows = read_rows(GOLDEN / "accuracy_points.csv")[:64]
    solve = tb.solve

    def spoilt(**given):
        solution = solve(**given)
        return SimpleNamespace(
            **{name: getattr(solution, name) * (1.0 + off) for name in VARIABLES},
            solution_status=solution.solution_status,
            error_bound=solution.error_bound,
        )

    monkeypatch.setattr("benchmarks.library.solve", spoilt)
    table = [row for row in error_rows(rows, [1e-9], plain) if row["method"] == "library"]
    assert {row["variable"] for row in table} == set(VARIABLES)
    for row in table:
        nothing = row["variable"] in ("particle_contact_area_ratio", "fluid_load_fraction")
        assert abs(row["largest_error"] - off * (not nothing)) < 1e-9
        assert row["beyond_rtol"] == (row["points"] if off and not nothing else 0)


def test_golden_points_are_solved_by_every_way():
    (group, *_) = grouped(read_rows(GOLDEN / "accuracy_points.csv"))
    given = group.conditions
    group = group.take(np.flatnonzero(given["viscosity"] * given["particle_diameter"]))
    found = [solution.separation for solution in solutions(group, 1e-3)]
    assert len({values.tobytes() for values in found}) == len(WAYS) == 3
    for values in found:
        assert values.shape == (len(group.rows),)
        np.testing.assert_allclose(values, found[0], rtol=1e-3)


# ---- baselines


@pytest.mark.parametrize("kind", USUAL, ids="-".join)
def test_the_baselines_solve_the_same_equations(kind, parameters, plain):
    given = random_conditions(kind, 6, parameters)
    best = tb.solve(**given, parameters=parameters, rtol=1e-11)
    expected = {name: getattr(best, name) for name in VARIABLES}
    nested = relative_errors(NestedRoots(plain, parameters).solve(**given), expected)
    assert max(errors.max() for errors in nested.values()) < 1e-9
    solver = ElementwiseRoots(parameters, ROUGHNESS["usual"][0], 1e-9)
    elementwise = relative_errors(solver.solve(**given), expected)
    # its nodes hold for d up to six deviations of the summits, which some points exceed
    assert np.median(np.stack(list(elementwise.values()))) < 1e-8


def test_the_reading_of_the_total_load_is_solved_one_by_one_alone(parameters, plain):
    inputs = replace(parameters, film_load="total")
    given = random_conditions(HEAVIEST, 3, inputs) | {"viscosity": np.array([1e-6, 3e-5, 1e-4])}
    best = tb.solve(**given, parameters=inputs, rtol=1e-11)
    assert best.solid_load_fraction.max() == 1.0 > best.solid_load_fraction.min()
    expected = {name: getattr(best, name) for name in VARIABLES}
    nested = relative_errors(NestedRoots(plain, inputs).solve(**given), expected)
    assert max(errors.max() for errors in nested.values()) < 1e-9
    assert np.isnan(ElementwiseRoots(inputs, 3e-7, 1e-9).solve(**given).separation).all()


def test_a_baseline_says_nan_where_it_finds_nothing(parameters, plain):
    given = dict(
        load=1.0, viscosity=0.0, particle_diameter=0.0, roughness=3e-7, particle_density=0.0
    )
    given = {name: np.array([value]) for name, value in given.items()}
    assert np.isnan(NestedRoots(plain, parameters).solve(**given).separation).all()
    assert np.isnan(ElementwiseRoots(parameters, 3e-7, 1e-9).solve(**given).separation).all()


# ---- classes, verdicts, measures


@pytest.mark.parametrize("kind", CLASSES, ids="-".join)
def test_the_points_of_a_class_are_what_its_name_says(kind, parameters):
    given = random_conditions(kind, 100, parameters)
    assert (given["viscosity"] > 0.0).all() == (kind.medium == "lubricated")
    assert (given["particle_diameter"] > 0.0).all() == (kind.bodies == "three_body")
    newtons = given["load"] * parameters.newtons_per_load
    low, high = SPANS[kind.span]["normal_load"]
    assert (low <= newtons).all() and (newtons <= high).all()
    again, other = (random_conditions(kind, 100, parameters, seed) for seed in (4, 5))
    assert np.array_equal(given["load"], again["load"])
    assert not np.array_equal(given["load"], other["load"])


@pytest.mark.parametrize(
    ("status", "error", "bound", "expected"),
    [
        ("converged", 1e-10, 2e-10, "right"),
        ("converged", 1e-8, 2e-8, "wrong"),
        ("not_converged", 1e-10, 2e-10, "wrong"),
        ("not_converged", 1e-8, 2e-8, "refused: the error is below 2.0e-08 only"),
        ("not_converged", 1e-8, 2e-9, "wrong"),
        ("not_converged", np.nan, np.nan, "wrong"),
    ],
)
def test_a_refusal_must_give_a_bound_that_holds(status, error, bound, expected):
    assert verdict({"status": "converged"}, status, error, bound, 1e-9) == expected


@pytest.mark.parametrize(
    ("conditioning", "beyond"), [("0.1", False), ("1e7", True), ("1e-8", True), ("", False)]
)
def test_conditioning_tells_what_float64_cannot_resolve(conditioning, beyond):
    assert beyond_float64({"gap_conditioning": conditioning}, 1e-9) == beyond


def test_a_warning_makes_a_point_wrong(monkeypatch):
    rows = read_rows(GOLDEN / "extremes.csv")[:1]
    monkeypatch.setattr("benchmarks.library.solve", lambda **_: np.log(np.zeros(1)))
    (found,) = judge_extremes(rows, 1e-9)
    assert found["verdict"].startswith("wrong: RuntimeWarning")


def test_waiting_takes_time_on_the_clock_but_not_of_the_processor():
    least = least_seconds(
        {"asleep": lambda: time.sleep(0.05), "awake": lambda: sum(range(10**6))}, 3
    )
    assert least["asleep"] < 0.005 < least["awake"]
    assert 0.05 <= wall_seconds(lambda: time.sleep(0.05)) < 5.0


def test_the_memory_is_what_arrays_hold_at_a_time():
    assert 80.0 < peak_megabytes(lambda: np.ones(10**7)) < 81.0


def test_a_grid_without_room_is_refused_before_it_is_solved(parameters, tmp_path):
    values = {"load": 10**5, "viscosity": 10**5, "particle_diameter": 100, "particle_density": 100}
    with pytest.raises(OSError, match="MB of free space"):
        stream_rows(parameters, {"values": values, "rtol": 1e-3, "rounds": 1}, tmp_path)
    assert not list(tmp_path.iterdir())
