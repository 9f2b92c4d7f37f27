"""Friction and contact resistance, and the fit of their coefficients."""

import numpy as np
import pandas as pd
import pint
import pytest

import thirdbody as tb
from thirdbody.lab.estimates import COEFFICIENTS, fitted_coefficients


def test_friction_is_what_both_carry(solved):
    expected = 0.2 * solved.solid_load_fraction + 0.05 * solved.fluid_load_fraction
    np.testing.assert_allclose(tb.lab.friction(solved, 0.2, 0.05), expected, rtol=1e-15)


def test_resistance_is_that_of_one_spot_of_the_area(solved, defaults):
    radius = np.sqrt(solved.total_contact_area * defaults.apparent_area / np.pi)
    found = tb.lab.contact_resistance(solved, pint.Quantity(10.0, "uohm cm"))
    np.testing.assert_allclose(found, 1e-7 / (2.0 * radius), rtol=1e-12)


def test_named_dimensions_and_points_without_solution_are_kept(rest):
    xr = pytest.importorskip("xarray")
    sizes = xr.DataArray([500.0, 9e5], dims="size")
    found = tb.lab.friction(tb.solve(load_N=10, **rest | {"particle_diameter_nm": sizes}))
    assert found.dims == ("size",) and np.isnan(found.values).tolist() == [False, True]


def test_the_resistance_is_that_of_the_area_of_the_inputs(rest, defaults):
    other = defaults.changed(apparent_area=2.0 * defaults.apparent_area)
    dry = rest | {"load": 1e-5, "viscosity_cSt": 0}
    points = tb.solve(**dry, parameters=other)
    expected = tb.lab.contact_resistance(tb.solve(**dry)) / np.sqrt(2.0)
    np.testing.assert_allclose(tb.lab.contact_resistance(points), expected, rtol=1e-12)


def test_coefficients_that_cannot_be_are_refused(solved):
    with pytest.raises(ValueError):
        tb.lab.friction(solved, boundary_friction=-0.1)
    with pytest.warns(tb.OutOfRangeWarning):
        tb.lab.friction(solved, boundary_friction=12)


@pytest.fixture
def points(rest):
    return tb.solve(load_N=np.geomspace(1.0, 50.0, 9), **rest)


def fitted(measured, points, **known):
    return fitted_coefficients(pd.DataFrame(measured), points, known)


def test_coefficients_are_fitted(points):
    scatter = 1.0 + 0.02 * np.random.default_rng(3).standard_normal((2, 9))
    measured = {
        "friction_coefficient": tb.lab.friction(points, 0.15, 0.05) * scatter[0],
        "contact_resistance_ohm": tb.lab.contact_resistance(points, 4e-7) * scatter[1],
    }
    found, notes = fitted(measured, points)
    assert found["boundary_friction"] == pytest.approx(0.15, rel=0.03)
    assert found["film_friction"] == pytest.approx(0.05, rel=0.15)
    assert found["resistivity_ohm_m"] == pytest.approx(4e-7, rel=0.03)
    assert sum("standard error" in note for note in notes) == 3


def test_standard_errors_are_those_of_many_repetitions(points, defaults):
    """The scatter of the fit over many sets of measurements is the standard error that it says."""
    from thirdbody.lab.estimates import _least_squares

    terms = np.column_stack([points.solid_load_fraction, points.fluid_load_fraction])
    random = np.random.default_rng(1)
    values, errors = np.transpose(
        [
            _least_squares(terms, terms @ [0.12, 0.03] + 0.002 * random.standard_normal(9))
            for _ in range(400)
        ],
        (1, 0, 2),
    )
    said = np.sqrt((errors**2).mean(axis=0))
    np.testing.assert_allclose(values.std(axis=0), said, rtol=0.12)
    np.testing.assert_allclose(values.mean(axis=0), [0.12, 0.03], atol=3.0 * said.max() / 20.0)


def test_given_coefficients_are_kept(points):
    friction = tb.lab.friction(points, 0.15, 0.05)
    found, _ = fitted({"friction_coefficient": friction}, points, film_friction=0.05)
    assert found["film_friction"] == 0.05
    assert found["boundary_friction"] == pytest.approx(0.15)
    found, _ = fitted({"friction_coefficient": friction}, points, film_friction=0.02)
    assert found["boundary_friction"] > 0.15


def test_what_the_measurements_do_not_tell_has_its_default(rest):
    dry = tb.solve(load_N=[1.0, 5.0, 20.0], **rest | {"viscosity_cSt": 0})
    found, notes = fitted({"friction_coefficient": [0.101, 0.1, 0.099]}, dry)
    assert found["film_friction"] == COEFFICIENTS["film_friction"]
    assert found["boundary_friction"] == pytest.approx(0.1, rel=0.01)
    assert any("film_friction" in note and "do not tell" in note for note in notes)
    one = tb.solve(load_N=[10.0], **rest)
    found, _ = fitted({"friction_coefficient": [0.09]}, one)
    assert found == COEFFICIENTS
    found, notes = fitted({"contact_resistance_ohm": [np.nan, 0.1, 0.0]}, dry)
    assert found == COEFFICIENTS and any("resistivity" in note for note in notes)


def test_a_negative_coefficient_is_no_fit(points):
    friction = 0.1 * points.solid_load_fraction - 0.05 * points.fluid_load_fraction
    found, _ = fitted({"friction_coefficient": friction}, points)
    assert min(found.values()) > 0.0
