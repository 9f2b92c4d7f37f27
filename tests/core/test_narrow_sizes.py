"""Particles of nearly one size: the load of solids falls steeply within their sizes, and is the
same to within rounding wherever all of them are elastic."""

from dataclasses import replace

import numpy as np
import pytest
from methods import solved_by

import thirdbody as tb
from thirdbody.core.contact import Contact
from thirdbody.core.film import Film, log_load_parameter

NOT_CONVERGED = "not_converged"
DIAMETER, ROUGHNESS, DENSITY = 3e-6, 100e-9, 1e9
GIVEN = {"particle_diameter": DIAMETER, "roughness": ROUGHNESS, "particle_density": DENSITY}
SPREAD = 3e-5  # of a diameter
INSIDE, OUTSIDE = 1.0 - 10.0 * SPREAD, 1.0 + 7.0 * SPREAD  # of all sizes, of a diameter


@pytest.fixture(scope="module")
def narrow(parameters):
    """Inputs with nearly one size."""
    sizes = {"mean_ratio": 1.0, "spread_ratio": SPREAD, "truncation": 7.0, "participation": 1.0}
    return replace(parameters, elastic_depth_ratio=0.1, **sizes)


def borne(inputs, separation, **given):
    """F_s* at separations [m]."""
    separation = np.asarray(separation, float)
    columns = [np.full(separation.shape, value) for value in {**GIVEN, **given}.values()]
    return np.exp(Contact.of(*columns, inputs).at(separation).log_load.value)


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("viscosity", [0.0, 9e-6])
def test_a_load_of_which_rounding_tells_no_separation_is_not_converged(
    narrow, method, viscosity, film_load
):
    inputs = replace(narrow, film_load=film_load)
    plateau = borne(inputs, [1.05 * DIAMETER])
    factors = np.array([1.0 - 1e-3, 1.0 - 1e-14, 1.0, 1.0 + 1e-14, 1.0 + 1e-3])
    given = GIVEN | {"load": plateau * factors, "viscosity": viscosity}
    found = tb.solve(**given, parameters=inputs, rtol=1e-8)
    undecided = [False, True, True, True, False]
    assert (found.solution_status == NOT_CONVERGED).tolist() == undecided
    assert np.isinf(found.error_bound).tolist() == undecided
    assert INSIDE < found.separation[0] / (1.1 * DIAMETER) < OUTSIDE  # at its outer end
    assert INSIDE < found.separation[4] / DIAMETER < OUTSIDE  # where particles yield


def test_where_rounding_tells_nothing_beyond_the_film_that_is_said(narrow, method):
    """A film under the total load that lies on a plateau as high as the load, or higher by
    rounding.
    """
    inputs = replace(narrow, film_load="total", elastic_depth_ratio=0.3)
    plateau = borne(inputs, [1.15 * DIAMETER])[0]
    log_parameter = log_load_parameter(np.log(plateau), inputs)
    oils = np.geomspace(1e-6, 1e-1, 500)
    thickness = inputs.ball_radius * Film.of(oils, ROUGHNESS, inputs).thickness(log_parameter)[0]
    oil = oils[np.argmin(np.abs(thickness - 1.15 * DIAMETER))]
    given = GIVEN | {"load": plateau * np.array([1.0, 1.0 - 1e-14]), "viscosity": oil}
    found = tb.solve(**given, parameters=inputs)
    assert (found.solution_status == NOT_CONVERGED).all()
    assert (found.separation > OUTSIDE * DIAMETER).all()
    assert np.isinf(found.error_bound).all()


def test_a_film_on_a_plateau_below_the_load_keeps_its_separation(narrow, method):
    """Under the total load: whatever the solids leave, at every separation of the plateau the
    same."""
    inputs = replace(narrow, film_load="total", elastic_depth_ratio=0.3)
    load, oils = 2.0 * borne(inputs, [1.15 * DIAMETER]), np.geomspace(1e-6, 1e-1, 500)
    film = Film.of(oils, ROUGHNESS, inputs).thickness(log_load_parameter(np.log(load), inputs))[0]
    on_plateau = np.abs(inputs.ball_radius * film / DIAMETER - 1.15) < 0.1
    found = tb.solve(**GIVEN, load=load, viscosity=oils[on_plateau], parameters=inputs)
    assert np.count_nonzero(on_plateau) > 5
    np.testing.assert_allclose(found.film_thickness, film[on_plateau], rtol=1e-12)
    np.testing.assert_allclose(found.solid_load_fraction, 0.5, rtol=1e-12)


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
@pytest.mark.parametrize("rtol", [1e-2, 1e-4])
def test_what_particles_lose_within_an_error_is_in_its_bound(narrow, rtol, viscosity, film_load):
    inputs = replace(narrow, film_load=film_load)
    for diameter, density in ((DIAMETER, DENSITY), (1e-7, 1e10), (1e-7, 1e13)):
        given = {"particle_diameter": diameter, "particle_density": density}
        d = diameter * np.concatenate([1.0 + SPREAD * np.linspace(-10.0, 8.0, 200), [1.05, 1.099]])
        points = GIVEN | given | {"load": borne(inputs, d, **given), "viscosity": viscosity}
        with solved_by("quadrature"):
            exact = tb.solve(**points, parameters=inputs, rtol=rtol)
        with solved_by("tables"):
            found = tb.solve(**points, parameters=inputs, rtol=rtol)
        known = np.isfinite(found.error_bound)
        bound = found.error_bound + exact.error_bound * (1.0 + found.error_bound)
        for name in ("separation", "particle_contact_area_ratio", "total_contact_area"):
            right = getattr(exact, name)
            assert (np.abs(getattr(found, name) - right) <= bound * right)[known].all(), name
