"""Transitions against interpolation on dense load grids."""

from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.curves.transitions import LIMITS, transitions
from thirdbody.data.conditions import Condition

pytestmark = pytest.mark.filterwarnings("error")

# dry and lubricated curves on several surfaces; at 375 nm on 300 nm the ratio rises and falls
CONDITIONS = np.array(
    [
        [0.0, 90e-6, 120e-6, 150e-6, 0.0, 25e-6, 0.0],
        [500e-9, 500e-9, 500e-9, 300e-9, 300e-9, 100e-9, 375e-9],
        [300e-9, 300e-9, 300e-9, 300e-9, 300e-9, 100e-9, 300e-9],
        [1e11, 1e11, 1e11, 1e11, 1e12, 1e11, 1e11],
    ]
)


DENSE = 4001


@cache
def solved(count, parameters, rtol=1e-9):
    """Loads over the range of Table 2, and the solution of all curves on them."""
    load = np.geomspace(0.04, 80.0, count) / parameters.newtons_per_load
    return load, tb.solve(
        load=load[:, None], **Condition(*CONDITIONS)._asdict(), parameters=parameters, rtol=rtol
    )


@cache
def crossings(quantity, level, parameters, rtol=1e-9, count=60):
    """The four columns of ``transitions``, in the order of curves and loads."""
    _, solution = solved(count, parameters, rtol)
    values = {quantity: getattr(solution, quantity)}
    limits = [(quantity, level)]
    _, *found = transitions(solution.separation, values, CONDITIONS, parameters, rtol, limits)
    order = np.lexsort((found[1], found[0]))
    return [column[order] for column in found]


def interpolated(quantity, level, parameters):
    """The same from a dense grid: rows of curve, load, and whether the quantity rises."""
    dense, solution = solved(DENSE, parameters)
    values = getattr(solution, quantity)
    rows = []
    for curve in range(CONDITIONS.shape[1]):
        above = values[:, curve] > level
        for step in np.flatnonzero(above[:-1] != above[1:]):
            two = slice(step, step + 2)
            order = slice(None) if above[step + 1] else slice(None, None, -1)
            ends = values[two, curve][order], np.log(dense[two])[order]
            rows.append((curve, np.exp(np.interp(level, *ends)), above[step + 1]))
    return rows


@pytest.mark.parametrize(("quantity", "level"), LIMITS)
def test_crossings_are_those_of_a_dense_grid(parameters, quantity, level):
    curve, load, _, rising = crossings(quantity, level, parameters)
    rows = interpolated(quantity, level, parameters)
    assert curve.tolist() == [row[0] for row in rows]
    assert rising.tolist() == [row[2] for row in rows]
    # an eighth of the square of the dense grid's step, 1.9e-3, times a curvature of some 100
    assert_allclose(load, [row[1] for row in rows], rtol=1e-4)


def test_a_level_that_is_never_reached_has_no_crossing(parameters):
    for column in crossings("particle_contact_area_ratio", 2.0, parameters):
        assert column.size == 0


def test_no_crossing_is_invented_beside_an_unsolved_point(parameters):
    separation = np.array([[1e-6], [0.9e-6], [np.nan]])
    values = dict.fromkeys(dict(LIMITS), np.array([[0.99], [0.99], [np.nan]]))
    found = transitions(separation, values, CONDITIONS[:, :1], parameters, 1e-9)
    assert found[0].size == 0
