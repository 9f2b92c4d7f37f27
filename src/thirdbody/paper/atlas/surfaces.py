"""The atlas on one surface: each set of inputs is solved once, and regimes, modes, design limits and
turning points are extracted while its points are in memory."""

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.special import logit

from thirdbody.core.bracketing import bracketed_roots
from thirdbody.core.contact import Contact
from thirdbody.core.film import Film, load_of_film, log_load_parameter
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import (
    BOUNDARY_LIMIT,
    CONTACT_MODES,
    LUBRICATION_REGIMES,
    PARTICLE_LIMIT,
)
from thirdbody.core.solve import solve_points
from thirdbody.core.sweep import is_worthwhile, sweep
from thirdbody.core.turning_points import film_turning_points
from thirdbody.core.windows import swept_windows
from thirdbody.grids import Axes, crossed
from thirdbody.ranges import ENDS
from thirdbody.variables import FLAGS

STATES = {"lubrication_regime": LUBRICATION_REGIMES, "contact_mode": CONTACT_MODES}
SOLVED = ("separation", "particle_contact_area_ratio", "solid_load_fraction", *STATES)
QUANTILES = np.array([ENDS[0], 0.5, ENDS[1]])  # nine in ten lie between the first and the last
EVEN = 0.5  # largest step of the log odds over which a limit is interpolated
PLACES = 900  # separations between which the diameter of a limit is interpolated


def solve_surface(
    axes: Axes,
    sets: Sequence[Parameters],
    weights: Sequence[int],
    kept: Collection[str],
    rtol: float,
) -> dict[str, NDArray]:
    """Variables of the atlas by name, on ``axes`` with one roughness and one particle density.

    ``sets`` are the default inputs, then the others of the ensemble, and ``weights`` the
    multiplicity of each.  Returns the variables ``kept`` and the flags, counts of the members in
    each regime and mode, limits and turning points of the default with their quantiles, and counts
    of turning points.
    """
    shape = [axis.size for axis in axes.values()]
    names = (state for states in STATES.values() for state in states)
    counts = {f"{name}_probability": np.zeros(shape, np.int16) for name in names}
    limits: list[dict[str, NDArray]] = []
    values: dict[str, NDArray] = {}
    for parameters, weight in zip(sets, weights, strict=True):
        own = {**axes, "load": axes["load"] / parameters.newtons_per_load}
        wanted = SOLVED if values else dict.fromkeys((*SOLVED, *kept, *FLAGS))
        if is_worthwhile(own, rtol):
            solution = sweep(own, parameters, rtol, wanted)
        else:
            solution = solve_points(crossed(own), parameters, rtol, wanted)
        values = values or {name: solution[name] for name in (*kept, *FLAGS)}
        for flag, states in STATES.items():
            for index, state in enumerate(states):
                counts[f"{state}_probability"] += weight * (solution[flag] == index)
        limits.append(
            _passed(own, solution, parameters, rtol)
            | _turning(own, solution["separation"], parameters, rtol)
        )
    found: dict[str, NDArray] = {}
    exists: dict[str, NDArray] = {}
    for name, value in limits[0].items():
        members = np.repeat(np.stack([each[name] for each in limits]), weights, axis=0)
        found |= {name: value, f"{name}_range": quantiles(members)}
        if name in ("turning_point_load", "turning_point_window_low"):
            count = np.isfinite(members).sum(axis=0).astype(np.int16)
            exists[f"{name.rpartition('_')[0]}_probability"] = count
    return values | counts | found | exists


def quantiles(values: NDArray) -> NDArray[np.float64]:
    """``QUANTILES`` over the members, the first axis of ``values``, interpolated linearly, without nan;
    also between infinite values, where ``numpy.quantile`` gives nan."""
    ordered = np.sort(values, axis=0)  # nan last
    last = np.count_nonzero(~np.isnan(values), axis=0) - 1
    place = np.multiply.outer(QUANTILES, np.maximum(last, 0))
    below = np.floor(place).astype(int)
    above = np.minimum(below + 1, np.maximum(last, 0))
    low, high = (np.take_along_axis(ordered, each, axis=0) for each in (below, above))
    with np.errstate(invalid="ignore"):  # infinity minus infinity
        step = np.where((place > below) & (low != high), (place - below) * (high - low), 0.0)
    return low + step


@np.errstate(divide="ignore", invalid="ignore")  # fractions of 0 and 1
def _passed(axes, solution, parameters, rtol) -> dict[str, NDArray]:
    """Largest diameter out of the p-s mode, and least viscosity out of boundary lubrication."""
    ends = np.nanmin(solution["separation"]), np.nanmax(solution["separation"])
    diameter = passed_diameter(PARTICLE_LIMIT, axes, ends, parameters, rtol)
    viscosity = passed_viscosity(BOUNDARY_LIMIT, axes, parameters, rtol)
    particles = logit(solution["particle_contact_area_ratio"]) - logit(PARTICLE_LIMIT)
    film = logit(BOUNDARY_LIMIT) - logit(solution["solid_load_fraction"])
    return {
        "largest_particle_diameter": first_passed("particle_diameter", axes, particles, diameter),
        "least_viscosity": first_passed("viscosity", axes, film, viscosity),
    }


def first_passed(along: str, axes: Axes, excess: NDArray, at_leaps: NDArray) -> NDArray:
    """Where ``excess``, the log odds above a level, first crosses 0 along an axis of a grid, SI.

    It is interpolated over the logarithm of the axis, without the value 0.  At a jump, as where the
    first particle touches, ``at_leaps`` is used.  The result has the shape of the grid
    without the axis: 0 where the level is exceeded at the first value, infinite where it never is,
    nan where points without solution leave this open.
    """
    nodes = axes[along][axes[along] > 0.0]
    excess = np.moveaxis(excess, list(axes).index(along), 0)[axes[along] > 0.0]
    beyond = excess > 0.0
    passed, last = beyond.any(axis=0), beyond.argmax(axis=0)
    never = np.where(np.isnan(excess).any(axis=0), np.nan, np.inf)
    found = np.where(passed, 0.0, never)
    others = np.nonzero(passed & (last > 0))
    high = last[others]
    ends = nodes[high - 1], nodes[high]
    below, above = (excess[(place, *others)] for place in (high - 1, high))
    crossing = ends[0] * (ends[1] / ends[0]) ** (below / (below - above))
    leaps = ~np.isnan(below) & ~(np.abs(above - below) < EVEN)
    found[others] = np.where(leaps, np.clip(at_leaps[others], *ends), crossing)
    return found


@np.errstate(all="ignore")  # no particle may touch
def passed_diameter(
    level: float, axes: Axes, ends: tuple[float, float], parameters: Parameters, rtol: float
) -> NDArray:
    """Mean diameter x_a [m] at which A_sa,t* equals ``level``: shape (loads, films, 1, 1).

    At a separation d, from the first to the last of ``ends`` [m], the ratio depends only on the
    particles: x_a(d) is found between the ends of its axis, and its load is F_s + F_f (Eq. 1).  The
    largest of several d is used.
    """
    sizes = axes["particle_diameter"]
    (surface,), (number,) = axes["roughness"], axes["particle_density"]
    separation = np.geomspace(*ends[::-1], PLACES)
    roughness, density = np.full(PLACES, surface), np.full(PLACES, number)

    def excess(log_diameter, some):
        columns = np.exp(log_diameter), roughness[some], density[some]
        contact = Contact.of(*columns, parameters, rtol)
        state = contact.at(separation[some], with_areas=True)
        return np.log(state.particle_area.value) - state.log_summit_area.value - logit(level)

    every = np.arange(PLACES)
    low, high = (np.full(PLACES, np.log(size)) for size in (sizes[sizes > 0.0][0], sizes[-1]))
    log_diameter = np.where(excess(low, every) > 0.0, low, high)
    passed = np.flatnonzero((log_diameter == high) & (excess(high, every) > 0.0))
    log_diameter[passed], _ = bracketed_roots(
        lambda log_size: excess(log_size, passed), low[passed], high[passed], 0.1 * rtol
    )
    contact = Contact.of(np.exp(log_diameter), roughness, density, parameters, rtol)
    solid = np.exp(contact.at(separation).log_load.value)
    film, _ = load_of_film(separation, axes["viscosity"][:, np.newaxis], surface, parameters)
    total = np.log(parameters.total_load(solid, film))
    rising = np.maximum.accumulate(total, axis=-1)
    found = [np.interp(np.log(axes["load"]), each, log_diameter) for each in rising]
    return np.exp(np.transpose(found))[:, :, np.newaxis, np.newaxis]


def passed_viscosity(level: float, axes: Axes, parameters: Parameters, rtol: float) -> NDArray:
    """Viscosity [m2/s] at which L_s equals ``level``: shape (loads, sizes, 1, 1).

    The solids carry this fraction of the load at one separation, dry or not, and there the film is as
    thick as the separation (Eqs. 7 and 8).
    """
    films = axes["viscosity"][axes["viscosity"] > 0.0]
    dry = {**axes, "load": level * axes["load"][:, np.newaxis], "viscosity": np.zeros(1)}
    separation = solve_points(dry, parameters, rtol, ["separation"])["separation"]
    log_fluid = np.log1p(-level) if parameters.film_shares_load else 0.0
    film = Film.of(films, axes["roughness"], parameters)
    found = []
    for wanted, log_load in zip(separation, np.log(axes["load"]), strict=True):
        thickness, _ = film.thickness(log_load_parameter(log_load + log_fluid, parameters))
        log_wanted = np.log(wanted / parameters.ball_radius)
        found.append(np.interp(log_wanted, np.log(thickness), np.log(films)))
    return np.exp(found)[:, :, np.newaxis, np.newaxis]


def _turning(axes, separation, parameters, rtol) -> dict[str, NDArray]:
    """Turning points of all curves, and their windows."""
    films, sizes = axes["viscosity"], axes["particle_diameter"]
    (roughness,), (density,) = axes["roughness"], axes["particle_density"]
    turning = film_turning_points(
        separation.reshape(-1, films.size, sizes.size),
        films,
        sizes,
        np.full_like(sizes, roughness),
        np.full_like(sizes, density),
        parameters,
        rtol,
    )
    shape = films.size, sizes.size, 1, 1
    large = sizes > 0.0
    prominence = np.moveaxis(turning.prominence.reshape(shape)[:, large], 1, 0)
    low, high = swept_windows(sizes[large] / roughness, prominence)
    return {
        "turning_point_load": turning.load.reshape(shape),
        "turning_point_window_low": low,
        "turning_point_window_high": high,
    }
