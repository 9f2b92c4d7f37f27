"""Windows of the turning point against brute scans of dense load grids."""

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.curves.windows import WindowSearch, swept_windows, turning_point_windows

pytestmark = pytest.mark.filterwarnings("error")

DENSITY = 1e11


def turns(diameter, roughness, load_range, parameters):
    """A brute scan: a load at which the ratio is 0.02 above some smaller and some larger load."""
    dense = np.geomspace(*load_range, 4001)[:, None]
    solution = tb.solve(
        load=dense,
        viscosity=0.0,
        particle_diameter=diameter,
        roughness=roughness,
        particle_density=DENSITY,
        parameters=parameters,
        rtol=1e-11,
    )
    ratio = solution.particle_contact_area_ratio
    before = ratio - np.minimum.accumulate(ratio)
    after = ratio - np.minimum.accumulate(ratio[::-1])[::-1]
    return np.minimum(before, after).max(axis=0) > 0.02


@pytest.mark.parametrize("roughness", [100e-9, 300e-9, 500e-9])
def test_the_ends_of_a_window_are_those_of_a_brute_scan(parameters, loads, roughness):
    load_range = loads[0], loads[-1]
    search = WindowSearch(np.linspace(0.3, 2.5, 56))
    (window,) = turning_point_windows([search], [roughness], DENSITY, load_range, parameters)
    assert max(window.low_error, window.high_error) < 1e-6
    assert 0.3 < window.low < window.high < 2.5
    # the scan misses the peak by 4e-7 in its logarithm, which moves an end by some 1e-8
    step = 1e-6
    beside = np.array(
        [window.low - step, window.low + step, window.high - step, window.high + step]
    )
    turning = turns(beside * roughness, roughness, load_range, parameters)
    assert turning.tolist() == [False, True, True, False]


def test_a_sweep_that_starts_inside_the_window_says_that_its_end_is_unknown(parameters, loads):
    load_range = loads[0], loads[-1]
    whole, part = (
        turning_point_windows(
            [WindowSearch(np.linspace(first, 2.5, 45))], [300e-9], DENSITY, load_range, parameters
        )[0]
        for first in (0.3, 1.0)
    )
    assert whole.low < 1.0 == part.low
    assert part.low_error == np.inf
    assert abs(part.high - whole.high) <= part.high_error + whole.high_error


def test_without_a_turning_point_there_is_no_window(parameters, loads):
    search = WindowSearch(np.linspace(0.01, 0.1, 10))
    load_range = loads[0], loads[-1]
    (window,) = turning_point_windows([search], [300e-9], DENSITY, load_range, parameters)
    assert all(np.isnan([window.low, window.low_error, window.high, window.high_error]))


def test_of_many_sweeps_the_longest_runs_are_the_windows():
    high, low, none = 0.08, 0.0, np.nan
    sweeps = [
        [low, high, high, low, high, low],  # two runs
        [high, high, low, high, low, low],  # one that begins beyond the sweep
        [low, low, none, low, none, low],  # none
        [low, none, high, high, high, high],  # one that ends beyond it
        [-high, high, high, high, -high, low],  # beside maxima beyond the loads
    ]
    starts, ends = swept_windows(np.arange(1.0, 7.0), np.transpose(sweeps))
    assert np.allclose(starts, [1.5, 1.0, np.nan, 2.5, 1.75], equal_nan=True)
    assert np.allclose(ends, [3.5, 2.5, np.nan, 6.0, 4.25], equal_nan=True)
