"""The extended-precision oracle against mpmath, against values of reference, and against itself."""

from pathlib import Path

import numpy as np
import pytest
from mpmath import mp, mpf

from benchmarks.points import read_rows, relative_error
from tests.oracle.extended import INTERPRETATIONS, NUMBERS, QUANTITIES, why_not
from tests.oracle.in_mpmath import Interface
from tests.oracle.random_points import PUBLISHED, draw, one

GOLDEN = Path(__file__).parents[1] / "golden"
pytestmark = pytest.mark.skipif(why_not() is not None, reason=str(why_not()))

# Load and area of Gaussian summits, computed elsewhere, to five digits: for k = 0.4, omega_2 = 54
# omega_1, eta_s R sigma_s = 0.05 and H/E = 5/112, by the plasticity index psi = (E/H)
# sqrt(sigma_s/R), F/(A_n E) and A/A_n at d/sigma_s of 0, 1, 2 and 3 from the plane of the summits
LOADS = {
    0.5: (6.3989e-4, 1.1260e-4, 9.8931e-6, 3.9281e-7),
    1.0: (1.1904e-3, 2.1671e-4, 1.9414e-5, 7.7860e-7),
    2.5: (2.1256e-3, 3.9565e-4, 3.6730e-5, 1.5304e-6),
}
AREAS = {
    0.5: (6.2666e-2, 1.3087e-2, 1.3337e-3, 6.0029e-5),
    1.0: (6.2708e-2, 1.3090e-2, 1.3338e-3, 6.0030e-5),
    2.5: (6.7305e-2, 1.3608e-2, 1.3635e-3, 6.0822e-5),
}


def in_mpmath(value):
    """A longdouble with all its digits."""
    high = float(value)
    return mpf(high) + mpf(float(value - np.longdouble(high)))


def surface_of(psi):
    """Summits of eta_s R sigma_s = 0.05 with the plasticity index ``psi`` = (E/H) sqrt(sigma/R)."""
    radius = 3e-7 / (psi * 5.0 / 112.0) ** 2
    return {"R": radius, "eta_s": 0.05 / (radius * 3e-7), "sigma_s": 3e-7, "y_s": 0.0}


@pytest.mark.parametrize("psi", LOADS)
def test_summits_bear_what_the_table_of_reference_says(oracle, psi):
    model = PUBLISHED | surface_of(psi)
    bare = dict(viscosity=0.0, particle_diameter=0.0, roughness=3e-7, particle_density=0.0)
    separation = 3e-7 * np.arange(4)
    load, area, particles, _ = oracle.evaluate(model, separation, **bare)
    assert load.astype(float) == pytest.approx(LOADS[psi], rel=5e-5)
    assert area.astype(float) == pytest.approx(AREAS[psi], rel=5e-5)
    assert (particles == 0.0).all()


def test_it_has_the_digits_that_mpmath_has(oracle, tell):
    """As many as the separation leaves: a tail multiplies the error of d by d h/sigma_s^2."""
    model, conditions = draw(28, seed=11)
    model["sigma_a_ratio"] = np.maximum(model["sigma_a_ratio"], 0.02)  # no step at one size
    conditions["load"] = np.maximum(conditions["load"], 1e-20)
    solved = oracle.solve(model, **conditions)
    worst, count = 0.0, 0
    with mp.workdps(50):
        for index in np.flatnonzero(solved.exists):
            point = Interface(one(index, model, conditions))
            found = {name: in_mpmath(solved.values[name][index]) for name in QUANTITIES}
            found["load"], h = point.load, found["separation"]
            if point.near_kink(h):  # of the distance to it ``h`` holds few digits
                continue
            digits_lost = float(abs((h - point.y_s) * h)) / float(point.sigma_s) ** 2
            for name, expected in point.at(h, found["fluid_load_fraction"] * point.load).items():
                size = max(abs(expected), mpf("1e-300"))
                error = float(abs(found[name] - expected) / size)
                assert error < 2e-18 * (50.0 + 3.0 * digits_lost), (index, name)
                worst = max(worst, error / (50.0 + 3.0 * digits_lost))
            count += 1
    assert count > 15
    tell(f"oracle: within {50.0 * worst:.0e} of mpmath where no digits are lost in tails")


@pytest.mark.parametrize("name", ["extremes", "accuracy_points"])
def test_golden_values_are_those_of_the_oracle(oracle, name):
    """Made in mpmath, to 25 digits; rows that are known by an argument or a limit are left out."""
    rows = read_rows(GOLDEN / f"{name}.csv")
    rows = [row for row in rows if row.get("origin", "equations") == "equations"]
    model = {key: np.array([float(row[key]) for row in rows]) for key in NUMBERS}
    words = INTERPRETATIONS.keys() & rows[0].keys()
    solved = oracle.solve(model | {key: np.array([row[key] for row in rows]) for key in words})
    for quantity in QUANTITIES:
        expected = np.array([float(row[quantity]) for row in rows])
        error = relative_error(solved.values[quantity].astype(float), expected)
        assert error.max() < 1e-10, (quantity, rows[np.argmax(error)])  # of nearly equal sizes


def test_the_forces_are_too_large_closer_and_too_small_farther(oracle, tell):
    """F_s + F_f - F_t changes its sign once among 1,000 separations, at the one that is found."""
    model, conditions = draw(80, seed=14)
    model["film_load"][:] = "fluid"
    solved = oracle.solve(model, **conditions)
    places = np.flatnonzero(solved.exists)
    for index in places:
        given = one(index, model, conditions)
        load, found = given.pop("load"), float(solved.values["separation"][index])
        sample = found + abs(found) * np.linspace(-1e-3, 1.0, 1000)
        sample = sample[np.abs(sample - found) > 1e-12 * abs(found)]  # rounding decides there
        solid, _, _, film = oracle.evaluate(given, sample)
        assert np.array_equal(solid + film > load, sample < found), index
    assert places.size > 60
    tell(f"oracle: one separation at each of {places.size} points")


def test_areas_keep_their_digits_next_to_a_kink(oracle):
    """Where particles alone touch, A_t* H_s1/E_ss = L_s F_t*, however close X_max + h_e."""
    model = PUBLISHED | {"sigma_a_ratio": 0.1}
    conditions = dict(viscosity=0.0, particle_diameter=2e-6, roughness=3e-8, particle_density=1e10)
    model |= {"mean_ratio": 1.0, "sigma_s": 3e-8}
    loads = 10.0 ** np.linspace(-300.0, -8.0, 400)
    solved = oracle.solve(model, load=loads, **conditions)
    assert solved.exists.all()
    assert (solved.values["particle_contact_area_ratio"] == 1.0).all()
    balance = solved.values["total_contact_area"] * np.longdouble(model["H_s1"])
    balance /= np.longdouble(model["E_ss"]) * loads
    assert np.abs(balance - 1.0).max() < 2e-18
