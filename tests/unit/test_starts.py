"""How starts are timed: what takes turns, what is left out, and where two ways cost the same."""

import numpy as np
import pytest

from benchmarks.starts import (
    AUTOMATIC,
    COLD,
    WARM,
    break_even,
    expected_seconds,
    least_times,
    loading_break_even,
    over_best,
)

BUDGET = {"points": [1, 100, 1000], "rounds": 3, "enough_seconds": 10.0, "limit_seconds": 60.0}
START = {"compiled": {COLD: 8.0, WARM: 1.0}, "tables": {WARM: 0.5}, "quadrature": {WARM: 0.5}}
POINT = {"compiled": 0.0, "tables": 1e-3, "quadrature": 0.1}  # seconds


def seconds(run):
    """Made-up time of a run; what is automatic is always compiled."""
    points, start, way = run
    way = "compiled" if way == AUTOMATIC else way
    return START[way][start] + POINT[way] * points


def test_each_run_is_repeated_until_it_had_its_rounds_or_enough_time():
    calls = []

    def timed(run):
        calls.append(run)
        return seconds(run)

    times = least_times(timed, BUDGET)
    assert calls.count((1, WARM, "tables")) == 3
    assert calls.count((1, COLD, "compiled")) == 2
    assert calls.count((100, WARM, "quadrature")) == 1
    assert times[1, WARM, "tables"] == seconds((1, WARM, "tables"))
    # what is compiled on disk is nothing to the other ways
    assert (1, COLD, "tables") not in times
    # the runs of a round follow each other before any is repeated
    assert calls.index((1000, WARM, AUTOMATIC)) < len(times)


def test_what_would_take_longer_than_the_limit_is_left_out():
    times = least_times(seconds, BUDGET)
    left_out = [run for run, time in times.items() if time is None]
    assert left_out == [(1000, WARM, "quadrature")]
    assert over_best(times, 1000, WARM, "quadrature") is None
    assert over_best(times, 1000, WARM, "tables") == 1.5
    assert over_best(times, 1000, COLD, AUTOMATIC) == 8.0 / 1.5
    # what is chosen is timed in any case, though with nothing to be held against
    impatient = least_times(seconds, BUDGET | {"points": [1, 10**6], "limit_seconds": 0.1})
    assert impatient[10**6, COLD, AUTOMATIC] == 8.0
    assert over_best(impatient, 10**6, COLD, AUTOMATIC) is None


def test_time_is_expected_to_grow_with_the_points_but_for_the_start():
    runs = {
        (1, WARM, "tables"): [0.7, 0.5],
        (100, WARM, "tables"): [1.5],
        (9, WARM, "other"): [9.0],
    }
    assert expected_seconds((1000, WARM, "tables"), runs) == pytest.approx(0.5 + 1.0 * 10)
    runs[100, WARM, "tables"] = [0.7]  # which may be noise
    assert expected_seconds((1000, WARM, "tables"), runs) == 0.7
    assert expected_seconds((1, WARM, "tables"), runs) == 0.0


def test_two_ways_cost_the_same_where_the_time_saved_changes_its_sign():
    assert break_even([0, 100], [1.0, 3.0], [2.0, 2.0]) == 50.0
    assert np.isnan(break_even([0, 100], [1.0, 3.0], [4.0, 4.0]))
    assert np.isnan(break_even([0, 100], [1.0, 3.0], [0.5, 0.5]))
    rows = [
        {"points": points, "start": start, "way": way, "seconds": time}
        for start in (COLD, WARM)
        for way, times in (("tables", (1.0, 3.0)), ("compiled", (2.0, 2.0 + (start == COLD))))
        for points, time in zip((0, 100), times, strict=True)
    ]
    assert loading_break_even(rows, WARM) == 50.0
    assert loading_break_even(rows, COLD) == 100.0
