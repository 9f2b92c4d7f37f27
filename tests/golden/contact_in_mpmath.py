"""The three-body lubricated contact in multiple precision, for golden values.

The model is written here a second time, straight from the equations of Chen & Horng (2024), Zhao, Maietta & Chang
(2000) and Masjedi & Khonsari (2015), with slow and plain means only: numerical integrals and a bracketed root search.
It shares nothing with the library that is tested against it.

Where the print leaves a choice, the readings are those of the list at the head of `tests/oracle/contact.c`. Of several
separations that balance the forces the largest is taken; `status` is the `solution_status` that belongs to it.

Inputs are exact: the float64 that is passed is the number that is solved. Constants that an equation prints (0.663,
0.884, ...) are exact decimals. Units are SI. Loads are divided by A_n E_ss, areas by A_n.
"""

from types import SimpleNamespace
from typing import NamedTuple

from mpmath import mp

DIGITS = 36  # working precision: 25 printed digits, and what the steep Gaussian tails and tiny film loads cost
SEARCH_DIGITS = 16  # precision of the search that only narrows the bracket
MAX_COVERAGE = 0.9  # Eq. 4 loses its meaning at 1
STEPS = 200  # of a search for several separations, from d = 0 to where the largest particles touch

READINGS = ("phi_a", "surface_offset", "elastic_limits", "coverage_limits", "film_load")
COORDINATES = ("load", "viscosity", "particle_diameter", "roughness", "particle_density")
PARAMETERS = (
    "E_ss", "E_sa", "H_s1", "H_s2", "k", "omega_ratio", "R_x", "G", "V", "kappa", "U_per_viscosity", "A_n",
    "eta_s", "R", "sigma_s", "y_s",
    "mean_ratio", "sigma_a_ratio", "gap_ratio", "truncation", "participation", "h_e_ratio",
)  # fmt: skip
OUTPUTS = (
    "total_contact_area", "particle_contact_area_ratio", "surface_contact_area_ratio", "solid_load_fraction",
    "fluid_load_fraction", "separation", "film_thickness",
)  # fmt: skip


class Meaningless(ArithmeticError):
    """The equations have no meaning here: coverage too high, or no positive separation carries the load."""


class Rule(NamedTuple):
    """How integrals are taken: mpmath's method, parts per smooth piece, and the n of the substitution omega = q^n."""

    method: str
    parts: int
    power: int


RULE = Rule("gauss-legendre", 1, 2)


# ----------------------------------------------------------------------------------------------------- numerical means
def integrate(function, edges, rule):
    """Integral over the pieces between `edges`, each scaled by its own size: mpmath's tolerance is absolute."""

    def piece(start, length):
        scale = max(abs(function(start + length * s)) for s in (0.015625, 0.125, 0.5, 0.875))
        scaled = mp.quad(lambda s: function(start + length * s) / scale, [0, 1], method=rule.method)
        return scaled * scale * length

    total = mp.zero
    for left, right in zip(edges, edges[1:]):
        length = (right - left) / rule.parts
        for part in range(rule.parts):
            total += piece(left + part * length, length)
    return total


def negligible_exponent():
    """Exponent beyond which a Gaussian factor does not matter at the present precision."""
    return (mp.dps + 15) * mp.log(10)


def find_root(function, low, high, tolerance):
    """Root in [low, high] within an absolute `tolerance` (Anderson & Björck), or None where the signs agree."""
    a, b, f_a, f_b = low, high, function(low), function(high)
    if f_a * f_b > 0:
        return None
    if f_a == 0:
        return a
    while abs(b - a) > 2 * tolerance and f_b != 0:
        x = b - f_b * (b - a) / (f_b - f_a)
        x = min(max(x, min(a, b) + tolerance), max(a, b) - tolerance)
        f_x = function(x)
        if f_x * f_b < 0:
            a, f_a = b, f_b
        else:
            f_a *= 1 - f_x / f_b if abs(f_x) < abs(f_b) else mp.mpf(1) / 2
        b, f_b = x, f_x
    return b


def solve(function, low, high):
    """Root in [low, high] at full precision; the search far from the root runs at low precision."""
    with mp.workdps(SEARCH_DIGITS):
        near = find_root(function, low, high, mp.mpf("1e-9"))
    for width in (mp.mpf("1e-8"), mp.mpf("1e-5")):
        root = find_root(
            function, max(low, near - width), min(high, near + width), mp.mpf(10) ** (4 - mp.dps)
        )
        if root is not None:
            return root
    raise ArithmeticError("the low-precision root does not hold")


# ---------------------------------------------------------------------------------------------------- two-body contact
def softer(p):
    """Hardness [Pa] of the surface that yields where two of them touch."""
    return min(p.H_s1, p.H_s2)


def critical_interferences(p):
    """Interferences [m] at which yielding begins and at which it is complete (Zhao, Maietta & Chang)."""
    omega_1 = (3 * mp.pi * p.k * softer(p) / (4 * p.E_ss)) ** 2 * p.R
    return omega_1, p.omega_ratio * omega_1


def asperity_area(p):
    """Contact area [m2] of one summit as a function of its interference [m]."""
    omega_1, omega_2 = critical_interferences(p)
    pi_R = mp.pi * p.R

    def area(omega):
        if omega <= omega_1:
            return pi_R * omega
        if omega >= omega_2:
            return 2 * pi_R * omega
        u = (omega - omega_1) / (omega_2 - omega_1)
        return pi_R * omega * (1 - 2 * u**3 + 3 * u**2)

    return area


def asperity_load(p):
    """Load of one summit divided by E_ss [m2] as a function of its interference [m]."""
    omega_1, omega_2 = critical_interferences(p)
    ln_1, ln_2 = mp.log(omega_1), mp.log(omega_2)
    area, hertz, hardness = asperity_area(p), mp.mpf(4) / 3 * mp.sqrt(p.R), softer(p) / p.E_ss

    def load(omega):
        if omega <= omega_1:
            return hertz * omega * mp.sqrt(omega)
        if omega >= omega_2:
            return area(omega) * hardness
        return area(omega) * hardness * (1 - (1 - p.k) * (ln_2 - mp.log(omega)) / (ln_2 - ln_1))

    return load


def population(single, d, p):
    """eta_s times the integral of `single`(z - d) over the Gaussian summit heights z; d [m] from the mean plane."""
    d_summit = d - p.y_s
    n, two_variances = p.rule.power, 2 * p.sigma_s**2
    end = mp.sqrt(max(d_summit, 0) ** 2 + two_variances * negligible_exponent()) - d_summit
    omega_1, omega_2 = critical_interferences(p)
    kinks = (omega_1, mp.sqrt(omega_1 * omega_2), omega_2)
    edges = [mp.root(omega, n) for omega in (0, *(omega for omega in kinks if omega < end), end)]

    def integrand(q):
        omega = q**n  # n = 2 turns the 3/2 power of first contact into a polynomial
        return single(omega) * mp.exp(-((d_summit + omega) ** 2) / two_variances) * n * q ** (n - 1)

    return p.eta_s * integrate(integrand, edges, p.rule) / (mp.sqrt(2 * mp.pi) * p.sigma_s)


# ----------------------------------------------------------------------------------------------------- third particles
def particle_distribution(p):
    """Mean m, spread S, smallest and largest size X_min and X_max [m] of phi_a."""
    m = mp.zero if p.phi_a == "uncentred" else p.mean_ratio * p.particle_diameter
    S = p.sigma_a_ratio * p.particle_diameter
    if p.phi_a == "gap_convolved":
        S = mp.sqrt(S**2 + (p.gap_ratio * p.roughness) ** 2)
    X_min = -mp.inf if p.phi_a == "gap_convolved" else mp.zero
    return m, S, X_min, m + p.truncation * S


def moment(a, b, p):
    """I(a, b): second moment [m2] of the particle sizes between a and b [m], as far as there are any (Eq. 6)."""
    m, S, X_min, X_max = particle_distribution(p)
    a, b = max(a, X_min), min(b, X_max)
    if a >= b:
        return mp.zero
    reach = mp.sqrt(max(a - m, m - b, 0) ** 2 + 2 * negligible_exponent() * S**2)
    a, b = max(a, m - reach), min(b, m + reach)
    mean_square = p.particle_diameter**2 * (1 + p.sigma_a_ratio**2)

    def integrand(x):
        weight = mean_square if p.phi_a == "gap_convolved" else x**2
        return weight * mp.exp(-((x - m) ** 2) / (2 * S**2))

    return integrate(integrand, [a, (a + b) / 2, b], p.rule) / (mp.sqrt(2 * mp.pi) * S)


def coverage(moment_value, p):
    """Part of the apparent area that the particles of a second moment [m2] take from the asperities (Eqs. 4 and 5)."""
    return mp.pi * p.H_s1 * p.participation * p.particle_density / (p.H_s1 + p.H_s2) * moment_value


def load_coverage(d, p):
    """Coverage in the load, in the reading that `coverage_limits` names (Eq. 4)."""
    if p.two_body:
        return mp.zero
    least = d if p.coverage_limits == "contacting" else -mp.inf
    return coverage(moment(least, mp.inf, p), p)


def elastic_factor(p):
    """What elastic particles have of the area and load of plastic ones (Eqs. 4 and 5)."""
    return 9 * mp.pi**2 / 4 * (p.H_s1**2 / p.E_sa**2 + p.H_s2**2 / p.E_ss**2)


def particle_area(d, p):
    """A_sa/A_n (Eqs. 4 and 5)."""
    if p.two_body:
        return mp.zero
    h_e = p.h_e_ratio * p.particle_diameter
    least, plastic = (d - h_e, d) if p.elastic_limits == "printed" else (d, d + h_e)
    density = mp.pi * p.H_s2 * p.participation * p.particle_density / (p.H_s1 + p.H_s2)
    elastic = elastic_factor(p) * moment(least, plastic, p)
    return density * (elastic + moment(plastic, mp.inf, p))


def solid_load(d, p):
    """F_s/(A_n E_ss) at the separation d [m] (Eq. 4); Meaningless where it is none."""
    F_sa = p.H_s1 / p.E_ss * particle_area(d, p)
    F_s = population(asperity_load(p), d, p) * max(1 - load_coverage(d, p), 0) + F_sa
    if F_s <= 0:
        raise Meaningless
    return F_s


def contact_areas(d, p):
    """A_t/A_n (Eq. 5), A_sa/A_t and A_ss/A_t (Eq. 10) at the separation d [m]."""
    A_sa = particle_area(d, p)
    covered = mp.zero if p.two_body else coverage(moment(d, mp.inf, p), p)
    A_ss = population(asperity_area(p), d, p) * (1 - covered)
    return A_ss + A_sa, A_sa / (A_ss + A_sa), A_ss / (A_ss + A_sa)


# ---------------------------------------------------------------------------------------------------- film and balance
def film_terms(load, p):
    """Smooth film thickness H_c and the roughness term r, so that H_c (1 + r) is Eq. 7; load is F/(A_n E_ss)."""
    W, U = load * p.A_n / p.R_x**2, p.U_per_viscosity * p.viscosity
    n = mp.mpf
    smooth = (
        n("3.672")
        * W ** (-n("0.045") * p.kappa ** n("0.18"))
        * U ** (n("0.663") * p.kappa ** n("0.025"))
    )
    smooth *= p.G ** (n("0.502") * p.kappa ** n("0.064")) * (
        1 - n("0.573") * mp.exp(-n("0.74") * p.kappa)
    )
    r = n("0.025") * (p.roughness / p.R_x) ** n("1.248") * p.V ** n("0.119") * W ** -n("0.133")
    r *= U ** -n("0.884") * p.G ** -n("0.977") * p.kappa ** n("0.081")
    return smooth, r


def film_separation(load, p):
    """d = R_x H_c [m] under a load F/(A_n E_ss) (Eq. 7)."""
    smooth, r = film_terms(load, p)
    return p.R_x * smooth * (1 + r)


def film_counts(in_film, solution, p):
    """Whether the film bears more than a thousandth, and grows with falling viscosity, is thicker than R_x/100, or is
    under more pressure than the softer surface bears."""
    e = mp.mpf("0.663") * p.kappa ** mp.mpf("0.025")
    falls = film_terms(in_film, p)[1] >= e / (mp.mpf("0.884") - e)
    thick = solution["film_thickness"] > mp.mpf("0.01")
    presses = in_film * p.E_ss > softer(p)
    return solution["fluid_load_fraction"] > mp.mpf("0.001") and (falls or thick or presses)


def may_rise(p):
    """Whether F_s may rise with d, so that several separations may balance the load."""
    factor = elastic_factor(p)
    if p.two_body or factor > 1:
        return not p.two_body
    rest = 1 - factor if p.elastic_limits == "printed" else factor
    return p.coverage_limits == "contacting" and p.load > rest * p.H_s2 / p.E_ss


def largest_root(function, low, high, p):
    """The largest root in [low, high], and the number of roots."""
    if not may_rise(p):
        return solve(function, low, high), 1
    with mp.workdps(SEARCH_DIGITS):
        places = mp.linspace(low, high, STEPS + 1)
        above = [function(x) > 0 for x in places]
    changes = [step for step in range(STEPS) if above[step] != above[step + 1]]
    if not changes:
        raise Meaningless
    return solve(function, places[changes[-1]], places[changes[-1] + 1]), len(changes)


def touches(d, p):
    """Whether particles, if they can make F_s rise, may touch at separations larger than d [m]."""
    return may_rise(p) and d < particle_distribution(p)[-1] + p.h_e_ratio * p.particle_diameter


def dry_separation(p, least="1e-3"):
    """d [m] at which the solids carry the whole load, in units of the roughness above `least`, and how many there are;
    Meaningless where there is none."""

    def separation(ln_d):
        return p.roughness * mp.exp(ln_d)

    def imbalance(ln_d):
        return mp.log(solid_load(separation(ln_d), p) / p.load)

    low = mp.log(mp.mpf(least))
    high = max(mp.mpf(1), low + 1)
    with mp.workdps(SEARCH_DIGITS):
        if imbalance(low) <= 0 and not may_rise(p):
            raise Meaningless
        while imbalance(high) > 0 or touches(separation(high), p):
            high += 1
    root, count = largest_root(imbalance, low, high, p)
    return separation(root), count


def balance_fluid(p):
    """L_s, L_f, d [m] and their number with the fluid's own load in Eq. 7; the unknown is ln(F_t/F_f) (Eqs. 1 and 8)."""

    def separation(x):
        return film_separation(p.load * mp.exp(-x), p)

    def imbalance(x):
        return mp.log(solid_load(separation(x), p) / p.load + mp.exp(-x))

    high = mp.one
    with mp.workdps(SEARCH_DIGITS):
        while imbalance(high) > 0 or touches(separation(high), p):
            high *= 2
    root, count = largest_root(imbalance, mp.zero, high, p)
    d = separation(root)
    return solid_load(d, p) / p.load, mp.exp(-root), d, count


def balance_total(p):
    """L_s, L_f, d [m] and their number with the total load in Eq. 7; where the solids hold the surfaces farther apart
    than that film they carry everything."""
    d = film_separation(p.load, p)
    L_s = solid_load(d, p) / p.load
    if L_s >= 1 or touches(d, p):
        try:
            dry, count = dry_separation(p, d / p.roughness if L_s < 1 else "1e-3")
            return mp.one, mp.zero, dry, count + int(L_s < 1)
        except Meaningless:
            if L_s >= 1:
                raise
    return L_s, 1 - L_s, d, 1


def status_of(solution, p, count=1):
    """The gravest `solution_status` that applies to a solution, one of `count`."""
    in_film = p.load * (solution["fluid_load_fraction"] if p.film_load == "fluid" else 1)
    if solution["total_contact_area"] > 1:
        return "area_exceeded"
    if p.viscosity and film_counts(in_film, solution, p):
        return "outside_film_formula"
    return "several_separations" if count > 1 else "converged"


def solve_contact(row, rule=RULE):
    """The row with its solution; Meaningless where it has none."""
    p = SimpleNamespace(rule=rule, **{name: row[name] for name in READINGS})
    vars(p).update({name: mp.mpf(row[name]) for name in (*COORDINATES, *PARAMETERS)})
    p.two_body = p.particle_diameter * p.particle_density == 0
    if p.coverage_limits == "printed" and load_coverage(mp.zero, p) > MAX_COVERAGE:
        raise Meaningless
    if p.viscosity == 0:
        L_s, L_f, d, count = mp.one, mp.zero, *dry_separation(p)
    else:
        L_s, L_f, d, count = (balance_fluid if p.film_load == "fluid" else balance_total)(p)
    if load_coverage(d, p) > MAX_COVERAGE:
        raise Meaningless
    solution = dict(zip(OUTPUTS, (*contact_areas(d, p), L_s, L_f, d, d / p.R_x)))
    return row | solution | {"status": status_of(solution, p, count)}
