"""The extremes at which models of this kind break.

``tests/golden/extremes.csv`` has values by mpmath; its ``origin`` says whether a row is known by
the equations as they stand, by a limit of them, or by an argument where there is no solution.
"""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from methods import POINT

import thirdbody as tb
from benchmarks.extremes import judge_extremes
from benchmarks.points import VARIABLES, read_rows, relative_error
from thirdbody.core.regimes import has_values

pytestmark = [
    pytest.mark.filterwarnings("error"),
    pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning"),
]

ROWS = read_rows(Path(__file__).parents[1] / "golden" / "extremes.csv")
ITEMS = list(dict.fromkeys(row["item"] for row in ROWS))
RTOLS = [1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-11]
# particles of next to no width: refused by the name of the input
REFUSED = {
    f"{case} {medium}"
    for case in ("1e-09", "0 uncentred", "0 1e-05", "0 0.0001")
    for medium in ("dry", "wet")
}
# particles so few or small that float64 has too few digits for their area
REFUSED |= {f"{size} {medium}" for size in ("1e-200", "1e-300") for medium in ("dry", "wet")}
# what the bounds of float64 allow no more than this error: its digits are those of a small
# difference, of the sizes that just touch, or of what particles leave of the interface
LOST = {
    1e-6: {"coverage 0.999999999 dry", "coverage 0.999999999 wet"},
    1e-9: {
        "1e-12 three-body dry",
        "1e-10 three-body wet",
        "1e-06 dry",
        "1e-06 wet",
    },
}
# |d ln d/d ln F_s| below which loads change so fast with d that 1e-11 may be too much
STEEP = 0.1
LOAD_ROUNDING = (
    1e-14  # relative error that rounding leaves in a load, through logarithms of its parts
)
GAP_ROUNDING = 2.3e-16  # and in a separation


def beyond_float64(row, rtol):
    """Whether rounding changes the separation or the loads of a row by more than ``rtol``."""
    conditioning = float(row["gap_conditioning"] or 0.0)
    if conditioning == 0.0:
        return False
    return max(conditioning * LOAD_ROUNDING, GAP_ROUNDING / conditioning) > rtol


def solve(parameters, rtol=1e-9, **given):
    return tb.solve(**(POINT | given), parameters=parameters, rtol=rtol)


def nearly_closes(row):
    """Whether the load almost closes the gap, so that d follows from a difference of loads."""
    return float(row["gap_conditioning"] or 0.0) > 50.0


@pytest.mark.parametrize("rtol", RTOLS)
@pytest.mark.parametrize("item", ITEMS)
def test_each_extreme_is_right_or_says_why_not(item, rtol):
    rows = [row for row in ROWS if row["item"] == item and not nearly_closes(row)]
    judged = judge_extremes([row for row in rows if not beyond_float64(row, rtol)], rtol)
    wrong = [found for found in judged if found["verdict"].startswith("wrong")]
    assert not wrong, "\n".join(map(str, wrong))
    refused = {found["case"] for found in judged if found["verdict"].startswith("refused")}
    allowed = REFUSED.union(*(cases for least, cases in LOST.items() if rtol <= least))
    if rtol == 1e-11:
        allowed |= {row["case"] for row in rows if float(row["gap_conditioning"] or 1.0) < STEEP}
        allowed |= {row["case"] for row in rows if row["item"] == "soft_particles"}
    assert refused <= allowed


NEARLY_CLOSED = [row for row in ROWS if nearly_closes(row)]


@pytest.mark.parametrize("rtol", RTOLS)
def test_a_gap_that_nearly_closes_is_right_too(rtol):
    rows = [row for row in NEARLY_CLOSED if not beyond_float64(row, rtol)]
    verdicts = {found["verdict"] for found in judge_extremes(rows, rtol)}
    assert verdicts <= {"right"}


@pytest.mark.parametrize("rtol", [1e-9, 1e-11])
def test_what_rounding_makes_impossible_says_so(rtol):
    rows = [row for row in ROWS if beyond_float64(row, rtol)]
    verdicts = [found["verdict"] for found in judge_extremes(rows, rtol)]
    assert len(rows) >= 2
    assert not [verdict for verdict in verdicts if verdict.startswith("wrong")]


@pytest.mark.parametrize("density", [1e-280, 1e-292, 1e-294, 1e-298, 5e-324])
def test_particles_too_few_for_float64_have_their_share_within_its_bound(parameters, density):
    film = {"viscosity": 120e-6, "particle_diameter": 3e-7, "roughness": 3e-8}
    few, more = (solve(parameters, **film, particle_density=number) for number in (density, 1e-200))
    expected = density * (more.particle_contact_area_ratio / 1e-200)
    error = abs(few.particle_contact_area_ratio / expected - 1.0)
    assert error <= few.error_bound + more.error_bound
    assert (few.solution_status == "converged") == (few.error_bound <= 1e-9)


@pytest.mark.parametrize("bad", [5e-324, 1e-320, 9.99e-31, 1.01e30, 1e308])
def test_a_roughness_whose_surface_float64_cannot_hold_is_refused(parameters, method, bad):
    shown = re.escape(f"roughness is {bad:g}; allowed: 1e-30 to 1e+30 m")
    for roughness in (bad, [3e-7, bad]):
        with pytest.raises(ValueError, match=f"^{shown}$"):
            solve(parameters, roughness=roughness)


def test_a_roughness_whose_summits_are_too_high_is_refused_with_the_input_that_lifts_them(
    parameters, method
):
    steep = replace(parameters, summit_parameter_exponent=1.0)
    message = (
        "^roughness is 1e-12 m, at which summit_parameter_exponent 1 puts .*; allowed: at most "
    )
    with pytest.raises(ValueError, match=message):
        solve(steep, roughness=1e-12)


def extreme_points(count, seed):
    """Conditions over the whole domain, some of them beyond what can be solved."""
    random = np.random.default_rng(seed)
    some = {
        "load": 10.0 ** random.uniform(-300.0, 300.0, count),
        "viscosity": 10.0 ** random.uniform(-320.0, 10.0, count),
        "particle_diameter": 10.0 ** random.uniform(-320.0, 10.0, count),
        "particle_density": 10.0 ** random.uniform(-320.0, 300.0, count),
    }
    usual = {"load": (-12, 2), "viscosity": (-12, 0), "particle_diameter": (-12, -3)}
    usual["particle_density"] = (0, 20)
    for name, values in some.items():
        near = random.random(count) < 0.7
        values[near] = 10.0 ** random.uniform(*usual[name], near.sum())
        if name != "load":
            values[random.random(count) < 0.05] = 0.0
    return some | {"roughness": random.choice([1e-9, 3e-8, 3e-7, 1e-5], count)}


@pytest.mark.parametrize("rtol", [1e-2, 1e-9])
def test_no_point_harms_another(parameters, rtol, method):
    points = extreme_points(400, seed=1)
    together = solve(parameters, rtol, **points)
    for index in range(0, 400, 25):
        one = {name: values[index] for name, values in points.items()}
        alone = solve(parameters, rtol, **one)
        assert alone.solution_status == together.solution_status[index], one
        for name in VARIABLES:
            values = getattr(alone, name), getattr(together, name)[index]
            assert np.isnan(values[1]) or relative_error(*values) <= rtol, (name, one)


@pytest.mark.parametrize("rtol", [1e-2, 1e-11])
def test_a_number_or_a_status_over_the_whole_domain(interpretation, rtol):
    solution = solve(interpretation, rtol, **extreme_points(1000, seed=2))
    solved = has_values(solution.solution_status.astype(int))
    missed = solution.solution_status == "not_converged"
    assert np.array_equal(solution.error_bound <= rtol, solved & ~missed)
    assert np.array_equal(np.isnan(solution.separation), ~solved)
    for name in VARIABLES:
        values = getattr(solution, name)
        assert np.array_equal(np.isfinite(values), solved), name
        assert (values[solved] >= 0.0).all(), name
    assert solved.mean() > 0.3
