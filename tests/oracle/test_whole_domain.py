"""The library against the extended-precision oracle over the whole domain, in all readings, by all
ways: no number is wrong that has a good status, and no bound is exceeded.

THIRDBODY_POINTS sets how many points are drawn, a few thousand if it is not set: with a million the
tests take an hour.
"""

import os

import numpy as np
import pytest

import thirdbody as tb
from tests.oracle.extended import CONDITIONS, QUANTITIES, Oracle, why_not
from tests.oracle.points import draw_for_library, move_to_kinks
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.plan import WAYS

pytestmark = [
    pytest.mark.skipif(why_not() is not None, reason=str(why_not())),
    pytest.mark.filterwarnings("ignore::RuntimeWarning"),  # of points that have no film, or no load
]

READINGS = 48  # combinations that ``draw_for_library`` takes in turn
SURFACES = READINGS * max(1, int(os.environ.get("THIRDBODY_POINTS", 4800)) // (READINGS * 100))
POINTS = 100  # on each surface
RTOLS = 1e-2, 1e-3, 1e-6, 1e-9, 1e-11
GOOD = [SOLUTION_STATUSES.index(name) for name in SOLUTION_STATUSES if name != "not_converged"]
SMALLEST = np.finfo(float).tiny  # below which numbers lose their digits


@pytest.fixture(scope="module")
def oracle(tmp_path_factory):
    return Oracle(tmp_path_factory.mktemp("oracle"))


@pytest.fixture(scope="module", params=["anywhere", "next to kinks"])
def drawn(request, oracle):
    """Conditions, the inputs of each surface, and what the oracle finds."""
    model, conditions, inputs = draw_for_library(SURFACES, POINTS, seed=5)
    if request.param != "anywhere":
        conditions = move_to_kinks(model, conditions, inputs, oracle, seed=6)
    return request.param, conditions, inputs, oracle.solve(model, **conditions)


def solved(conditions, inputs, way, rtol):
    """The variables of all points, each surface solved in one call."""
    found = []
    for index, parameters in enumerate(inputs):
        here = slice(index * POINTS, (index + 1) * POINTS)
        given = {name: conditions[name][here] for name in CONDITIONS}
        found.append(
            tb.solve(
                **given,
                parameters=parameters,
                rtol=rtol,
                way=way,
            )
        )
    variables = vars(found[0]).keys() - {"conditions"}
    return {name: np.concatenate([vars(one)[name] for one in found]) for name in variables}


def relative_error(found, expected):
    """Of numbers that float64 holds with all their digits; the others count as equal."""
    vanishes = (np.abs(found) < SMALLEST) & (np.abs(expected) < SMALLEST)
    error = np.abs((found - expected) / expected)
    return np.where(vanishes | (found == expected), 0.0, error).astype(float)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("rtol", RTOLS)
def test_no_number_is_wrong_and_no_bound_exceeded(drawn, way, rtol):
    place, conditions, inputs, expected = drawn
    found = solved(conditions, inputs, way, rtol)
    separation, status = expected.first("separation"), found["solution_status"]
    has_values = np.isfinite(found["separation"])
    exists = (expected.count > 0) & (separation >= 0.0)
    # a load that closes the surfaces to within rounding of d = 0 may be borne there or not
    doubtful = np.abs(separation) < 1e-13 * conditions["roughness"]
    # and two separations next to each other, where F_s turns, pass for none
    doubtful |= separation - expected.roots["separation"][:, 1] < 1e-10 * separation
    assert (has_values == exists)[~doubtful].all()
    known = has_values & exists & ~doubtful
    errors = {name: relative_error(found[name], expected.first(name)) for name in QUANTITIES}
    for name, error in errors.items():
        exceeded = known & ~(error <= found["error_bound"])
        assert not exceeded.any(), (name, np.flatnonzero(exceeded)[:5])
        wrong = known & np.isin(status, GOOD) & ~(error <= rtol)
        assert not wrong.any(), (name, np.flatnonzero(wrong)[:5])
    if place == "anywhere":  # next to kinks one of two may be within rounding of the other
        count = (expected.roots["separation"] >= 0.0).sum(axis=1)
        assert np.array_equal(found["separation_count"][known], count[known])
    assert (found["error_bound"][known] <= rtol).mean() > 0.5


@pytest.mark.parametrize("way", WAYS)
def test_where_particles_alone_touch_they_press_with_their_hardness(way):
    """A_t* H/E = L_s F_t* where summits bear nothing (Eqs. 4 and 5)."""
    parameters = tb.load_parameters()
    load = np.geomspace(1e-12, 1e-6, 400)
    found = tb.solve(
        load=load,
        viscosity=[[0.0], [90e-6]],
        particle_diameter=1e-6,
        roughness=20e-9,
        particle_density=1e11,
        parameters=parameters,
        way=way,
    )
    pressure = parameters.hardness_surface_1 / parameters.elastic_modulus_surfaces
    alone = (found.surface_contact_area_ratio < 1e-12) & (found.error_bound < 1e-9)
    assert alone.mean() > 0.3
    solids = found.solid_load_fraction * load
    assert np.abs(found.total_contact_area * pressure / solids - 1.0)[alone].max() < 2e-9
