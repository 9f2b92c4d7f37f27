"""The whole model against mpmath: tests/golden/generate_solutions.py made the values."""

import csv
from pathlib import Path

import numpy as np

import thirdbody as tb
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solution import OUTSIDE_FILM_FORMULA

GOLDEN = Path(__file__).parents[1] / "golden" / "solutions.csv"
VARIABLES = (
    "total_contact_area",
    "particle_contact_area_ratio",
    "surface_contact_area_ratio",
    "solid_load_fraction",
    "fluid_load_fraction",
    "separation",
    "film_thickness",
)
RTOL = 1e-9


def golden_rows():
    with open(GOLDEN, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def solve_row(row, rtol, way=None):
    conditions = (
        "load",
        "viscosity",
        "particle_diameter",
        "roughness",
        "particle_density",
    )
    inputs = Parameters.on_one_surface(row, float(row["roughness"]))
    return tb.solve(*(float(row[name]) for name in conditions), inputs, rtol, way=way)


def test_there_are_enough_golden_points_over_all_readings():
    rows = golden_rows()
    readings = {
        (
            row["phi_a"],
            row["surface_offset"],
            row["elastic_limits"],
            row["coverage_limits"],
            row["film_load"],
        )
        for row in rows
    }
    assert len(rows) >= 200
    assert len(readings) == 3 * 2 * 2 * 2 * 2


def test_every_variable_within_the_tolerance_asked_for(way):
    errors = {}
    for index, row in enumerate(golden_rows()):
        solution = solve_row(row, RTOL, way)
        outside = OUTSIDE_FILM_FORMULA if row["outside_film_formula"] == "1" else 0
        assert solution.solution_status == outside, row
        for name in VARIABLES:
            # what float64 can hold: below the smallest normal number only zero is asked for
            expected = float(row[name])
            error = abs(float(getattr(solution, name)) - expected)
            errors[index, name] = error / max(abs(expected), np.finfo(float).tiny)
    worst = max(errors, key=errors.get)
    assert errors[worst] < RTOL, (worst, errors[worst], golden_rows()[worst[0]])
