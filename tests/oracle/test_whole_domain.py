"""The library against the extended-precision oracle over the whole domain, in all interpretations of the
equations: no value with a good status is wrong, and no bound is exceeded.

THIRDBODY_POINTS sets the number of points, THIRDBODY_SEED which are drawn: as many anywhere as next to kinks.
6,000 of each take a minute of a core.  For a million, run seeds one after the other.
"""

import os

import numpy as np
import pytest

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
