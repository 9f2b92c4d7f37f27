"""The compiled loop gives what the other ways give, and leaves to them what it cannot promise."""

import os
import sys
from dataclasses import fields, replace
from subprocess import run

import numpy as np
import pytest
from scipy.optimize import brentq

import thirdbody as tb
from benchmarks.classes import HEAVIEST, random_conditions
from benchmarks.points import relative_errors
from thirdbody.model.asperity import SummitPopulation
from thirdbody.model.film import Film, log_load_parameter
from thirdbody.model.particles import Moment
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.compiled import machine_code
from thirdbody.solver.compiled.layout import ROOT
from thirdbody.solver.compiled.loop import solve_points
from thirdbody.solver.compiled.points import CompiledPoints, Interfaces
from thirdbody.solver.compiled.tables import DOUBLE, SINGLE, precisions, prepare_model
from thirdbody.solver.plan import TABLE_WORTH
from thirdbody.solver.points import Conditions, make_contact
from thirdbody.solver.solution import FLAGS, QUANTITIES, VARIABLES
from thirdbody.solver.surfaces import Sheet, cells_of, log_yields

pytestmark = pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning")

ROUGHNESS = 300e-9
MANY = 5000
QUADRATURE = 5e-12  # what is left of errors by the other ways
READINGS = {
    "centred": {},
    "uncentred": {"size_distribution": "uncentred"},
    "gap_convolved": {"size_distribution": "gap_convolved", "gap_ratio": 1.0},
    "physical": {"elastic_limits": "physical"},
    "contacting": {"coverage_limits": "contacting"},
    "offset": {"summit_offset": True},
    "total": {"film_load": "total"},
}


@pytest.fixture(params=READINGS)
def reading(request, parameters):
    return replace(parameters, **READINGS[request.param])


def conditions(count, seed=0):
    """Random points of the paper's ranges, lubricated and with particles, on one roughness."""
    random = np.random.default_rng(seed)
    ends = {
        "load": (1e-7, 2e-4),
        "viscosity": (10e-6, 150e-6),
        "particle_diameter": (50e-9, 1e-6),
        "particle_density": (1e10, 1e12),
    }
    return {name: np.exp(random.uniform(*np.log(pair), count)) for name, pair in ends.items()}


def compiled(parameters, rtol, real=None, **given):
    """The points by the loop, in numbers of type ``real`` or those that are tried first."""
    given = {"roughness": ROUGHNESS} | given
    names = [field.name for field in fields(Conditions)]
    columns = map(np.ascontiguousarray, np.broadcast_arrays(*(given[name] for name in names)))
    conditions, real = Conditions(*columns), real or precisions(rtol)[0]
    sheet = sheet_of(parameters, cell=np.ndim(given["roughness"]) > 0)
    with np.errstate(all="ignore"):
        interfaces = Interfaces(sheet, conditions, parameters, rtol, real)
        return CompiledPoints(interfaces, conditions.load, areas=True)


def sheet_of(parameters, cell=False):
    """The sheet of the roughness alone, or of the cell in which it is."""
    summits = SummitPopulation.of(parameters.surface(ROUGHNESS), parameters)
    if cell:
        return Sheet.of_cell(cells_of(log_yields(summits)), summits.materials)
    return Sheet.of_one(log_yields(summits), summits.materials)


def best(parameters, **given):
    """The points by quadrature, each on its own."""
    given = {"roughness": ROUGHNESS} | given
    return tb.solve(**given, parameters=parameters, rtol=1e-11, way="quadrature")


def assert_within_bounds(found, expected, known):
    """Where points are ``known``, no error is beyond the bounds of what is found and expected."""
    errors = relative_errors(found, {name: getattr(expected, name) for name in QUANTITIES})
    allowed = np.maximum(expected.error_bound, QUADRATURE) + found.error_bound
    for name, error in errors.items():
        assert (error[known] <= allowed[known]).all(), name


@pytest.mark.parametrize("rtol", [1e-2, 1e-3, 1e-6, 1e-9, 1e-10])
@pytest.mark.parametrize("medium", ["dry", "lubricated"])
@pytest.mark.parametrize("bodies", ["two_body", "three_body"])
def test_errors_stay_below_the_bound_of_each_point(reading, medium, bodies, rtol):
    given = conditions(1500)
    if medium == "dry":
        given["viscosity"] = np.zeros(1500)
    if bodies == "two_body":
        given["particle_density"] = np.zeros(1500)
    found = compiled(reading, rtol, **given)
    assert found.left.mean() < {1e-2: 0.01, 1e-3: 0.05, 1e-10: 0.1}.get(rtol, 0.01)
    known = ~found.left
    expected = best(reading, **given)
    assert_within_bounds(found, expected, known)


@pytest.mark.parametrize(
    ("real", "rtol"), [(SINGLE, 1e-2), (SINGLE, 1e-3), (DOUBLE, 1e-3), (DOUBLE, 1e-9)]
)
@pytest.mark.parametrize("medium", ["dry", "lubricated"])
def test_bounds_hold_far_beyond_the_ranges_of_the_paper(reading, medium, real, rtol):
    random = np.random.default_rng(5)
    count = 1500
    diameter = 10.0 ** random.uniform(-9.0, -5.0, count)
    given = {
        "load": 10.0 ** random.uniform(-12.0, -1.0, count),
        "viscosity": 10.0 ** random.uniform(-10.0, -2.0, count) * (medium == "lubricated"),
        "particle_diameter": diameter,
        "particle_density": 10.0 ** random.uniform(-6.0, -0.5, count) / diameter**2,
    }
    found = compiled(reading, rtol, real, **given)
    expected = best(reading, **given)
    known = ~found.left & (expected.error_bound < 1e-9)
    assert known.mean() > 0.4
    assert_within_bounds(found, expected, known)


@pytest.mark.parametrize(
    ("real", "rtol"), [(SINGLE, 1e-3), (DOUBLE, 1e-3), (DOUBLE, 1e-6), (DOUBLE, 1e-9)]
)
def test_bounds_hold_on_many_surfaces_that_share_tables(reading, real, rtol):
    given = conditions(1500)
    given["roughness"] = ROUGHNESS * np.exp(np.random.default_rng(7).uniform(-0.02, 0.02, 1500))
    found = compiled(reading, rtol, real, **given)
    assert found.left.mean() < 0.06
    known = ~found.left
    expected = best(reading, **given)
    assert_within_bounds(found, expected, known)


def test_summits_beyond_their_tables_bear_nothing(parameters):
    """Between large particles smooth surfaces are more than 40 sigma_s apart."""
    given = conditions(1500) | {"roughness": 50e-9, "particle_diameter": 2e-6}
    inputs = {"parameters": parameters, "rtol": 1e-9}
    found = tb.solve(**given, **inputs, way="compiled")
    expected = tb.solve(**given, **inputs, way="quadrature")
    assert (found.separation > 45.0 * 50e-9).any()
    for name in QUANTITIES:
        one, other = getattr(found, name), getattr(expected, name)
        np.testing.assert_allclose(one, other, rtol=2e-9, atol=1e-307)


@pytest.mark.parametrize("rtol", [1e-2, 1e-3, 1e-6])
@pytest.mark.parametrize("distribution", ["centred", "uncentred"])
def test_bounds_hold_next_to_the_smallest_sizes(parameters, distribution, rtol):
    """Where particles alone bear the load, and nearly all of them do: it hardly falls with d there."""
    sizes = {"mean_ratio": 1.1, "spread_ratio": 0.7, "truncation": 1.77, "elastic_depth_ratio": 2.5}
    hardness = {"hardness_surface_1": 2.8e8, "hardness_surface_2": 1.3e9}
    sizes |= {"size_distribution": distribution, "participation": 1e-3}
    inputs = replace(parameters, elastic_modulus_particle=3.2e9, **sizes, **hardness)
    given = {"particle_diameter": 2e-7, "roughness": 7e-9, "particle_density": 2e12}
    separation = 2e-7 * (2.5 + np.geomspace(1e-4, 0.3, 1000))
    columns = (np.full_like(separation, value) for value in given.values())
    borne = make_contact(*columns, inputs, None).log_solid_load(separation).value
    given |= {"load": np.exp(borne), "viscosity": 0.0}
    found = tb.solve(**given, parameters=inputs, rtol=rtol, way="compiled")
    assert_within_bounds(found, best(inputs, **given), found.error_bound <= rtol)


@pytest.mark.parametrize("rtol", [1e-2, 1e-3, 1e-6])
@pytest.mark.parametrize("limits", ["printed", "physical"])
def test_nothing_is_extrapolated_across_first_contact(parameters, rtol, limits):
    """Diameters at which the largest particles begin to touch, and those just about them."""
    parameters = replace(parameters, elastic_limits=limits)
    given = {"load": 1e-6, "viscosity": 0.0, "particle_density": 1e11}
    alone = tb.solve(
        load=1e-6,
        viscosity=0.0,
        particle_diameter=0.0,
        roughness=ROUGHNESS,
        particle_density=0.0,
        parameters=parameters,
    ).separation
    for reach in (0.0, parameters.elastic_depth_ratio):
        largest = parameters.mean_ratio + parameters.truncation * parameters.spread_ratio + reach
        near = np.concatenate([[0.0], np.geomspace(1e-12, 0.5, 400)])
        diameter = alone / largest * np.concatenate([1.0 - near, 1.0 + near])
        found = compiled(parameters, rtol, **given | {"particle_diameter": diameter})
        expected = best(parameters, **given | {"particle_diameter": diameter})
        errors = relative_errors(found, {name: getattr(expected, name) for name in QUANTITIES})
        known = ~found.left
        assert known.mean() > 0.1
        for name, error in errors.items():
            assert (error[known] <= rtol).all(), (name, error[known].max())


@pytest.mark.parametrize(("real", "rtol"), [(SINGLE, 1e-2), (SINGLE, 1e-3), (DOUBLE, 1e-9)])
@pytest.mark.parametrize("density", [0.0, 1e11])
def test_a_film_of_the_total_load_takes_over_from_the_solids(parameters, real, rtol, density):
    """Viscosities at which it is about as thick as the dry surfaces are apart."""
    inputs, load = replace(parameters, film_load="total"), 1e-5
    given = {"load": load, "particle_diameter": 5e-7, "particle_density": density}
    dry = tb.solve(**given, viscosity=0.0, roughness=ROUGHNESS, parameters=inputs).separation
    log_load = log_load_parameter(np.log(load), inputs)

    def excess(log_viscosity):
        film = Film.of(np.exp(log_viscosity), ROUGHNESS, inputs)
        return film.thickness(log_load)[0] * inputs.ball_radius / dry - 1.0

    viscosity = np.exp(brentq(excess, *np.log([1e-6, 1e-1]), xtol=1e-15))
    near = np.concatenate([[0.0], np.geomspace(1e-16, 0.5, 400)])
    given["viscosity"] = viscosity * np.concatenate([1.0 - near, 1.0 + near])
    found, expected = compiled(inputs, rtol, real, **given), best(inputs, **given)
    known = ~found.left
    assert 0.1 < known.mean() < 1.0
    assert (found.fluid_load_fraction[known] == 0.0).any()
    assert (found.fluid_load_fraction[known] > 0.0).any()
    assert_within_bounds(found, expected, known)


def looked_up(table, x):
    """Values of a table at ``x``, as the loop finds them."""
    if hasattr(table, "scale"):
        position = np.minimum((x - table.start) * table.scale, len(table.rows) - 1.5)
        piece = position.astype(int)
        local = 2.0 * (position - piece) - 1.0
    else:
        mantissa, exponent = np.frexp(x)
        position = (2.0 * mantissa - 1.0) * table.pieces
        within = position.astype(int)
        local = 2.0 * (position - within) - 1.0
        first_mantissa, first_exponent = np.frexp(first_of(table))
        assert first_mantissa == 0.5
        piece = (exponent - first_exponent) * table.pieces + within
    powers = table.rows[piece, 0].astype(float)
    return sum(power * local**index for index, power in enumerate(powers.T))


def first_of(table):
    """Where an octave table begins: the number with these leading bits."""
    integer = np.int32 if isinstance(table.within, np.float32) else np.int64
    return np.array(table.first << table.shift, integer).view(type(table.within))


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("real", [SINGLE, DOUBLE])
def test_tables_are_as_good_as_they_say(reading, real, rtol):
    sheet = sheet_of(reading)
    exact = sheet.population(0.0)
    model = prepare_model(sheet, reading, rtol, real)
    random = np.random.default_rng(1)
    t = random.uniform(-5.0, 40.0, 3000)
    terms = model.degree + 1
    summits, film, particles = model.summits, model.film, model.particles
    for start, curve in ((0, exact.log_load), (terms, exact.log_area)):
        table = summits.table._replace(rows=summits.table.rows[..., start : start + terms])
        error = ROOT * np.log(looked_up(table, t)) - curve(t)[0]
        assert np.abs(error).max() <= 1.5 * summits.error + 1e-12  # of curves e^-800 high
    like = Film.of(np.ones(1), np.ones(1), reading)
    thickness = np.exp(random.uniform(-6.0, 14.0, 3000))
    alone = replace(like, smooth=0.0, rough=0.0)
    error = ROOT * np.log(looked_up(film.table, thickness)) - alone.load_parameter(thickness)
    assert np.abs(error).max() <= 1.5 * film.error
    moment = Moment.of_all_layers(reading)
    alpha = random.uniform(max(moment.smallest, -9.0), moment.largest, 3000)
    above, slope = moment(alpha)
    slope = np.abs(slope)
    error = looked_up(particles.table, alpha) - above
    moved = 10.0 * model.limits.rounding * slope  # the start of the table is rounded
    assert (np.abs(error) <= 2.0 * particles.error * (above + slope) + moved).all()


@pytest.mark.parametrize("given", [{}, {"viscosity": 0.0}, {"particle_density": 0.0}])
def test_what_single_precision_leaves_is_solved_in_double(parameters, given):
    given = conditions(MANY) | given
    single = compiled(parameters, 1e-3, SINGLE, **given)
    double = compiled(parameters, 1e-3, DOUBLE, **given)
    both = tb.solve(**given, roughness=ROUGHNESS, parameters=parameters, rtol=1e-3, way="compiled")
    for name in QUANTITIES:
        chosen = np.where(single.left, getattr(double, name), getattr(single, name))
        settled = ~(single.left & double.left)
        np.testing.assert_array_equal(getattr(both, name)[settled], chosen[settled])
    assert double.left.mean() <= single.left.mean() < 0.03


def test_points_beyond_the_tables_are_left(parameters):
    for given in (
        {"load": np.array([1e3]), "viscosity": 0.0},  # heavier than what the solids bear
        {"viscosity": np.array([1e9])},  # a film that no summit reaches through
    ):
        point = {"load": 1e-5, "viscosity": 9e-5}
        point |= {"particle_diameter": 5e-7, "particle_density": 1e11}
        assert compiled(parameters, 1e-6, **point | given).left.all()


def test_a_point_on_a_flat_part_of_the_load_is_settled():
    """There the load of the summits fades away step by step, and what particles bear hardly falls."""
    flat = {
        "load": np.array([2.608075929341208e-05]),
        "viscosity": 5.837166768228566e-05,
        "particle_diameter": 4.5263135987791657e-07,
        "particle_density": 689190164526.9723,
    }
    assert not compiled(tb.load_parameters(), 1e-9, **flat).left.any()


def test_hardly_a_point_of_the_usual_ranges_is_left():
    """Not even where particles can just bear the load, all together."""
    inputs = tb.load_parameters()
    given = random_conditions(HEAVIEST, 100_000, inputs)
    assert compiled(inputs, 1e-9, **given | {"roughness": ROUGHNESS}).left.mean() < 1e-4


def test_many_points_have_the_status_and_the_flags_of_few(parameters):
    given = conditions(MANY)
    given["load"][::500] = 1e3
    given["viscosity"][1::500] = 1e-9
    given["particle_density"][2::500] = 1e22
    many = tb.solve(**given, roughness=ROUGHNESS, parameters=parameters, way="compiled")
    some = np.flatnonzero(np.arange(MANY) % 500 < 5)
    few = {name: values[some] for name, values in given.items()}
    assert some.size < TABLE_WORTH
    few = tb.solve(**few, roughness=ROUGHNESS, parameters=parameters)
    for name in ("solution_status", "lubrication_regime", "contact_mode"):
        np.testing.assert_array_equal(getattr(many, name)[some], getattr(few, name))
    assert len(set(few.solution_status)) >= 3


@pytest.mark.parametrize("viscosity", [0.0, 90e-6])
def test_points_that_particles_cover_need_no_other_way(reading, viscosity):
    given = conditions(1500) | {"viscosity": np.full(1500, viscosity)}
    given["particle_density"] = np.geomspace(1e12, 1e15, 1500)
    given["load"][::2] *= 5e3  # up to 1: more than is borne at any separation
    found = compiled(reading, 1e-9, **given)
    expected = tb.solve(**given, roughness=ROUGHNESS, parameters=reading, way="quadrature")
    covers = expected.solution_status == SOLUTION_STATUSES.index("coverage_exceeded")
    assert covers.any() or reading.readings.coverage_limits.contacting
    promised = expected.solution_status != SOLUTION_STATUSES.index("not_converged")
    kept = ~found.left & promised
    for name in (*FLAGS, "separation_count"):
        assert np.array_equal(getattr(found, name)[kept], getattr(expected, name)[kept]), name
    for name in (*QUANTITIES, "error_bound"):
        assert np.isnan(getattr(found, name)[covers & kept]).all(), name
    if not reading.readings.coverage_limits.contacting:
        assert found.left[covers & (given["load"] < 1e-3)].sum() == 0
        beyond = expected.solution_status == SOLUTION_STATUSES.index("load_exceeded")
        assert beyond.any() or viscosity > 0.0


def test_areas_that_nobody_asks_for_change_nothing_else(parameters):
    given = conditions(MANY)
    given |= {"roughness": ROUGHNESS, "parameters": parameters, "way": "compiled"}
    every = tb.solve(**given)
    names = ["solid_load_fraction", "separation", "error_bound"]
    some = tb.solve(**given, variables=names)
    for name in names:
        np.testing.assert_array_equal(getattr(some, name), getattr(every, name))
    assert [name for name in VARIABLES if getattr(some, name) is None] == [
        name for name in VARIABLES if name not in names
    ]


RESULTS = [name for name in VARIABLES if name in (*QUANTITIES, "error_bound")]
# solves points in one precision after the other and says how many were compiled before
SOLVE_IN = """
import sys
import numpy as np
from tests.unit.test_compiled import RESULTS, compiled, conditions
from thirdbody import load_parameters
from thirdbody.solver.compiled.loop import solve_points
from thirdbody.solver.compiled import machine_code
for name in sys.argv[2:]:
    found = compiled(load_parameters(), 1e-3, getattr(np, name), **conditions(2000))
    np.save(f"{sys.argv[1]}/{name}", [getattr(found, result) for result in RESULTS])
print(machine_code.compiled(solve_points).loaded)
"""


def test_precisions_compiled_by_different_processes_are_told_apart(tmp_path, defaults):
    """numba names the machine code of a record after a number that only one process knows."""
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path), "PYTHONPATH": ":".join(sys.path)}
    for names, kept in ((["float32"], 0), (["float64"], 0), (["float32", "float64"], 2)):
        command = [sys.executable, "-c", SOLVE_IN, str(tmp_path), *names]
        ran = run(command, capture_output=True, text=True, check=True, env=environment)
        assert int(ran.stdout) == kept
    for real in (SINGLE, DOUBLE):
        found = compiled(defaults, 1e-3, real, **conditions(2000))
        expected = [getattr(found, name) for name in RESULTS]
        np.testing.assert_array_equal(np.load(tmp_path / f"{real.__name__}.npy"), expected)


@pytest.mark.parametrize(("real", "rtol"), [(SINGLE, 1e-3), (DOUBLE, 1e-6)])
@pytest.mark.parametrize("many", [False, True])
def test_a_point_is_solved_alike_wherever_it_stands(reading, real, rtol, many):
    given = conditions(3000)
    if many:
        given["roughness"] = ROUGHNESS * np.linspace(0.99, 1.01, 3000)
    later = {name: values[123:] for name, values in given.items()}
    every, some = (compiled(reading, rtol, real, **points) for points in (given, later))
    for name in QUANTITIES:
        np.testing.assert_array_equal(getattr(every, name)[123:], getattr(some, name))


def test_it_compiles_where_nothing_can_be_kept(monkeypatch, parameters):
    def refusing(function):
        raise RuntimeError("cannot cache function: no locator available")

    found = compiled(parameters, 1e-6, **conditions(10))
    monkeypatch.setattr(machine_code, "KeptCode", refusing)
    again = machine_code.MachineCode(solve_points)
    monkeypatch.setattr("thirdbody.solver.compiled.points.compiled", lambda function: again)
    again = compiled(parameters, 1e-6, **conditions(10))
    np.testing.assert_array_equal(again.separation, found.separation)
