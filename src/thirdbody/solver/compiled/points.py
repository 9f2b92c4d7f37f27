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
from thirdbody.solver.compiled.tables import DOUBLE, INTEGERS, prepare_model
from thirdbody.solver.points import Conditions
from thirdbody.solver.surfaces import Sheet, log_yields, summits_of, summits_of_one

OIL_VISCOSITIES = 1e-9, 1e-3  # [m2/s], of any oil
# F_t* of which the summits would bear a share in float64 even beyond their tables
LEAST_LOAD = 1e-20
ROUGHER = 1e6  # by a factor
BLOCKS = Blocks()


class CompiledPoints:
    """Points solved by the compiled loop: what ``SolvedPoints`` is, for those that are not ``left``.

    All points have a film, or none has; all have particles, or none has.

    Parameters
    ----------
    sheet : Sheet
        The sheet of their surfaces.  On one that is no cell all points have one roughness.
    conditions : Conditions
        The points.
    parameters : Parameters
        Inputs of the model.
    rtol : float
        Relative error asked for.
    real : type
        Type of number to solve in, one of ``precisions(rtol)``.
    areas : bool
        Whether areas are asked for; if not, variables that follow from areas have no meaning.
    apart : callable
        Returns the context in which machine code runs, which does without the interpreter.

    Attributes
    ----------
    left : array of bool
        Points that are to be solved in another way; their other values have no meaning.
    total_contact_area, ... : array
        The variables of ``Solution``; of one point numbers.
    """

    def __init__(
        self,
        sheet: Sheet,
        conditions: Conditions,
        parameters: Parameters,
        rtol: float,
        real: type,
        areas: bool,
        apart: Callable[[], AbstractContextManager] = nullcontext,
    ):
        points, first = conditions.size, conditions.take(0)
        if points == 1:  # numbers take a tenth of the time that arrays of one do
            conditions = first
        load, viscosity = conditions.load, conditions.viscosity
        diameter, density = conditions.particle_diameter, conditions.particle_density
        if sheet.is_cell:
            roughness = conditions.roughness
            surface, summits = summits_of(roughness, parameters)
        else:
            roughness = float(first.roughness)
            surface, summits = summits_of_one(roughness, parameters)
        self._parameters = parameters
        self._has_particles = bool(has_particles(first.particle_diameter, first.particle_density))
        self._has_film = bool(first.viscosity > 0.0)
        columns, results = np.empty((GIVEN, points), real), np.empty((RESULTS, points))
        # numbers if there is one point
        given, found = (columns[:, 0], results[:, 0]) if points == 1 else (columns, results)
        given[PER_LOAD] = 1.0 / load.astype(real)
        _fill_summits(given, sheet, surface, summits)
        self._covered = np.zeros(load.shape, bool)
        if self._has_particles:
            sigma = roughness.astype(real) if sheet.is_cell else roughness
            sizes = diameter.astype(real), sigma, density.astype(real)
            layer = ParticleLayer.of(*sizes, parameters)
            _fill_particles(given, layer, sigma)
            if real is DOUBLE:
                self._covered = _are_covered(layer, load)
        self._has_values = not self._covered.any()
        film_is_known = self._has_film and not parameters.readings.film_load.depends_on_shares
        film_shares = self._has_film and not film_is_known
        if film_is_known:
            self._means_nothing = _fill_known_film(given, conditions, roughness, parameters)
        if film_shares:
            _fill_film(given, roughness, viscosity.astype(real), parameters)
        kind = self._has_particles, film_shares, film_is_known
        model = prepare_model(sheet, parameters, rtol, real)
        block = BLOCKS.of(real, INTEGERS[real], *kind)
        solve = compiled(solve_points)
        with apart():
            solve(real, model, columns, *kind, areas, block, results)
        if not self._has_values:
            found[..., self._covered] = np.nan
        self.total_contact_area = found[TOTAL_AREA]
        self.particle_contact_area_ratio = found[PARTICLE_SHARE]
        self.surface_contact_area_ratio = found[SURFACE_SHARE]
        self.solid_load_fraction = found[SOLID_SHARE]
        self.fluid_load_fraction = found[FLUID_SHARE]
        self.separation = found[GAP] * roughness
        self.error_bound = found[BOUND]
        left = ~(self.error_bound <= rtol)
        if not self._has_values:
            left &= ~self._covered
        if self._has_particles:
            left |= load > greatest_single_load(parameters)
        left |= load < LEAST_LOAD
        self.left = left.reshape(points)
        if film_shares:
            over_crossing = found[GAP] * given[PER_CROSSING]
            self._means_nothing = over_crossing > _film_scales(parameters).thickest
            in_film = self.fluid_load_fraction * load
            self._means_nothing |= in_film > greatest_film_load(parameters)

    @property
    def film_thickness(self):
        return self.separation / self._parameters.ball_radius

    @property
    def lubrication_regime(self):
        return self._valid(lubrication_regime(self.solid_load_fraction), NO_FLAG)

    @property
    def contact_mode(self):
        mode = contact_mode(self.particle_contact_area_ratio, self._has_particles)
        return self._valid(mode, NO_FLAG)

    @property
    def separation_count(self):
        return self._valid(np.ones(self.left.shape, np.int8), 0)

    @property
    def solution_status(self):
        applies = {
            "area_exceeded": self.total_contact_area > 1.0,
            "coverage_exceeded": self._covered,
        }
        if self._has_film:
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


def _are_covered(layer, load):
    """Points without a solution because particles cover everything at any separation (Eq. 4), unless
    their load F_t* might be more than the particles bear: then they have none for another reason."""
    covered = layer.log_bare < FULL
    if covered.any():
        area, *_ = layer.contact(np.zeros(covered.shape))
        covered &= load < 0.5 * area * layer.parameters.particle_pressure
    return covered


def _fill_film(columns, roughness, viscosity, parameters):
    """Fill the rows that say what is known of a film."""
    scales, scale = _film_scales(parameters), roughness / parameters.reference_roughness
    for row, value, (of_viscosity, of_roughness) in (
        (PER_CROSSING, scales.per_crossing, scales.per_crossing_exponents),
        (CROSSING_ROOT, scales.root, scales.root_exponents),
    ):
        columns[row] = value * scale**of_roughness * viscosity**of_viscosity
    columns[CROSSING_ROOT] *= np.sqrt(np.sqrt(np.sqrt(np.sqrt(columns[PER_LOAD]))))


def _fill_known_film(columns, conditions, roughness, parameters):
    """Fill the rows that say what is known of a film under F_t; returns where Eq. 7 has no meaning."""
    film = Film.of(conditions.viscosity, roughness, parameters)
    log_load = log_load_parameter(np.log(conditions.load), parameters)
    thickness, slope = film.thickness(log_load)
    columns[FILM_GAP] = thickness * (parameters.ball_radius / roughness)
    columns[FILM_ERROR] = film.rounding(log_load, thickness, slope)
    return ~film.is_meaningful(log_load)


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
