"""Random sections through the three-body interface.

The surfaces are Gaussian, the particles follow the size distribution of the model, and the mean
planes are at the solved separation.  Lengths are as in the model; on paper heights are stretched, and
particles, which are drawn round, touch the surfaces as they are drawn.  Those that touch both, or are
large enough by Eqs. 4 and 5, carry load; sections are chosen where no other reaches into the elastic
zone h_e.  The seed is fixed.  A section is a mapping: its state, which has the condition and the solution,
``elastic_depth`` h_e, ``position`` along it, and by the names of ``LINES`` and ``PARTICLES`` [m].
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import CONTACT_MODES
from thirdbody.curves import Condition
from thirdbody.variables import NORMAL_LOAD

SEED = 20240507  # publication date of the paper
STRETCH = 25.0  # of heights over lengths, so that several summits are seen
LENGTHS = {"fig01": 150e-6, "fig02": 84e-6}  # of the sections of each schematic [m]
# ASSUME: fewer particles than in a slab as deep as their mean spacing, so that each is seen
SPACING = 16e-6  # of particles [m]
POINTS = 500
ATTEMPTS = 1000
LEFT, MIDDLE, RIGHT = (0.15, 0.45), (0.35, 0.65), (0.55, 0.85)  # parts of a section
# parts with a contact of summits, and with a particle that touches both surfaces, by contact mode
TOUCHING = {
    "two_body": ((LEFT, RIGHT), ()),
    "surface_surface": ((LEFT, RIGHT), ()),
    "hybrid": ((LEFT,), (RIGHT,)),
    "particle_surface": ((), (MIDDLE,)),
}

Section = Mapping[str, Any]

NUMBERS = ("separation", "particle_contact_area_ratio", "solid_load_fraction")  # of a state
LINES = ("lower", "upper", "surfaces_touch")
PARTICLES = ("particle_position", "particle_height", "particle_size", "particle_carries_load")


def state_of(
    condition: Condition, load_N: float, variables: Mapping[str, NDArray]
) -> dict[str, Any]:
    """The state of an interface from the variables of one point at ``load_N`` [N]; ``ValueError`` if it has no
    solution."""
    if not np.isfinite(variables["separation"]):
        raise ValueError(f"schematic conditions {condition._asdict()} have no solution")
    numbers = {name: float(variables[name]) for name in NUMBERS}
    numbers |= {NORMAL_LOAD.name: float(load_N)}
    return {**condition._asdict(), **numbers, "contact_mode": np.int8(variables["contact_mode"])}


def condition_of(section: Section) -> Condition:
    """The condition of a section, or of a state."""
    return Condition(*(float(section[name]) for name in Condition._fields))


def sections(figure: str, states: Sequence[Section], parameters: Parameters) -> list[Section]:
    """The sections of ``fig01`` or ``fig02``, a panel for each state; errors as below."""
    return [section_through(state, parameters, LENGTHS[figure], SEED) for state in states]


def section_through(state: Section, parameters: Parameters, length: float, seed: int) -> Section:
    """A random section of this ``length`` [m] through the contacts that carry the load in the mode of the
    ``state``: summits, particles, or both; ``ValueError`` if none is found."""
    random = np.random.default_rng(seed)
    position = np.linspace(0.0, length, POINTS)
    mode = CONTACT_MODES[state["contact_mode"]]
    summits, held = TOUCHING[mode]
    depth = parameters.elastic_depth_ratio * state["particle_diameter"]
    least = _least_size(state, depth, parameters)
    for _ in range(ATTEMPTS):
        lower, upper = _surfaces(state, parameters, position, summits, random)
        touches = lower > upper
        particles = _particles(state, parameters, position, lower, upper, held, random)
        touching = particles["particle_carries_load"].astype(bool)
        carries = touching | (particles["particle_size"] > least)
        top = particles["particle_height"] + 0.5 * particles["particle_size"]
        in_zone = top > state["separation"] - depth
        if (
            touches.any() == bool(summits)
            and touching.any() == bool(held)
            and carries[in_zone].all()  # where free ones lie is no matter in the model
            and _are_apart(particles, position[touches], length)
        ):
            particles["particle_carries_load"] = carries.astype(np.int8)
            middle = 0.5 * (lower + upper)
            lower, upper = np.where(touches, middle, [lower, upper])
            lines = dict(zip(LINES, (lower, upper, touches.astype(np.int8)), strict=True))
            return {**state, "elastic_depth": depth, "position": position, **lines, **particles}
    raise ValueError(f"no section of {length:g} m shows the {mode} contact of {state}")


def _least_size(state, depth, parameters) -> float:
    """The diameter [m] from which a particle reaches into the elastic zone, at the separation (Eqs. 4 and 5)."""
    summit_offset = parameters.surface(state["roughness"]).summit_offset
    offset = parameters.particle_plane_height(summit_offset)
    return state["separation"] - offset - depth


def _surfaces(state, parameters, position, summits, random):
    """Heights of the lower and the upper surface; they interpenetrate somewhere within each of ``summits``."""
    sigma, separation = state["roughness"], state["separation"]
    # the correlation length l of a Gaussian surface with the summit density of the model, which is
    # 1/(2 pi sqrt(3) l^2) for the autocorrelation exp(-x^2/2l^2): Nayak (1971)
    # ASSUME: this autocorrelation, and the density rather than the radius of the summits, as a
    # Gaussian surface cannot have both
    length = 1.0 / np.sqrt(2.0 * np.pi * np.sqrt(3.0) * parameters.surface(sigma).summit_density)
    step = position[1] - position[0]
    reach = int(3.0 * length / step)
    kernel = np.exp(-((np.arange(-reach, reach + 1) * step / length) ** 2))
    noise = random.standard_normal((2, position.size + 2 * reach))
    profiles = np.array([np.convolve(each, kernel, "valid") for each in noise])
    # ASSUME: both surfaces are equally rough, sigma/sqrt(2) each
    lower, upper = sigma / np.sqrt(2.0) * (profiles / np.sqrt(np.sum(kernel**2)))
    for first, last in summits:
        # a Gaussian process through a given height there: a sample plus its regression on the
        # difference; above a high level d it rises by sigma^2/d on average
        place = random.uniform(first, last) * position[-1]
        missing = separation + sigma**2 / separation - np.interp(place, position, lower - upper)
        rise = 0.5 * missing * np.exp(-0.5 * ((position - place) / length) ** 2)
        lower, upper = lower + rise, upper - rise
    return lower, upper + separation


def _particles(state, parameters, position, lower, upper, held, random) -> dict[str, NDArray]:
    """Particles of random sizes, each in its part of the section; in the narrowest gap within each of ``held``
    is one that touches both surfaces, or else the largest."""
    count = round(position[-1] / SPACING)
    places = (np.arange(count) + random.uniform(0.2, 0.8, count)) / count * position[-1]
    smallest = np.zeros(count)
    carries = np.zeros(count, bool)
    for first, last in held:
        within = (position > first * position[-1]) & (position < last * position[-1])
        gap = np.where(within, upper - lower, np.inf)
        narrowest = np.argmin(gap)
        nearest = np.argmin(np.abs(places - position[narrowest]))
        places[nearest], smallest[nearest] = position[narrowest], gap[narrowest]
        carries[nearest] = True
    fractions = random.uniform(size=count)
    sizes = size_quantiles(fractions, smallest, state["particle_diameter"], parameters)
    apart = np.abs(places[:, None] - places[carries]) > 0.5 * STRETCH * (
        sizes[:, None] + sizes[carries]
    )
    clear = carries | apart.all(axis=1)  # free particles leave room for those
    places, sizes, carries = places[clear], sizes[clear], carries[clear]
    settled = [
        _settled(place, size, position, lower, upper)
        for place, size in zip(places, sizes, strict=True)
    ]
    heights, touch = np.reshape(settled, (-1, 2)).T
    carries |= touch > 0.0
    return dict(zip(PARTICLES, (places, heights, sizes, carries.astype(np.int8)), strict=True))


def size_quantiles(
    fraction: float | NDArray, smallest: float | NDArray, diameter: float, parameters: Parameters
) -> NDArray:
    """Quantiles [m] of the sizes from ``smallest`` [m] to X_max, for x_a = ``diameter`` [m]."""
    mean, spread = parameters.sizes(diameter)
    above = ndtr(parameters.truncation)
    below = np.minimum(ndtr((smallest - mean) / spread), above)
    return mean + spread * ndtri(below + (above - below) * fraction)


def _settled(place, diameter, position, lower, upper) -> tuple[float, bool]:
    """Height of a particle that rests on the lower surface or is held in a narrower gap; and whether it
    touches both."""
    radius, across = 0.5 * diameter, np.abs(position - place) / STRETCH
    half_chord = np.sqrt(np.maximum(radius**2 - across**2, 0.0))
    near = across <= max(radius, across.min())
    rests = (lower[near] + half_chord[near]).max()
    hangs = (upper[near] - half_chord[near]).min()
    return min(rests, 0.5 * (rests + hangs)), rests > hangs


def _are_apart(particles, contacts, length) -> bool:
    """Whether no particle overlaps another, a contact of summits, or the ends of the section."""
    places, radii = particles["particle_position"], 0.5 * STRETCH * particles["particle_size"]
    distances = np.abs(places[:, None] - places) - radii[:, None] - radii
    np.fill_diagonal(distances, np.inf)
    within = (places > radii) & (places < length - radii)
    clear = np.abs(places[:, None] - contacts) > radii[:, None]
    return bool((distances > 0.0).all() and within.all() and clear.all())
