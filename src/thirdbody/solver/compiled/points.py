"""Many points on one sheet, solved by the compiled loop.

The loop balances loads (Eqs. 1, 2 and 4) where ``thirdbody.solver.balance`` balances their
logarithms, which hold the smallest and the largest.  Points at which the loop cannot promise the
error asked for are left to that.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.contact import greatest_single_load
from thirdbody.model.film import THICKEST, Film, greatest_film_load, log_load_parameter
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import FULL, ParticleLayer, has_particles
from thirdbody.model.regimes import (
    FILM_COUNTS,
    NO_FLAG,
    contact_mode,
    gravest_status,
    lubrication_regime,
)
from thirdbody.solver.compiled.layout import (
    BARE,
    BOUND,
    CROSSING_ROOT,
    ELASTIC_SHIFT,
    FILM_ERROR,
    FILM_GAP,
    FLUID_SHARE,
    GAP,
    GIVEN,
    MEAN,
    OFFSET,
    PARTICLE_SHARE,
    PER_CROSSING,
    PER_DEVIATION,
    PER_LOAD,
    PER_SPREAD,
    PLACE,
    PLASTIC_AREA,
    RESULTS,
    ROOT,
    SOLID_SHARE,
    SUMMIT_PARAMETER,
    SURFACE_SHARE,
    TOTAL_AREA,
    Blocks,
)
from thirdbody.solver.compiled.loop import solve_points
from thirdbody.solver.compiled.machine_code import compiled
from thirdbody.solver.compiled.tables import DOUBLE, INTEGERS, precisions, prepare_model
from thirdbody.solver.points import Conditions
from thirdbody.solver.surfaces import Sheet, log_yields, sheet_of_one, summits_of, summits_of_one

OIL_VISCOSITIES = 1e-9, 1e-3  # [m2/s], of any oil
# F_t* of which the summits would bear a share in float64 even beyond their tables
LEAST_LOAD = 1e-20
ROUGHER = 1e6  # by a factor
BLOCKS, ONE = Blocks(), np.int8(1)


class Interfaces:
    """Interfaces as the loop takes them, before it is known what they bear.

    All have a film, or none has; all have particles, or none has.

    Parameters
    ----------
    sheet : Sheet
        The sheet of their surfaces.  On one that is no cell all points have one roughness.
    conditions : Conditions
        The points, all but their loads.
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for.
    real : type
        Type of number to solve in, one of ``precisions(rtol)``.
    """

    def __init__(
        self, sheet: Sheet, conditions: Conditions, parameters: Parameters, rtol: float, real: type
    ):
        self.size, first = conditions.size, conditions.take(0)
        if self.size == 1:  # numbers take a tenth of the time that arrays of one do
            conditions = first
        viscosity, roughness = conditions.viscosity, conditions.roughness
        if sheet.is_cell:
            surface, summits = summits_of(roughness, parameters)
        else:
            roughness = float(first.roughness)
            surface, summits = summits_of_one(roughness, parameters)
        self.parameters, self.rtol, self.real, self.roughness = parameters, rtol, real, roughness
        self.has_particles = bool(has_particles(first.particle_diameter, first.particle_density))
        self.has_film = bool(first.viscosity > 0.0)
        film_is_known = self.has_film and not parameters.readings.film_load.depends_on_shares
        film_shares = self.has_film and not film_is_known
        self.kind = self.has_particles, film_shares, film_is_known
        self.model = prepare_model(sheet, parameters, rtol, real)
        self._columns = np.empty((GIVEN, self.size), real)
        rows = self._rows(self._columns)
        _fill_summits(rows, sheet, surface, summits)
        self._layer = self._film = None
        self.greatest_load, self.may_be_covered = np.inf, False
        if self.has_particles:
            sigma = roughness.astype(real) if sheet.is_cell else roughness
            diameter, density = conditions.particle_diameter, conditions.particle_density
            sizes = diameter.astype(real), sigma, density.astype(real)
            self._layer = ParticleLayer.of(*sizes, parameters)
            _fill_particles(rows, self._layer, sigma)
            self.greatest_load = greatest_single_load(parameters)
            self.may_be_covered = real is DOUBLE and bool((self._layer.log_bare < FULL).any())
        if film_is_known:
            self._film = Film.of(viscosity, roughness, parameters)
        if film_shares:
            _fill_film(rows, roughness, viscosity.astype(real), parameters)

    def _rows(self, array):
        """The rows of an array with a column for each point; numbers if there is one point."""
        return array[:, 0] if self.size == 1 else array

    def solved(self, load, areas, apart):
        """What the loop finds under the loads F_t*: the rows of results, and where Eq. 7 has no meaning, or
        None if there is no film.  To be called once, unless there is one point."""
        columns = self._columns.copy() if self.size == 1 else self._columns
        found = np.empty((RESULTS, self.size))
        given, means_nothing = self._rows(columns), None
        given[PER_LOAD] = 1.0 / load.astype(self.real)
        _, film_shares, film_is_known = self.kind
        if film_is_known:
            means_nothing = self._fill_known_film(given, load)
        if film_shares:
            given[CROSSING_ROOT] *= np.sqrt(np.sqrt(np.sqrt(np.sqrt(given[PER_LOAD]))))
        block, solve = BLOCKS.of(self.real, INTEGERS[self.real], *self.kind), compiled(solve_points)
        with apart():
            solve(self.real, self.model, columns, *self.kind, areas, block, found)
        found = self._rows(found)
        if film_shares:
            over_crossing = found[GAP] * given[PER_CROSSING]
            means_nothing = over_crossing > _film_scales(self.parameters).thickest
            in_film = found[FLUID_SHARE] * load
            means_nothing |= in_film > greatest_film_load(self.parameters)
        return found, means_nothing

    def _fill_known_film(self, given, load):
        """Fill the rows that say what is known of a film under F_t; returns where Eq. 7 has no meaning."""
        log_load = log_load_parameter(np.log(load), self.parameters)
        thickness, slope = self._film.thickness(log_load)
        given[FILM_GAP] = thickness * (self.parameters.ball_radius / self.roughness)
        given[FILM_ERROR] = self._film.rounding(log_load, thickness, slope)
        return ~self._film.is_meaningful(log_load)

    def are_covered(self, load):
        """Points without a solution because particles cover everything at any separation (Eq. 4), unless
        their load F_t* might be more than the particles bear: then they have none for another reason."""
        covered = self._layer.log_bare < FULL
        area, *_ = self._layer.contact(np.zeros(covered.shape))
        return covered & (load < 0.5 * area * self.parameters.particle_pressure)


@lru_cache(maxsize=256)
def interface_of_one(
    viscosity: float,
    particle_diameter: float,
    roughness: float,
    particle_density: float,
    parameters: Parameters,
    rtol: float,
) -> Interfaces:
    """The ``Interfaces`` of one point, made once for all its loads."""
    numbers = np.nan, viscosity, particle_diameter, roughness, particle_density
    conditions = Conditions(*(np.array([number]) for number in numbers))
    sheet = sheet_of_one(roughness, parameters)
    return Interfaces(sheet, conditions, parameters, rtol, precisions(rtol)[-1])


class CompiledPoints:
    """Points solved by the compiled loop: what ``SolvedPoints`` is, for those that are not ``left``.

    Parameters
    ----------
    interfaces : Interfaces
        What is given of the points but their loads; taken once, unless it is one point.
    load : array, shape (points,)
        F_t* [1].
    areas : bool
        Whether areas are asked for; if not, variables that follow from areas have no meaning.
    apart : callable
        Returns the context in which machine code runs, which does without the interpreter.

    Attributes
    ----------
    left : array of bool, shape (points,)
        Points that are to be solved in another way; their other values have no meaning.
    total_contact_area, ... : array
        The variables of ``Solution``; of one point numbers.
    """

    def __init__(
        self,
        interfaces: Interfaces,
        load: NDArray,
        areas: bool,
        apart: Callable[[], AbstractContextManager] = nullcontext,
    ):
        self._interfaces = interfaces
        if interfaces.size == 1:
            load = load[0]
        self._covered = interfaces.are_covered(load) if interfaces.may_be_covered else None
        self._has_values = self._covered is None or not self._covered.any()
        found, self._means_nothing = interfaces.solved(load, areas, apart)
        if not self._has_values:
            found[..., self._covered] = np.nan
        self.total_contact_area = found[TOTAL_AREA]
        self.particle_contact_area_ratio = found[PARTICLE_SHARE]
        self.surface_contact_area_ratio = found[SURFACE_SHARE]
        self.solid_load_fraction = found[SOLID_SHARE]
        self.fluid_load_fraction = found[FLUID_SHARE]
        self.separation = found[GAP] * interfaces.roughness
        self.error_bound = found[BOUND]
        left = ~(self.error_bound <= interfaces.rtol)
        if not self._has_values:
            left &= ~self._covered
        left |= (load > interfaces.greatest_load) | (load < LEAST_LOAD)
        self.left = left.reshape(interfaces.size)

    @property
    def film_thickness(self):
        return self.separation / self._interfaces.parameters.ball_radius

    @property
    def lubrication_regime(self):
        return self._valid(lubrication_regime(self.solid_load_fraction), NO_FLAG)

    @property
    def contact_mode(self):
        mode = contact_mode(self.particle_contact_area_ratio, self._interfaces.has_particles)
        return self._valid(mode, NO_FLAG)

    @property
    def separation_count(self):
        one = self._interfaces.size == 1
        return self._valid(ONE if one else np.ones(self.left.shape, np.int8), 0)

    @property
    def solution_status(self):
        applies = {"area_exceeded": self.total_contact_area > 1.0}
        if not self._has_values:
            applies["coverage_exceeded"] = self._covered
        if self._interfaces.has_film:
            outside = self._means_nothing | (self.film_thickness > THICKEST)
            applies["outside_film_formula"] = outside & (self.fluid_load_fraction > FILM_COUNTS)
        return gravest_status(**applies)

    def _valid(self, values, otherwise):
        """``values`` where there is a solution, else ``otherwise``."""
        return values if self._has_values else np.where(self._covered, otherwise, values)


class FilmScales(NamedTuple):
    """Where both terms of Eq. 7 are equal, at a viscosity of 1 m2/s and the reference roughness, and
    as a power of both."""

    root: float  # root of F_f* there
    root_exponents: tuple[float, float]
    per_crossing: float  # sigma/h_c there
    per_crossing_exponents: tuple[float, float]
    thickest: float  # h_c up to which Eq. 7 has a meaning, over that there


def _fill_summits(columns, sheet, surface, summits):
    """Fill the rows that say what is known of the summits."""
    columns[OFFSET] = surface.summit_offset / surface.roughness
    columns[PER_DEVIATION] = surface.roughness / surface.summit_deviation
    columns[SUMMIT_PARAMETER] = summits.summit_parameter
    columns[PLACE] = sheet.place(log_yields(summits)) if sheet.is_cell else 0.0


def _fill_particles(columns, layer, roughness):
    """Fill the rows that say what is known of a layer of particles."""
    parameters = layer.parameters
    columns[MEAN] = layer.mean * (1.0 / roughness)
    columns[PER_SPREAD] = roughness / layer.spread
    columns[ELASTIC_SHIFT] = parameters.readings.elastic_limits.side * layer.depth
    columns[PLASTIC_AREA] = layer.share * parameters.hardness_surface_2
    columns[BARE] = np.exp(layer.log_bare)


def _fill_film(columns, roughness, viscosity, parameters):
    """Fill the rows that say what is known of a film, but for the factor that the load is in one."""
    scales, scale = _film_scales(parameters), roughness / parameters.reference_roughness
    for row, value, (of_viscosity, of_roughness) in (
        (PER_CROSSING, scales.per_crossing, scales.per_crossing_exponents),
        (CROSSING_ROOT, scales.root, scales.root_exponents),
    ):
        columns[row] = value * scale**of_roughness * viscosity**of_viscosity


@lru_cache(maxsize=64)
def _film_scales(parameters: Parameters) -> FilmScales:
    """Planes of ln W and ln H_c over ln viscosity and ln roughness.

    The first is drawn through the ends of what oils have, the other from there to another roughness.
    """
    sigma = parameters.reference_roughness
    viscosities = np.array([*OIL_VISCOSITIES, OIL_VISCOSITIES[0]])
    roughness = sigma * np.array([1.0, 1.0, ROUGHER])
    films = Film.of(viscosities, roughness, parameters)
    log_parameters, log_thicknesses = films.crossing()
    ends = math.log(viscosities[0]), math.log(viscosities[1]) - math.log(viscosities[0])

    def plane(values):
        start, other, rougher = map(float, values)
        slopes = (other - start) / ends[1], (rougher - start) / math.log(ROUGHER)
        return start - slopes[0] * ends[0], *slopes

    log_parameter, *parameter_slopes = plane(log_parameters)
    log_thickness, *thickness_slopes = plane(log_thicknesses)
    thickest, _ = films.thickness(films.turning())
    log_area = math.log(parameters.apparent_area / parameters.ball_radius**2)
    return FilmScales(
        root=math.exp((log_parameter - log_area) / ROOT),
        root_exponents=tuple(slope / ROOT for slope in parameter_slopes),
        per_crossing=math.exp(-log_thickness) * sigma / parameters.ball_radius,
        per_crossing_exponents=(-thickness_slopes[0], 1.0 - thickness_slopes[1]),
        thickest=float(thickest[0] / math.exp(log_thicknesses[0])),
    )
