"""Sections through the three-body interface, for the drawings of Figures 1 and 2.

Two surfaces of a fixed shape, as rough as the condition says, lie at the solved separation.  At
fixed places they are raised until summits touch, or a particle touches both, as the contact mode
says. Lengths are as in the model; on paper heights are stretched, and particles, which are drawn
round, touch the surfaces as they are drawn.  A section is a mapping: its state, which has the
condition and the solution, ``elastic_depth`` h_e, ``position`` along it, and by the names of
``LINES`` and ``PARTICLES`` [m]; the first ``touching`` particles touch both surfaces.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq
from scipy.special import ndtr, ndtri

from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import CONTACT_MODES
from thirdbody.curves import Condition
from thirdbody.variables import NORMAL_LOAD

STRETCH = 25.0  # of heights over lengths, so that several summits are seen
LENGTHS = {"fig01": 150e-6, "fig02": 84e-6}  # of the sections of each schematic [m]
POINTS = 500
# the waves of a surface: wavelength and place of a crest, in lengths of the section, and weight
WAVES = {
    "lower": ((0.42, 0.28, 1.0), (0.17, 0.30, 0.4), (1.1, 0.5, 0.4)),
    "upper": ((0.42, 0.28, -1.0), (0.19, 0.26, -0.4), (0.8, 0.9, 0.4)),
}
SUMMIT = 0.06  # standard deviation of a raised summit, in lengths of the section
# places with a contact of summits, and with a particle that touches both surfaces, by contact mode
TOUCHING = {
    "two_body": ((0.28, 0.66), ()),
    "surface_surface": ((0.28, 0.66), ()),
    "hybrid": ((0.28,), (0.66,)),
    "particle_surface": ((), (0.28,)),
}
HELD = 0.8  # size of a particle that touches both surfaces, over the separation
FREE = (
    (0.06, 0.6),
    (0.44, 0.3),
    (0.52, 0.7),
    (0.83, 0.2),
    (0.91, 0.5),
)  # places, quantiles of size

Section = Mapping[str, Any]

NUMBERS = ("separation", "particle_contact_area_ratio", "solid_load_fraction")  # of a state
LINES = ("lower", "upper", "surfaces_touch")
PARTICLES = ("particle_position", "particle_height", "particle_size", "particle_carries_load")


def state_of(
    condition: Condition, load_N: float, variables: Mapping[str, NDArray]
) -> dict[str, Any]:
    """The state of an interface from the variables of a point at ``load_N`` [N]; ``ValueError`` if
    it has no solution."""
    if not np.isfinite(variables["separation"]):
        raise ValueError(f"schematic conditions {condition._asdict()} have no solution")
    numbers = {name: float(variables[name]) for name in NUMBERS}
    numbers |= {NORMAL_LOAD.name: float(load_N)}
    return {**condition._asdict(), **numbers, "contact_mode": np.int8(variables["contact_mode"])}


def condition_of(section: Section) -> Condition:
    """The condition of a section, or of a state."""
    return Condition(*(float(section[name]) for name in Condition._fields))


def sections(figure: str, states: Sequence[Section], parameters: Parameters) -> list[Section]:
    """The sections of ``fig01`` or ``fig02``, a panel for each state."""
    return [section_through(state, parameters, LENGTHS[figure]) for state in states]


def section_through(state: Section, parameters: Parameters, length: float) -> Section:
    """The section of this ``length`` [m] through the contacts that carry the load in the mode of
    the ``state``: summits, particles, or both."""
    summits, held = TOUCHING[CONTACT_MODES[state["contact_mode"]]]
    separation, sigma = state["separation"], state["roughness"]
    depth = parameters.elastic_depth_ratio * state["particle_diameter"]
    position = np.linspace(0.0, length, POINTS)
    # ASSUME: both surfaces are equally rough, sigma/sqrt(2) each
    lower = sigma / np.sqrt(2.0) * _waves("lower", position / length)
    upper = separation + sigma / np.sqrt(2.0) * _waves("upper", position / length)
    largest = size_quantiles(1.0, state["particle_diameter"], parameters)
    fits = min(HELD * separation, 0.9 * largest)
    gaps = dict.fromkeys(summits, -0.3 * sigma) | dict.fromkeys(held, fits)
    for place, gap in gaps.items():
        missing = np.interp(place * length, position, upper - lower) - gap
        rise = 0.5 * missing * np.exp(-0.5 * ((position / length - place) / SUMMIT) ** 2)
        lower, upper = lower + rise, upper - rise
    touches = lower > upper
    middle = 0.5 * (lower + upper)
    lower, upper = np.where(touches, middle, [lower, upper])
    particles = _particles(state, parameters, position, lower, upper, held)
    return {
        **state,
        "elastic_depth": depth,
        "position": position,
        **dict(zip(LINES, (lower, upper, touches.astype(np.int8)), strict=True)),
        "touching": len(held),
        **particles,
    }


def _waves(surface, place) -> NDArray:
    """Heights of a surface at each ``place``, with a standard deviation of 1."""
    lengths, crests, weights = np.transpose(WAVES[surface])
    heights = weights * np.cos(2.0 * np.pi * (place[:, np.newaxis] - crests) / lengths)
    return heights.sum(axis=1) / np.sqrt(0.5 * np.sum(weights**2))


def _particles(state, parameters, position, lower, upper, held) -> dict[str, NDArray]:
    """Particles that touch both surfaces at the places ``held``, and others that rest on the lower
    surface where they fit.  They carry load if they touch both, or are large enough by Eqs. 4 and
    5."""
    length, diameter = position[-1], state["particle_diameter"]
    summit_offset = parameters.surface(state["roughness"]).summit_offset
    plane = parameters.particle_plane_height(summit_offset)
    least = state["separation"] - plane - parameters.elastic_depth_ratio * diameter
    rows = []
    for x in length * np.array(held):
        size = brentq(_clearance, 0.0, 2.0 * state["separation"], (x, position, lower, upper))
        height, _ = _heights(x, size, position, lower, upper)
        rows.append((x, height, size, True))
    for place, fraction in FREE:
        x, size = place * length, size_quantiles(fraction, diameter, parameters)
        rests, hangs = _heights(x, size, position, lower, upper)
        radius = 0.5 * STRETCH * size
        is_apart = all(abs(x - row[0]) > radius + 0.5 * STRETCH * row[2] for row in rows)
        if rests < hangs and is_apart and radius < x < length - radius:
            rows.append((x, rests, size, size > least))
    columns = np.reshape(rows, (-1, len(PARTICLES))).T
    return dict(zip(PARTICLES, columns, strict=True))


def size_quantiles(
    fraction: float | NDArray, diameter: float, parameters: Parameters
) -> NDArray | float:
    """Quantiles [m] of the sizes from 0 to X_max, for x_a = ``diameter`` [m]."""
    mean, spread = parameters.sizes(diameter)
    below, above = ndtr(-mean / spread), ndtr(parameters.truncation)
    return mean + spread * ndtri(below + (above - below) * fraction)


def _clearance(size, x, position, lower, upper) -> float:
    """What is left between both surfaces and a particle of this ``size`` at ``x``."""
    rests, hangs = _heights(x, size, position, lower, upper)
    return hangs - rests


def _heights(x, size, position, lower, upper) -> tuple[float, float]:
    """Heights of a particle of this ``size`` at ``x`` that rests on the lower surface, and of a
    particle that hangs from the upper, as they are drawn."""
    radius, across = 0.5 * size, np.abs(position - x) / STRETCH
    near = across <= max(radius, across.min())
    half_chord = np.sqrt(np.maximum(radius**2 - across[near] ** 2, 0.0))
    return (lower[near] + half_chord).max(), (upper[near] - half_chord).min()
