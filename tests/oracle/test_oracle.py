"""The extended-precision oracle against mpmath, against values of reference, and against itself."""

import numpy as np
import pytest
from mpmath import mp, mpf

from tests.oracle.extended import QUANTITIES, Oracle, why_not
from tests.oracle.in_mpmath import Interface
from tests.oracle.points import PUBLISHED, draw, one
from tests.summit_reference import PRINTED

pytestmark = pytest.mark.skipif(why_not() is not None, reason=str(why_not()))


@pytest.fixture(scope="module")
def oracle(tmp_path_factory):
    return Oracle(tmp_path_factory.mktemp("oracle"))


def in_mpmath(value):
    """A longdouble with all its digits."""
    high = float(value)
    return mpf(high) + mpf(float(value - np.longdouble(high)))


def surface_of(psi):
    """Summits of eta_s R sigma_s = 0.05 with the plasticity index ``psi`` = (E/H) sqrt(sigma/R)."""
    radius = 3e-7 / (psi * 5.0 / 112.0) ** 2
    return {"R": radius, "eta_s": 0.05 / (radius * 3e-7), "sigma_s": 3e-7, "y_s": 0.0}


@pytest.mark.parametrize("psi", PRINTED)
def test_summits_bear_what_the_table_of_reference_says(oracle, psi):
    model = PUBLISHED | surface_of(psi)
    bare = dict(viscosity=0.0, particle_diameter=0.0, roughness=3e-7, particle_density=0.0)
    separation = 3e-7 * np.arange(4)
    load, area, particles = oracle.evaluate(model, separation, **bare)
    assert load.astype(float) == pytest.approx(PRINTED[psi][0], rel=5e-5)
    assert area.astype(float) == pytest.approx(PRINTED[psi][1], rel=5e-5)
    assert (particles == 0.0).all()


def test_it_has_the_digits_that_mpmath_has(oracle, tell):
    """As many as the separation leaves: a tail multiplies the error of d by d h/sigma_s^2."""
    model, conditions = draw(28, seed=11)
    model["sigma_a_ratio"] = np.maximum(model["sigma_a_ratio"], 0.02)  # no step at one size
    conditions["load"] = np.maximum(conditions["load"], 1e-20)
    solved = oracle.solve(model, **conditions)
    worst = 0.0
    with mp.workdps(50):
        for index in np.flatnonzero(solved.count > 0):
            point = Interface(one(index, model, conditions))
            expected = point.quantities(in_mpmath(solved.first("separation")[index]))
            h = expected["separation"]
            digits_lost = float(abs((h - point.y_s) / point.sigma_s) * h / point.sigma_s)
            for name in QUANTITIES:
                found = in_mpmath(solved.first(name)[index])
                size = max(abs(expected[name]), mpf("1e-300"))
                error = float(abs(found - expected[name]) / size)
                assert error < 2e-18 * (50.0 + 3.0 * digits_lost), (index, name)
                worst = max(worst, error / (50.0 + 3.0 * digits_lost))
    tell(f"oracle: within {50.0 * worst:.0e} of mpmath where no digits are lost in tails")


def test_forces_fall_wherever_they_are_said_to(oracle):
    """Looking for more roots than one finds none, where F_s cannot rise with the separation."""
    model, conditions = draw(400, seed=13)
    few = oracle.solve(model, **conditions)
    many = oracle.solve(model, **conditions, everywhere=True)
    assert (few.count == many.count).all()
    model["coverage_limits"][:] = "printed"
    model["E_ss"] = model["E_sa"] = np.maximum(model["H_s1"], model["H_s2"]) * 10.0  # factor < 1
    assert set(oracle.solve(model, **conditions, everywhere=True).count) <= {-1, 1}


@pytest.mark.parametrize("limits", ["printed", "physical"])
def test_soft_particles_have_several_separations(oracle, limits):
    """All balance the forces, and the largest comes first."""
    model = PUBLISHED | {"E_ss": 3e9, "E_sa": 3e9, "h_e_ratio": 0.5, "elastic_limits": limits}
    model |= {"phi_a": "centred", "mean_ratio": 1.0, "sigma_a_ratio": 0.05}
    conditions = dict(viscosity=0.0, particle_diameter=1e-6, roughness=3e-7, particle_density=1e11)
    loads = 10.0 ** np.linspace(-4.0, -1.0, 31)
    solved = oracle.solve(model, load=loads, **conditions)
    several = np.flatnonzero(solved.count > 1)
    assert several.size and set(solved.count) == {1, 3}
    for index in several:
        roots = solved.roots["separation"][index, : solved.count[index]]
        assert (np.diff(roots) < 0.0).all()
        forces = oracle.evaluate(model, roots, **conditions)[0]
        assert (np.abs(forces / loads[index] - 1.0) < 1e-15).all()


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


def test_a_film_of_the_total_load_bears_what_solids_leave(oracle):
    model = PUBLISHED | {"film_load": "total"}
    conditions = dict(particle_diameter=5e-7, roughness=3e-7, particle_density=1e11)
    loads = 10.0 ** np.linspace(-7.0, -3.0, 50)
    wet = oracle.solve(model, load=loads, viscosity=90e-6, **conditions)
    dry = oracle.solve(model, load=loads, viscosity=0.0, **conditions)
    apart = wet.first("fluid_load_fraction") == 0.0
    assert apart.any() and not apart.all()
    assert (wet.first("separation")[apart] == dry.first("separation")[apart]).all()
    assert (wet.first("separation")[~apart] > dry.first("separation")[~apart]).all()
