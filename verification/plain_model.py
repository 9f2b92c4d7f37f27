"""The three-body lubricated contact of Chen & Horng (2024), one point at a time and plainly.

A second implementation, written from the printed equations alone: every integral is a
`scipy.integrate.quad`, every root a `scipy.optimize.brentq`, and nothing is tabulated or
vectorised.  It needs scipy alone and shares no line with the library whose results it
recomputes.  All quantities SI; loads are divided by A_n E_ss, areas by A_n.

`model` is the mapping in a dataset's attribute `model_parameters`; `point` is a `Point`.

What the paper leaves open is read so.  The separation d is that of the mean planes of the
surfaces; summits see d - y_s, and particles d, or d - y_s where the `particle_plane` is "summit".
The sizes of particles have the mean `mean_ratio` x_a: 0 as Eq. 6 is printed, 1 where x_a is the
mean. Summits have the hardness of the softer surface.  No particle is smaller than X_min = 0, nor
larger than X_max; only particles that take part (`participation`) bear load or cover anything.
Where they would cover more than everything, Eq. 4 has no meaning.  Surfaces are no closer than d =
0.  Inputs are of hard particles, with an elastic factor of at most 1: then F_s falls as d grows.
"""

import math
import sys
from typing import NamedTuple

from scipy.integrate import quad
from scipy.optimize import brentq

NEGLIGIBLE = 80.0  # exp(-80) of the greatest weight is nothing in float64
# L_f; above it, L_s follows from the solids at d, because 1 - L_f has fewer digits
NEARLY_ALL = 0.99
FILM_AT_WORK = 1e-3  # L_f; a film that bears less changes nothing
# h_c/R_x; Eq. 7 is for films that are thin against the bodies
THICKEST_FILM = 0.01
ROUNDING = 4.0 * sys.float_info.epsilon  # of the lengths in a difference with d
STEP = 1e-7  # of these lengths: the step of a difference of forces


class Point(NamedTuple):
    """The conditions at which the model is evaluated, and the summits of the surface."""

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
    coverage: float  # share of the interface that Eq. 4 takes from the summits [1]


class Solution(NamedTuple):
    """A solved point; ``status`` as in the datasets, and values unless no separation is found."""

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


def root(function, low, high):
    """Root of ``function`` between ``low`` and ``high``, to the last digits of float64."""
    return brentq(function, low, high, xtol=1e-300, rtol=1e-15, maxiter=500)


def logarithm(value):
    return math.log(value) if value > 0.0 else -math.inf


def log_of_sum(first, second):
    """ln(e^first + e^second)."""
    larger, smaller = max(first, second), min(first, second)
    return larger if smaller == -math.inf else larger + math.log1p(math.exp(smaller - larger))


# --- rough surface against rough surface (Zhao, Maietta & Chang 2000; first half of Eq. 6) ---


def softer(model):
    """H [Pa] of the surface that yields first."""
    return min(model["H_s1"], model["H_s2"])


def yield_interference(model, point):
    """omega_1 [m]."""
    strain = 3.0 * math.pi * model["k"] * softer(model) / (4.0 * model["E_ss"])
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
    full = asperity_area(omega, omega_1, omega_2, radius) * softer(model)
    if omega >= omega_2:
        return full
    share = (math.log(omega_2) - math.log(omega)) / (math.log(omega_2) - math.log(omega_1))
    return full * (1.0 - (1.0 - model["k"]) * share)


def log_population(single, separation, model, point):
    """ln of eta_s times the integral of ``single``(omega) phi over the summit heights (Eq. 6).

    With t the separation from the summit plane over sigma_s and omega = w sigma_s, the weight is
    exp(-(t + w)^2/2).  Its largest value exp(-max(t, 0)^2/2) is taken out of the integral and
    enters as a logarithm: tails far beyond float64 stay exact.
    """
    deviation = point.summit_deviation
    t = (separation - point.summit_offset) / deviation
    reach = 2.0 * NEGLIGIBLE / (math.hypot(t, math.sqrt(2.0 * NEGLIGIBLE)) + t)
    if t < 0.0:
        reach = math.sqrt(2.0 * NEGLIGIBLE) - t
    first = yield_interference(model, point) / deviation
    last = first * model["omega_ratio"]

    def integrand(root):  # w = root^2 makes the 3/2 power of first contact smooth
        w = root * root
        exponent = -w * (t + 0.5 * w) if t > 0.0 else -0.5 * (t + w) ** 2
        return single(w * deviation) * math.exp(exponent) * 2.0 * root

    inner = sorted(w for w in (first, last, -t) if 0.0 < w < reach)  # kinks, and the mean height
    value = integral(integrand, [math.sqrt(w) for w in (0.0, *inner, reach)])
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


def sizes(model, point):
    """Mean m and spread S of the sizes [m], and the largest, X_max."""
    mean = model["mean_ratio"] * point.diameter
    spread = model["sigma_a_ratio"] * point.diameter
    return mean, spread, mean + model["truncation"] * spread


def second_moment(low, high, model, point):
    """I(low, high): integral of x^2 phi_a (Eq. 6) from ``low`` to ``high`` [m], in m2.

    No size is smaller than X_min = 0, or larger than X_max.
    """
    mean, spread, x_max = sizes(model, point)

    def weight(x):
        density = math.exp(-0.5 * ((x - mean) / spread) ** 2) / (math.sqrt(2.0 * math.pi) * spread)
        return x * x * density

    first = max(low, 0.0, mean - math.sqrt(2.0 * NEGLIGIBLE) * spread)
    last = min(high, x_max)
    inner = (mean,) if first < mean < last else ()
    return integral(weight, [first, *inner, last])


def coverage(moment, model, point):
    """Share of the interface that particles of a second ``moment`` [m2] take from the summits."""
    hardness = model["H_s1"] / (model["H_s1"] + model["H_s2"])
    return math.pi * hardness * point.density * model["participation"] * moment  # Eqs. 4 and 5


def elastic_factor(model):
    """Load of an elastic particle over that of a plastic one of its size (Eqs. 4 and 5)."""
    strains = (model["H_s1"] / model["E_sa"]) ** 2 + (model["H_s2"] / model["E_ss"]) ** 2
    return 9.0 * math.pi**2 / 4.0 * strains


def gap_of_particles(separation, model, point):
    """The gap [m] that particles meet at the ``separation`` d [m]."""
    at_summits = model.get("particle_plane", "surface") == "summit"
    return separation - point.summit_offset if at_summits else separation


def particle_area(gap, model, point):
    """A_sa* (Eq. 5) at a ``gap`` [m]: elastic sizes lie between d - h_e and d, as printed."""
    depth = model["h_e_ratio"] * point.diameter
    moment = elastic_factor(model) * second_moment(gap - depth, gap, model, point)
    moment += second_moment(gap, math.inf, model, point)
    hardness = model["H_s2"] / (model["H_s1"] + model["H_s2"])
    return math.pi * hardness * point.density * model["participation"] * moment


def load_coverage(model, point):
    """Coverage in Eq. 4: from X_min to X_max."""
    if point.two_body:
        return 0.0
    return coverage(second_moment(0.0, math.inf, model, point), model, point)


def particle_share(separation, model, point):
    """A_sa*, and the coverages of Eqs. 4 and 5, at ``separation`` d [m]."""
    if point.two_body:
        return 0.0, 0.0, 0.0
    gap = gap_of_particles(separation, model, point)
    larger = coverage(second_moment(gap, math.inf, model, point), model, point)
    return particle_area(gap, model, point), load_coverage(model, point), larger


# --- load and area of the solids (Eqs. 2 to 5) ---


def log_particle_load(area, model):
    """ln F_sa*: particles press with the hardness of surface 1 (Eq. 4 over Eq. 5)."""
    return logarithm(model["H_s1"] / model["E_ss"] * area)


def log_solid_load(separation, model, point):
    """ln F_s* at ``separation`` d [m] (Eqs. 2 and 4)."""
    area, covered, _ = particle_share(separation, model, point)
    summits = log_summit_load(separation, model, point) + logarithm(1.0 - covered)
    return log_of_sum(summits, log_particle_load(area, model))


def state(separation, model, point, log_solid=None):
    """Loads, areas and coverage at ``separation`` d [m].

    Next to X_max the area of the particles has few digits, as d is rounded.  If the particles bear
    most of a known ``log_solid``, ln F_s*, their area follows from their load by Eq. 4.
    """
    area, load_covered, area_covered = particle_share(separation, model, point)
    summit_load = log_summit_load(separation, model, point) + logarithm(1.0 - load_covered)
    summit_area = log_summit_area(separation, model, point) + logarithm(1.0 - area_covered)
    particles = logarithm(area)
    if log_solid is not None and summit_load < log_solid - math.log(2.0):
        rest = log_solid + math.log(-math.expm1(summit_load - log_solid))
        particles = rest - math.log(model["H_s1"] / model["E_ss"])
    total = log_of_sum(particles, summit_area)
    return State(
        log_of_sum(summit_load, log_particle_load(area, model)),
        math.exp(total),
        math.exp(particles - total),
        math.exp(summit_area - total),
        load_covered,
    )


# --- film (Eqs. 7 and 8) ---


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


def log_film_load(separation, model, point):
    """ln F_f* under which the film is as thick as ``separation`` d [m], at most ln F_t*."""
    total = math.log(point.load)
    if separation <= film_separation(total, model, point):
        return total
    below = 1.0
    while film_separation(total - below, model, point) < separation:
        below *= 2.0

    def excess(log_load):
        return math.log(film_separation(log_load, model, point) / separation)

    return root(excess, total - below, total)


def log_load_in_w(log_fluid_fraction, model, point):
    """ln of the load in W (Eq. 8): that of the fluid, or the total as printed."""
    log_load = math.log(point.load)
    return log_load if model["film_load"] == "total" else log_load + log_fluid_fraction


def outside_film_formula(fluid_fraction, film_thickness, model, point):
    """Whether the film bears load where Eq. 7 has no meaning.

    It has none where H_c falls with rising viscosity, dH_c/dU <= 0, where the film is not thin, and
    where the load in W over A_n is above the hardness of the softer surface.
    """
    if point.dry or fluid_fraction <= FILM_AT_WORK:
        return False
    log_load = log_load_in_w(math.log(fluid_fraction), model, point)
    if log_load > math.log(softer(model) / model["E_ss"]):
        return True
    _, rough = film_terms(log_load, model, point)
    rise = 0.663 * model["kappa"] ** 0.025
    return rise * (1.0 + rough) <= 0.884 * rough or film_thickness > THICKEST_FILM


# --- balance of the loads (Eq. 1) ---


def bears_fluid_share(model, point):
    """Whether Eq. 7 gives the load of the film; otherwise the film bears what the solids leave."""
    return not point.dry and model["film_load"] == "fluid"


def log_borne(separation, model, point):
    """ln((F_s + F_f)/F_t) at ``separation`` d [m]; zero where Eq. 1 holds.

    F_f is 0 if Eq. 7 has the total load: that film bears only where d is its thickness.
    """
    solid = log_solid_load(separation, model, point)
    fluid = (
        log_film_load(separation, model, point) if bears_fluid_share(model, point) else -math.inf
    )
    return log_of_sum(solid, fluid) - math.log(point.load)


def exceeds_solids(model, point):
    """Whether dry solids bear less than the load at every separation d >= 0."""
    return point.dry and log_borne(0.0, model, point) < 0.0


def film_alone(model, point):
    """The separation d [m] at which a film bears all of the load; 0 where there is none."""
    return 0.0 if point.dry else film_separation(math.log(point.load), model, point)


def separation_of(model, point):
    """The separation d >= 0 [m] at which Eq. 1 holds, unless the load ``exceeds_solids``."""
    film = film_alone(model, point)
    if log_borne(film, model, point) < 0.0:
        return film  # the film bears the rest of the load
    far = max(film, point.roughness)
    while log_borne(far, model, point) >= 0.0:
        far *= 2.0
    return root(lambda d: log_borne(d, model, point), film, far)


def shares(separation, model, point):
    """L_s and L_f (Eq. 9) at a ``separation`` d [m] at which Eq. 1 holds."""
    if point.dry:
        return 1.0, 0.0
    log_total = math.log(point.load)
    solid = math.exp(log_solid_load(separation, model, point) - log_total)
    if bears_fluid_share(model, point):
        fluid = math.exp(log_film_load(separation, model, point) - log_total)
        return (1.0 - fluid if fluid < NEARLY_ALL else solid), fluid
    held_by_film = separation == film_separation(log_total, model, point)
    return (solid, 1.0 - solid) if held_by_film else (1.0, 0.0)


def solve(model, point):
    """The ``Solution`` at ``point``; if several statuses apply, that without values."""
    if exceeds_solids(model, point):
        return Solution("load_exceeded")
    if load_coverage(model, point) > 1.0:
        return Solution("coverage_exceeded")
    separation = separation_of(model, point)
    solid, fluid = shares(separation, model, point)
    log_solid = math.log(point.load) + logarithm(solid)
    there = state(separation, model, point, log_solid)
    status = named_status(there.total_area, fluid, separation / model["R_x"], model, point)
    return Solution(status, separation, solid, fluid, there)


# --- how well float64 can know a solution ---


def uncertainty(separation, model, point, noise):
    """The relative error [1] that loads and areas at the solution ``separation`` [m] may have.

    The forces are known to the relative ``noise``.  So the separation may be off by the rounding of
    lengths, and by the distance over which the forces change by their noise.  The error is the
    largest change of loads and areas over this distance.
    """
    lengths = separation + point.roughness + point.summit_offset
    if not point.two_body:
        lengths += sizes(model, point)[2]
    film = film_alone(model, point)
    move = ROUNDING * lengths + noise * separation
    lack = 0.0  # relative error of what the solids leave to the film
    if separation > film or bears_fluid_share(model, point):
        step = STEP * lengths
        fall = log_borne(separation, model, point) - log_borne(separation + step, model, point)
        move += noise * step / fall if fall > 0.0 else separation
    if not point.dry and not bears_fluid_share(model, point):
        unlike = abs(math.expm1(min(log_borne(film, model, point), 1.0)))
        lack = noise / max(unlike, noise)
    closer, farther = (
        known_logarithms(d, model, point) for d in (max(separation - move, 0.0), separation + move)
    )
    both = closer.keys() & farther.keys()
    change = max((abs(closer[name] - farther[name]) for name in both), default=0.0)
    return change + noise + lack


def known_logarithms(separation, model, point):
    """ln of the loads and areas at ``separation`` d [m] that float64 holds in full, by name."""
    there = state(separation, model, point)
    least, log_area = math.log(sys.float_info.min), logarithm(there.total_area)
    logarithms = {
        "solid load": (there.log_solid_load, there.log_solid_load - math.log(point.load)),
        "area": (log_area, log_area),
    }
    for name, ratio in (("particles", there.particle_ratio), ("summits", there.summit_ratio)):
        logarithms[name] = logarithm(ratio), logarithm(ratio) + log_area
    if bears_fluid_share(model, point):
        fluid = log_film_load(separation, model, point)
        logarithms["film load"] = fluid, fluid - math.log(point.load)
    return {name: value for name, (value, size) in logarithms.items() if size > least}


# --- names of the states (sections 3.1 and 3.2) ---


def named_status(total_area, fluid_fraction, film_thickness, model, point):
    """The status of a point with a separation; the gravest, if several apply."""
    if total_area > 1.0:
        return "area_exceeded"
    if outside_film_formula(fluid_fraction, film_thickness, model, point):
        return "outside_film_formula"
    return "converged"


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
