"""The three-body lubricated contact of Chen & Horng (2024), one point at a time and plainly.

A second implementation, written from the printed equations alone: every integral is a
`scipy.integrate.quad`, every balance a `scipy.optimize.brentq`, and nothing is tabulated or
vectorised.  It needs scipy alone and shares no line with the library whose results it
recomputes.  All quantities SI; loads are divided by A_n E_ss, areas by A_n.

`model` is the mapping in a dataset's attribute `model_parameters`; `point` is a `Point`.
"""

import math
from typing import NamedTuple

from scipy.integrate import quad
from scipy.optimize import brentq

NEGLIGIBLE = 80.0  # exp(-80) of the greatest weight is nothing in float64
TINIEST_LOGARITHM = -745.0  # exp of anything less is zero in float64


class Point(NamedTuple):
    """Where the model is evaluated, and the summits of the surface there."""

    load: float  # F_t* [1]
    viscosity: float  # nu [m2/s], 0: dry
    diameter: float  # x_a [m], 0: no particles
    roughness: float  # sigma [m]
    density: float  # eta_a [m-2], 0: no particles
    summit_density: float  # eta_s [m-2]
    summit_radius: float  # R [m]
    summit_deviation: float  # sigma_s [m]
    summit_offset: float  # y_s [m]

    @property
    def two_body(self):
        return self.diameter == 0.0 or self.density == 0.0

    @property
    def dry(self):
        return self.viscosity == 0.0


class State(NamedTuple):
    """The interface at a given separation (Eqs. 4, 5 and 10)."""

    log_solid_load: float  # ln F_s*
    total_area: float  # A_t* [1]
    particle_ratio: float  # A_sa,t* [1]
    summit_ratio: float  # A_ss,t* [1]
    covered: bool  # whether particles leave no room for summits


class Solution(NamedTuple):
    """A solved point; ``status`` as in the datasets, and the rest absent where it is 2 or 3."""

    status: str
    separation: float = math.nan  # d [m]
    solid_fraction: float = math.nan  # L_s [1]
    fluid_fraction: float = math.nan  # L_f [1]
    state: State | None = None


def integral(function, edges):
    """Integral of ``function`` over the smooth pieces between increasing ``edges``.

    The relative tolerance alone counts: these integrals may be 1e-300, where quad's default
    absolute tolerance would stop at once.
    """
    return sum(
        quad(function, low, high, epsabs=0.0, epsrel=1e-11, limit=200)[0]
        for low, high in zip(edges, edges[1:])
        if low < high
    )


def logarithm(value):
    return math.log(value) if value > 0.0 else -math.inf


def log_of_sum(first, second):
    """ln(e^first + e^second)."""
    larger, smaller = max(first, second), min(first, second)
    return larger if smaller == -math.inf else larger + math.log1p(math.exp(smaller - larger))


# --- the summits of a rough surface (McCool 1986) ---


def surface_roughness(density, radius, deviation, offset):
    """sigma [m] of a surface with such summits; in the reading without offset it is theirs."""
    lost = 3.717e-4 / (density * radius) ** 2 if offset else 0.0
    return math.sqrt(deviation**2 + lost)


def summit_plane(density, radius):
    """y_s [m], the height of the summits' plane in the reading with offset."""
    return 0.045944 / (density * radius)


# --- rough surface against rough surface (Zhao, Maietta & Chang 2000; first half of Eq. 6) ---


def yield_interference(model, point):
    """omega_1 [m]."""
    strain = 3.0 * math.pi * model["k"] * model["H_s2"] / (4.0 * model["E_ss"])
    return strain**2 * point.summit_radius


def asperity_area(omega, omega_1, omega_2, radius):
    """Contact area [m2] of one asperity at interference ``omega`` [m]."""
    if omega <= omega_1:
        return math.pi * radius * omega
    if omega >= omega_2:
        return 2.0 * math.pi * radius * omega
    u = (omega - omega_1) / (omega_2 - omega_1)
    return math.pi * radius * omega * (1.0 - 2.0 * u**3 + 3.0 * u**2)


def asperity_load(omega, omega_1, omega_2, radius, model):
    """Load [N] of one asperity at interference ``omega`` [m]."""
    if omega <= omega_1:
        return 4.0 / 3.0 * model["E_ss"] * math.sqrt(radius) * omega**1.5
    full = asperity_area(omega, omega_1, omega_2, radius) * model["H_s2"]
    if omega >= omega_2:
        return full
    share = (math.log(omega_2) - math.log(omega)) / (math.log(omega_2) - math.log(omega_1))
    return full * (1.0 - (1.0 - model["k"]) * share)


def log_population(single, separation, model, point):
    """ln of eta_s times the integral of ``single``(omega) phi over the summit heights.

    With t the separation from the summit plane over sigma_s and omega = w sigma_s, the weight is
    exp(-(t + w)^2/2).  Its largest value exp(-max(t, 0)^2/2) is taken out of the integral and
    enters as a logarithm: tails far beyond float64 stay exact.
    """
    deviation = point.summit_deviation
    t = (separation - point.summit_offset) / deviation
    reach = math.sqrt(max(t, 0.0) ** 2 + 2.0 * NEGLIGIBLE) - t
    first = yield_interference(model, point) / deviation
    last = first * model["omega_ratio"]

    def integrand(root):  # w = root^2 makes the 3/2 power of first contact smooth
        w = root * root
        exponent = -w * (t + 0.5 * w) if t > 0.0 else -0.5 * (t + w) ** 2
        return single(w * deviation) * math.exp(exponent) * 2.0 * root

    kinks = [w for w in (first, math.sqrt(first * last), last) if w < reach]
    value = integral(integrand, [math.sqrt(w) for w in (0.0, *kinks, reach)])
    return logarithm(point.summit_density * value / math.sqrt(2.0 * math.pi)) - 0.5 * max(t, 0) ** 2


def log_summit_load(separation, model, point):
    """ln F_ss*."""
    omega_1 = yield_interference(model, point)
    omega_2, radius = omega_1 * model["omega_ratio"], point.summit_radius
    load = log_population(
        lambda omega: asperity_load(omega, omega_1, omega_2, radius, model),
        separation,
        model,
        point,
    )
    return load - math.log(model["E_ss"])


def log_summit_area(separation, model, point):
    """ln A_ss*."""
    omega_1 = yield_interference(model, point)
    omega_2, radius = omega_1 * model["omega_ratio"], point.summit_radius
    return log_population(
        lambda omega: asperity_area(omega, omega_1, omega_2, radius), separation, model, point
    )


# --- third particles (Eqs. 4 to 6) ---


def size_distribution(model, point):
    """Mean m and spread S of the sizes [m] in the reading ``phi_a``."""
    mean = model["mean_ratio"] * point.diameter
    spread = model["sigma_a_ratio"] * point.diameter
    if model["phi_a"] == "uncentred":
        return 0.0, spread
    if model["phi_a"] == "centred":
        return mean, spread
    return mean, math.hypot(spread, model["gap_ratio"] * point.roughness)


def mean_square(model, point):
    """Mean square x_a^2 (1 + c^2) of all particles [m2], which `gap_convolved` has meet the gap."""
    return point.diameter**2 * (1.0 + model["sigma_a_ratio"] ** 2)


def second_moment(low, high, model, point):
    """I(low, high): integral of x^2 phi_a over the sizes from ``low`` to ``high`` [m], in m2.

    No particle is larger than X_max = m + truncation S.
    """
    mean, spread = size_distribution(model, point)
    far = math.sqrt(2.0 * NEGLIGIBLE)
    first = max((low - mean) / spread, -far)
    last = min((high - mean) / spread, model["truncation"])
    if first >= last:
        return 0.0
    all_sizes = model["phi_a"] == "gap_convolved"
    square = mean_square(model, point)

    def integrand(s):
        weight = square if all_sizes else (mean + spread * s) ** 2
        return weight * math.exp(-0.5 * s * s)

    return integral(integrand, [first, last]) / math.sqrt(2.0 * math.pi)


def coverage(moment, model, point):
    """Share of the interface that particles of a second ``moment`` [m2] take from the summits."""
    hardness = model["H_s1"] / (model["H_s1"] + model["H_s2"])
    return math.pi * hardness * point.density * model["participation"] * moment


def load_coverage(contacting, model, point):
    """Coverage in Eq. 4, from X_min to X_max or of the particles ``contacting`` [m2] alone."""
    if model["coverage_limits"] == "contacting":
        return coverage(contacting, model, point)
    if model["phi_a"] == "gap_convolved":
        return coverage(mean_square(model, point), model, point)
    return coverage(second_moment(0.0, math.inf, model, point), model, point)


def particle_area(separation, contacting, model, point):
    """A_sa* (Eq. 5): the elastic particles about the separation, and all larger ones."""
    depth = model["h_e_ratio"] * point.diameter
    if model["elastic_limits"] == "printed":
        elastic = second_moment(separation - depth, separation, model, point)
    else:
        elastic = second_moment(separation, separation + depth, model, point)
    strains = (model["H_s1"] / model["E_sa"]) ** 2 + (model["H_s2"] / model["E_ss"]) ** 2
    hardness = model["H_s2"] / (model["H_s1"] + model["H_s2"])
    density = math.pi * hardness * point.density * model["participation"]
    return density * (9.0 * math.pi**2 / 4.0 * strains * elastic + contacting)


def particle_share(separation, model, point):
    """A_sa*, and the coverages of Eqs. 4 and 5, at ``separation`` [m]."""
    if point.two_body:
        return 0.0, 0.0, 0.0
    contacting = second_moment(separation, math.inf, model, point)
    return (
        particle_area(separation, contacting, model, point),
        load_coverage(contacting, model, point),
        coverage(contacting, model, point),
    )


def log_solid_load(separation, model, point):
    """ln F_s* at ``separation`` d [m] (Eqs. 2 and 4)."""
    area, covered, _ = particle_share(separation, model, point)
    summits = log_summit_load(separation, model, point) + logarithm(1.0 - covered)
    return log_of_sum(summits, logarithm(model["H_s1"] / model["E_ss"] * area))


def state(separation, model, point):
    """Loads, areas and coverage at ``separation`` d [m]."""
    area, load_covered, area_covered = particle_share(separation, model, point)
    summit_load = log_summit_load(separation, model, point) + logarithm(1.0 - load_covered)
    summit_area = log_summit_area(separation, model, point) + logarithm(1.0 - area_covered)
    particles = logarithm(area)
    total = log_of_sum(particles, summit_area)
    return State(
        log_of_sum(summit_load, logarithm(model["H_s1"] / model["E_ss"] * area)),
        math.exp(total),
        math.exp(particles - total),
        math.exp(summit_area - total),
        max(load_covered, area_covered) >= 1.0,
    )


# --- film and balance (Eqs. 1, 7 and 8) ---


def film_terms(log_load, model, point):
    """Smooth film thickness and the roughness term r, so that H_c = smooth (1 + r) (Eq. 7).

    ``log_load`` is ln F/(A_n E_ss) of the load F in W = F/(E_ss R_x^2).
    """
    kappa, speed = model["kappa"], model["U_per_viscosity"] * point.viscosity
    log_w = log_load + math.log(model["A_n"] / model["R_x"] ** 2)
    smooth = 3.672 * math.exp(-0.045 * kappa**0.18 * log_w) * speed ** (0.663 * kappa**0.025)
    smooth *= model["G"] ** (0.502 * kappa**0.064) * (1.0 - 0.573 * math.exp(-0.74 * kappa))
    rough = 0.025 * (point.roughness / model["R_x"]) ** 1.248 * model["V"] ** 0.119
    rough *= math.exp(-0.133 * log_w) * speed**-0.884 * model["G"] ** -0.977 * kappa**0.081
    return smooth, rough


def film_separation(log_load, model, point):
    """d = R_x H_c [m] (Eq. 7)."""
    smooth, rough = film_terms(log_load, model, point)
    return model["R_x"] * smooth * (1.0 + rough)


def outside_film_formula(log_load, model, point):
    """Whether H_c falls with rising viscosity, dH_c/dU <= 0: there Eq. 7 has no meaning."""
    rise = 0.663 * model["kappa"] ** 0.025
    return film_terms(log_load, model, point)[1] >= rise / (0.884 - rise)


def film_load(log_fluid_fraction, model, point):
    """ln of the load in Eq. 7: that of the fluid, or the total in the printed reading of Eq. 8."""
    log_load = math.log(point.load)
    return log_load if model["film_load"] == "total" else log_load + log_fluid_fraction


def root(function, low, high):
    """Root of ``function`` between ``low`` and ``high``, to the last digits of float64."""
    return brentq(function, low, high, xtol=1e-300, rtol=1e-15, maxiter=500)


def dry_separation(model, point):
    """d >= 0 [m] at which the solids bear all of the load, or None; solved for d/sigma."""

    def excess(x):
        return log_solid_load(x * point.roughness, model, point) - math.log(point.load)

    if excess(0.0) < 0.0:
        return None
    high = 1.0
    while excess(high) > 0.0:
        high *= 2.0
    return point.roughness * root(excess, 0.0, high)


def fluid_balance(model, point):
    """d [m], ln L_s and ln L_f with the load of the fluid in Eq. 7; None without a solution.

    The unknown is -ln L_f: ln(F_s/F_t + L_f) rises with L_f and vanishes once.
    """

    def separation(y):
        return film_separation(math.log(point.load) - y, model, point)

    def excess(y):
        solid = log_solid_load(separation(y), model, point) - math.log(point.load)
        return log_of_sum(solid, -y)

    high = 1.0
    while excess(high) > 0.0:
        if high > -TINIEST_LOGARITHM:
            return None
        high *= 2.0
    y = root(excess, 0.0, high)
    d = separation(y)
    return d, log_solid_load(d, model, point) - math.log(point.load), -y


def total_balance(model, point):
    """The same with the total load in Eq. 7: no solid bears more than everything."""
    d = film_separation(math.log(point.load), model, point)
    solid = log_solid_load(d, model, point) - math.log(point.load)
    if solid < 0.0:
        return d, solid, math.log(-math.expm1(solid))
    d = dry_separation(model, point)
    return None if d is None else (d, 0.0, -math.inf)


def solve(model, point):
    """The ``Solution`` at ``point``."""
    if point.dry:
        d = dry_separation(model, point)
        balance = None if d is None else (d, 0.0, -math.inf)
    else:
        balances = {"fluid": fluid_balance, "total": total_balance}
        balance = balances[model["film_load"]](model, point)
    if balance is None:
        return Solution("not_converged")
    d, log_solid, log_fluid = balance
    there = state(d, model, point)
    if there.covered:
        return Solution("coverage_exceeded")
    status = "converged"
    if not point.dry and outside_film_formula(film_load(log_fluid, model, point), model, point):
        status = "outside_film_formula"
    return Solution(status, d, math.exp(log_solid), math.exp(log_fluid), there)


# --- names of the states (sections 3.1 and 3.2) ---


def lubrication_regime(solid_fraction):
    """Boundary above L_s = 0.90, full film below 0.03."""
    return (
        "boundary" if solid_fraction > 0.90 else "full_film" if solid_fraction < 0.03 else "mixed"
    )


def contact_mode(particle_ratio, two_body):
    """Particle-surface above A_sa,t* = 0.95, surface-surface below 0.05."""
    if two_body:
        return "two_body"
    if particle_ratio > 0.95:
        return "particle_surface"
    return "surface_surface" if particle_ratio < 0.05 else "hybrid"
