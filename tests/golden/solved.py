"""Solutions of golden points, to as many digits as mpmath is set to.

The oracle in extended precision (`tests/oracle/contact.c`) finds every separation that balances the forces;
`tests/oracle/in_mpmath.py` gives the largest one all its digits. Inputs are exact: the float64 that is passed is the
number that is solved. Units are SI; loads are divided by A_n E_ss, areas by A_n.
"""

import functools
import tempfile

import numpy as np
from mpmath import mp

from tests.oracle.extended import CONDITIONS, NUMBERS, Oracle
from tests.oracle.extended import QUANTITIES as FOUND
from tests.oracle.in_mpmath import Interface

INTERPRETATIONS = ("phi_a", "surface_offset", "elastic_limits", "coverage_limits", "film_load")
COORDINATES = CONDITIONS
PARAMETERS = (
    *("E_ss", "E_sa", "H_s1", "H_s2", "k", "omega_ratio"),
    *("R_x", "G", "V", "kappa", "U_per_viscosity", "A_n"),
    *("eta_s", "R", "sigma_s", "y_s"),
    *("mean_ratio", "sigma_a_ratio", "gap_ratio", "truncation", "participation", "h_e_ratio"),
)
OUTPUTS = (
    *("total_contact_area", "particle_contact_area_ratio", "surface_contact_area_ratio"),
    *("solid_load_fraction", "fluid_load_fraction", "separation", "film_thickness"),
)
assert set(PARAMETERS) | set(COORDINATES) == set(NUMBERS) and set(OUTPUTS) == set(FOUND)


class Meaningless(ArithmeticError):
    """The equations have no meaning here: coverage too high, or no positive separation carries the load."""


@functools.cache
def oracle():
    """The oracle, compiled once."""
    folder = tempfile.mkdtemp()
    return Oracle(folder, threads=1)


def given(row):
    """What the oracle and `Interface` take of a row."""
    words = {name: row[name] for name in INTERPRETATIONS if name != "surface_offset"}
    return words | {name: row[name] for name in NUMBERS} | {"particle_plane": "surface"}


def interface(row):
    """The equations at a row."""
    return Interface(given(row))


def solve_contact(row, most_coverage=0.9):
    """The row with its solution and status; Meaningless where it has none."""
    p = interface(row)
    if load_coverage(mp.zero, p) > most_coverage and row["coverage_limits"] == "printed":
        raise Meaningless
    roots = oracle().solve(given(row)).roots["separation"][0]
    count = int(np.count_nonzero(roots >= 0.0))
    if count == 0:
        raise Meaningless
    solution = p.quantities(exact(roots[0]))
    if load_coverage(solution["separation"], p) > most_coverage:
        raise Meaningless
    return row | solution | {"status": status_of(solution, p, count)}


def load_coverage(d, p):
    """What particles take from the load of the summits (Eq. 4)."""
    return p.coverage(d if p.given["coverage_limits"] == "contacting" else -mp.inf)


def status_of(solution, p, count=1):
    """The gravest `solution_status` that applies to a solution, one of `count`."""
    if solution["total_contact_area"] > 1:
        return "area_exceeded"
    if p.viscosity and solution["fluid_load_fraction"] > mp.mpf("0.001"):
        in_film = p.load * solution["fluid_load_fraction"]
        load = p.load if p.given["film_load"] == "total" else in_film
        thick = solution["film_thickness"] > mp.mpf("0.01")
        if thick or thins(load, p) or load * p.E_ss > min(p.H_s1, p.H_s2):
            return "outside_film_formula"
    return "several_separations" if count > 1 else "converged"


def thins(load, p):
    """Whether the film of Eq. 7 is thinner under more viscosity."""
    thickness, viscosity = p.film(load), p.viscosity
    p.viscosity = viscosity * (1 + mp.mpf("1e-12"))
    thinner = p.film(load) <= thickness
    p.viscosity = viscosity
    return thinner


def root(function, low, high):
    """The root of `function` between `low` and `high`."""
    return mp.findroot(function, (low, high), solver="anderson", verify=False)


def exact(value):
    """A longdouble with all its digits."""
    high = float(value)
    return mp.mpf(high) + mp.mpf(float(value - np.longdouble(high)))
