"""``verification/plain_model.py`` against the extended-precision oracle, in all interpretations."""

from pathlib import Path

import numpy as np
import pytest

from benchmarks.baselines import load_plain_model
from tests.oracle.extended import CONDITIONS, QUANTITIES, SURFACE, why_not
from tests.oracle.random_points import COMBINATIONS, PUBLISHED, draw, one

pytestmark = [
    pytest.mark.skipif(why_not() is not None, reason=str(why_not())),
    # next to X_max, integrals over a few rounding errors of a size
    pytest.mark.filterwarnings("ignore:Extremely bad integrand:scipy.integrate.IntegrationWarning"),
]

RTOL = 1e-8
TINIEST = 1e-290  # what is smaller has fewer digits in float64
ROUNDING = 1e-15  # of a separation: what next to X_max a few particles bear depends on it
plain = load_plain_model(Path(__file__).parents[2] / "verification" / "plain_model.py")


def each_of(model, conditions):
    """The mapping of all numbers and interpretations, and the ``Point``, of each of the points."""
    for index in range(len(conditions["load"])):
        given = one(index, model, conditions)
        yield given, plain.Point(*(given[name] for name in (*CONDITIONS, *SURFACE)))


def quantities(separation, fractions, state, ball):
    """Values in the order of ``QUANTITIES``."""
    areas = state.total_area, state.particle_ratio, state.summit_ratio
    return np.array([separation, *fractions, *areas, separation / ball])


def errors(found, expected):
    """Relative, for every quantity; of numbers that have all digits."""
    size = np.maximum(np.abs(found), np.abs(expected))
    return np.abs(found - expected) / np.maximum(size, TINIEST)


def test_it_agrees_with_the_oracle_in_every_quantity(oracle, tell):
    every = 40 * COMBINATIONS
    model, conditions = draw(len(every), 17, every)
    expected = oracle.solve(model, **conditions)
    sound = expected.values["separation"] >= 0.0  # closer than d = 0 none are
    worst = 0.0
    for index, (given, point) in enumerate(each_of(model, conditions)):
        solution = plain.solve(given, point)
        assert (solution.state is not None) == sound[index], index
        if solution.state is None:
            crowded = not expected.exists[index]
            assert solution.status in ("load_exceeded", crowded and "coverage_exceeded"), index
            continue
        fractions = solution.solid_fraction, solution.fluid_fraction
        ball = given["R_x"]
        found = quantities(solution.separation, fractions, solution.state, ball)
        right = np.array([expected.values[name][index] for name in QUANTITIES], float)
        error = errors(found, right)
        if error.max() > RTOL:
            nearby = solution.separation * (1.0 + ROUNDING)
            shares, state = (each(nearby, given, point) for each in (plain.shares, plain.state))
            there = quantities(nearby, shares, state, ball)
            assert (error < RTOL + errors(found, there)).all(), index
        else:
            worst = max(worst, error.max())
    tell(f"plain model: within {worst:.0e} of the oracle at {len(sound)} points")


FEW = {"load": 1e-5, "viscosity": 0.0, "particle_diameter": 3e-7, "roughness": 3e-7}
FEW |= {"particle_density": 1e11}
CROWDED = {"participation": 1.0, "particle_density": 1e14}


@pytest.mark.parametrize(
    ("status", "changes"),
    [
        ("converged", {}),
        ("outside_film_formula", {"viscosity": 1e-6, "load": 1e-10}),  # thinner under more oil
        ("outside_film_formula", {"viscosity": 1e-1}),  # thicker than a hundredth of the ball
        ("outside_film_formula", {"viscosity": 90e-6, "load": 0.05}),  # more than the surfaces bear
        ("outside_film_formula", {"viscosity": 90e-6, "load": 1.0, "film_load": "total"}),
        ("converged", {"viscosity": 90e-6, "load": 0.04}),
        ("converged", {"viscosity": 1e-6}),  # a film that bears next to nothing
        ("area_exceeded", {"eta_s": 1e12, "load": 0.05}),
        ("area_exceeded", {"eta_s": 1e12, "load": 0.05, "viscosity": 1e-6}),
        ("coverage_exceeded", CROWDED),
        ("load_exceeded", {"load": 1.0}),
    ],
)
def test_it_names_what_is_to_be_said_of_a_point(status, changes):
    given = PUBLISHED | FEW | changes
    point = plain.Point(*(given[name] for name in (*CONDITIONS, *SURFACE)))
    solution = plain.solve(given, point)
    assert solution.status == status
    assert (solution.state is None) == (status in ("coverage_exceeded", "load_exceeded"))
