"""Grids to three digits: functions of the separation d alone are tabulated and interpolated.

For a given surface and particles, F_ss, A_ss and A_sa are functions of d alone (Eqs. 2-6),
independent of load and lubricant.  They are evaluated at a few hundred separations and interpolated
by cubic Hermite polynomials.  Eq. 1 is then solved at all loads and viscosities at once.  Dry
contact, and points where the interpolation error exceeds ``rtol``, are solved individually.
"""

from collections.abc import Collection, Iterator, Mapping

import numpy as np
import scipy  # scipy.interpolate is loaded on first use: many jobs do not need it
from numpy.typing import NDArray

from thirdbody.model.contact import greatest_single_load
from thirdbody.model.film import Film, log_load_parameter
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import TINY, has_particles
from thirdbody.progress import Progress
from thirdbody.solver.points import make_contact
from thirdbody.solver.solution import QUANTITIES, Solution, add_flags, type_of
from thirdbody.solver.solve import CONDITIONS, solve_arrays

LEAST_RTOL = 1e-3  # interpolation does not reach a smaller error
FEWEST_POINTS = 500  # of one surface and particle size; fewer are solved individually
STEP = 0.06  # of asinh(d/sigma) between separations
# from the smallest to the largest particle, clustered at the largest
SIZES = np.concatenate([np.linspace(0.0, 1.0, 40), 1.0 - np.geomspace(1e-7, 0.02, 14)])
LOWEST = -6.0  # (size - mean)/spread below which particles are negligible
KINK_GAP = 1e-12  # relative distance of separations from a kink, on both sides
SAFETY = 2.0  # times the error midway between two separations
SUMMIT_RTOL = 1e-7  # error of the summits' load and area
MOST_LOG_LOAD = 10.0  # ln F_s* assumed where particles cover everything
SOLIDS = 500  # pairs of particle size and density whose tables are made together
GUESSES = 200  # separations at which films are tabulated for the initial guess of Newton's method
NEWTON_STEPS = 2
ORDER = "particle_diameter", "roughness", "particle_density", "viscosity", "load"  # in memory


def is_worthwhile(axes: Mapping[str, NDArray], rtol: float) -> bool:
    """Whether ``sweep`` solves a grid over ``axes`` faster than point by point."""
    films = np.count_nonzero(axes["viscosity"])
    return rtol >= LEAST_RTOL and films > 1 and films * axes["load"].size >= FEWEST_POINTS


def sweep(
    axes: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    variables: Collection[str],
    progress: bool = False,
) -> Solution:
    """Solve all combinations of five axes by interpolation over the separation.

    Parameters
    ----------
    axes : mapping
        Load [1], viscosity [m2/s], particle diameter [m], roughness [m] and particle density [m-2]
        by name, in this order; 1-D and increasing.
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Requested relative error, at least ``LEAST_RTOL``.
    variables : collection of str
        Names of the fields of ``Solution`` to compute.
    progress : bool
        Whether a long call reports its progress.

    Returns
    -------
    Solution
        Arrays over the five axes.  ``error_bound`` is twice the interpolation error midway between
        two separations, of the quantity most affected, plus the remaining error of the iteration.
    """
    shape = tuple(axes[name].size for name in ORDER)
    values = {name: np.empty(shape, type_of(name)) for name in variables}
    unsure = np.zeros(shape, bool)
    dry = np.count_nonzero(axes["viscosity"] == 0.0)  # rows before those with a film
    sizes, densities = np.meshgrid(*(axes[name] for name in ORDER[:3:2]), indexing="ij")
    three_body = has_particles(sizes, densities)
    groups = [
        some[start : start + SOLIDS]
        for some in (np.argwhere(three_body), np.argwhere(~three_body))
        for start in range(0, len(some), SOLIDS)
    ]
    with np.errstate(all="ignore"), Progress(unsure.size, "points", progress) as bar:
        for number, roughness in enumerate(axes["roughness"]):
            surface = _Surface(axes, roughness, parameters)
            for places in groups:
                chosen = tuple(places.T)
                found = surface.solved(sizes[chosen], densities[chosen], rtol, values)
                for (size, density), states in zip(places, found, strict=True):
                    at = size, number, density
                    for name, array in values.items():
                        array[at][:dry], array[at][dry:] = states[name]
                    unsure[at][dry:] = states["unsure"]
                    bar.add(unsure[at].size)
        index = np.nonzero(unsure)
        if index[0].size:
            given = {name: axes[name][place] for name, place in zip(ORDER, index, strict=True)}
            some = solve_arrays(given, parameters, rtol, variables)
            for name, array in values.items():
                array[index] = getattr(some, name)
    back = [ORDER.index(name) for name in axes]
    return Solution(
        **{name: array.transpose(back) for name, array in values.items()},
        conditions=dict(zip(axes, np.ix_(*axes.values()), strict=True)),
    )


class _Surface:
    """All loads and films on a surface of one roughness; arrays have the shape (films, loads)."""

    def __init__(self, axes: Mapping[str, NDArray], roughness: float, parameters: Parameters):
        self.load, self.roughness, self.parameters = axes["load"], roughness, parameters
        self.log_load = np.log(self.load)
        viscosity = axes["viscosity"][axes["viscosity"] > 0.0]
        self.film = Film.of(viscosity[:, np.newaxis], roughness, parameters)
        self.log_total = log_load_parameter(self.log_load, parameters)  # ln W of F_t
        self.alone = parameters.ball_radius * self.film.thickness(self.log_total)[0]

    def solved(
        self, diameter: NDArray, density: NDArray, rtol: float, variables: Collection[str]
    ) -> Iterator[dict]:
        """Yield for each particle size and density the variables by name, dry and with films, and
        which points with films are ``unsure``: those to solve individually."""
        dry = self._dry(diameter, density, rtol, variables)
        beyond = self.load > greatest_single_load(self.parameters)
        films_share = self.parameters.interpretation.film_load.depends_on_shares
        half = log_load_parameter(np.log(0.5 * self.load[0]), self.parameters)
        farthest = self.parameters.ball_radius * self.film.thickness(half)[0].max()
        low = np.nan_to_num(0.999 * dry["separation"][-1])
        high = 1.001 * np.fmax(farthest, dry["separation"][0])
        film = [self._log_film(low.min(), high.max())] if films_share else []
        for number, table in enumerate(self._tables(diameter, density, low, high)):
            with_particles = bool(has_particles(diameter[number], density[number]))
            found = (self._by_newton if films_share else self._explicit)(table, *film)
            add_flags(found, self.film, self.log_load, self.parameters, with_particles)
            unsure = ~(found["error_bound"] <= rtol)
            unsure |= found["total_contact_area"] < TINY  # where float64 loses digits
            unsure |= beyond & with_particles
            alone = {name: each[1:, number] for name, each in dry.items()}
            carried = found["fluid_load_fraction"] <= 0.0  # by the solids, at their dry separation
            if carried.any():
                for name in variables:
                    found[name] = np.where(carried, alone[name], found[name])
            yield {name: (alone[name], found[name]) for name in variables} | {"unsure": unsure}

    def _dry(self, diameter, density, rtol, variables):
        """Variables of dry contact by name, at half the least load and at all loads: shape (loads +
        1, solids)."""
        load = np.append(0.5 * self.load[0], self.load)[:, np.newaxis]
        columns = load, np.zeros(1), diameter, np.full(1, self.roughness), density
        given = dict(zip(CONDITIONS, columns, strict=True))
        names = dict.fromkeys([*variables, "separation"])
        found = solve_arrays(given, self.parameters, rtol, names)
        return {name: getattr(found, name) for name in names}

    def _tables(self, diameter, density, low, high):
        """Yield a table for each of the solids: cubic Hermite polynomials over d from ``low`` to ``high``.

        Its columns are ln F_ss, A_sa and ln A_ss (the summits beside the particles), their slopes,
        the relative error of F_s, and of areas and their ratios.
        """

        def contact(solid):
            columns = diameter[solid], np.full(solid.size, self.roughness), density[solid]
            return make_contact(*columns, self.parameters, SUMMIT_RTOL)

        every = contact(np.arange(diameter.size))
        separations = [
            _separations(*ends, self.roughness, every.particles, solid)
            for solid, ends in enumerate(zip(low, high, strict=True))
        ]
        stops = np.cumsum([each.size for each in separations])
        solid = np.repeat(np.arange(diameter.size), np.diff(stops, prepend=0))
        d = np.concatenate(separations)
        value, slope = np.split(_parts(contact(solid), d), 2, axis=1)
        # all cells; those between one solid and the next are not used
        width, rise = np.diff(d)[:, np.newaxis], np.diff(value, axis=0)
        middle = 0.5 * (value[:-1] + value[1:]) - 0.125 * width * np.diff(slope, axis=0)
        between = _parts(contact(solid[:-1]), d[:-1] + 0.5 * width[:, 0])
        errors = _errors(middle, between, self.parameters.particle_pressure)
        steepness = slope[:-1] + slope[1:] - 2.0 * rise / width
        cubic = steepness / width**2
        square = (rise / width - slope[:-1] - steepness) / width
        nothing = np.zeros_like(cubic)
        columns = (
            [cubic, nothing, nothing[:, :2]],
            [square, 3.0 * cubic, nothing[:, :2]],
            [slope[:-1], 2.0 * square, nothing[:, :2]],
            [value[:-1], slope[:-1], errors],
        )
        powers = np.stack([np.concatenate(each, axis=1) for each in columns])
        for places, stop in zip(separations, stops, strict=True):
            cells = slice(stop - places.size, stop - 1)
            yield scipy.interpolate.PPoly.construct_fast(
                np.ascontiguousarray(powers[:, cells]), places
            )

    def _explicit(self, table):
        """Solve Eq. 1 where the total load gives the film thickness: d is known."""
        d = np.clip(self.alone, table.x[0], table.x[-1])
        log_summits, area, log_area, *_, load_error, area_error = np.moveaxis(table(d), -1, 0)
        solid = self._summits(log_summits) + self._particles(area)
        fluid = 1.0 - solid
        error = area_error + load_error * np.maximum(1.0, solid / fluid)
        error[np.abs(fluid) <= load_error] = np.inf
        return self._variables(d, solid, fluid, area, np.exp(log_area), error)

    def _by_newton(self, table, log_film):
        """Solve Eq. 1 where the film load gives its thickness: Newton's method for ln L_f.

        The effect of the last change of d is expanded about the previous d.
        """
        radius, low, high = self.parameters.ball_radius, table.x[0], table.x[-1]
        places = table.x[::-1]
        log_summits, area, *_ = table(places).T
        log_solid = np.logaddexp(log_summits, np.log(area * self.parameters.particle_pressure))
        log_solid = np.nan_to_num(log_solid, nan=MOST_LOG_LOAD, neginf=-np.inf)
        log_film = log_film(places)
        held = np.logaddexp(log_solid, log_film)
        # all films in a single interpolation, shifted apart
        apart = np.arange(len(held))[:, np.newaxis] * (np.ptp(held) + 1.0)
        wanted = np.clip(self.log_load, held[:, :1], held[:, -1:]) + apart
        log_fluid = np.interp(wanted, (held + apart).ravel(), log_film.ravel()) - self.log_load
        log_fluid = np.minimum(log_fluid, 0.0)
        step = np.inf
        for _ in range(NEWTON_STEPS):
            thickness, widening = self.film.thickness(self.log_total + log_fluid)
            d, widening = radius * thickness, radius * widening
            columns = np.moveaxis(table(np.clip(d, low, high)), -1, 0)
            log_summits, area, log_area, slope, area_slope, log_area_slope, *errors = columns
            summits, fluid = self._summits(log_summits), np.exp(log_fluid)
            solid = summits + self._particles(area)
            total = solid + fluid
            fall = (summits * slope + self._particles(area_slope)) / solid  # d ln F_s/dd
            gain = (solid * fall * widening + fluid) / total
            last, step = step, -np.log(total) / gain
            log_fluid = log_fluid + step
        change = widening * step  # of d
        steepest = np.where(area > 0.0, np.abs(area_slope) / area, 0.0)
        for each in (slope, log_area_slope, 1.0 / d):
            steepest = np.maximum(steepest, np.abs(each))
        fluid = np.exp(log_fluid)
        solid = np.where(fluid < 0.5, 1.0 - fluid, solid * np.exp(fall * change))
        area = np.maximum(area + area_slope * change, 0.0)
        load_error, area_error = errors
        unknown = 2.0 * step**2 / (np.abs(last) + TINY) + load_error * solid / gain  # of ln L_f
        error = area_error + load_error + unknown * np.maximum(1.0, steepest * np.abs(widening))
        error += (steepest * change) ** 2
        summit_area = np.exp(log_area + log_area_slope * change)
        return self._variables(d + change, solid, fluid, area, summit_area, error)

    def _variables(self, d, solid, fluid, area, summit_area, error):
        """Variables by name (Eqs. 3, 9 and 10)."""
        total_area = area + summit_area
        ratios = area / total_area, summit_area / total_area
        values = total_area, *ratios, solid, fluid, d, d / self.parameters.ball_radius
        found = dict(zip(QUANTITIES, values, strict=True))
        return found | {"separation_count": np.ones(d.shape, np.int8), "error_bound": error}

    def _log_film(self, low, high):
        """ln F_f* of films over the separation [m], accurate enough to start Newton's method."""
        places = np.geomspace(max(low, 0.5 * self.alone.min()), high, GUESSES)
        log_film, _ = self.film.load_parameter_and_slope(places / self.parameters.ball_radius)
        log_film -= log_load_parameter(0.0, self.parameters)
        return scipy.interpolate.make_interp_spline(places, log_film, k=1, axis=-1)

    def _summits(self, log_load):
        """Fraction of F_t carried by summits."""
        return np.exp(log_load - self.log_load)

    def _particles(self, area):
        """Fraction of F_t carried by particles with the ``area`` A_sa (Eqs. 4 and 5)."""
        return area * (self.parameters.particle_pressure / self.load)


def _separations(low, high, roughness, particles, solid):
    """Separations [m] from ``low`` to ``high``: finer over the particle sizes, and on both sides of
    every kink."""
    ends = np.arcsinh(np.array([low, high]) / roughness)
    steps = int(np.ceil((ends[1] - ends[0]) / STEP)) + 1
    places = [roughness * np.sinh(np.linspace(*ends, steps + 1)), [low, high]]
    if particles is not None:
        one = particles.take(solid)
        mean, spread, depth = one.mean, one.spread, one.depth
        smallest, largest = particles.moment.smallest, particles.moment.largest
        for shift in (0.0, particles.parameters.interpretation.elastic_limits.side * depth):
            first = max(smallest, LOWEST)
            places.append(mean + spread * (first + SIZES * (largest - first) - shift))
            for kink in (smallest, largest):
                beside = KINK_GAP * (mean + spread * (abs(kink) + abs(shift)))
                places.append(mean + spread * (kink - shift) + beside * np.array([-1.0, 1.0]))
    return np.unique(np.clip(np.concatenate(places), low, high))


def _parts(contact, d):
    """ln F_ss, A_sa and ln A_ss, of the summits beside the particles, and their slopes: shape (n, 6).

    nan where particles cover everything.
    """
    solids = contact.at(d, with_areas=True)
    parts = solids.log_summit_load, solids.particle_area, solids.log_summit_area
    values, slopes = zip(*parts, strict=True)
    parts = np.stack([*values, *slopes], axis=1)
    if contact.particles is not None:
        parts[contact.particles.cover_all(solids.coverage)] = np.nan
    return parts


def _errors(found, true, pressure):
    """Bounds on the relative error of F_s, and of areas and their ratios, from the errors midway
    between separations: shape (n, 2)."""
    summits, area = np.exp(true[:, 0]), pressure * true[:, 1]
    load = summits * np.expm1(found[:, 0] - true[:, 0]) + pressure * (found[:, 1] - true[:, 1])
    load_error = np.where(summits + area > 0.0, np.abs(load) / (summits + area), 0.0)
    area_error = np.where(area > 0.0, np.abs(found[:, 1] / true[:, 1] - 1.0), 0.0)
    area_error += np.abs(found[:, 2] - true[:, 2])
    errors = SAFETY * np.stack([load_error, area_error], axis=1) + SUMMIT_RTOL
    return np.where(np.isfinite(errors), errors, np.inf)
