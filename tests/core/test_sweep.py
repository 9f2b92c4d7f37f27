"""Grids that are interpolated over the separation, against the same points solved one by one."""

from dataclasses import replace

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.core.regimes import SOLUTION_STATUSES
from thirdbody.core.solve import solve_points
from thirdbody.core.sweep import sweep
from thirdbody.variables import QUANTITIES, VARIABLES

pytestmark = pytest.mark.filterwarnings("error")

ORDINARY = {
    "load": np.geomspace(1e-8, 1e-4, 100),
    "viscosity": np.array([0.0, 2e-6, 2e-5, 5e-5, 1e-4, 2e-4]),
    "particle_diameter": np.array([0.0, 1e-7, 5e-7]),
    "roughness": np.array([3e-7]),
    "particle_density": np.array([1e10, 1e12]),
}
EXTREME = {
    "load": np.geomspace(1e-14, 1e-1, 100),
    "viscosity": np.geomspace(1e-8, 1e-2, 5),
    "particle_diameter": np.array([1e-9, 1e-5]),
    "roughness": np.array([1e-8]),
    "particle_density": np.array([1e8, 1e14]),
}
TINY = 2.3e-308


def compared(axes, parameters, rtol):
    """The sweep, the points solved one by one, and whether both have the error asked for."""
    found = sweep(axes, parameters, rtol, VARIABLES)
    crossed = dict(zip(axes, np.ix_(*axes.values()), strict=True))
    points = solve_points(crossed, parameters, 1e-9, VARIABLES)
    hidden = SOLUTION_STATUSES.index("not_converged")
    both = (found["solution_status"] != hidden) & (points["solution_status"] != hidden)
    return found, points, both


@pytest.mark.parametrize("film_load", ["fluid", "total"])
@pytest.mark.parametrize("axes", [ORDINARY, EXTREME], ids=["ordinary", "extreme"])
def test_a_sweep_keeps_the_error_asked_for(interpretation, axes, film_load):
    rtol = 1e-3
    inputs = replace(interpretation, film_load=film_load)
    found, points, both = compared(axes, inputs, rtol)
    assert np.array_equal(found["solution_status"][both], points["solution_status"][both])
    for quantity in QUANTITIES:
        value, true = (each[quantity][both] for each in (found, points))
        assert np.array_equal(np.isnan(value), np.isnan(true))
        large = true > TINY
        error = np.abs(value[large] / true[large] - 1.0)
        bound = (found["error_bound"] + points["error_bound"])[both][large]
        assert (error <= bound).all(), (quantity, error.max())
    assert (found["error_bound"][both & ~np.isnan(found["separation"])] <= rtol).all()


def test_a_grid_is_the_sweep_where_digits_are_few(parameters):
    swept, exact = (
        tb.grid(**ORDINARY, parameters=parameters, rtol=rtol, progress=False)
        for rtol in (1e-3, 1e-6)
    )
    for name in ("separation", "total_contact_area", "solid_load_fraction"):
        np.testing.assert_allclose(swept[name], exact[name], rtol=2e-3, err_msg=name)
