"""The elementwise interface: shapes, types, statuses, misuse, and what is not computed."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from methods import POINT
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.data.model_attribute import model_attribute
from thirdbody.model.regimes import (
    CONTACT_MODES,
    FILM_COUNTS,
    SOLUTION_STATUSES,
)
from thirdbody.solver.solution import QUANTITIES, VARIABLES, WHOLE

pytestmark = [
    pytest.mark.filterwarnings("error"),
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

RTOL, TINY = 1e-9, np.finfo(float).tiny
ARGUMENTS = ("load", "viscosity", "particle_diameter", "roughness", "particle_density")
CONVERGED, OUTSIDE, COVERED, FAILED, SEVERAL, WIDE, EXCEEDED = range(len(SOLUTION_STATUSES))


def solve(parameters, rtol=RTOL, **given):
    return tb.solve(**(POINT | given), parameters=parameters, rtol=rtol)


def assert_same(one, other, rtol=0.0):
    """Equal in every variable; ``rtol`` relative in the quantities."""
    for name in QUANTITIES:
        assert_allclose(getattr(one, name), getattr(other, name), rtol=rtol, err_msg=name)
    for name in WHOLE:
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


# ---- shapes and types


def test_an_array_is_solved_as_its_points_are_one_by_one(interpretation, mixture):
    together = solve(interpretation, **mixture)
    for index in range(len(mixture["load"])):
        alone = solve(interpretation, **{name: values[index] for name, values in mixture.items()})
        for name in VARIABLES:
            values = getattr(together, name)[index], getattr(alone, name)
            # sums over the nodes of the quadrature may take another order: a few roundings
            assert_allclose(*values, rtol=1e-12, err_msg=name)


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
        assert values.dtype == (np.int8 if name in WHOLE else np.float64)


@pytest.mark.parametrize("name", ARGUMENTS)
def test_an_empty_argument_gives_an_empty_solution(parameters, name):
    assert solve(parameters, **{name: []}).separation.shape == (0,)


LAYOUTS = {
    "list": lambda a: a.tolist(),
    "float32": lambda a: a.astype(np.float32),
    "big-endian": lambda a: a.astype(">f8"),
    "big-endian single": lambda a: a.astype(">f4"),
    "long double": lambda a: a.astype(np.longdouble),
    "every other": lambda a: np.repeat(a, 2)[::2],
    "reversed": lambda a: a[::-1].copy()[::-1],
    "column": lambda a: np.stack([a, a], axis=1)[:, 0],
    "read-only": lambda a: np.broadcast_to(a, (1, a.size))[0],
}


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("name", ARGUMENTS)
def test_any_layout_in_memory_is_the_same_numbers(parameters, layout, name):
    values = POINT[name] * np.array([1.0, 1.25, 1.5])
    given = LAYOUTS[layout](values)
    plain = np.asarray(given).astype(float).copy()
    assert_same(solve(parameters, **{name: given}), solve(parameters, **{name: plain}))


def test_integers_are_numbers(parameters):
    as_integers = solve(parameters, viscosity=0, particle_diameter=0, particle_density=10**11)
    assert_same(as_integers, solve(parameters, viscosity=0.0, particle_diameter=0.0))
    unsigned = solve(parameters, particle_density=np.array([10**11], dtype=np.uint64))
    assert_same(unsigned, solve(parameters, particle_density=[1e11]))


def test_the_given_arrays_are_left_alone(parameters, mixture):
    before = {name: np.array(values) for name, values in mixture.items()}
    given = {name: values.copy() for name, values in before.items()}
    solve(parameters, **given)
    for name, values in given.items():
        assert np.array_equal(values, before[name])


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
        assert np.array_equal(getattr(shuffled, name), getattr(first, name)[order], equal_nan=True)


# ---- chunks and tables


def test_where_a_chunk_ends_makes_no_difference(parameters, mixture, monkeypatch):
    whole = solve(parameters, **mixture)
    for chunk in (1, 7):
        for size in ("CHUNK", "QUADRATURE_CHUNK"):
            monkeypatch.setattr(f"thirdbody.solver.solve.{size}", chunk)
        assert_same(solve(parameters, **mixture), whole, rtol=1e-12)


@pytest.mark.parametrize("viscosity", [0.0, 1e-2])
def test_points_on_several_surfaces_are_what_they_are_on_one(parameters, loads, method, viscosity):
    # on the smoothest of them the film is thicker than any table reaches
    roughness = np.array([[1e-8], [1e-7], [3e-7]])
    given = {"load": loads, "viscosity": viscosity}
    together = solve(parameters, roughness=roughness, **given)
    for place, (sigma,) in enumerate(roughness):
        alone = solve(parameters, roughness=sigma, **given)
        for name in VARIABLES:
            found = getattr(together, name)[place]
            assert np.array_equal(found, getattr(alone, name), equal_nan=True), name


# ---- one knob


@pytest.mark.parametrize("rtol", [0.0, -1e-9, 0.99e-11, 1.01e-2, 1.0, np.nan, np.inf, "1e-9", None])
def test_any_other_rtol_is_refused_by_name(parameters, rtol):
    with pytest.raises(ValueError, match="rtol is .*allowed: 1e-11 to 1e-2"):
        solve(parameters, rtol)


# ---- misuse


@pytest.mark.parametrize("name", ARGUMENTS)
@pytest.mark.parametrize("bad", [-1e-9, -0.1, np.nan, np.inf, -np.inf], ids=str)
def test_numbers_without_meaning_are_refused_by_name_and_value(parameters, name, bad):
    given = np.array([POINT[name], bad, POINT[name]])
    with pytest.raises(ValueError, match=f"^{name} is {bad:g}; allowed: .*finite numbers"):
        solve(parameters, **{name: given})


@pytest.mark.parametrize("name", ["load", "roughness"])
def test_zero_is_refused_where_it_has_no_meaning(parameters, name):
    with pytest.raises(ValueError, match=f"^{name} is 0; allowed: positive"):
        solve(parameters, **{name: 0.0})


@pytest.mark.parametrize("name", ARGUMENTS)
@pytest.mark.parametrize(
    "bad", ["1e-5", b"1", None, True, 1j, [["a"]], [None], {"a": 1}, np.datetime64("2024-01-01")]
)
def test_what_is_no_number_is_refused_by_name(parameters, name, bad):
    with pytest.raises(ValueError, match=f"^{name} is of type .*; allowed: numbers"):
        solve(parameters, **{name: bad})


def test_a_masked_value_is_not_taken_for_a_number(parameters):
    masked = np.ma.masked_array([1e-5, 1e-6], mask=[False, True])
    with pytest.raises(ValueError, match="load"):
        solve(parameters, load=masked)


# ---- kinds of points and their statuses


@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
def test_zero_diameter_and_zero_density_are_both_two_body_contact(interpretation, viscosity):
    without = [{"particle_diameter": 0.0}, {"particle_density": 0.0}]
    one, other = (solve(interpretation, viscosity=viscosity, **given) for given in without)
    assert_same(one, other)
    assert one.particle_contact_area_ratio == 0.0
    assert one.surface_contact_area_ratio == 1.0
    assert CONTACT_MODES[one.contact_mode] == "two_body"


def coverage_of_one_particle(parameters, equations, diameter):
    """Largest coverage of Eqs. 4-5 for one particle in a square metre [m2]."""
    model = model_attribute(parameters, np.array([POINT["roughness"]]))
    one = equations(model, 0, POINT["roughness"], np.array([diameter]), np.ones(1))
    return one.load_coverage(np.zeros(1))[0]


@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
@pytest.mark.parametrize("coverage", [0.5, 0.999, 1.0 + 1e-9, 1.5, 50.0])
def test_particles_that_cover_the_interface_are_not_solved(
    sizes, equations, loads, viscosity, coverage
):
    density = coverage / coverage_of_one_particle(sizes, equations, POINT["particle_diameter"])
    given = {"viscosity": viscosity, "particle_density": density}
    # the fewer summits touch between particles, the more digits rounding takes from their share
    solution = solve(sizes, rtol=1e-6, load=np.append(1e-9, loads), **given)
    expected = CONVERGED if coverage < 1.0 else COVERED
    assert (solution.solution_status == expected).all()


def test_coverage_counts_only_touching_particles_where_the_interpretation_says_so(
    parameters, equations
):
    inputs = replace(parameters, coverage_limits="contacting")
    density = 1.5 / coverage_of_one_particle(inputs, equations, POINT["particle_diameter"])
    solution = solve(inputs, load=1e-5, viscosity=[90e-6, 1e-2], particle_density=density)
    # a thick film lifts the surface off the particles
    assert solution.solution_status[1] == CONVERGED


@pytest.mark.parametrize("film_load", ["fluid", "total"])
def test_the_status_says_where_the_film_formula_has_lost_its_meaning(
    parameters, equations, loads, film_load
):
    inputs = replace(parameters, film_load=film_load)
    viscosity = np.geomspace(1e-9, 1.0, 90)[:, None]
    loads = np.concatenate([np.geomspace(1e-12, 1e-8, 20), loads])
    solution = solve(inputs, rtol=1e-8, load=loads, viscosity=viscosity, particle_diameter=0.0)
    model = model_attribute(inputs, np.array([POINT["roughness"]]))
    zero = np.zeros(1)
    share = solution.fluid_load_fraction
    again = equations(model, 0, POINT["roughness"], zero, zero)
    thickness, rough = again.film((share if film_load == "fluid" else 1.0) * loads, viscosity)
    # H_c is least where the roughness term is 0.663/(0.884 - 0.663) = 3
    clear = (np.abs(rough - 3.0) > 1e-6) & (np.abs(thickness - 0.01) > 1e-8)
    clear &= np.abs(share - FILM_COUNTS) > 1e-8
    meaningless, counts = (rough > 3.0) | (thickness > 0.01), share > FILM_COUNTS
    outside = solution.solution_status == OUTSIDE
    assert np.array_equal(outside[clear], (meaningless & counts)[clear])
    for reason in (rough > 3.0, thickness > 0.01):
        assert (reason & outside).any()
    assert (meaningless & ~counts).any()
    assert not meaningless.all()


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("particle_diameter", [0.0, 3e-7])
@pytest.mark.parametrize("rtol", [1e-3, RTOL])
def test_no_film_presses_harder_than_the_softer_surface_is(
    defaults, method, rtol, film_load, particle_diameter
):
    inputs = replace(defaults, film_load=film_load, hardness_surface_2=3e9)
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


def test_an_area_larger_than_the_apparent_one_is_said(parameters):
    # plastic summits have twice the area of what they are cut off by
    soft = replace(parameters, hardness_surface_1=1e6, hardness_surface_2=1e6)
    solution = solve(soft, load=np.geomspace(1e-6, 1e-5, 50), viscosity=0.0, particle_diameter=0.0)
    wide = solution.total_contact_area > 1.0
    assert wide.any() and not wide.all()
    assert np.array_equal(wide, solution.solution_status == WIDE)


@pytest.mark.parametrize("elastic_limits", ["printed", "physical"])
def test_of_several_separations_the_largest_is_given(parameters, equations, elastic_limits):
    # elastic particles press more than plastic ones: the solids may bear more, farther apart
    soft = {"elastic_modulus_particle": 5e9, "elastic_depth_ratio": 0.5}
    inputs = replace(parameters, elastic_limits=elastic_limits, **soft)
    load, roughness = np.geomspace(1e-7, 1e-3, 300), 1e-7
    solution = solve(inputs, load=load, viscosity=0.0, roughness=roughness)
    several = solution.solution_status == SEVERAL
    assert several.sum() > 10
    assert np.array_equal(several, solution.separation_count > 1)
    model = model_attribute(inputs, np.array([roughness]))
    again = equations(model, 0, roughness, np.array([500e-9]), np.array([1e11]))
    d = np.linspace(0.0, 3e-6, 1500)
    borne = np.array([again.solid_load(gap[None])[0] for gap in d])
    turns = borne[1:-1][(np.diff(borne)[:-1] > 0.0) != (np.diff(borne)[1:] > 0.0)]
    clear = (np.abs(load[:, None] / turns - 1.0) > 0.01).all(axis=1)
    above = borne > load[:, None]
    assert np.array_equal(
        (above[:, 1:] != above[:, :-1]).sum(axis=1)[clear], solution.separation_count[clear]
    )
    last = d.size - 1 - above[:, ::-1].argmax(axis=1)
    assert (d[last] <= solution.separation)[clear].all()
    assert (solution.separation <= d[last + 1])[clear].all()
    assert clear.mean() > 0.8


def test_a_point_that_cannot_be_solved_harms_no_other(parameters):
    load = np.array([1e-5, 1e3, 1e-6, 1e300, 1e-300])
    together = solve(parameters, load=load, viscosity=0.0)
    assert together.solution_status.tolist() == [
        CONVERGED, EXCEEDED, CONVERGED, EXCEEDED, CONVERGED,
    ]  # fmt: skip
    alone = solve(parameters, load=load[[0, 2]], viscosity=0.0)
    assert_allclose(together.separation[[0, 2]], alone.separation, rtol=1e-12)


@pytest.mark.parametrize(
    "extreme",
    [
        {"plastic_interference_ratio": 1.0},
        {"plastic_interference_ratio": 1e4},
        {"yield_pressure_ratio": 1.0},
        {"truncation": 0.5},
        {"truncation": 10.0},
        {"spread_ratio": 1e-6},
        {"spread_ratio": 1e-6, "size_distribution": "centred", "mean_ratio": 1.0},
        {"spread_ratio": 1e-6, "size_distribution": "gap_convolved", "gap_ratio": 1.0},
        {"elastic_depth_ratio": 0.0},
        {"ellipticity": 0.1},
        {"ellipticity": 10.0},
        {"summit_radius": 1e-7},
        {"summit_radius": 1e-2},
        {"participation": 1e-6},
    ],
    ids=str,
)
def test_inputs_at_the_ends_of_their_bounds_give_numbers_and_no_warning(parameters, loads, extreme):
    inputs = replace(parameters, **extreme)
    for viscosity in (0.0, 90e-6):
        solution = solve(inputs, load=loads, viscosity=viscosity)
        assert (solution.solution_status == CONVERGED).all()
        assert np.isfinite(solution.total_contact_area).all()


def test_a_roughness_without_summits_names_the_input_that_forbids_it(parameters):
    inputs = replace(parameters, summit_parameter=0.0193, summit_parameter_exponent=-1.0)
    with pytest.raises(ValueError, match="summit_parameter is .*at roughness 6e-07"):
        solve(inputs, roughness=6e-7)


# ---- no more than is needed


@pytest.mark.parametrize("name", VARIABLES)
def test_a_variable_alone_is_what_it_is_among_all(parameters, mixture, name):
    every = solve(parameters, **mixture)
    alone = solve(parameters, **mixture, variables=[name])
    assert np.array_equal(getattr(alone, name), getattr(every, name), equal_nan=True)
    assert all(getattr(alone, other) is None for other in VARIABLES if other != name)


@pytest.mark.parametrize("names", [["total_area"], "separation", ["separation", "load"]])
def test_an_unknown_variable_is_refused_by_its_name(parameters, names):
    with pytest.raises(
        ValueError, match="variables has '.*'; allowed: a list out of total_contact"
    ):
        tb.solve(**POINT, parameters=parameters, variables=names)


def test_engineering_names_and_the_published_inputs_give_the_same():
    inputs = tb.load_parameters()
    sizes = dict(particle_diameter_nm=500, roughness_nm=300, particle_density_per_m2=1e11)
    plain = dict(particle_diameter=500e-9, roughness=300e-9, particle_density=1e11)
    found = tb.solve(load_N=10, viscosity_cSt=90, **sizes)
    load = 10 / inputs.newtons_per_load
    same = tb.solve(load=load, viscosity=90e-6, **plain, parameters=inputs)
    assert found.total_contact_area == pytest.approx(float(same.total_contact_area), rel=1e-9)
    gridded = tb.grid(load_N=10, viscosity_cSt=90, **sizes)
    assert gridded["total_contact_area"].item() == pytest.approx(
        float(same.total_contact_area), rel=1e-9
    )


@pytest.mark.parametrize("given", [{"truncation": 2.0}, "config/inputs.yaml"], ids=str)
def test_parameters_of_another_kind_are_refused_in_one_line(given):
    with pytest.raises(ValueError) as refused:
        tb.solve(**POINT, parameters=given)
    told = "allowed: Parameters, as of load_parameters()"
    assert str(refused.value) == f"parameters is a {type(given).__name__}; {told}"


def test_a_solution_prints_what_each_variable_is_with_names_for_flags(parameters):
    given = {"viscosity": 0.0, "particle_diameter": 3e-7, "roughness": 3e-7}
    given |= {"particle_density": 1e11, "parameters": parameters}
    lines = repr(solve(load=1e-6, **given)).splitlines()
    assert lines[0] == "Solution of shape ()"
    told = dict(line.split(maxsplit=1) for line in lines[1:])
    assert told["lubrication_regime"] == "boundary"
    assert told["solution_status"] == "converged"
    assert float(told["solid_load_fraction"]) == 1.0
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
            assert np.array_equal(getattr(other, name), getattr(first, name), equal_nan=True), name


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
    given[:] = 1.0
    assert np.array_equal(found.conditions["load"], loads)
