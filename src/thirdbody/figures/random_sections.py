"""Random sections through the three-body interface, true to scale.

The surfaces are Gaussian, the particles come from the size distribution of the model, and the mean
planes stand at the solved separation.  The seed is always the same.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtr, ndtri

from thirdbody.figures.sections import Particle, Section, State
from thirdbody.model.parameters import Parameters

SEED = 20240507  # the day on which the paper appeared
LENGTHS = {"fig01": 12e-6, "fig02": 8e-6}  # of the sections of each schematic [m]
POINTS = 500
CLEARANCE = 0.12  # fraction of the section that contacts keep from its ends
ATTEMPTS = 1000


def sections(figure: str, states: Sequence[State], parameters: Parameters) -> list[Section]:
    """The sections of the schematic ``fig01`` or ``fig02``, one for each state; errors as below."""
    return [section_through(state, parameters, LENGTHS[figure], SEED) for state in states]


def section_through(state: State, parameters: Parameters, length: float, seed: int) -> Section:
    """A section of this ``length`` [m] that meets the contacts which carry the load: summits touch in
    the s-s and hybrid modes, a particle is held in the p-s and hybrid modes.

    ``ValueError`` if no random section is of this kind.
    """
    random = np.random.default_rng(seed)
    position = np.linspace(0.0, length, POINTS)
    mode = state.contact_mode
    summits_touch = mode in ("two_body", "surface_surface", "hybrid")
    particle_carries = mode in ("particle_surface", "hybrid")
    reach = _reach(state, parameters) if particle_carries else None
    for _ in range(ATTEMPTS):
        lower, upper = _surfaces(state, parameters, position, summits_touch, random)
        touches = lower > upper
        particles = _particles(state, parameters, position, lower, upper, reach, random)
        carries = any(particle.carries_load for particle in particles)
        if (
            touches.any() == summits_touch
            and carries == particle_carries
            and _are_apart(particles, position[touches], length)
        ):
            middle = 0.5 * (lower + upper)
            lower, upper = (np.where(touches, middle, heights) for heights in (lower, upper))
            return Section(state, position, lower, upper, touches, particles)
    raise ValueError(f"no section of {length:g} m shows the {mode} contact of {state}")


def _reach(state, parameters):
    """By how much a gap may exceed a particle that carries load in it [m]: by the height of the plane
    that particles meet, and by the elastic zone as printed."""
    interpretation = parameters.interpretation
    height = interpretation.particle_plane.height(state.condition.roughness, parameters)
    depth = parameters.elastic_depth_ratio * state.condition.particle_diameter
    return height + interpretation.elastic_limits.beyond * depth


def _surfaces(state, parameters, position, summits_touch, random):
    """Heights of the lower and the upper surface; they interpenetrate where summits touch."""
    # the correlation length l of a Gaussian surface with the model's density of summits, which is
    # 1/(2 pi sqrt(3) l^2) with the autocorrelation exp(-x^2/2l^2): Nayak (1971)
    # ASSUME: this autocorrelation, and the density rather than the radius of the summits, which
    # cannot both be those of a Gaussian surface
    density = parameters.surface(state.condition.roughness).summit_density
    length = 1.0 / np.sqrt(2.0 * np.pi * np.sqrt(3.0) * density)
    # ASSUME: both surfaces are equally rough, sigma/sqrt(2) each
    roughness = state.condition.roughness / np.sqrt(2.0)
    lower, upper = (roughness * _profile(position, length, random) for _ in range(2))
    if summits_touch:
        # a Gaussian process that passes a given height there: a draw plus its regression on the
        # difference; beyond a high level d it rises sigma^2/d on average
        place = random.uniform(0.25, 0.4) * position[-1]
        excess = state.condition.roughness**2 / state.separation
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


def _particles(state, parameters, position, lower, upper, reach, random):
    """Particles of a slab as deep as their mean distance.

    With a ``reach`` the first carries load: it lies in the narrowest place on the right, and is larger
    than the gap there less the reach.
    """
    count = round(position[-1] * np.sqrt(state.condition.particle_density))
    places = random.uniform(0.05, 0.95, count) * position[-1]
    smallest = np.zeros(count)
    if reach is not None:
        right = (position > 0.6 * position[-1]) & (position < (1 - CLEARANCE) * position[-1])
        gap = np.where(right, upper - lower, np.inf)
        places[0], smallest[0] = position[np.argmin(gap)], max(gap.min() - reach, 0.0)
    # up to X_max, from the size distribution of the model
    diameters = size_quantiles(
        random.uniform(size=count), smallest, state.condition.particle_diameter, parameters
    )
    return tuple(
        _settled(place, diameter, position, lower, upper, reach or 0.0)
        for place, diameter in zip(places, diameters, strict=True)
    )


def size_quantiles(
    fraction: ArrayLike, smallest: ArrayLike, diameter: float, parameters: Parameters
) -> NDArray:
    """Sizes [m] below which a ``fraction`` of the particles from ``smallest`` [m] to X_max lies, for a
    mean ``diameter`` x_a [m]."""
    mean, spread = parameters.interpretation.size_distribution.sizes(diameter, parameters)
    above = ndtr(parameters.truncation)
    below = np.minimum(ndtr((smallest - mean) / spread), above)
    return mean + spread * ndtri(below + (above - below) * fraction)


def _settled(place, diameter, position, lower, upper, reach) -> Particle:
    """The particle at rest on the lower surface, or held where the gap is narrower than it; it carries
    load where the gap exceeds it by no more than the ``reach``."""
    radius = 0.5 * diameter
    across = np.abs(position - place) < radius
    if not across.any():
        return Particle(place, float(np.interp(place, position, lower)) + radius, diameter, False)
    half_chord = np.sqrt(radius**2 - (position[across] - place) ** 2)
    rests = float((lower[across] + half_chord).max())
    hangs = float((upper[across] - half_chord).min())
    return Particle(place, min(rests, 0.5 * (rests + hangs)), diameter, rests + reach > hangs)


def _are_apart(particles, contacts, length) -> bool:
    """Whether no particle covers another, a contact of summits, or the ends of the section."""
    places = np.array([particle.position for particle in particles])
    radii = np.array([0.5 * particle.diameter for particle in particles])
    distances = np.abs(places[:, None] - places) - radii[:, None] - radii
    np.fill_diagonal(distances, np.inf)
    within = (places > radii) & (places < length - radii)
    clear = np.abs(places[:, None] - contacts) > radii[:, None]
    return bool((distances > 0.0).all() and within.all() and clear.all())
