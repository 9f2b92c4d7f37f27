"""A section through the three-body interface, true to scale, at a state that the model solved.

Nothing is drawn here: the surfaces are Gaussian, the particles come from the size distribution of
the model, and their mean planes stand at the solved separation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from thirdbody.data.scene import CENTISTOKES, NANOMETRE
from thirdbody.figures.conditions import Conditions
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import CONTACT_MODES, LUBRICATION_REGIMES
from thirdbody.solver.solve import solve

POINTS = 500
CLEARANCE = 0.12  # share of the section that contacts keep from its ends
ATTEMPTS = 1000


@dataclass(frozen=True)
class State(Conditions):
    """A solved interface: its conditions and what a drawing needs of the solution."""

    separation: float  # d [m]
    particle_contact_area_ratio: float  # A_sa,t* [1]
    solid_load_fraction: float  # L_s [1]
    mode: str  # of CONTACT_MODES
    regime: str  # of LUBRICATION_REGIMES


@dataclass(frozen=True)
class Particle:
    """A particle: where its centre is [m], its diameter [m], and whether it bears load."""

    position: float
    height: float
    diameter: float
    bears: bool


@dataclass(frozen=True)
class Section:
    """Heights [m] of both surfaces along ``position`` [m], flat where they touch."""

    position: np.ndarray
    lower: np.ndarray
    upper: np.ndarray
    touches: np.ndarray
    particles: tuple[Particle, ...]


def solved_state(conditions: dict, parameters: Parameters) -> State:
    """The state of the interface at ``conditions``, given as the configuration gives them.

    Raises ``ValueError`` where the model has no solution.
    """
    viscosity = conditions["viscosity_cSt"] * CENTISTOKES
    diameter = conditions["particle_diameter_nm"] * NANOMETRE
    roughness = conditions["roughness_nm"] * NANOMETRE
    density = conditions["particle_density_per_m2"]
    load = conditions["load_N"] / parameters.newtons_per_load
    solution = solve(load, viscosity, diameter, roughness, density, parameters=parameters)
    if not np.isfinite(solution.separation):
        raise ValueError(f"schematic conditions {conditions} have no solution")
    return State(
        viscosity,
        diameter,
        roughness,
        density,
        float(solution.separation),
        float(solution.particle_contact_area_ratio),
        float(solution.solid_load_fraction),
        CONTACT_MODES[int(solution.contact_mode)],
        LUBRICATION_REGIMES[int(solution.lubrication_regime)],
    )


def section_through(state: State, parameters: Parameters, length: float, seed: int) -> Section:
    """A section of ``length`` [m] that meets the contacts by which the load is borne in ``state``.

    Summits touch in the s-s and hybrid modes, a particle is held in the p-s and hybrid modes.
    Raises ``ValueError`` where chance gives no such section.
    """
    random = np.random.default_rng(seed)
    position = np.linspace(0.0, length, POINTS)
    summits_touch = state.mode in ("two_body", "surface_surface", "hybrid")
    particle_bears = state.mode in ("particle_surface", "hybrid")
    for _ in range(ATTEMPTS):
        lower, upper = _surfaces(state, parameters, position, summits_touch, random)
        touches = lower > upper
        particles = _particles(state, parameters, position, lower, upper, particle_bears, random)
        bears = any(particle.bears for particle in particles)
        if (
            touches.any() == summits_touch
            and bears == particle_bears
            and _are_apart(particles, position[touches], length)
        ):
            middle = 0.5 * (lower + upper)
            lower, upper = (np.where(touches, middle, heights) for heights in (lower, upper))
            return Section(position, lower, upper, touches, particles)
    raise ValueError(f"no section of {length:g} m shows the {state.mode} contact of {state}")


def correlation_length(state: State, parameters: Parameters) -> float:
    """Length [m] after which a Gaussian surface with the model's density of summits forgets."""
    # ASSUME: autocorrelation exp(-x^2/2l^2), whose summit density is 1/(2 pi sqrt(3) l^2)
    # (Nayak 1971); density and radius of the summits cannot both be those of a Gaussian surface
    density = parameters.surface(state.roughness).summit_density
    return 1.0 / np.sqrt(2.0 * np.pi * np.sqrt(3.0) * density)


def _surfaces(state, parameters, position, summits_touch, random):
    """Heights of the lower and the upper surface; they interpenetrate where summits touch."""
    length = correlation_length(state, parameters)
    # ASSUME: both surfaces are equally rough, sigma/sqrt(2) each
    roughness = state.roughness / np.sqrt(2.0)
    lower, upper = (roughness * _profile(position, length, random) for _ in range(2))
    if summits_touch:
        # a Gaussian process that passes a given height there: a draw plus its regression on the
        # difference; beyond a high level d it rises sigma^2/d on average
        place = random.uniform(0.25, 0.4) * position[-1]
        excess = state.roughness**2 / state.separation
        drawn = np.interp(place, position, lower - upper)
        missing = state.separation + excess - drawn
        rise = 0.5 * missing * np.exp(-0.5 * ((position - place) / length) ** 2)
        lower, upper = lower + rise, upper - rise
    return lower, upper + state.separation


def _profile(position, length, random):
    """A Gaussian random profile of unit variance and autocorrelation exp(-x^2/2 length^2)."""
    step = position[1] - position[0]
    reach = int(3.0 * length / step)
    kernel = np.exp(-((np.arange(-reach, reach + 1) * step / length) ** 2))
    noise = random.standard_normal(position.size + 2 * reach)
    return np.convolve(noise, kernel, "valid") / np.sqrt(np.sum(kernel**2))


def _particles(state, parameters, position, lower, upper, one_bears, random):
    """Particles of a slab as deep as their mean distance; the first one is held if ``one_bears``.

    It lies in the narrowest place on the right, and is larger than the gap there.
    """
    count = round(position[-1] * np.sqrt(state.particle_density))
    places = random.uniform(0.05, 0.95, count) * position[-1]
    smallest = np.zeros(count)
    if one_bears:
        right = (position > 0.6 * position[-1]) & (position < (1 - CLEARANCE) * position[-1])
        gap = np.where(right, upper - lower, np.inf)
        places[0], smallest[0] = position[np.argmin(gap)], gap.min()
    # up to X_max, from the size distribution of the model
    diameters = parameters.readings.size_distribution.quantiles(
        random.uniform(size=count), smallest, state.particle_diameter, parameters
    )
    return tuple(
        _settled(place, diameter, position, lower, upper)
        for place, diameter in zip(places, diameters, strict=True)
    )


def _settled(place, diameter, position, lower, upper) -> Particle:
    """The particle at rest on the lower surface, or held where the gap is narrower than it."""
    radius = 0.5 * diameter
    across = np.abs(position - place) < radius
    if not across.any():
        return Particle(place, float(np.interp(place, position, lower)) + radius, diameter, False)
    half_chord = np.sqrt(radius**2 - (position[across] - place) ** 2)
    rests = float((lower[across] + half_chord).max())
    hangs = float((upper[across] - half_chord).min())
    return Particle(place, min(rests, 0.5 * (rests + hangs)), diameter, rests > hangs)


def _are_apart(particles, contacts, length) -> bool:
    """Whether no particle covers another, a contact of summits, or the ends of the section."""
    places = np.array([particle.position for particle in particles])
    radii = np.array([0.5 * particle.diameter for particle in particles])
    distances = np.abs(places[:, None] - places) - radii[:, None] - radii
    np.fill_diagonal(distances, np.inf)
    within = (places > radii) & (places < length - radii)
    clear = np.abs(places[:, None] - contacts) > radii[:, None]
    return bool((distances > 0.0).all() and within.all() and clear.all())
