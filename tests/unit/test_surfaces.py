"""Tables of the summits, of one surface or shared by many, against quadrature."""

from functools import partial

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.model.asperity import SummitPopulation
from thirdbody.solver.solution import QUANTITIES
from thirdbody.solver.surfaces import (
    CELL,
    CELL_START,
    FEW_SURFACES,
    TABLE_END,
    RoughSurfaces,
    Sheet,
    few_surfaces,
    prepare_tables,
    shared_tables,
)

MATERIALS = (0.02, 0.4, 54.0)  # H/E, k and omega_2/omega_1


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("log_yield", [-12.0, -6.0, -2.5, -1.0, 0.5, 4.0])
def test_a_cell_is_as_good_as_it_says(log_yield, rtol):
    sheet = Sheet.of_cell(log_yield // CELL, MATERIALS)
    tables = prepare_tables(sheet, rtol)
    assert tables.error <= 0.1 * rtol
    t = np.random.default_rng(3).uniform(CELL_START, TABLE_END, 500)
    for place in (-1.0, -0.8, -0.1, 0.4, 1.0):
        population = sheet.population(place)
        for table, curve in (
            (tables.log_load, population.log_load),
            (tables.log_area, population.log_area),
        ):
            (value, slope), (exact, exact_slope) = table(t, place), curve(t)
            assert np.abs(value - exact).max() <= 2.0 * tables.error + 1e-12
            assert np.abs(slope / exact_slope - 1.0).max() <= 1e4 * tables.error + 1e-10


def test_summits_depend_on_yield_interference_alone(parameters):
    t = np.linspace(-3.0, 20.0, 50)
    for roughness in (5e-8, 3e-7, 1e-6):
        population = SummitPopulation.of(parameters.surface(roughness), parameters)
        unit = SummitPopulation.of_unit(population.yield_interference, population.materials)
        for one, other in zip(
            population.log_load_and_area(t), unit.log_load_and_area(t), strict=True
        ):
            value = other[0] + np.log(population.summit_parameter)
            np.testing.assert_allclose(one[0], value, rtol=0.0, atol=1e-12)
            np.testing.assert_allclose(one[1], other[1], rtol=1e-12)


@pytest.mark.parametrize("table_rtol", [None, 1e-9])
@pytest.mark.parametrize("count", [1, 2, FEW_SURFACES, 500])
def test_many_surfaces_are_what_each_is_alone(parameters, table_rtol, count):
    roughness = np.random.default_rng(4).permutation(np.geomspace(5e-8, 1e-6, count))
    shape = (3, count)  # several separations of each
    t = np.random.default_rng(5).uniform(-3.0, 45.0, shape)
    together = RoughSurfaces.of(roughness, parameters, table_rtol)
    error = 1e-10 if table_rtol else 1e-12
    for name in ("log_load", "log_area"):
        value, slope = getattr(together, name)(t)
        assert value.shape == slope.shape == shape
        for point in range(0, count, 97):
            alone = SummitPopulation.of(parameters.surface(float(roughness[point])), parameters)
            exact, exact_slope = getattr(alone, name)(t[:, point])
            np.testing.assert_allclose(value[:, point], exact, rtol=1e-13, atol=error)
            np.testing.assert_allclose(slope[:, point], exact_slope, rtol=1e3 * error)
    chosen = np.arange(count) % 3 == 1
    if chosen.any():
        some = together.take(chosen)
        np.testing.assert_array_equal(
            some.log_load(t[:, chosen])[0], together.log_load(t)[0][:, chosen]
        )


@pytest.mark.parametrize("way", ["tables", "compiled"])
def test_points_on_many_surfaces_are_those_of_each_in_any_order(parameters, way):
    random = np.random.default_rng(6)
    count = 4000
    given = {
        "load": np.exp(random.uniform(*np.log([1e-7, 2e-4]), count)),
        "viscosity": random.integers(0, 2, count) * 9e-5,
        "particle_diameter": np.exp(random.uniform(*np.log([5e-8, 1e-6]), count)),
        "roughness": np.exp(random.uniform(*np.log([5e-8, 1e-6]), count)),
        "particle_density": random.integers(0, 2, count) * 1e11,
    }
    together = tb.solve(**given, parameters=parameters, way=way)
    order = random.permutation(count)
    shuffled = tb.solve(
        **{name: values[order] for name, values in given.items()}, parameters=parameters, way=way
    )
    best = tb.solve(**given, parameters=parameters, way="quadrature")
    for name in QUANTITIES:
        found, exact = getattr(together, name), getattr(best, name)
        np.testing.assert_array_equal(getattr(shuffled, name), found[order])
        known = np.isfinite(exact) & (exact > 1e-300)
        error = np.abs(found[known] / exact[known] - 1.0)
        assert (error <= together.error_bound[known] + 1e-11).all(), name


def test_tables_that_all_inputs_share_give_what_their_own_give(parameters):
    loads = np.geomspace(1e-7, 1e-4, 40)
    given = {"roughness": 0.3e-6, "particle_diameter": 0.5e-6, "particle_density": 1e11}
    given |= {"load": loads, "viscosity": [[0.0], [90e-6]], "parameters": parameters}
    solved = partial(tb.solve, **given, rtol=1e-4, way="tables")
    own = solved()
    with shared_tables():
        assert few_surfaces(np.full(2, 0.3e-6)) is None
        together = solved()
    assert few_surfaces(np.full(2, 0.3e-6)) is not None
    for name in ("separation", "total_contact_area", "solid_load_fraction"):
        assert_allclose(getattr(together, name), getattr(own, name), rtol=1e-4)
    assert not np.array_equal(together.separation, own.separation)
