"""Turning points, windows and transitions: the error made is at most the error asked for, on few
loads too.
"""

from functools import cache

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.core.transitions import LIMITS, limit_crossings
from thirdbody.core.turning_points import turning_points
from thirdbody.core.windows import WindowSearch, turning_point_windows
from thirdbody.curves import Condition

pytestmark = pytest.mark.filterwarnings("error")

RTOLS = [1e-2, 1e-4, 1e-7, 1e-10]
BEST = 1e-11
FEW, MANY = 12, 200  # loads of a curve: four a decade, and many
# viscosity, diameter, roughness, density of curves with turning points and transitions
CURVES = np.array(
    [
        [0.0, 25e-6, 90e-6, 120e-6, 0.0, 0.0],
        [300e-9, 300e-9, 300e-9, 300e-9, 500e-9, 100e-9],
        [300e-9, 300e-9, 300e-9, 300e-9, 500e-9, 100e-9],
        [1e11, 1e11, 1e11, 1e11, 1e11, 1e11],
    ]
)


def span(count, parameters):
    """``count`` loads over the range of Table 2."""
    return np.geomspace(0.04, 80.0, count) / parameters.newtons_per_load


@cache
def solved(count, parameters, rtol):
    """The curves on so many loads."""
    load, given = span(count, parameters)[:, None], Condition(*CURVES)._asdict()
    return tb.solve(load=load, **given, parameters=parameters, rtol=rtol)


def turning(count, parameters, rtol):
    separation = solved(count, parameters, rtol).separation
    return turning_points(separation, *CURVES, parameters, rtol)


@pytest.mark.parametrize("rtol", RTOLS)
def test_turning_points_on_few_loads(parameters, rtol):
    found, best = turning(FEW, parameters, rtol), turning(MANY, parameters, BEST)
    assert np.isfinite(best.load).sum() >= 4
    for name in ("load", "peak_ratio", "solid_load_fraction", "separation"):
        value, reference = getattr(found, name), getattr(best, name)
        np.testing.assert_allclose(value, reference, rtol=rtol + BEST, err_msg=name)
    error = np.abs(found.load - best.load)
    assert (error <= found.load_error + best.load_error)[np.isfinite(error)].all()


@cache
def window(count, parameters, rtol):
    loads = span(2, parameters)
    search = WindowSearch(np.linspace(0.6, 1.6, 15), count, tolerance=0.1 * rtol, rtol=rtol)
    return turning_point_windows(search, [300e-9], 1e11, loads, parameters)[0]


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize("end", ["low", "high"])
def test_the_ends_of_a_window_on_few_loads(parameters, rtol, end):
    found, best = window(FEW, parameters, rtol), window(MANY, parameters, BEST)
    error = abs(getattr(found, end) - getattr(best, end))
    assert error <= (rtol + BEST) * getattr(best, end)
    assert error <= getattr(found, f"{end}_error") + getattr(best, f"{end}_error")


@cache
def crossings(count, parameters, rtol):
    """Loads and their error bounds of all transitions of all curves."""
    solution = solved(count, parameters, rtol)
    values = {quantity: getattr(solution, quantity) for quantity, _ in LIMITS}
    limit, curve, crossing, error, _ = limit_crossings(
        solution.separation, values, CURVES, parameters, rtol
    )
    order = np.lexsort((crossing, curve, limit))
    return curve[order], crossing[order], error[order]


@pytest.mark.parametrize("rtol", RTOLS)
def test_transition_loads_on_few_loads(parameters, rtol):
    curve, load, error = crossings(FEW, parameters, rtol)
    best_curve, best_load, best_error = crossings(MANY, parameters, BEST)
    assert curve.size >= 4
    assert np.array_equal(curve, best_curve)
    np.testing.assert_allclose(load, best_load, rtol=rtol + BEST)
    assert (np.abs(load - best_load) <= error + best_error).all()


def test_no_crossing_is_invented_beside_an_unsolved_point(parameters):
    separation = np.array([[1e-6], [0.9e-6], [np.nan]])
    values = dict.fromkeys(dict(LIMITS), np.array([[0.99], [0.99], [np.nan]]))
    assert limit_crossings(separation, values, CURVES[:, :1], parameters, 1e-9)[0].size == 0
