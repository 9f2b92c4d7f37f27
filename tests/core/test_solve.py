"""The elementwise interface: shapes, types, statuses, misuse, and what is not computed."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from methods import POINT
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.variables import FLAGS, QUANTITIES, VARIABLES

pytestmark = [
    pytest.mark.filterwarnings("error"),
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

RTOL, TINY = 1e-9, np.finfo(float).tiny
CONVERGED, OUTSIDE, EXCEEDED = "converged", "outside_film_formula", "load_exceeded"


def solve(parameters, rtol=RTOL, **given):
    return tb.solve(**(POINT | given), parameters=parameters, rtol=rtol)


def assert_same(one, other, rtol=0.0):
    """Equal in every variable; ``rtol`` relative in the quantities."""
    for name in QUANTITIES:
        assert_allclose(getattr(one, name), getattr(other, name), rtol=rtol, err_msg=name)
    for name in FLAGS:
        assert np.array_equal(getattr(one, name), getattr(other, name)), name


@pytest.fixture(scope="module")
def mixture():
    """Points of every kind on three surfaces: dry, lubricated, two-body, three-body, unsolvable."""
    random = np.random.default_rng(0)
    count = 60
    return {
        "load": np.append(random.uniform(1e-7, 1e-4, count - 3), [1.0, 1e-6, 1e-12]),
        "viscosity": [*random.choice([0.0, 1e-7, 25e-6, 90e-6], count - 3), 0.0, 0.0, 1e-7],
        "particle_diameter": [*random.choice([0.0, 2e-7, 8e-7], count - 3), 5e-7, 1e-4, 0.0],
        "roughness": random.choice([1e-7, 3e-7, 5e-7], count),
        "particle_density": [*random.choice([0.0, 1e11, 1e12], count - 3), 1e11, 1e12, 0.0],
    }


def same_bits(one, other, name):
    """Whether two solutions have the same values of a variable."""
    return np.array_equal(getattr(one, name), getattr(other, name), equal_nan=name not in FLAGS)


def test_an_array_is_solved_as_its_points_are_one_by_one(interpretation, mixture):
    together = solve(interpretation, **mixture)
    for index in range(len(mixture["load"])):
        alone = solve(interpretation, **{name: values[index] for name, values in mixture.items()})
        for name in VARIABLES:
            value, expected = getattr(together, name)[index], getattr(alone, name)
            if name in FLAGS:
                assert value == expected, name
            else:  # sums over the nodes of the quadrature may take another order: a few roundings
                assert_allclose(value, expected, rtol=1e-12, err_msg=name)


def test_the_five_arguments_broadcast_against_each_other(parameters):
    axes = {
        "load": np.geomspace(1e-6, 1e-4, 4)[:, None, None],
        "viscosity": np.array([0.0, 90e-6])[:, None],
        "particle_diameter": np.array([0.0, 3e-7, 5e-7]),
    }
    grid = solve(parameters, **axes)
    assert grid.separation.shape == (4, 2, 3)
    full = dict(zip(axes, (a.copy() for a in np.broadcast_arrays(*axes.values())), strict=True))
    assert_same(grid, solve(parameters, **full))


@pytest.mark.parametrize("name", VARIABLES)
def test_each_variable_has_the_shape_of_the_points_and_its_type(parameters, name):
    for shape in ((), (1,), (2, 3), (0,), (3, 0)):
        values = getattr(solve(parameters, load=np.full(shape, 1e-5)), name)
        assert isinstance(values, np.ndarray)
        assert values.shape == shape
        assert values.dtype == (object if name in FLAGS else np.float64)


@pytest.mark.parametrize("many", [3, 600])
def test_points_of_many_surfaces_are_the_same_bits_in_any_order(parameters, many):
    random = np.random.default_rng(2)
    spans = (1e-8, 1e-3), (1e-6, 2e-4), (1e-7, 1e-6), (1e-7, 5e-7), (1e9, 1e13)
    columns = [np.exp(random.uniform(*np.log(ends), 1800)) for ends in spans]
    columns[3] = np.geomspace(1e-7, 5e-7, many)[random.integers(many, size=1800)]
    given = dict(zip(POINT, columns, strict=True))
    order = random.permutation(1800)
    first = solve(parameters, **given)
    shuffled = solve(parameters, **{name: values[order] for name, values in given.items()})
    for name in VARIABLES:
        values, expected = getattr(shuffled, name), getattr(first, name)[order]
        assert np.array_equal(values, expected, equal_nan=name not in FLAGS)


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("particle_diameter", [0.0, 3e-7])
@pytest.mark.parametrize("rtol", [1e-3, RTOL])
def test_no_film_presses_harder_than_the_softer_surface_is(
    defaults, method, rtol, film_load, particle_diameter
):
    inputs = replace(defaults.best, film_load=film_load, hardness_surface_2=3e9)
    hardest = 3e9 / inputs.elastic_modulus_surfaces
    loads = np.array([0.99 * hardest, 1.05 * hardest, 1.0, 1e10, 1e308])
    given = {"particle_diameter": particle_diameter, "rtol": rtol}
    together = solve(inputs, load=loads, **given)
    # at the first load but one the film bears some 98 %: more than it can, all or its share
    assert together.solution_status.tolist() == [CONVERGED, *[OUTSIDE] * 4]
    assert (together.fluid_load_fraction > 0.97).all()
    for load, status in zip(loads, together.solution_status):
        assert solve(inputs, load=load, **given).solution_status == status
    assert (solve(inputs, load=loads[1:], viscosity=0.0).solution_status == EXCEEDED).all()


@pytest.mark.parametrize("name", VARIABLES)
def test_a_variable_alone_is_what_it_is_among_all(parameters, mixture, name):
    every = solve(parameters, **mixture)
    alone = solve(parameters, **mixture, variables=[name])
    assert same_bits(alone, every, name)
    assert list(alone.variables) == [name]
    with pytest.raises(AttributeError):
        getattr(alone, next(other for other in VARIABLES if other != name))


def test_a_solution_prints_what_each_variable_is_with_names_for_flags(parameters):
    given = {"viscosity": 0.0, "particle_diameter": 3e-7, "parameters": parameters}
    lines = repr(solve(load=1e-6, **given)).splitlines()
    assert lines[0] == "Solution of shape ()"
    values = dict(line.split(maxsplit=1) for line in lines[1:])
    assert values["lubrication_regime"] == "boundary"
    assert values["solution_status"] == "converged"
    assert float(values["solid_load_fraction"]) == 1.0
    lines = repr(solve(load=[1e-6, 1e-5], **given, variables=("separation", "contact_mode")))
    assert "Solution of shape (2,)" in lines
    assert " to " in lines


def test_the_same_call_gives_the_same_bits_whatever_was_called_before(parameters, loads):
    given = {"load": np.tile(loads, 12), "viscosity": 90e-6}
    first = solve(parameters, **given)
    solve(parameters, load=loads[:3])
    solve(parameters, load=np.tile(loads, 15), roughness=1e-7)
    with ThreadPoolExecutor(2) as pool:
        others = [pool.submit(solve, parameters, **given) for _ in range(2)]
        others = [solve(parameters, **given), *(each.result() for each in others)]
    for other in others:
        for name in VARIABLES:
            assert same_bits(other, first, name), name


@pytest.mark.parametrize("rtol", [1e-2, 1e-6, 1e-9, 1e-11])
def test_a_point_alone_is_within_both_bounds_of_what_it_is_among_many(interpretation, rtol):
    load = np.geomspace(1e-8, 1e-3, 2000)
    many = solve(interpretation, rtol, load=load, viscosity=60e-6)
    for index in range(0, load.size, 61):
        alone = solve(interpretation, rtol, load=load[index], viscosity=60e-6)
        bounds = many.error_bound[index] + alone.error_bound
        for name in QUANTITIES:
            together, value = getattr(many, name)[index], getattr(alone, name)
            assert np.abs(together - value) <= 1.01 * bounds * np.abs(value) + TINY, name
        decided = (
            np.abs(np.log10(np.array([many.error_bound[index], alone.error_bound]) / rtol)) > 1.0
        )
        if decided.all():
            assert many.solution_status[index] == alone.solution_status


@pytest.mark.parametrize("wrapped", [np.asarray, lambda a: xr.DataArray(a, dims="load")])
def test_conditions_of_a_solution_are_copies(parameters, loads, wrapped):
    given = loads.copy()
    found = solve(parameters, load=wrapped(given))
    assert np.array_equal(given, loads)  # and what is given is left alone
    given[:] = 1.0
    assert np.array_equal(found.conditions["load"], loads)


LARGE = {"particle_diameter": 1e-6, "roughness": 1e-7}


@pytest.mark.parametrize("rtol", [1e-2, 1e-3, 1e-4, 1e-6])
@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
def test_what_a_tight_request_solves_a_loose_one_solves_too(parameters, rtol, viscosity):
    # a few particles far larger than the roughness carry the lightest loads
    load = np.geomspace(1e-11, 1e-5, 200)
    tight, loose = (
        solve(parameters, asked, load=load, viscosity=viscosity, **LARGE) for asked in (1e-9, rtol)
    )
    assert np.array_equal(tight.solution_status == CONVERGED, tight.error_bound <= 1e-9)
    assert (tight.error_bound < 1e-7).all()
    assert (loose.solution_status == CONVERGED).all()
    assert_allclose(loose.separation, tight.separation, rtol=rtol)
    assert_allclose(loose.solid_load_fraction, tight.solid_load_fraction, rtol=rtol)
