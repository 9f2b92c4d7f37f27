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


def parameters_of(row) -> Parameters:
    """The inputs of a golden row; its surface is given at its own roughness."""
    number = {name: float(text) for name, text in row.items() if _is_number(text)}
    return Parameters(
        elastic_modulus_surfaces=number["E_ss"],
        elastic_modulus_particle=number["E_sa"],
        hardness_surface_1=number["H_s1"],
        hardness_surface_2=number["H_s2"],
        yield_pressure_ratio=number["k"],
        plastic_interference_ratio=number["omega_ratio"],
        ball_radius=number["R_x"],
        material_parameter=number["G"],
        hardness_parameter=number["V"],
        speed_per_viscosity=number["U_per_viscosity"],
        ellipticity=number["kappa"],
        apparent_area=number["A_n"],
        reference_roughness=number["roughness"],
        summit_parameter=number["eta_s"] * number["R"] * number["roughness"],
        summit_parameter_exponent=0.0,
        summit_radius=number["R"],
        summit_radius_exponent=0.0,
        summit_offset=row["surface_offset"] == "1",
        size_distribution=row["phi_a"],
        mean_ratio=number["mean_ratio"],
        spread_ratio=number["sigma_a_ratio"],
        gap_ratio=number["gap_ratio"],
        truncation=number["truncation"],
        participation=number["participation"],
        elastic_depth_ratio=number["h_e_ratio"],
        elastic_limits=row["elastic_limits"],
        coverage_limits=row["coverage_limits"],
        film_load=row["film_load"],
    )


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def solve_row(row, rtol):
    conditions = (
        "load",
        "viscosity",
        "particle_diameter",
        "roughness",
        "particle_density",
    )
    return tb.solve(*(float(row[name]) for name in conditions), parameters_of(row), rtol)


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
        solution = solve_row(row, RTOL)
        outside = OUTSIDE_FILM_FORMULA if row["outside_film_formula"] == "1" else 0
        assert solution.solution_status == outside, row
        for name in VARIABLES:
            # what float64 can hold: below the smallest normal number only zero is asked for
            expected = float(row[name])
            error = abs(float(getattr(solution, name)) - expected)
            errors[index, name] = error / max(abs(expected), np.finfo(float).tiny)
    worst = max(errors, key=errors.get)
    assert errors[worst] < RTOL, (worst, errors[worst], golden_rows()[worst[0]])
