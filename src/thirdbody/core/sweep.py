"""Grids to three digits, interpolated over the separation d.

For given surfaces and particles, F_ss, A_ss and A_sa depend only on d (Eqs. 2-6), not on load and
lubricant.  ``solid_tables`` tabulates them.  Newton's method for ln L_f then solves Eq. 1 at all
loads and viscosities together.  Dry contact, and points where the interpolation error exceeds
``rtol``, are solved individually.
"""

from collections.abc import Callable, Collection, Iterator, Mapping
from typing import NamedTuple

import numpy as np
import scipy  # scipy.interpolate is loaded on first use: many jobs do not need it
from numpy.typing import NDArray

from thirdbody.core.film import Film, has_film, log_load_parameter
from thirdbody.core.logarithms import TINY
from thirdbody.core.names import ERROR_BOUND, FLUID_LOAD_FRACTION, SEPARATION, TOTAL_CONTACT_AREA
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import has_particles
from thirdbody.core.solid_tables import TabulatedSolids, solid_tables
from thirdbody.core.solve import solve_points
from thirdbody.core.state import add_flags, quantities, type_of

LEAST_RTOL = 1e-3  # interpolation does not reach a smaller error
FEWEST_POINTS = 500  # with the same solids; fewer points are faster individually
MOST_LOG_LOAD = 10.0  # ln F_s* in place of infinity where particles cover everything
PAIRS = 500  # pairs of particle size and density whose tables are made together
FILM_SAMPLES = 200  # separations in the table of films that starts Newton's method
ORDER = "particle_diameter", "roughness", "particle_density", "viscosity", "load"  # in memory


def is_worthwhile(axes: Mapping[str, NDArray], rtol: float) -> bool:
    """Whether ``sweep`` solves a grid over ``axes`` faster than point by point."""
    films = int(np.count_nonzero(axes["viscosity"]))
    return rtol >= LEAST_RTOL and films > 1 and films * axes["load"].size >= FEWEST_POINTS


def sweep(
    axes: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    variables: Collection[str],
    callback: Callable[[int], None] | None = None,
) -> dict[str, NDArray]:
    """Solve all combinations of five axes by interpolation over the separation.

    Parameters
    ----------
    axes : mapping
        Load [1], viscosity [m2/s], particle size x_a [m], roughness [m] and particle density [m-2]
        by name; 1-D and increasing.
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Requested relative error, at least ``LEAST_RTOL``.
    variables : collection of str
        Names of the variables to return, among those of ``state.describe``.
    callback : callable, optional
        Called with the number of points that have been solved since its last call.

    Returns
    -------
    dict of arrays
        The variables by name, with the dimensions in the order of ``axes``.  ``error_bound`` is
        twice the interpolation error midway between two separations, for the quantity with the
        largest error, plus the remaining error of the iteration.
    """
    shape = tuple(axes[name].size for name in ORDER)
    values = {name: np.empty(shape, type_of(name)) for name in variables}
    unsure = np.zeros(shape, bool)
    dry_count = np.count_nonzero(~has_film(axes["viscosity"]))  # dry rows come first
    sizes, densities = axes["particle_diameter"], axes["particle_density"]
    with np.errstate(all="ignore"):
        for number, roughness in enumerate(axes["roughness"]):
            surface = _Surface(axes, roughness, parameters)
            for size, density in _pairs(sizes, densities):
                solids = surface.solved(sizes[size], densities[density], rtol, values)
                for i, j, solved in zip(size, density, solids, strict=True):
                    at = i, number, j
                    for name, array in values.items():
                        array[at][:dry_count], array[at][dry_count:] = (
                            solved.dry[name],
                            solved.films[name],
                        )
                    unsure[at][dry_count:] = solved.unsure
                    if callback is not None:
                        callback(unsure[at].size)
        index = np.nonzero(unsure)
        if index[0].size:
            points = {name: axes[name][which] for name, which in zip(ORDER, index, strict=True)}
            solved_alone = solve_points(points, parameters, rtol, variables)
            for name, array in values.items():
                array[index] = solved_alone[name]
    back = [ORDER.index(name) for name in axes]
    return {name: array.transpose(back) for name, array in values.items()}


def _pairs(sizes, densities):
    """Yield indices of particle sizes and of densities, at most ``PAIRS`` pairs at a time.

    All pairs of a batch have particles, or none has.
    """
    three_body = has_particles(sizes[:, np.newaxis], densities)
    for alike in (three_body, ~three_body):
        size, density = np.nonzero(alike)
        for start in range(0, size.size, PAIRS):
            yield size[start : start + PAIRS], density[start : start + PAIRS]


class _Solved(NamedTuple):
    """Variables by name for a particle size and density.

    Those in ``dry`` contact have the shape (loads,), those with ``films`` (films, loads).
    ``unsure`` marks the points with films that must be solved individually.
    """

    dry: dict[str, NDArray]
    films: dict[str, NDArray]
    unsure: NDArray


class _Step(NamedTuple):
    """A step of Newton's method: the ``change`` of ln L_f, and the state before it.

    ``solids`` at the ``separation`` d [m] carry the fraction ``solid`` of F_t.  ``fall`` is
    d ln F_s/dd [m-1], ``widening`` is dd/d ln L_f [m], ``gain`` is d ln(F_s + F_f)/d ln L_f [1].
    """

    separation: NDArray
    solids: TabulatedSolids
    solid: NDArray
    fall: NDArray
    widening: NDArray
    gain: NDArray
    change: NDArray


class _Surface:
    """All loads and films at a single roughness; arrays have the shape (films, loads)."""

    def __init__(self, axes: Mapping[str, NDArray], roughness: float, parameters: Parameters):
        self.load, self.roughness, self.parameters = axes["load"], roughness, parameters
        self.log_load = np.log(self.load)
        viscosity = axes["viscosity"][has_film(axes["viscosity"])]
        self.film = Film.of(viscosity[:, np.newaxis], roughness, parameters)
        self.films_share = parameters.film_shares_load
        self.log_total = log_load_parameter(self.log_load, parameters)  # ln W of F_t
        self.film_separation = parameters.ball_radius * self.film.thickness(self.log_total)[0]

    def solved(
        self, diameter: NDArray, density: NDArray, rtol: float, variables: Collection[str]
    ) -> Iterator[_Solved]:
        """Yield the variables for every pair of particle size and density."""
        dry = self._dry(diameter, density, rtol, variables)
        low, high = self._ends(dry[SEPARATION])
        log_film = self._log_film(low.min(), high.max()) if self.films_share else None
        roughness = np.full(diameter.shape, self.roughness)
        tables = solid_tables(diameter, roughness, density, low, high, self.parameters)
        for number, table in enumerate(tables):
            with_particles = bool(has_particles(diameter[number], density[number]))
            films = self._sharing(table, log_film) if self.films_share else self._explicit(table)
            add_flags(films, self.film, self.log_load, self.parameters, with_particles)
            unsure = ~(films[ERROR_BOUND] <= rtol)
            unsure |= films[TOTAL_CONTACT_AREA] < TINY  # where float64 loses digits
            alone = {name: dry[name][1:, number] for name in variables}
            carried = films[FLUID_LOAD_FRACTION] <= 0.0  # by the solids, at their dry separation
            if carried.any():
                for name in variables:
                    films[name] = np.where(carried, alone[name], films[name])
            yield _Solved(dry=alone, films=films, unsure=unsure)

    def _dry(self, diameter, density, rtol, variables):
        """Variables of dry contact by name, at half the least load and at all loads.

        Their shape is (loads + 1, solids).
        """
        points = {
            "load": np.append(0.5 * self.load[0], self.load)[:, np.newaxis],
            "viscosity": np.zeros(1),
            "particle_diameter": diameter,
            "roughness": np.full(1, self.roughness),
            "particle_density": density,
        }
        names = dict.fromkeys([*variables, SEPARATION])
        return solve_points(points, self.parameters, rtol, names)

    def _ends(self, dry_separation):
        """The least and the largest separation [m] of the solids under all loads and films."""
        half = log_load_parameter(np.log(0.5 * self.load[0]), self.parameters)
        farthest = self.parameters.ball_radius * self.film.thickness(half)[0].max()
        low = np.nan_to_num(0.999 * dry_separation[-1])
        return low, 1.001 * np.fmax(farthest, dry_separation[0])

    def _explicit(self, table):
        """Solve Eq. 1 if F_t determines the film thickness: d is then known."""
        solids = table(self.film_separation)
        area = solids.particle_area.value
        solid = self._summits(solids.log_summit_load.value) + self._particles(area)
        fluid = 1.0 - solid
        error = solids.area_error + solids.load_error * np.maximum(1.0, solid / fluid)
        error[np.abs(fluid) <= solids.load_error] = np.inf
        return self._variables(
            separation=np.clip(self.film_separation, *table.ends),
            solid_load_fraction=solid,
            fluid_load_fraction=fluid,
            particle_area=area,
            log_summit_area=solids.log_summit_area.value,
            error=error,
        )

    def _sharing(self, table, log_film):
        """Solve Eq. 1 if F_f determines the film thickness, with two Newton steps for ln L_f.

        The solids after the last step are expanded about the separation before it.
        """
        log_fluid = self._first_fluid(table, log_film)
        first = self._step(table, log_fluid)
        step = self._step(table, log_fluid + first.change)
        fluid = np.exp(log_fluid + first.change + step.change)
        solids, change = step.solids, step.widening * step.change  # change of d
        solid = np.where(fluid < 0.5, 1.0 - fluid, step.solid * np.exp(step.fall * change))
        area, log_summit_area = solids.particle_area, solids.log_summit_area
        return self._variables(
            separation=step.separation + change,
            solid_load_fraction=solid,
            fluid_load_fraction=fluid,
            particle_area=np.maximum(area.value + area.slope * change, 0.0),
            log_summit_area=log_summit_area.value + log_summit_area.slope * change,
            error=_error_after(step, first.change, solid),
        )

    def _first_fluid(self, table, log_film):
        """Approximate ln L_f.

        It is interpolated over F_s + F_f, which is known at the separations of the table.
        """
        separations = table.separations[::-1]
        solids = table(separations)
        log_particles = np.log(solids.particle_area.value * self.parameters.particle_pressure)
        log_solid = np.logaddexp(solids.log_summit_load.value, log_particles)
        log_solid = np.nan_to_num(log_solid, nan=MOST_LOG_LOAD, neginf=-np.inf)
        log_film = log_film(separations)
        log_load = np.logaddexp(log_solid, log_film)
        # a single interpolation for all films, whose loads are shifted so that they do not overlap
        apart = np.arange(len(log_load))[:, np.newaxis] * (np.ptp(log_load) + 1.0)
        log_total = np.clip(self.log_load, log_load[:, :1], log_load[:, -1:]) + apart
        log_film = np.interp(log_total, (log_load + apart).ravel(), log_film.ravel())
        return np.minimum(log_film - self.log_load, 0.0)

    def _step(self, table, log_fluid):
        """The step of Newton's method from ln L_f."""
        thickness, widening = self.film.thickness(self.log_total + log_fluid)
        separation = self.parameters.ball_radius * thickness
        widening = self.parameters.ball_radius * widening
        solids = table(separation)
        summits = self._summits(solids.log_summit_load.value)
        solid = summits + self._particles(solids.particle_area.value)
        fluid = np.exp(log_fluid)
        total = solid + fluid
        slope = summits * solids.log_summit_load.slope + self._particles(solids.particle_area.slope)
        fall = slope / solid
        gain = (solid * fall * widening + fluid) / total
        return _Step(
            separation=separation,
            solids=solids,
            solid=solid,
            fall=fall,
            widening=widening,
            gain=gain,
            change=-np.log(total) / gain,
        )

    def _variables(self, *, error, **state):
        """Variables by name, for the arguments of ``quantities``."""
        return quantities(**state, parameters=self.parameters) | {ERROR_BOUND: error}

    def _log_film(self, low, high):
        """A spline of ln F_f* over the separation [m], accurate enough to start Newton's method."""
        separations = np.geomspace(max(low, 0.5 * self.film_separation.min()), high, FILM_SAMPLES)
        log_film, _ = self.film.log_W_and_slope(separations / self.parameters.ball_radius)
        log_film -= log_load_parameter(0.0, self.parameters)
        return scipy.interpolate.make_interp_spline(separations, log_film, k=1, axis=-1)

    def _summits(self, log_load):
        """Fraction of F_t carried by summits."""
        return np.exp(log_load - self.log_load)

    def _particles(self, area):
        """Fraction of F_t carried by particles with the ``area`` A_sa (Eqs. 4 and 5)."""
        return area * (self.parameters.particle_pressure / self.load)


def _error_after(step, change_before, solid):
    """Relative error [1] after a ``step`` of Newton's method.

    ``change_before`` is the change of ln L_f in the step before, and ``solid`` the fraction of F_t
    that the solids carry after the step.
    """
    solids = step.solids
    area, slope = solids.particle_area
    steepest = np.where(area > 0.0, np.abs(slope) / area, 0.0)
    for slope_of_log in (
        solids.log_summit_load.slope,
        solids.log_summit_area.slope,
        1.0 / step.separation,
    ):
        steepest = np.maximum(steepest, np.abs(slope_of_log))
    left = 2.0 * step.change**2 / (np.abs(change_before) + TINY)  # error of ln L_f
    left = left + solids.load_error * solid / step.gain
    error = solids.area_error + solids.load_error
    error = error + left * np.maximum(1.0, steepest * np.abs(step.widening))
    return error + (steepest * step.widening * step.change) ** 2
