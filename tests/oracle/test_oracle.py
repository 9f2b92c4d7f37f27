"""The extended-precision oracle against mpmath, against values of reference, and against itself."""

from pathlib import Path

import numpy as np
import pytest
from mpmath import mp, mpf

from benchmarks.points import read_rows, relative_error
from tests.oracle.extended import INTERPRETATIONS, NUMBERS, QUANTITIES, why_not
from tests.oracle.in_mpmath import Interface
from tests.oracle.points import PUBLISHED, draw, one

GOLDEN = Path(__file__).parents[1] / "golden"
pytestmark = pytest.mark.skipif(why_not() is not None, reason=str(why_not()))

# Load and area of Gaussian summits, computed elsewhere, to five digits: for k = 0.4, omega_2 = 54 omega_1,
# eta_s R sigma_s = 0.05 and H/E = 5/112, by the plasticity index psi = (E/H) sqrt(sigma_s/R), F/(A_n E) and
# A/A_n at d/sigma_s of 0, 1, 2 and 3 from the plane of the summits
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
        for index in np.flatnonzero(solved.count > 0):
            point = Interface(one(index, model, conditions))
            found = {name: in_mpmath(solved.first(name)[index]) for name in QUANTITIES}
            found["load"], h = point.load, found["separation"]
            if point.near_kink(h):  # of the distance to it ``h`` holds few digits
                continue
            digits_lost = float(abs((h - point.y_s) / point.sigma_s) * h / point.sigma_s)
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
        error = relative_error(solved.first(quantity).astype(float), expected)
        assert error.max() < 1e-10, (quantity, rows[np.argmax(error)])  # of nearly equal sizes


def test_no_separation_is_missed(oracle, tell):
    """As many as there are changes of sign of F_s + F_f - F_t among 1,000 separations."""
    count = 80
    model, conditions = draw(count, seed=14)
    model["E_ss"] = model["E_sa"] = model["E_ss"] / 30.0  # soft: F_s rises somewhere
    model["film_load"][:] = "fluid"
    separation = conditions["particle_diameter"] * np.random.default_rng(14).uniform(
        0.1, 3.0, count
    )
    separation = np.where(separation > 0.0, separation, conditions["roughness"])
    del conditions["load"]
    solid, _, _, film = oracle.evaluate(model, separation, **conditions)
    conditions["load"] = np.clip((solid + film).astype(float), 1e-100, 10.0)
    solved = oracle.solve(model, **conditions)
    several = 0
    for index in np.flatnonzero(solved.count > 0):
        given = one(index, model, conditions)
        load = given.pop("load")
        roots = solved.roots["separation"][index, : solved.count[index]].astype(float)
        low = roots[-1] - 1e-3 * abs(roots[-1])
        places = np.concatenate([np.linspace(low, 2.0 * abs(roots[0]), 1000), roots])
        # no sample within rounding of a root
        near = np.abs(places[:, None] - roots).min(axis=1) < 1e-12 * np.abs(places)
        places = np.sort(places[~near])
        solid, _, _, film = oracle.evaluate(given, places)
        above = solid + film > load
        assert np.count_nonzero(above[1:] != above[:-1]) <= solved.count[index], index
        assert above[0] and not above[-1], index
        several += solved.count[index] > 1
    assert several > 10
    tell(f"oracle: several separations at {several} points, none missed")


@pytest.mark.parametrize("limits", ["printed", "physical"])
def test_areas_keep_their_digits_next_to_a_kink(oracle, limits):
    """Where particles alone touch, A_t* H_s1/E_ss = L_s F_t*, however close X_max or X_max + h_e."""
    model = PUBLISHED | {"elastic_limits": limits, "sigma_a_ratio": 0.1}
    conditions = dict(viscosity=0.0, particle_diameter=2e-6, roughness=3e-8, particle_density=1e10)
    model |= {"phi_a": "centred", "mean_ratio": 1.0, "sigma_s": 3e-8}
    loads = 10.0 ** np.linspace(-300.0, -8.0, 400)
    solved = oracle.solve(model, load=loads, **conditions)
    assert (solved.count == 1).all()
    assert (solved.first("particle_contact_area_ratio") == 1.0).all()
    balance = solved.first("total_contact_area") * np.longdouble(model["H_s1"])
    balance /= np.longdouble(model["E_ss"]) * loads
    assert np.abs(balance - 1.0).max() < 2e-18
