"""Balance of forces, dry and lubricated, against equations written a second time (Eqs. 1-7)."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.data.model_attribute import model_attribute
from thirdbody.model.regimes import SOLUTION_STATUSES

pytestmark = [
    pytest.mark.filterwarnings("error"),
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

RTOL = 1e-9
DIAMETER, ROUGHNESS, DENSITY = 500e-9, 300e-9, 1e11
CONVERGED, OUTSIDE, FAILED, EXCEEDED = map(
    SOLUTION_STATUSES.index,
    ("converged", "outside_film_formula", "not_converged", "load_exceeded"),
)


def solve(load, viscosity, parameters, diameter=DIAMETER, rtol=RTOL):
    return tb.solve(
        load=load,
        viscosity=viscosity,
        particle_diameter=diameter,
        roughness=ROUGHNESS,
        particle_density=DENSITY,
        parameters=parameters,
        rtol=rtol,
    )


@pytest.fixture(scope="module")
def written_again(equations):
    """Makes the second writing of the equations for ``count`` points of these conditions."""

    def make(parameters, count, diameter=DIAMETER):
        model = model_attribute(parameters, np.array([ROUGHNESS]))
        points = np.full(count, diameter), np.full(count, DENSITY)
        return equations(model, 0, ROUGHNESS, *points)

    return make


@pytest.fixture(scope="module")
def zero_load(written_again):
    """The load F_s*(0) that closes the gap when dry."""
    return lambda parameters: written_again(parameters, 1).solid_load(np.zeros(1))[0]


@pytest.mark.parametrize("roughness", [1e-9, 1e-8])
def test_the_share_of_the_fluid_keeps_its_digits_where_it_vanishes(
    parameters, equations, roughness
):
    # large particles hold smooth surfaces apart: a film so thick bears next to nothing
    viscosity = np.geomspace(5e-7, 1e-5, 12)
    load, diameter, density = np.full((3, 12), [[1e-5], [1e-6], [DENSITY]])
    solution = tb.solve(
        load=load,
        viscosity=viscosity,
        particle_diameter=diameter,
        roughness=roughness,
        particle_density=density,
        parameters=parameters,
    )
    assert solution.fluid_load_fraction.max() < 1e-17
    assert solution.fluid_load_fraction.min() > 0.0
    model = model_attribute(parameters, np.array([roughness]))
    again = equations(model, 0, roughness, diameter, density)
    thickness, _ = again.film(solution.fluid_load_fraction * load, viscosity)
    # both sides in error by RTOL, the load by a power of at most 0.2
    assert_allclose(solution.film_thickness, thickness, rtol=1.2 * RTOL)


def test_the_film_of_the_total_load_carries_what_the_solids_leave(parameters, loads, written_again):
    inputs = replace(parameters, film_load="total")
    for viscosity in (25e-6, 90e-6, 150e-6):
        solution = solve(loads, viscosity, inputs)
        again = written_again(inputs, loads.size)
        film = inputs.ball_radius * again.film(loads, viscosity)[0]
        dry = solve(loads, 0.0, inputs).separation
        expected = np.maximum(film, dry)
        assert_allclose(solution.separation, expected, rtol=2.0 * RTOL)
        assert np.array_equal(solution.solid_load_fraction == 1.0, film <= dry)


def test_the_dry_gap_closes_at_the_load_of_touching_mean_planes(interpretation, zero_load):
    greatest = zero_load(interpretation)
    solution = solve(greatest * np.array([0.5, 1.0 - 1e-6]), 0.0, interpretation)
    # the gap is the difference of two loads of which it is a millionth
    assert solution.solution_status.tolist() == [CONVERGED, FAILED]
    assert 1e-9 < solution.error_bound[1] < 1e-7
    assert 0.0 < solution.separation[1] < 1e-5 * ROUGHNESS
    assert solution.separation[1] < solution.separation[0]


@pytest.mark.parametrize("rtol", [1e-2, 1e-3, 1e-6, 1e-9, 1e-11])
@pytest.mark.parametrize("excess", [0.04, 0.5, 1e3])
def test_a_dry_load_beyond_zero_separation_is_not_solved(parameters, zero_load, rtol, excess):
    load = zero_load(parameters) * np.array([0.9, 1.0 + excess])
    solution = solve(load, 0.0, parameters, rtol=rtol)
    assert solution.solution_status.tolist() == [CONVERGED, EXCEEDED]
    assert solution.separation_count.tolist() == [1, 0]
    assert np.isnan(solution.separation[1])


def test_a_film_bears_any_load_but_not_all_within_its_formula(interpretation, zero_load):
    load = zero_load(interpretation) * np.array([0.9, 1.1, 10.0, 1e4])
    solution = solve(load, 90e-6, interpretation)
    in_film = load * (solution.fluid_load_fraction if interpretation.film_load == "fluid" else 1.0)
    hardness = min(interpretation.hardness_surface_1, interpretation.hardness_surface_2)
    beyond = in_film > hardness / interpretation.elastic_modulus_surfaces
    assert beyond[-1] and not beyond[0]
    assert (solution.solution_status == np.where(beyond, OUTSIDE, CONVERGED)).all()
    assert (np.diff(solution.separation) < 0.0).all()
    assert (solution.separation > 0.0).all()


@pytest.mark.parametrize("rtol", [1e-2, 1e-3, 1e-4, 1e-6])
@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
@pytest.mark.parametrize("limits", ["printed", "physical"])
def test_what_a_tight_request_solves_a_loose_one_solves_too(parameters, rtol, viscosity, limits):
    # a few particles far larger than the roughness carry the lightest loads
    inputs = replace(parameters, elastic_limits=limits)
    load = np.geomspace(1e-11, 1e-5, 200)
    tight, loose = (
        tb.solve(
            load=load,
            viscosity=viscosity,
            particle_diameter=1e-6,
            roughness=1e-7,
            particle_density=DENSITY,
            parameters=inputs,
            rtol=asked,
        )
        for asked in (1e-9, rtol)
    )
    assert np.array_equal(tight.solution_status == CONVERGED, tight.error_bound <= 1e-9)
    assert (tight.error_bound < 1e-7).all()
    assert (loose.solution_status == CONVERGED).all()
    assert_allclose(loose.separation, tight.separation, rtol=rtol)
    assert_allclose(loose.solid_load_fraction, tight.solid_load_fraction, rtol=rtol)


def test_dry_contact_is_the_limit_of_a_vanishing_fluid_share(parameters, loads):
    film = solve(loads, 10e-6, parameters)
    share = film.fluid_load_fraction
    limit = (film.solution_status == CONVERGED) & (share < 1e-4)
    assert limit.sum() > 10
    # the solids bear 1 - L_f of the load: d rises by L_f/|d ln F_s/d ln d|, a slope above 1
    excess = film.separation / solve(loads, 0.0, parameters).separation - 1.0
    assert (excess[limit] >= -2.0 * RTOL).all()
    assert (excess[limit] <= share[limit] + 2.0 * RTOL).all()
