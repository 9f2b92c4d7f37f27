"""Random sections through the three-body interface, and their dataset.

The surfaces are Gaussian, the particles follow the size distribution of the model, and the mean
planes are at the solved separation.  The seed is fixed.  A section is a mapping by the names of
``VARIABLES``, and ``position`` along it; its state has the condition and the solution.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtr, ndtri

from thirdbody.data.attributes import coordinate_attributes, variable_attributes
from thirdbody.data.conditions import AXES, Condition
from thirdbody.data.netcdf import PlainDataset, Variable
from thirdbody.data.quantities import FLAGS, QUANTITIES
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import CONTACT_MODES
from thirdbody.toml_tables import toml_beside

SEED = 20240507  # publication date of the paper
LENGTHS = {"fig01": 70e-6, "fig02": 40e-6}  # of the sections of each schematic [m]: several summits
POINTS = 500
CLEARANCE = 0.12  # distance of contacts from the ends, as a fraction of the section
ATTEMPTS = 1000

Section = Mapping[str, Any]


NUMBERS = ("separation", "particle_contact_area_ratio", "solid_load_fraction")  # of a state
STATE = {name: coordinate_attributes(AXES[name]) for name in Condition._fields}
STATE |= {name: coordinate_attributes(QUANTITIES[name]) for name in NUMBERS}
STATE |= {"contact_mode": variable_attributes(FLAGS["contact_mode"])}
# attributes of the other variables, over the position and over the particles
OTHERS = toml_beside(__file__)
LINES, PARTICLES = OTHERS["lines"], OTHERS["particles"]
VARIABLES = STATE | LINES | PARTICLES


def state_of(condition: Condition, solution: Any) -> dict[str, Any]:
    """The state of an interface from the ``Solution`` of one point; ``ValueError`` if there is none."""
    if not np.isfinite(solution.separation):
        raise ValueError(f"schematic conditions {condition._asdict()} have no solution")
    numbers = {name: float(getattr(solution, name)) for name in NUMBERS}
    return {**condition._asdict(), **numbers, "contact_mode": np.int8(solution.contact_mode)}


def condition_of(section: Section) -> Condition:
    """The condition of a section, or of a state."""
    return Condition(*(float(section[name]) for name in Condition._fields))


def sections(figure: str, states: Sequence[Section], parameters: Parameters) -> PlainDataset:
    """The sections of ``fig01`` or ``fig02`` as one dataset, a panel for each state; errors as below."""
    found = [section_through(state, parameters, LENGTHS[figure], SEED) for state in states]
    most = max(section["particle_size"].size for section in found)
    variables = {}
    for name, attributes in VARIABLES.items():
        values, dims = [section[name] for section in found], ("panel",)
        if name in LINES:
            dims = ("panel", "position")
        elif name in PARTICLES:  # panels with fewer particles are padded with nan
            dims, nothing = ("panel", "particle"), np.nan if values[0].dtype == float else 0
            values = [np.pad(v, (0, most - v.size), constant_values=nothing) for v in values]
        variables[name] = Variable(dims, np.array(values), attributes)
    position = Variable(("position",), found[0]["position"], OTHERS["position"])
    return PlainDataset(variables, {"position": position}, {"Conventions": "CF-1.11"})


def panels_of(data: PlainDataset) -> list[Section]:
    """The section of each panel in a dataset of ``sections``."""
    return [
        {name: variable.values[panel] for name, variable in data.data_vars.items()}
        | {"position": data["position"].values}
        for panel in range(data.sizes["panel"])
    ]


def section_through(state: Section, parameters: Parameters, length: float, seed: int) -> Section:
    """A random section of this ``length`` [m] through the contacts that carry the load in the mode of the
    ``state``: summits, a particle, or both; ``ValueError`` if none is found."""
    random = np.random.default_rng(seed)
    position = np.linspace(0.0, length, POINTS)
    mode = CONTACT_MODES[state["contact_mode"]]
    summits_touch = mode in ("two_body", "surface_surface", "hybrid")
    particle_carries = mode in ("particle_surface", "hybrid")
    # largest excess of a gap over a particle that carries load in it: the height of the plane that
    # particles meet, plus the elastic zone as printed
    options, sigma = parameters.interpretation, state["roughness"]
    depth = parameters.elastic_depth_ratio * state["particle_diameter"]
    plane = options.particle_plane.height(parameters.surface(sigma).summit_offset)
    reach = plane + options.elastic_limits.beyond * depth
    held = reach if particle_carries else None
    for _ in range(ATTEMPTS):
        lower, upper = _surfaces(state, parameters, position, summits_touch, random)
        touches = lower > upper
        particles = _particles(state, parameters, position, lower, upper, held, random)
        if (
            touches.any() == summits_touch
            and particles["particle_carries_load"].any() == particle_carries
            and _are_apart(particles, position[touches], length)
        ):
            middle = 0.5 * (lower + upper)
            lower, upper = np.where(touches, middle, [lower, upper])
            lines = dict(zip(LINES, (lower, upper, touches.astype(np.int8)), strict=True))
            return {**state, "position": position, **lines, **particles}
    raise ValueError(f"no section of {length:g} m shows the {mode} contact of {state}")


def _surfaces(state, parameters, position, summits_touch, random):
    """Heights of the lower and the upper surface; they interpenetrate where summits touch."""
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
    if summits_touch:
        # a Gaussian process through a given height there: a sample plus its regression on the
        # difference; above a high level d it rises by sigma^2/d on average
        place = random.uniform(0.25, 0.4) * position[-1]
        missing = separation + sigma**2 / separation - np.interp(place, position, lower - upper)
        rise = 0.5 * missing * np.exp(-0.5 * ((position - place) / length) ** 2)
        lower, upper = lower + rise, upper - rise
    return lower, upper + separation


def _particles(state, parameters, position, lower, upper, reach, random) -> dict[str, NDArray]:
    """Particles of a slab as deep as their mean spacing; with a ``reach`` the first carries load: it is in
    the narrowest gap on the right, and larger than this gap minus the reach."""
    count = round(position[-1] * np.sqrt(state["particle_density"]))
    places = random.uniform(0.05, 0.95, count) * position[-1]
    smallest = np.zeros(count)
    if reach is not None:
        right = (position > 0.6 * position[-1]) & (position < (1 - CLEARANCE) * position[-1])
        gap = np.where(right, upper - lower, np.inf)
        places[0], smallest[0] = position[np.argmin(gap)], max(gap.min() - reach, 0.0)
    fractions = random.uniform(size=count)
    sizes = size_quantiles(fractions, smallest, state["particle_diameter"], parameters)
    settled = [
        _settled(place, size, position, lower, upper, reach or 0.0)
        for place, size in zip(places, sizes, strict=True)
    ]
    heights, carries = np.reshape(settled, (count, 2)).T
    return dict(zip(PARTICLES, (places, heights, sizes, carries.astype(np.int8)), strict=True))


def size_quantiles(
    fraction: ArrayLike, smallest: ArrayLike, diameter: float, parameters: Parameters
) -> NDArray:
    """Quantiles [m] of the sizes from ``smallest`` [m] to X_max, for x_a = ``diameter`` [m]."""
    mean, spread = parameters.interpretation.size_distribution.sizes(diameter)
    above = ndtr(parameters.truncation)
    below = np.minimum(ndtr((smallest - mean) / spread), above)
    return mean + spread * ndtri(below + (above - below) * fraction)


def _settled(place, diameter, position, lower, upper, reach) -> tuple[float, bool]:
    """Height of a particle that rests on the lower surface or is held in a narrower gap; and whether it
    carries load: the gap exceeds it by at most ``reach``."""
    radius = 0.5 * diameter
    across = np.abs(position - place) < radius
    if not across.any():
        return np.interp(place, position, lower) + radius, False
    half_chord = np.sqrt(radius**2 - (position[across] - place) ** 2)
    rests = (lower[across] + half_chord).max()
    hangs = (upper[across] - half_chord).min()
    return min(rests, 0.5 * (rests + hangs)), rests + reach > hangs


def _are_apart(particles, contacts, length) -> bool:
    """Whether no particle overlaps another, a contact of summits, or the ends of the section."""
    places, radii = particles["particle_position"], 0.5 * particles["particle_size"]
    distances = np.abs(places[:, None] - places) - radii[:, None] - radii
    np.fill_diagonal(distances, np.inf)
    within = (places > radii) & (places < length - radii)
    clear = np.abs(places[:, None] - contacts) > radii[:, None]
    return bool((distances > 0.0).all() and within.all() and clear.all())
