"""The library against the extended-precision oracle over the whole domain, in all interpretations
of the equations: no value with a good status is wrong, and no bound is exceeded.

THIRDBODY_POINTS sets the number of points, THIRDBODY_SEED which are drawn: as many anywhere as next
to kinks. 2,000 of each take 20 seconds of a core, `make test-survival` has 12,000.  For a million,
run seeds one after the other.
"""

import itertools
import os

import numpy as np
import pytest

from tests.oracle.comparison import PLACES, ROUND, compare, draw_points
from tests.oracle.extended import why_not
from tests.oracle.random_points import PUBLISHED
from thirdbody.core.asperity import SummitPopulation
from thirdbody.core.summits import QUADRATURE_ERROR

pytestmark = [
    pytest.mark.skipif(why_not() is not None, reason=str(why_not())),
    pytest.mark.filterwarnings("ignore::RuntimeWarning"),  # of points that have no film, or no load
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

POINTS = 25  # on each surface
SURFACES = ROUND * max(1, int(os.environ.get("THIRDBODY_POINTS", 2000)) // (ROUND * POINTS))
HARDNESS = PUBLISHED["H_s1"] / PUBLISHED["E_ss"]
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


def test_summits_keep_their_digits_however_deep_they_are_pressed(oracle):
    """Also where d is far below the summits' plane: wide integrals need more nodes than others."""
    t = np.linspace(-14.0, 8.0, 221)
    for ratio, first in itertools.product((1.0, 54.0, 1e4), (1e-3, 1.0, 6.0, 15.0, 300.0)):
        summits = SummitPopulation(
            scaled_density=0.05,
            sharpness=(0.3 * np.pi * HARDNESS) ** 2 / first,
            hardness_ratio=HARDNESS,
            yield_ratio=PUBLISHED["k"],
            plastic_ratio=ratio,
        )
        radius = 3e-7 / summits.sharpness
        surface = {"R": radius, "eta_s": 0.05 / (3e-7 * radius), "sigma_s": 3e-7, "y_s": 1e-5}
        model = PUBLISHED | surface | {"omega_ratio": ratio}
        d = 1e-5 + 3e-7 * t
        bare = dict(viscosity=0.0, particle_diameter=0.0, roughness=3e-7, particle_density=0.0)
        load, area, _, _ = oracle.evaluate(model, d, **bare)
        found = summits.log_load_and_area((d - 1e-5) / 3e-7)[:, 0]
        assert np.abs(found - np.log([load, area])).max() < QUADRATURE_ERROR, (ratio, first)
