"""The library against the extended-precision oracle over the whole domain, in all interpretations of the
equations: no value with a good status is wrong, and no bound is exceeded.

THIRDBODY_POINTS sets the number of points, THIRDBODY_SEED which are drawn: as many anywhere as next to kinks.
6,000 of each take a minute of a core.  For a million, run seeds one after the other.
"""

import os

import numpy as np
import pytest

import thirdbody as tb
from tests.oracle.comparison import PLACES, ROUND, compare, draw_points
from tests.oracle.extended import why_not

pytestmark = [
    pytest.mark.skipif(why_not() is not None, reason=str(why_not())),
    pytest.mark.filterwarnings("ignore::RuntimeWarning"),  # of points that have no film, or no load
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

POINTS = 25  # on each surface
SURFACES = ROUND * max(1, int(os.environ.get("THIRDBODY_POINTS", 6000)) // (ROUND * POINTS))
SEED = int(os.environ.get("THIRDBODY_SEED", 5))


@pytest.fixture(scope="module", params=PLACES)
def drawn(request, oracle):
    return draw_points(oracle, SURFACES, POINTS, SEED, request.param)


def test_no_number_is_wrong_and_no_bound_exceeded(drawn, oracle):
    compared = compare(drawn, oracle)
    problems = {name: places[:5] for name, places in compared.problems.items() if places.size}
    assert not problems, f"seed {SEED}"
    bound, known = compared.found["error_bound"], compared.known
    assert np.isinf(bound[bound > 1.0]).all()
    assert (bound[known] <= drawn.per_point(drawn.rtols)[known]).mean() > 0.8


def test_where_particles_alone_touch_they_press_with_their_hardness():
    """A_t* H/E = L_s F_t* where summits carry nothing (Eqs. 4 and 5)."""
    parameters = tb.load_parameters()
    load = np.geomspace(1e-12, 1e-6, 400)
    found = tb.solve(
        load=load,
        viscosity=[[0.0], [90e-6]],
        particle_diameter=1e-6,
        roughness=20e-9,
        particle_density=1e11,
        parameters=parameters,
    )
    pressure = parameters.hardness_surface_1 / parameters.elastic_modulus_surfaces
    alone = (found.surface_contact_area_ratio < 1e-12) & (found.error_bound < 1e-9)
    assert alone.mean() > 0.3
    solids = found.solid_load_fraction * load
    assert np.abs(found.total_contact_area * pressure / solids - 1.0)[alone].max() < 2e-9
