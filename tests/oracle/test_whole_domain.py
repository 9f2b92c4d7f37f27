"""The library against the extended-precision oracle over the whole domain, in all readings, by all
ways: no number is wrong that has a good status, and no bound is exceeded.

THIRDBODY_POINTS sets how many points are drawn, anywhere and next to kinks, and THIRDBODY_SEED which.
24,000 of both take about three minutes of a core; a million are best drawn by 42 seeds, one after the
other, which needs less memory than all at once and tells of failures early.
"""

import os

import numpy as np
import pytest

import thirdbody as tb
from tests.oracle.extended import CONDITIONS, QUANTITIES, Oracle, why_not
from tests.oracle.points import draw_for_library, move_to_kinks
from thirdbody.model.regimes import SOLUTION_STATUSES
from thirdbody.solver.plan import WAYS
from thirdbody.solver.several import ROUNDED

pytestmark = [
    pytest.mark.skipif(why_not() is not None, reason=str(why_not())),
    pytest.mark.filterwarnings("ignore::RuntimeWarning"),  # of points that have no film, or no load
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

RTOLS = 1e-2, 1e-3, 1e-6, 1e-9, 1e-11  # of the surfaces, in turn
ROUND = 48 * len(RTOLS)  # surfaces that have all readings, which are in turn too, with all of them
POINTS = 100  # on each surface
SURFACES = ROUND * max(1, int(os.environ.get("THIRDBODY_POINTS", 24000)) // (ROUND * POINTS))
SEED = int(os.environ.get("THIRDBODY_SEED", 5))
NOT_CONVERGED = SOLUTION_STATUSES.index("not_converged")
SMALLEST = np.finfo(float).tiny  # below which numbers lose their digits
# of a load: differences that may decide whether there is a separation (that within which samples tell no
# side, and the noise of solids beside), and how many there are; of both also so much times the elastic
# factor, by which rounding of what particles bear is magnified
ROUNDING, LEAST_TURN, MAGNIFIED = 1.5 * ROUNDED, 1e-9, 1e-13


@pytest.fixture(scope="module")
def oracle(tmp_path_factory):
    return Oracle(tmp_path_factory.mktemp("oracle"))


@pytest.fixture(scope="module", params=["anywhere", "next to kinks"])
def drawn(request, oracle):
    """Numbers and conditions of all points, the inputs of each surface, and what the oracle finds."""
    model, conditions, inputs = draw_for_library(SURFACES, POINTS, SEED)
    if request.param != "anywhere":
        conditions = move_to_kinks(model, conditions, inputs, oracle, SEED + 1)
    return model, conditions, inputs, oracle.solve(model, **conditions)


def solved(conditions, inputs, rtols, way):
    """The variables of all points, each surface solved in one call."""
    found = []
    for index, (parameters, rtol) in enumerate(zip(inputs, rtols, strict=True)):
        here = slice(index * POINTS, (index + 1) * POINTS)
        given = {name: conditions[name][here] for name in CONDITIONS}
        found.append(tb.solve(**given, parameters=parameters, rtol=rtol, way=way))
    variables = vars(found[0]).keys() - {"conditions"}
    return {name: np.concatenate([vars(one)[name] for one in found]) for name in variables}


def relative_error(found, expected):
    """Of numbers that float64 holds with all their digits; the others count as equal."""
    vanishes = (np.abs(found) < SMALLEST) & (np.abs(expected) < SMALLEST)
    error = np.abs((found - expected) / expected)
    return np.where(vanishes | (found == expected), 0.0, error).astype(float)


def counted(expected):
    """How many separations there are that are not negative."""
    return (expected.roots["separation"] >= 0.0).sum(axis=1)


def decided(oracle, model, conditions, places, apart):
    """Those of ``places`` where as many separations balance loads ``apart`` by so much [1]."""
    apart = np.broadcast_to(apart, conditions["load"].shape)[places]
    model, conditions = (
        {name: values[places] for name, values in given.items()} for given in (model, conditions)
    )
    counts = [
        counted(oracle.solve(model, **conditions | {"load": conditions["load"] * factor}))
        for factor in (1.0 - apart, 1.0, 1.0 + apart)
    ]
    return places[(counts[0] == counts[1]) & (counts[1] == counts[2])]


@pytest.mark.parametrize("way", WAYS)
def test_no_number_is_wrong_and_no_bound_exceeded(drawn, oracle, way):
    model, conditions, inputs, expected = drawn
    rtols = np.resize(RTOLS, SURFACES)
    found, rtol = solved(conditions, inputs, rtols, way), np.repeat(rtols, POINTS)
    count, bound = counted(expected), found["error_bound"]
    good = found["solution_status"] != NOT_CONVERGED
    has_values, exists = np.isfinite(found["separation"]), count > 0
    known = has_values & exists
    elastic = np.repeat([parameters.elastic_factor for parameters in inputs], POINTS)
    differs = np.flatnonzero(has_values != exists)
    by_rounding = np.maximum(ROUNDING, MAGNIFIED * elastic)
    problems = {
        "exists": decided(oracle, model, conditions, differs, by_rounding),
        "is good without a separation": np.flatnonzero(has_values & good & ~exists),
    }
    for name in QUANTITIES:
        error = relative_error(found[name], expected.first(name))
        problems[f"{name} beyond its bound"] = np.flatnonzero(known & ~(error <= bound))
        problems[f"{name} beyond rtol"] = np.flatnonzero(known & good & ~(error <= rtol))
    other = np.flatnonzero(known & good & (found["separation_count"] != count))
    apart = np.maximum(LEAST_TURN, MAGNIFIED * elastic)
    problems["separation_count"] = decided(oracle, model, conditions, other, apart)
    problems = {name: places[:5] for name, places in problems.items() if places.size}
    assert not problems, f"seed {SEED}"
    assert np.isinf(bound[bound > 1.0]).all()
    assert (bound[known] <= rtol[known]).mean() > 0.8


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
