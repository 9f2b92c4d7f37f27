"""No variable jumps where regimes, table pieces, branches or node counts change."""

import warnings
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from methods import POINT, solved_by
from scipy.integrate import IntegrationWarning

import thirdbody as tb
from benchmarks.points import VARIABLES, relative_error
from thirdbody.core.asperity import SummitPopulation
from thirdbody.core.parameters import mccool_summits
from thirdbody.core.regimes import has_values
from thirdbody.core.solve import TABLE_WORTH
from thirdbody.core.summits import pieces_for
from thirdbody.netcdf import model_attribute

pytestmark = [
    pytest.mark.filterwarnings("error"),
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

RTOLS = [1e-2, 1e-6, 1e-11]
CONVERGED, FAILED = "converged", "not_converged"
NEXT = 1e-12  # relative distance of two points that are the same in all but rounding


def solve(parameters, rtol=1e-9, **given):
    return tb.solve(**(POINT | given), parameters=parameters, rtol=rtol)


def assert_no_jump(before, after, rtol):
    """No variable of two solutions differs by more than ten times ``rtol``."""
    for name in VARIABLES:
        error = relative_error(getattr(after, name), getattr(before, name))
        assert error.max(initial=0.0) <= 10.0 * rtol, (name, int(np.argmax(error)), error.max())


def crossing(parameters, name, level, ends, **given):
    """The load at which a variable crosses ``level``, by halving between the ``ends``."""
    low, high = ends
    rising = getattr(solve(parameters, load=high, **given), name) > level
    for _ in range(50):
        middle = np.sqrt(low * high)
        above = getattr(solve(parameters, 1e-11, load=middle, **given), name) > level
        low, high = (low, middle) if above == rising else (middle, high)
    return high


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize(
    ("name", "level", "ends"),
    [
        ("solid_load_fraction", 0.90, (3e-5, 1e-3)),
        ("solid_load_fraction", 0.03, (1e-3, 1e2)),
        ("particle_contact_area_ratio", 0.95, (1e-6, 1e-2)),
        ("particle_contact_area_ratio", 0.05, (1e-4, 1e2)),
    ],
)
def test_no_jump_at_the_limits_of_regimes_and_modes(parameters, name, level, ends, rtol, method):
    load = crossing(parameters, name, level, ends)
    sides = [solve(parameters, rtol, load=load * (1.0 + step)) for step in (-3e-7, 3e-7)]
    assert_no_jump(*sides, rtol=max(rtol, 1e-6))
    flags = [(int(s.lubrication_regime), int(s.contact_mode)) for s in sides]
    # the flag changes where the variable crosses, within the error asked for
    assert flags[0] != flags[1] or rtol > 1e-7


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize("method", ["tables"], indirect=True)
def test_no_jump_between_the_pieces_of_the_tables(parameters, rtol, method):
    inputs = replace(parameters, summit_parameter=0.05, summit_parameter_exponent=0.0)
    inputs = replace(inputs, **mccool_summits(0.05))
    population = SummitPopulation.of(inputs.surface(POINT["roughness"]), inputs)
    for pieces in (45, 90, 180, 360, 720):
        edges = np.linspace(-5.0, 40.0, pieces + 1)
        edges = edges[(edges > -0.5) & (edges < 37.0)]
        load = np.exp(population.log_load(edges)[0])
        dry = {"viscosity": 0.0, "particle_diameter": 0.0}
        sides = [solve(inputs, rtol, load=load * (1.0 + step), **dry) for step in (-NEXT, NEXT)]
        assert_no_jump(*sides, rtol=max(rtol, NEXT))


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize("t", [-5.0, 0.0, 38.0, 40.0])
def test_no_jump_at_the_ends_of_tables_and_of_branches(parameters, rtol, t, method):
    """A film sets the separation t from the summits' plane; there the quadrature changes too."""
    inputs = replace(parameters, summit_parameter=0.0195, summit_parameter_exponent=0.0)
    inputs = replace(inputs, **mccool_summits(0.0195))
    surface = inputs.surface(POINT["roughness"])
    load = np.float64(1e-14 if t > 0.0 else 1e-2)
    low, high = 1e-9, 1.0
    for _ in range(60):
        middle = np.sqrt(low * high)
        d = solve(inputs, 1e-11, load=load, viscosity=middle, particle_diameter=0.0).separation
        below = (d - surface.summit_offset) / surface.summit_deviation < t
        low, high = (middle, high) if below else (low, middle)
    near = high * (1.0 + np.array([-10.0, -1.0, 0.0, 1.0, 10.0]) * NEXT)
    solution = solve(inputs, rtol, load=load, viscosity=near, particle_diameter=0.0)
    for name in VARIABLES:
        value = getattr(solution, name)
        error = relative_error(value[1:], value[:-1])
        # the steepest tail, t = 40, makes t^2 of a difference in d
        assert error.max() <= 10.0 * max(rtol, 4e4 * NEXT), (name, error)


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize("truncation", [0.5, 2.44])
def test_no_jump_where_the_largest_particles_touch(sizes, equations, truncation, rtol, method):
    """Areas begin there as steeply as the equations say, and the separation goes on as before."""
    inputs = replace(sizes, truncation=truncation)
    model = model_attribute(inputs, np.array([POINT["roughness"]]))
    again = equations(model, 0, POINT["roughness"], np.full(1, 500e-9), np.full(1, 1e9))
    depth = inputs.elastic_depth_ratio * POINT["particle_diameter"]
    for edge in (again.largest, again.largest + depth):
        load = again.solid_load(edge)
        near = load * (1.0 + np.array([-2.0, -1.0, 1.0, 2.0]) * NEXT)
        solution = solve(inputs, rtol, load=near, viscosity=0.0, particle_density=1e9)
        # so near the edge rounding of the gap may decide on the particles' area
        known = solution.solution_status == CONVERGED
        assert np.array_equal(known, solution.error_bound <= rtol)
        d = solution.separation
        assert relative_error(d[1:], d[:-1]).max() <= 10.0 * max(rtol, NEXT)
        with warnings.catch_warnings():
            # the largest particles leave `quad` an interval that is as narrow as rounding
            warnings.simplefilter("ignore", IntegrationWarning)
            at, closer, farther = (again.areas(gap) for gap in (d, d * (1 - rtol), d * (1 + rtol)))
        for index, name in enumerate(VARIABLES[:3]):
            allowed = rtol * at[index] + np.abs(closer[index] - farther[index])
            error = np.abs(getattr(solution, name) - at[index])
            assert (error <= allowed)[known].all(), (name, edge)


SWEEPS = {
    "load": np.geomspace(1e-7, 1e-2, 1000),
    "lightest load": np.geomspace(1e-12, 1e-7, 1000),
    "viscosity": np.geomspace(3e-6, 1e-2, 1000),
    "particle_diameter": np.geomspace(1e-9, 3e-6, 1000),
    "particle_density": np.geomspace(1e3, 2e12, 1000),
}


@cache
def best_along(parameters, name, viscosity):
    """The solution by quadrature, the same for all accuracies."""
    given = {"viscosity": viscosity} | {name.split()[-1]: SWEEPS[name]}
    with solved_by("quadrature"):
        return solve(parameters, 1e-11, **given)


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize("name", list(SWEEPS))
@pytest.mark.parametrize("viscosity", [0.0, 90e-6], ids=["dry", "wet"])
def test_no_jump_along_a_sweep(interpretation, name, viscosity, rtol):
    """Tables, loose tolerances and branches leave the best solution by no more than ``rtol``."""
    given = {"viscosity": viscosity} | {name.split()[-1]: SWEEPS[name]}
    asked, best = solve(interpretation, rtol, **given), best_along(interpretation, name, viscosity)
    solved = has_values(asked.solution_status.astype(int))
    assert np.array_equal(solved, has_values(best.solution_status.astype(int)))
    allowed = (asked.error_bound + best.error_bound)[solved]
    for variable in VARIABLES:
        error = relative_error(getattr(asked, variable)[solved], getattr(best, variable)[solved])
        assert (error <= allowed).all(), (variable, np.argmax(error - allowed), error.max())
    # refused: what particles that begin to touch make too steep for float64
    refused = np.count_nonzero(asked.error_bound > rtol)
    if name != "lightest load":
        assert refused <= (200 if rtol < 1e-10 else 2)


@pytest.mark.parametrize("rtol", RTOLS)
def test_no_jump_from_the_thinnest_film_to_dry(parameters, rtol, method):
    """Where a valid film bears nothing, every variable is that of dry contact."""
    given = {"roughness": 1e-8, "particle_diameter": 1e-4, "particle_density": 1e7}
    load = np.geomspace(1e-8, 1e-6, 20)
    film = solve(parameters, rtol, load=load, viscosity=3e-3, **given)
    dry = solve(parameters, rtol, load=load, viscosity=0.0, **given)
    assert set(film.solution_status) <= {CONVERGED, FAILED}
    assert (film.error_bound <= max(rtol, 1e-9)).all()
    assert film.fluid_load_fraction.max() < 1e-25
    assert film.fluid_load_fraction.min() > 0.0
    for name in VARIABLES:
        if name != "fluid_load_fraction":
            error = relative_error(getattr(film, name), getattr(dry, name))
            assert error.max() <= 10.0 * rtol, (name, error.max())


@pytest.mark.parametrize("rtol", [1e-2, 1e-9, 1e-11])
@pytest.mark.parametrize("viscosity", [0.0, 90e-6], ids=["dry", "wet"])
@pytest.mark.parametrize("name", ["particle_diameter", "particle_density"])
def test_no_jump_from_few_or_small_particles_to_none(sizes, name, viscosity, rtol, method):
    load = np.geomspace(1e-9, 1e-3, 20)
    none = solve(sizes, rtol, load=load, viscosity=viscosity, **{name: 0.0})
    for least in (5e-324, 1e-310, 1e-200, 1e-100, 1e-30):
        few = solve(sizes, rtol, load=load, viscosity=viscosity, **{name: least})
        assert (few.particle_contact_area_ratio < 1e-15).all()
        few.particle_contact_area_ratio[...] = 0.0  # few compared with none: never within rtol
        assert_no_jump(none, few, rtol)


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize(
    ("name", "limit"), [("plastic_interference_ratio", 1.0), ("yield_pressure_ratio", 1.0)]
)
def test_no_jump_to_the_limits_of_the_asperity_law(parameters, name, limit, rtol, method):
    load = np.geomspace(1e-9, 1e-3, 50)
    for excess in (1e-16, 3e-16, 1e-15, 1e-13):
        direction = 1.0 if name == "plastic_interference_ratio" else -1.0
        near = replace(parameters, **{name: limit * (1.0 + direction * excess)})
        at = replace(parameters, **{name: limit})
        sides = [solve(inputs, rtol, load=load, viscosity=0.0) for inputs in (at, near)]
        assert_no_jump(*sides, rtol=rtol)


@pytest.mark.parametrize("viscosity", [0.0, 90e-6], ids=["dry", "wet"])
@pytest.mark.parametrize("edge", [1e-5, 1e-7, 1e-9])
def test_no_jump_where_the_tables_get_finer(sizes, edge, viscosity):
    load = np.geomspace(1e-9, 1e-3, 1000)
    rtols = np.nextafter(edge, 0.0), edge, np.nextafter(edge, 1.0)
    sides = [solve(sizes, rtol, load=load, viscosity=viscosity) for rtol in rtols]
    assert_no_jump(sides[0], sides[1], edge)
    assert_no_jump(sides[1], sides[2], edge)


@pytest.mark.parametrize("rtol", RTOLS)
def test_no_jump_where_points_become_enough_for_a_table(interpretation, rtol):
    load = np.geomspace(1e-9, 1e-3, int(np.ceil(TABLE_WORTH * pieces_for(rtol))))
    few, enough = (solve(interpretation, rtol, load=each) for each in (load[:-1], load))
    for name in VARIABLES:
        error = relative_error(getattr(enough, name)[:-1], getattr(few, name))
        assert error.max() <= 10.0 * rtol, name
