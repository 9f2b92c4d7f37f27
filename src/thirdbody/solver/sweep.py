"""Grids to three digits: what depends on the separation d alone is evaluated once and interpolated.

On a surface with given particles F_ss, A_ss and A_sa are functions of d alone (Eqs. 2-6), whatever
the load and the lubricant.  They are evaluated at some hundred separations and interpolated between
them by cubic Hermite polynomials.  Eq. 1 is then solved at all loads and viscosities at once.  Dry
contact, and points at which the interpolation is not as good as ``rtol``, are solved one by one.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline, PPoly

from thirdbody.model.contact import greatest_single_load
from thirdbody.model.film import THICKEST, Film, log_load_parameter
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import TINY, has_particles, log_bare_share
from thirdbody.model.regimes import FILM_COUNTS, contact_mode, gravest_status, lubrication_regime
from thirdbody.progress import Progress
from thirdbody.solver.points import make_contact
from thirdbody.solver.solution import Solution, type_of
from thirdbody.solver.solve import solve_arrays

LEAST_RTOL = 1e-3  # interpolation does not reach a smaller error
FEWEST_POINTS = 500  # of one surface and particle size; fewer are solved one by one
STEP = 0.06  # of asinh(d/sigma) between separations
# from the smallest to the largest particle, closing in on that
SIZES = np.concatenate([np.linspace(0.0, 1.0, 40), 1.0 - np.geomspace(1e-7, 0.02, 14)])
LOWEST = -6.0  # (size - mean)/spread below which particles do not matter
BESIDE = 1e-12  # relative distance of the separations on both sides of a kink
SAFETY = 2.0  # times the error in the middle between two separations
SUMMIT_RTOL = 1e-7  # error of the summits' load and area
# of dry contact
NEEDED = (
    *("separation", "solid_load_fraction", "fluid_load_fraction", "total_contact_area"),
    *("particle_contact_area_ratio", "surface_contact_area_ratio"),
    *("solution_status", "error_bound"),
)
NEWTON_STEPS = 2  # from between two separations
ORDER = "particle_diameter", "roughness", "particle_density", "viscosity", "load"  # in memory
LOAD_SLOPE = 3  # column of a table


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
        Relative error asked for, at least ``LEAST_RTOL``.
    variables : collection of str
        Names of the fields of ``Solution`` that are wanted.
    progress : bool
        Whether a call that takes long reports its progress.

    Returns
    -------
    Solution
        Arrays over the five axes.  ``error_bound`` is twice the error of the interpolation in the
        middle between two separations, in the quantity that it affects most, plus the error that
        the iteration leaves.
    """
    shape = tuple(axes[name].size for name in ORDER)
    values = {name: np.empty(shape, type_of(name)) for name in variables}
    left = np.zeros(shape, bool)
    with np.errstate(all="ignore"), Progress(left.size, "points", progress) as shown:
        for number, roughness in enumerate(axes["roughness"]):
            surface = _Surface(axes, roughness, parameters, rtol, variables)
            for place, found, unsure in surface.solids():
                at = place[0], number, place[1]
                for name, array in values.items():
                    array[at] = found[name]
                left[at] = unsure
                shown.add(unsure.size)
        index = np.nonzero(left)
        if index[0].size:
            given = {name: axes[name][place] for name, place in zip(ORDER, index, strict=True)}
            given = {name: given[name] for name in axes}
            solved = solve_arrays(given, parameters, rtol, variables)
            for name, array in values.items():
                array[index] = getattr(solved, name)
    back = [ORDER.index(name) for name in axes]
    return Solution(
        **{name: array.transpose(back) for name, array in values.items()},
        conditions=dict(zip(axes, np.ix_(*axes.values()), strict=True)),
    )


@dataclass
class _Surface:
    """The points of one roughness."""

    axes: Mapping[str, NDArray]
    roughness: float
    parameters: Parameters
    rtol: float
    variables: Collection[str]

    def __post_init__(self):
        self.load, viscosity = self.axes["load"], self.axes["viscosity"]
        self.log_load = np.log(self.load)
        self.wet = viscosity > 0.0
        self.film = Film.of(viscosity[self.wet, np.newaxis], self.roughness, self.parameters)
        self.log_total = log_load_parameter(self.log_load, self.parameters)  # ln W of F_t
        thickness, _ = self.film.thickness(self.log_total)
        self.alone = self.parameters.ball_radius * thickness  # of films that carry all
        self.shares = self.parameters.readings.film_load.depends_on_shares

    def solids(self):
        """Yield the place of each pair of size and density, its values over viscosity and load by
        name, and which of these are to be solved one by one."""
        sizes, densities = np.meshgrid(
            self.axes["particle_diameter"], self.axes["particle_density"], indexing="ij"
        )
        three_body = has_particles(sizes, densities)
        for kind in (False, True):
            places = np.argwhere(three_body == kind)
            chosen = places if kind else places[:1]  # all two-body contacts are the same
            if not places.size:
                continue
            solids = sizes[tuple(chosen.T)], densities[tuple(chosen.T)]
            dry = self._dry(*solids)
            for number, table in enumerate(self._tables(*solids, dry["separation"])):
                found, unsure = self._points(
                    table, {name: each[1:, number] for name, each in dry.items()}, kind
                )
                for place in chosen[number : number + 1] if kind else places:
                    yield place, found, unsure

    def _dry(self, diameter, density):
        """Variables of dry contact by name, at half of the least load and at all loads: shape
        (loads + 1, solids)."""
        given = {
            "load": np.append(0.5 * self.load[0], self.load)[:, np.newaxis],
            "viscosity": np.zeros(1),
            "particle_diameter": diameter,
            "roughness": np.full(1, self.roughness),
            "particle_density": density,
        }
        names = dict.fromkeys([*self.variables, *NEEDED])
        found = solve_arrays(given, self.parameters, self.rtol, names)
        return {name: getattr(found, name) for name in names}

    def _tables(self, diameter, density, dry):
        """Yield a table for each of some solids: columns over d.

        These are ln F_ss, A_sa and ln A_ss (the summits beside the particles), their slopes, the
        relative error of F_s, and that of areas and their ratios.
        """
        half = log_load_parameter(np.log(0.5 * self.load[0]), self.parameters)
        farthest = self.parameters.ball_radius * self.film.thickness(half)[0].max()
        low = np.nan_to_num(0.999 * dry[-1])
        high = 1.001 * np.fmax(farthest, dry[0])
        one = np.full_like(diameter, self.roughness)
        contact = make_contact(diameter, one, density, self.parameters, SUMMIT_RTOL)
        separations = [
            _separations(*ends, self.roughness, contact.particles, solid)
            for solid, ends in enumerate(zip(low, high, strict=True))
        ]
        middles = [0.5 * (each[:-1] + each[1:]) for each in separations]
        d = np.concatenate([*separations, *middles])
        counts = [each.size for each in (*separations, *middles)]
        solid = np.repeat(np.tile(np.arange(diameter.size), 2), counts)
        contact = make_contact(
            diameter[solid], one[solid], density[solid], self.parameters, SUMMIT_RTOL
        )
        pieces = np.split(_parts(contact, d), np.cumsum(counts)[:-1])
        pressure = self.parameters.particle_pressure
        for place, middle, known, between in zip(
            separations, middles, pieces[: diameter.size], pieces[diameter.size :], strict=True
        ):
            unknown = ~np.isfinite(known).all(axis=1)
            known[unknown] = 0.0
            curve = CubicHermiteSpline(place, known[:, :3], known[:, 3:6])
            errors = _errors(curve(middle), between, pressure)
            errors[unknown[:-1] | unknown[1:]] = np.inf
            order, cells, _ = curve.c.shape
            slopes = np.zeros_like(curve.c)
            slopes[1:] = curve.c[:-1] * np.arange(order - 1, 0, -1)[:, np.newaxis, np.newaxis]
            constant = np.zeros((order, cells, 2))
            constant[-1] = errors
            yield PPoly(np.concatenate([curve.c, slopes, constant], axis=2), place)

    def _points(self, table, dry, has_particles):
        """Variables over viscosity and load by name, and which points to solve one by one."""
        found = (self._shared if self.shares else self._total)(table, dry)
        fluid, d = found["fluid_load_fraction"], found["separation"]
        share = self.parameters.readings.film_load.log_share(np.log(fluid))
        outside = ~self.film.is_meaningful(self.log_total + share)
        found["film_thickness"] = d / self.parameters.ball_radius
        outside |= found["film_thickness"] > THICKEST
        own = gravest_status(
            area_exceeded=found["total_contact_area"] > 1.0,
            outside_film_formula=outside & (fluid > FILM_COUNTS),
        )
        solid = found["solid_load_fraction"]
        found["solution_status"] = np.where(solid == 1.0, dry["solution_status"], own)
        found["lubrication_regime"] = lubrication_regime(solid)
        found["contact_mode"] = contact_mode(found["particle_contact_area_ratio"], has_particles)
        found["separation_count"] = np.ones(d.shape, np.int8)
        unsure = ~(found["error_bound"] <= self.rtol)
        unsure |= found["total_contact_area"] < TINY  # where float64 loses digits
        if has_particles:
            unsure |= self.load > greatest_single_load(self.parameters)
        if self.wet.all():
            return found, unsure
        places = np.cumsum(self.wet) - 1
        return (
            {
                name: np.where(self.wet[:, np.newaxis], found[name][places], dry[name])
                for name in self.variables
            },
            np.where(self.wet[:, np.newaxis], unsure[places], False),
        )

    def _total(self, table, dry):
        """Eq. 1 where the film's thickness follows from the total load: d is known."""
        d = np.clip(self.alone, table.x[0], table.x[-1])
        log_summits, area, log_area, *_, load_error, area_error = np.moveaxis(table(d), -1, 0)
        solid = self._summits(log_summits) + self._particles(area)
        fluid = 1.0 - solid
        summit_area = np.exp(log_area)
        total_area = area + summit_area
        found = {
            "separation": d,
            "solid_load_fraction": solid,
            "fluid_load_fraction": fluid,
            "total_contact_area": total_area,
            "particle_contact_area_ratio": area / total_area,
            "surface_contact_area_ratio": summit_area / total_area,
            "error_bound": area_error + load_error * np.maximum(1.0, solid / fluid),
        }
        carried = fluid <= 0.0  # by the solids alone, at their dry separation
        for name, values in found.items():
            found[name] = np.where(carried, dry[name], values)
        found["error_bound"][np.abs(fluid) <= load_error] = np.inf
        return found

    def _shared(self, table, dry):
        """Eq. 1 where the film's thickness follows from its own load: Newton's method for ln L_f.

        It begins between two separations of the table.
        """
        radius = self.parameters.ball_radius
        log_summits, area = table(table.x)[:, :2].T
        log_solid = np.logaddexp(log_summits, np.log(area * self.parameters.particle_pressure))
        log_film = self.film.load_parameter(table.x / radius)
        log_film = log_film - log_load_parameter(0.0, self.parameters)
        log_fluid = np.empty(self.alone.shape)
        for guess, film in zip(log_fluid, log_film, strict=True):
            held = np.logaddexp(log_solid, film)[::-1]
            guess[:] = np.interp(self.log_load, held, film[::-1]) - self.log_load
        step = np.inf
        for _ in range(NEWTON_STEPS):
            thickness, widening = self.film.thickness(self.log_total + log_fluid)
            d, widening = radius * thickness, radius * widening
            columns = np.moveaxis(table(np.clip(d, table.x[0], table.x[-1])), -1, 0)
            log_summits, area, log_area, slope, area_slope, log_area_slope, *errors = columns
            summits, fluid = self._summits(log_summits), np.exp(log_fluid)
            solid = summits + self._particles(area)
            total = solid + fluid
            slope = (summits * slope + self._particles(area_slope)) / solid  # d ln F_s/dd
            gain = (solid * slope * widening + fluid) / total
            last, step = step, -np.log(total) / gain
            log_fluid = log_fluid + step
        change = widening * step  # of d; what follows from it is expanded about the last place
        steepest = np.where(area > 0.0, np.abs(area_slope) / area, 0.0)
        for each in (columns[LOAD_SLOPE], log_area_slope, 1.0 / d):
            steepest = np.maximum(steepest, np.abs(each))
        area = np.maximum(area + area_slope * change, 0.0)
        summit_area = np.exp(log_area + log_area_slope * change)
        total_area = area + summit_area
        fluid = np.exp(log_fluid)
        solid = np.where(fluid < 0.5, 1.0 - fluid, solid * np.exp(slope * change))
        load_error, area_error = errors
        unknown = 2.0 * step**2 / np.abs(last) + load_error * solid / gain  # of ln L_f
        magnified = np.maximum(1.0, steepest * np.abs(widening))
        return {
            "separation": d + change,
            "solid_load_fraction": solid,
            "fluid_load_fraction": fluid,
            "total_contact_area": total_area,
            "particle_contact_area_ratio": area / total_area,
            "surface_contact_area_ratio": summit_area / total_area,
            "error_bound": area_error + load_error + unknown * magnified + (steepest * change) ** 2,
        }

    def _summits(self, log_load):
        """Fraction of F_t that the summits carry."""
        return np.exp(log_load - self.log_load)

    def _particles(self, area):
        """Fraction of F_t that particles of the ``area`` A_sa carry (Eqs. 4 and 5)."""
        return area * (self.parameters.particle_pressure / self.load)


def _separations(low, high, roughness, particles, solid):
    """Separations [m] from ``low`` to ``high``: closer where sizes matter, and on both sides of every
    kink."""
    ends = np.arcsinh(np.array([low, high]) / roughness)
    steps = int(np.ceil((ends[1] - ends[0]) / STEP)) + 1
    places = [roughness * np.sinh(np.linspace(*ends, steps + 1)), [low, high]]
    if particles is not None:
        mean, spread, depth = (
            each[solid] for each in (particles.mean, particles.spread, particles.depth)
        )
        smallest, largest = particles.moment.smallest, particles.moment.largest
        for shift in (0.0, particles.parameters.readings.elastic_limits.side * depth):
            first = max(smallest, LOWEST)
            places.append(mean + spread * (first + SIZES * (largest - first) - shift))
            for kink in (smallest, largest):
                beside = BESIDE * (mean + spread * (abs(kink) + abs(shift)))
                places.append(mean + spread * (kink - shift) + beside * np.array([-1.0, 1.0]))
    return np.unique(np.clip(np.concatenate(places), low, high))


def _parts(contact, d):
    """ln F_ss, A_sa and ln A_ss, of the summits beside the particles, and their slopes: shape (n, 6).

    nan where particles cover everything.
    """
    t = contact.summit_separation(d)
    log_load, load_slope = contact.summits.log_load(t)
    log_area, area_slope = contact.summits.log_area(t)
    deviation = contact.summits.deviation
    load_slope, area_slope = load_slope / deviation, area_slope / deviation
    if contact.particles is None:
        nothing = np.zeros_like(d)
        parts = log_load, nothing, log_area, load_slope, nothing, area_slope
        return np.stack(parts, axis=1)
    area, slope, *coverage = contact.particles.contact(d)
    bare_load, bare_load_slope = contact.particles.log_bare_load(*coverage)  # Eq. 4
    bare_area, bare_area_slope = log_bare_share(*coverage)  # Eq. 5
    parts = np.stack(
        [
            log_load + bare_load,
            area,
            log_area + bare_area,
            load_slope + bare_load_slope,
            slope,
            area_slope + bare_area_slope,
        ],
        axis=1,
    )
    parts[contact.particles.leave_no_room(coverage[0])] = np.nan
    return parts


def _errors(found, true, pressure):
    """Bounds on the relative error of F_s, and of areas and their ratios, from those in the middle
    between separations: shape (n, 2)."""
    load = np.exp(found[:, 0] - true[:, 0]) - 1.0
    area = np.where(true[:, 1] > 0.0, found[:, 1] / true[:, 1] - 1.0, 0.0)
    odds = np.exp(np.log(pressure * true[:, 1]) - true[:, 0])  # of particles to summits
    fraction = np.where(odds > 0.0, odds / (1.0 + odds), 0.0)
    fraction = np.where(np.isinf(odds), 1.0, fraction)
    load_error = np.abs(load * (1.0 - fraction) + area * fraction)
    area_error = np.abs(area) + np.abs(found[:, 2] - true[:, 2])
    errors = SAFETY * np.stack([load_error, area_error], axis=1) + SUMMIT_RTOL
    return np.where(np.isfinite(errors), errors, np.inf)
