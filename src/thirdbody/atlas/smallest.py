"""Making of the table for real time: as few numbers as keep an error."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from thirdbody.atlas.lookup import GRIDS, PIECE, Lookup
from thirdbody.configuration.axes import axis_values
from thirdbody.data.attributes import global_attributes
from thirdbody.data.conditions import AXES, CONDITION_AXES
from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer
from thirdbody.solver.points import make_contact
from thirdbody.solver.solve import solve

TABLES = {
    "summits": "ln F_ss*, ln(A_ss/A_n)",
    "height": "height of the plane that particles meet over sigma",
    "particles": "A_sa/A_n, coverage of Eq. 4, coverage of Eq. 5, each over eta_a x_a^2",
    "crossing": "ln W, ln H_c where both terms of Eq. 7 are equal",
    "film": "ln W over that of the crossing",
}
OF_TABLES = {"units": "1", "coverage_content_type": "modelResult"}
TITLE = "Table for L_s and A_sa,t* in real time"
SUMMARY = (
    "What summits, particles and film between two rough surfaces bear by themselves over their "
    "separation: where they hold the load together, their shares of it and of the real contact area are "
    "read off. Computed from the equations printed by Chen & Horng (2024) with the parameters in "
    "model_parameters."
)
COMMENT = (
    "thirdbody.atlas.lookup says how it is interpolated. range_ attributes: between which values it "
    "holds, SI; error_ attributes: the larger error of both shares at random conditions between them"
)
UNITS = {
    "gap_squared": "(d/sigma)^2",
    "log_roughness": "ln(sigma/m)",
    "separation_over_diameter": "(d less the height)/x_a",
    "log_viscosity": "ln(nu/(m2 s-1))",
    "log_film_roughness": "ln(sigma/m)",
    "log_relative_thickness": "ln H_c over that of the crossing",
}
# readings in which particles scale with their diameter
ALLOWED = {"size_distribution": ("uncentred", "centred")}

SI = [[axis.scale] for axis in CONDITION_AXES]
THINNED = (0.5, 0.7, 0.85, 0.95)  # factors of a number of nodes, one after the other
SIGMAS = 3.0  # standard deviations by which a table is better at the search than it has to be
SOLVED_RTOL = 1e-5  # of the conditions by which a table is judged
MARGIN = 1.1  # of the separations that the table spans, around those that were seen
NEGLIGIBLE = 1e-6  # share of the least load: what summits bear less than that counts for nothing
FEW = 1e-6  # coverage of particles that leave all of the interface bare


class Counts(NamedTuple):
    """Numbers of nodes of the table.

    Attributes
    ----------
    gap, surface : int
        (d/sigma)^2 and ln sigma, of the summits.
    share : int
        d/x_a, of the particles.
    film : int
        ln H_c, of the film.
    """

    gap: int
    surface: int
    share: int
    film: int

    @property
    def numbers(self) -> int:
        """How many numbers the table holds."""
        return (2 * self.gap + 1) * self.surface + 3 * self.share + self.film + 8


LEAST = Counts(4, 2, 4, 4)


class Ranges(NamedTuple):
    """Between which values the table holds, pairs in SI; viscosity and diameter may be 0 besides.

    Attributes
    ----------
    newtons, viscosity, particle_diameter, roughness, particle_density : tuple of float
        The conditions, the first a normal load F_t [N].
    separation : tuple of float
        d [m] that occur there.
    gap : tuple of float
        d/sigma [1] at which summits bear anything.
    """

    newtons: tuple[float, float]
    viscosity: tuple[float, float]
    particle_diameter: tuple[float, float]
    roughness: tuple[float, float]
    particle_density: tuple[float, float]
    separation: tuple[float, float]
    gap: tuple[float, float]


def search_lookup(parameters: Parameters, axes: Mapping[str, Mapping], settings: Mapping) -> Lookup:
    """Find the smallest table that keeps an error: one that keeps it is thinned, axis by axis.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    axes : mapping
        ``axes`` of ``config/atlas.yaml``, of which the table spans the positive values.
    settings : mapping
        ``lookup`` of ``config/atlas.yaml``.

    Returns
    -------
    Lookup
        With the errors at other random conditions than those of the search as attributes.

    Raises
    ------
    ValueError
        As ``lookup_of``.
    """
    chance = np.random.default_rng(settings["seed"])
    searched, checked = (
        _solved(parameters, axes, settings[f"{name}_points"], chance)
        for name in ("search", "check")
    )
    ranges = _ranges(parameters, axes, searched.separation)

    counts_of = searched.separation.size, checked.separation.size
    judge = _Judge(
        *(searched, settings["error"], allowed_misses(settings["share"], *counts_of)),
        np.zeros(counts_of[0], int),
    )

    def keeps(counts):
        return judge.passes(lookup_of(parameters, ranges, counts))

    counts = LEAST
    while not keeps(counts):
        finer = Counts(*(2 * count for count in counts))
        if finer.numbers > settings["most_numbers"]:
            break
        counts = finer
    for factor in THINNED:
        counts = _thinned(counts, factor, keeps)
    found = lookup_of(parameters, ranges, counts)
    request = {"axes": axes, "settings": settings}
    described = global_attributes(
        TITLE, parameters, np.array(ranges.roughness), SOLVED_RTOL, request
    )
    found.tables.attrs |= described | {"summary": SUMMARY, "comment": COMMENT}
    at_check = checked.errors(found)
    found.tables.attrs |= {
        "error_asked_for": settings["error"],
        "error_kept_in_share": float((at_check <= settings["error"]).mean()),
        "error_quantile_99_percent": float(np.quantile(at_check, 0.99)),
        "error_quantile_99_9_percent": float(np.quantile(at_check, 0.999)),
        "largest_error": float(at_check.max()),
        "checked_conditions": len(at_check),
        "numbers": counts.numbers,
    }
    return found


def allowed_misses(share: float, searched: int, checked: int) -> int:
    """At how many conditions of a search a table may miss its error.

    So few that at other conditions it keeps the error in the share asked for, unless chance is
    ``SIGMAS`` standard deviations off.  With as many as the share allows chance would decide there, and
    mostly against the table, because it was chosen of many as one that did well at the search.

    Parameters
    ----------
    share : float
        Of conditions at which the error is to be kept.
    searched, checked : int
        Numbers of conditions of the search, and of those others.

    Examples
    --------
    >>> allowed_misses(0.999, 50_000, 100_000), allowed_misses(0.999, 10**9, 10**9)
    (29, 995766)
    """
    # root, where root^2 + SIGMAS root sqrt(1/searched + 1/checked) = 1 - share, squared is the share of misses
    half = 0.5 * SIGMAS * (1.0 / searched + 1.0 / checked) ** 0.5
    return int(searched * ((half**2 + 1.0 - share) ** 0.5 - half) ** 2)


class _Sample(NamedTuple):
    """Random conditions, shape (5, count), and there the separation [m] and both shares, (2, count)."""

    conditions: NDArray
    separation: NDArray
    shares: NDArray

    def errors(self, lookup: Lookup, some=slice(None)) -> NDArray:
        """The larger error of both shares [1] at ``some`` of the conditions."""
        found = np.array(lookup(*self.conditions[:, some]))
        return np.abs(found - self.shares[:, some]).max(axis=0)


@dataclass
class _Judge:
    """Whether tables keep an ``error`` at the conditions of a ``sample``, all but ``misses`` of them.

    Those that other tables ``missed`` come first: a table that does not pass is soon found out.
    """

    sample: _Sample
    error: float
    misses: int
    missed: NDArray[np.int64]

    def passes(self, lookup: Lookup) -> bool:
        """Whether this table does."""
        order, missing = np.argsort(-self.missed, kind="stable"), 0
        for first in range(0, order.size, PIECE):
            some = order[first : first + PIECE]
            wrong = some[~(self.sample.errors(lookup, some) <= self.error)]
            self.missed[wrong] += 1
            missing += wrong.size
            if missing > self.misses:
                return False
        return True


def _solved(parameters, axes, count, chance) -> _Sample:
    """So many random conditions, evenly spread as the axes are, but those without solution."""
    columns = []
    for axis in axes.values():
        first, last, share = float(axis["from"]), float(axis["to"]), chance.random(count)
        if axis["scale"] == "logarithmic":
            columns.append(first * (last / first) ** share)
        else:
            columns.append(first + share * (last - first))
    conditions = np.array(columns)
    load, *others = conditions * np.array([[1.0 / parameters.newtons_per_load], *SI])
    solution = solve(
        **dict(zip(AXES, (load, *others), strict=True)),
        parameters=parameters,
        rtol=SOLVED_RTOL,
        variables=("solid_load_fraction", "particle_contact_area_ratio", "separation"),
        progress=False,
    )
    solved = np.isfinite(solution.separation)
    shares = np.array([solution.solid_load_fraction, solution.particle_contact_area_ratio])
    return _Sample(conditions[:, solved], solution.separation[solved], shares[:, solved])


def _ranges(parameters, axes, seen) -> Ranges:
    """What the table spans, around separations [m] that were ``seen``."""
    ends = [[value for value in axis_values(axis) if value > 0.0] for axis in axes.values()]
    spans = [(values[0], values[-1]) for values in ends]
    si = [1.0, *(float(scale) for (scale,) in SI)]
    newtons, viscosity, diameter, roughness, density = (
        (low * scale, high * scale) for (low, high), scale in zip(spans, si, strict=True)
    )
    separation = np.nanmin(seen) / MARGIN, np.nanmax(seen) * MARGIN
    gaps = np.linspace(separation[0] / roughness[1], separation[1] / roughness[0], 200)
    loads = _summits(parameters, gaps**2, np.log(np.array(roughness)))[..., 0].max(axis=1)
    bears = loads > np.log(NEGLIGIBLE * newtons[0] / parameters.newtons_per_load)
    last = gaps[bears][-1] if bears.any() else gaps[-1]
    gap = separation[0] / roughness[1], last
    return Ranges(newtons, viscosity, diameter, roughness, density, separation, gap)


def _thinned(counts: Counts, factor: float, keeps: Callable[[Counts], bool]) -> Counts:
    """The fewest numbers that are reached by making one axis after the other coarser by a factor,
    each time that which saves most, as long as the table ``keeps`` the error."""
    while True:
        coarser = [
            counts._replace(**{name: max(int(factor * count), least)})
            for (name, count), least in zip(counts._asdict().items(), LEAST, strict=True)
        ]
        fewer = (each for each in coarser if each.numbers < counts.numbers)
        kept = next(filter(keeps, sorted(fewer, key=lambda each: each.numbers)), None)
        if kept is None:
            return counts
        counts = kept


def lookup_of(parameters: Parameters, ranges: Ranges, counts: Counts) -> Lookup:
    """The table of some inputs of the model, with given numbers of nodes.

    Raises
    ------
    ValueError
        For readings in which particles do not scale with their diameter.
    """
    for name, allowed in ALLOWED.items():
        given = getattr(parameters, name)
        if given not in allowed:
            told = f"allowed for a lookup table: {', '.join(allowed)}"
            raise ValueError(f"{name} is {given}; {told}")
    surfaces = np.linspace(*np.log(ranges.roughness), counts.surface)
    squares = np.linspace(*np.square(ranges.gap), counts.gap)
    heights = _height(parameters, np.exp(surfaces))
    shares, particles = _particles(parameters, ranges, counts.share)
    films = np.log(ranges.viscosity), np.log(ranges.roughness)
    crossing, thicknesses, film = _film(parameters, ranges, *films, counts.film)
    columns = {
        name: axes if name in ("height", "film") else (*axes, f"of_{name}")
        for name, axes in GRIDS.items()
    }
    values = _summits(parameters, squares, surfaces), heights, particles, crossing, film
    nodes = squares, surfaces, shares, *films, thicknesses
    names = dict.fromkeys(name for axes in GRIDS.values() for name in axes)
    tables = xr.Dataset(
        {
            name: (axes, table, {"long_name": TABLES[name], **OF_TABLES})
            for (name, axes), table in zip(columns.items(), values, strict=True)
        },
        {
            name: (name, places, {"long_name": UNITS[name]})
            for name, places in zip(names, nodes, strict=True)
        },
        {
            **{f"range_{name}": np.array(ends) for name, ends in ranges._asdict().items()},
            "film_load": parameters.film_load,
            "newtons_per_load": parameters.newtons_per_load,
            "ball_radius": parameters.ball_radius,
            "load_per_parameter": parameters.ball_radius**2 / parameters.apparent_area,
            "particle_pressure": parameters.particle_pressure,
        },
    )
    for name in tables.coords:
        tables.variables[name].encoding["_FillValue"] = None  # where it is written: none is missing
    return Lookup(tables)


def _summits(parameters, squares, log_roughness) -> NDArray:
    """ln F_ss* and ln A_ss/A_n [1] over (d/sigma)^2 [1] and ln sigma."""
    roughness = np.exp(log_roughness)
    contact = make_contact(
        np.zeros_like(roughness), roughness, np.zeros_like(roughness), parameters, None
    )
    t = contact.summit_separation(np.sqrt(squares)[:, np.newaxis] * roughness)
    return np.stack([contact.summits.log_load(t)[0], contact.summits.log_area(t)[0]], axis=-1)


def _height(parameters, roughness) -> NDArray:
    """Height of the plane that particles meet over sigma [1]."""
    return parameters.readings.particle_plane.height(roughness, parameters) / roughness


def _particles(parameters, ranges, count) -> tuple[NDArray, NDArray]:
    """Nodes of d/x_a [1], d counted from the plane that particles meet, up to where no particle
    touches; and there the area of particles and their coverages in Eqs. 4 and 5, all over
    A_n eta_a x_a^2."""
    diameter, roughness = np.sqrt(np.prod(ranges.particle_diameter)), np.array(ranges.roughness)
    few = FEW / diameter**2
    layer = ParticleLayer.of(np.array([diameter]), roughness[:1], np.array([few]), parameters)
    heights = _height(parameters, roughness) * roughness
    nodes = np.linspace(
        (ranges.separation[0] - heights.max()) / ranges.particle_diameter[1],
        (layer.reach[0] - heights[0]) / diameter,
        count,
    )
    area, _, coverage, slope = layer.contact(nodes * diameter + heights[0])
    bare = -np.expm1(layer.log_bare_load(coverage, slope)[0])
    values = np.stack(np.broadcast_arrays(area, bare, coverage), axis=-1)
    values[-1, 0] = 0.0  # exactly: rounding is more than what summits share far apart
    return nodes, values / (few * diameter**2)


def _film(parameters, ranges, log_viscosity, log_roughness, count):
    """Where the terms of Eq. 7 are equal, ln W and ln H_c [1] over ln nu and ln sigma; nodes of ln H_c
    seen from there, and ln W over that there at each."""
    viscosity, roughness = np.broadcast_arrays(
        *np.ix_(np.exp(log_viscosity), np.exp(log_roughness))
    )
    film = Film.of(viscosity, roughness, parameters)
    crossing = np.stack(film.crossing(), axis=-1)
    ends = np.log(np.array(ranges.separation) / parameters.ball_radius)
    nodes = np.linspace(ends[0] - crossing[..., 1].max(), ends[1] - crossing[..., 1].min(), count)
    of_one = film.take((0, 0))
    log_parameter = of_one.load_parameter(np.exp(nodes + crossing[0, 0, 1]))
    return crossing, nodes, log_parameter - crossing[0, 0, 0]
