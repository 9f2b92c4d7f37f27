"""What measures the accuracy is itself right: errors, verdicts, the plain solver, times."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import thirdbody as tb
from benchmarks.accuracy import error_rows
from benchmarks.baselines import NestedRoots, load_plain_model
from benchmarks.classes import CLASSES, random_conditions
from benchmarks.extremes import verdict
from benchmarks.points import VARIABLES, read_rows, relative_error

ROOT = Path(__file__).parents[2]
GOLDEN = ROOT / "tests" / "golden"
USUAL = [kind for kind in CLASSES if kind.span == "usual"]


@pytest.fixture(scope="module")
def plain():
    return load_plain_model(ROOT / "verification" / "plain_model.py")


def errors_of(solution, expected):
    """Relative errors of all variables, shape (variables, points)."""
    return np.stack(
        [relative_error(getattr(solution, name), getattr(expected, name)) for name in VARIABLES]
    )


def test_a_relative_error_is_relative_and_never_nan():
    expected = np.array([2.0, 0.0, 0.0, 1.0, 1e-320, -4.0])
    value = np.array([2.2, 0.0, 1e-320, np.nan, 0.0, -3.0])
    error = relative_error(value, expected)
    np.testing.assert_allclose(error, [0.1, 0.0, 0.0, np.inf, 0.0, 0.25])
    assert relative_error(np.array(1e-300), np.array(0.0)) > 1.0


@pytest.mark.parametrize("off", [0.0, 1e-6])
def test_an_error_that_is_put_in_is_the_error_that_is_found(off, plain):
    rows = read_rows(GOLDEN / "accuracy_points.csv")[:8]
    for row in rows:
        row |= {name: str(float(row[name]) / (1.0 + off)) for name in VARIABLES}
    table = [row for row in error_rows(rows, [1e-9], plain) if row["method"].startswith("library")]
    assert {row["method"] for row in table} == {"library", "library_grid"}
    assert {row["variable"] for row in table} == set(VARIABLES)
    for row in table:
        nothing = row["variable"] in ("particle_contact_area_ratio", "fluid_load_fraction")
        assert abs(row["largest_error"] - off * (not nothing)) < 1e-9
        assert row["beyond_rtol"] == (row["points"] if off and not nothing else 0)


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("kind", USUAL, ids="-".join)
def test_the_plain_solver_has_the_same_equations(kind, film_load, parameters, plain):
    inputs = replace(parameters, film_load=film_load)
    given = random_conditions(kind, 6, inputs)
    best = tb.solve(**given, parameters=inputs, rtol=1e-11)
    solved = NestedRoots(plain, inputs).solve(**given)
    assert errors_of(solved, best).max() < 1e-9


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
