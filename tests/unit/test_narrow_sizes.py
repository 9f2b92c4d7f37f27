"""Particles of nearly one size: the load of solids falls or rises steeply within their sizes, and is the
same to within rounding wherever all of them are elastic."""

from dataclasses import replace

import numpy as np
import pytest
from methods import solved_by

import thirdbody as tb
from thirdbody.model.film import Film, log_load_parameter
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.points import make_contact

NOT_CONVERGED = SOLUTION_STATUSES.index("not_converged")
DIAMETER, ROUGHNESS, DENSITY = 3e-6, 100e-9, 1e9
GIVEN = {"particle_diameter": DIAMETER, "roughness": ROUGHNESS, "particle_density": DENSITY}
SPREAD = 3e-5  # of a diameter
INSIDE, OUTSIDE = 1.0 - 10.0 * SPREAD, 1.0 + 7.0 * SPREAD  # of all sizes, of a diameter


@pytest.fixture(scope="module")
def narrow(parameters):
    """Inputs with nearly one size."""
    sizes = {"mean_ratio": 1.0, "spread_ratio": SPREAD, "truncation": 7.0, "participation": 1.0}
    return replace(parameters, size_distribution="centred", elastic_depth_ratio=0.1, **sizes)


@pytest.fixture(scope="module")
def soft(narrow):
    """Inputs with particles that bear more while elastic, before those of the same size yield."""
    return replace(narrow, elastic_limits="physical", elastic_modulus_particle=1e10)


def borne(inputs, separation, **given):
    """F_s* at separations [m]."""
    separation = np.asarray(separation, float)
    columns = [np.full(separation.shape, value) for value in {**GIVEN, **given}.values()]
    return np.exp(make_contact(*columns, inputs, None).at(separation).log_load.value)


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
def test_a_load_of_which_rounding_tells_no_separation_is_not_converged(
    soft, method, viscosity, film_load
):
    inputs = replace(soft, film_load=film_load)
    plateau = borne(inputs, [0.97 * DIAMETER])
    factors = np.array([1.0 - 1e-3, 1.0 - 1e-14, 1.0, 1.0 + 1e-14, 1.0 + 1e-3])
    given = GIVEN | {"load": plateau * factors, "viscosity": viscosity}
    found = tb.solve(**given, parameters=inputs, rtol=1e-8)
    undecided = [False, True, True, True, False]
    assert (found.solution_status == NOT_CONVERGED).tolist() == undecided
    assert np.isinf(found.error_bound).tolist() == undecided
    assert found.separation_count[[0, 4]].tolist() == [3, 1]
    assert INSIDE < found.separation[0] / DIAMETER < OUTSIDE  # at its outer end
    assert found.separation[4] < 0.5 * DIAMETER  # where summits touch


def test_where_rounding_tells_nothing_beyond_the_film_that_stays(soft, method):
    """A film under the total load that lies on a plateau as high as the load, or higher by rounding."""
    inputs = replace(soft, film_load="total", elastic_depth_ratio=0.3)
    plateau = borne(inputs, [0.85 * DIAMETER])[0]
    log_parameter = log_load_parameter(np.log(plateau), inputs)
    oils = np.geomspace(1e-6, 1e-1, 500)
    thickness = inputs.ball_radius * Film.of(oils, ROUGHNESS, inputs).thickness(log_parameter)[0]
    oil = oils[np.argmin(np.abs(thickness - 0.85 * DIAMETER))]
    given = GIVEN | {"load": plateau * np.array([1.0, 1.0 - 1e-14]), "viscosity": oil}
    found = tb.solve(**given, parameters=inputs)
    assert (found.solution_status == NOT_CONVERGED).all()
    assert ((found.separation > 0.75 * DIAMETER) & (found.separation < OUTSIDE * DIAMETER)).all()
    assert np.isinf(found.error_bound).all()


def test_a_crest_that_summits_and_particles_bear_together_is_found(soft, method):
    given = {"particle_diameter": 300e-9, "particle_density": 1e11}
    places = 300e-9 * np.array([INSIDE, OUTSIDE, 0.6])
    crest, summits, closer = borne(soft, places, **given)
    assert 0.005 < summits / crest < 0.5
    assert closer < 0.7 * crest
    given |= {"roughness": ROUGHNESS, "load": 0.99 * crest, "viscosity": 0.0}
    found = tb.solve(**given, parameters=soft)
    assert found.separation_count == 3
    assert places[0] < found.separation < places[1]


@pytest.mark.parametrize(("diameter", "least"), [(2.59e-6, 1e-9), (2.75e-6, 8e-11)])
def test_a_crest_that_stands_out_by_little_more_than_rounding_is_found(soft, diameter, least):
    """Where the last sizes yield, and summits that bear next to nothing decide which way F_s goes."""
    inputs = replace(soft, particle_plane="surface", elastic_depth_ratio=0.05)
    inputs = replace(inputs, summit_offset_ratio=0.0, summit_deviation_ratio=1.0)
    inputs = replace(inputs, mean_ratio=0.7, spread_ratio=2e-5, truncation=7.3, participation=1e-3)
    inputs = replace(inputs, elastic_modulus_particle=5e9, coverage_limits="contacting")
    inputs = replace(inputs, hardness_surface_1=2.5e9, hardness_surface_2=3.5e8)
    given = {"particle_diameter": diameter, "roughness": 300e-9, "particle_density": 1e11}
    places = diameter * (0.65 + 2e-5 * np.linspace(4.0, 7.2, 2001))
    loads = borne(inputs, places, **given)
    crest = loads.argmax()
    assert least < loads[crest] / loads[-1] - 1.0 < 1.3 * least
    given |= {"load": loads[crest] * (1.0 - 5e-12), "viscosity": 0.0}
    found = tb.solve(**given, parameters=inputs, rtol=1e-3)
    assert found.separation_count == 3
    assert found.separation == pytest.approx(places[crest], rel=2e-5)


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("limits", ["printed", "physical"])
@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
@pytest.mark.parametrize("rtol", [1e-2, 1e-4])
def test_what_particles_lose_within_an_error_is_in_its_bound(
    narrow, rtol, viscosity, limits, film_load
):
    inputs = replace(narrow, elastic_limits=limits, film_load=film_load)
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


def test_separations_at_which_particles_cover_everything_do_not_count(narrow, method):
    inputs = replace(narrow, coverage_limits="contacting", elastic_limits="physical")
    given = {"particle_diameter": 100e-9, "roughness": 300e-9, "particle_density": 1e14}
    inside, outside = 100e-9 * np.array([INSIDE, OUTSIDE])
    elastic, summits = borne(inputs, [inside, outside], **given)  # no summit is left bare inside
    load = np.sqrt(elastic * summits)
    assert elastic < 0.8 * load
    assert borne(inputs, [0.0], **given) > load  # where particles are plastic
    found = tb.solve(load=load, viscosity=0.0, **given, parameters=inputs)
    assert found.separation > outside
    assert found.separation_count == 2


def test_nor_do_they_where_a_crest_elsewhere_bears_the_load(parameters):
    inputs = replace(
        parameters,
        **{"coverage_limits": "contacting", "elastic_limits": "physical"},
        **tb.mccool_summits(1.4),
        **{"size_distribution": "uncentred", "spread_ratio": 0.3, "truncation": 5.4},
        **{"particle_plane": "surface", "participation": 0.87, "elastic_depth_ratio": 1.3},
        **{"elastic_modulus_surfaces": 1.1e10, "elastic_modulus_particle": 8e11},
        **{"hardness_surface_1": 5e9, "hardness_surface_2": 1.3e8, "yield_pressure_ratio": 0.12},
        **{"summit_parameter": 1.4, "summit_radius": 2e-6, "summit_radius_exponent": 0.0},
    )
    given = {"particle_diameter": 380e-9, "roughness": 380e-9, "particle_density": 2e16}
    places = 380e-9 * np.linspace(1.2, 1.6, 1001)
    loads = borne(inputs, places, **given)
    crest = loads.argmax()
    assert 0 < crest < 1000
    load = 0.999 * loads[crest]
    assert borne(inputs, [0.0], **given) > load
    with pytest.warns(tb.OutOfRangeWarning):
        found = tb.solve(load=load, viscosity=0.0, **given, parameters=inputs)
    assert found.separation_count == 2
    assert found.separation > places[crest]
