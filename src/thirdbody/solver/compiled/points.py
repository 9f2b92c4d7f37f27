"""Many points on one surface, solved by the compiled loop.

The loop balances loads (Eqs. 1, 2 and 4) where ``thirdbody.solver.balance`` balances their
logarithms, which hold the smallest and the largest.  Points at which the loop cannot promise the
error asked for are left to that.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.contact import greatest_single_load
from thirdbody.model.film import THICKEST, Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer, has_particles
from thirdbody.model.regimes import FILM_COUNTS, contact_mode, gravest_status, lubrication_regime
from thirdbody.solver.compiled.layout import (
    BARE,
    BOUND,
    CROSSING_ROOT,
    ELASTIC_SHIFT,
    FLUID_SHARE,
    GAP,
    GIVEN,
    MEAN,
    PARTICLE_SHARE,
    PER_CROSSING,
    PER_LOAD,
    PER_SPREAD,
    PLASTIC_AREA,
    RESULTS,
    ROOT,
    SOLID_SHARE,
    SURFACE_SHARE,
    TOTAL_AREA,
    make_block,
)
from thirdbody.solver.compiled.loop import solve_points
from thirdbody.solver.compiled.machine_code import compiled
from thirdbody.solver.compiled.tables import INTEGERS, prepare_model
from thirdbody.solver.surfaces import RoughSurface

OIL_VISCOSITIES = 1e-9, 1e-3  # [m2/s], of any oil


class CompiledPoints:
    """Points solved by the compiled loop: what ``SolvedPoints`` is, for those that are not ``left``.

    All points have a film, which bears the fluid load, or none has; all have particles, or none
    has.

    Parameters
    ----------
    rough : RoughSurface
        The surface of all points, with tables.
    parameters : Parameters
        Inputs of the model.
    load : array, shape (points,)
        F_t* [1].
    viscosity : array, shape (points,)
        [m2/s], 0 without film.
    diameter, density : array, shape (points,)
        x_a [m] and eta_a [m-2] of the particles.
    rtol : float
        Relative error asked for.
    real : type
        Type of number to solve in, one of ``precisions(rtol)``.
    areas : bool
        Whether areas are asked for; if not, variables that follow from areas have no meaning.

    Attributes
    ----------
    left : array of bool
        Points that are to be solved in another way; their other values have no meaning.
    total_contact_area, ... : array
        The variables of ``Solution``.
    """

    def __init__(
        self,
        rough: RoughSurface,
        parameters: Parameters,
        load: NDArray,
        viscosity: NDArray,
        diameter: NDArray,
        density: NDArray,
        rtol: float,
        real: type,
        areas: bool,
    ):
        roughness = rough.surface.roughness
        self._parameters = parameters
        self._has_particles = bool(has_particles(diameter[0], density[0]))
        self._scales = _film_scales(roughness, parameters) if viscosity[0] > 0.0 else None
        columns = np.empty((GIVEN, load.size), real)
        columns[PER_LOAD] = 1.0 / load.astype(real)
        if self._has_particles:
            sizes = diameter.astype(real), roughness, density.astype(real)
            _fill_particles(columns, ParticleLayer.of(*sizes, parameters), roughness)
        if self._scales:
            _fill_film(columns, self._scales, viscosity.astype(real))
        found = np.empty((RESULTS, load.size))
        compiled(solve_points)(
            prepare_model(rough, parameters, rtol, real),
            columns,
            self._has_particles,
            self._scales is not None,
            areas,
            make_block(real, INTEGERS[real]),
            found,
        )
        self.total_contact_area = found[TOTAL_AREA]
        self.particle_contact_area_ratio = found[PARTICLE_SHARE]
        self.surface_contact_area_ratio = found[SURFACE_SHARE]
        self.solid_load_fraction = found[SOLID_SHARE]
        self.fluid_load_fraction = found[FLUID_SHARE]
        self.separation = found[GAP] * roughness
        self.error_bound = found[BOUND]
        self.left = ~(self.error_bound <= rtol)
        if self._has_particles:
            self.left |= load > greatest_single_load(parameters)
        self._over_crossing = found[GAP] * columns[PER_CROSSING]

    @property
    def film_thickness(self):
        return self.separation / self._parameters.ball_radius

    @property
    def lubrication_regime(self):
        return lubrication_regime(self.solid_load_fraction)

    @property
    def contact_mode(self):
        return contact_mode(self.particle_contact_area_ratio, self._has_particles)

    @property
    def separation_count(self):
        return np.ones(self.left.shape, np.int8)

    @property
    def solution_status(self):
        applies = {"area_exceeded": self.total_contact_area > 1.0}
        if self._scales:
            outside = self._over_crossing > self._scales.thickest
            outside |= self.film_thickness > THICKEST
            applies["outside_film_formula"] = outside & (self.fluid_load_fraction > FILM_COUNTS)
        return gravest_status(**applies)


class FilmScales(NamedTuple):
    """Where both terms of Eq. 7 are equal, at a viscosity of 1 m2/s, and as a power of viscosity."""

    root: float  # root of F_f* there
    root_exponent: float
    per_crossing: float  # sigma/h_c there
    per_crossing_exponent: float
    thickest: float  # h_c up to which Eq. 7 has a meaning, over that there


def _fill_particles(columns, layer, roughness):
    """Fill the rows that say what is known of a layer of particles."""
    parameters = layer.parameters
    columns[MEAN] = layer.mean * (1.0 / roughness)
    columns[PER_SPREAD] = roughness / layer.spread
    columns[ELASTIC_SHIFT] = parameters.readings.elastic_limits.side * layer.depth
    columns[PLASTIC_AREA] = layer.share * parameters.hardness_surface_2
    columns[BARE] = np.exp(layer.log_bare)


def _fill_film(columns, scales, viscosity):
    """Fill the rows that say what is known of a film."""
    columns[PER_CROSSING] = scales.per_crossing * viscosity**scales.per_crossing_exponent
    columns[CROSSING_ROOT] = scales.root * viscosity**scales.root_exponent
    columns[CROSSING_ROOT] *= np.sqrt(np.sqrt(np.sqrt(np.sqrt(columns[PER_LOAD]))))


@lru_cache(maxsize=64)
def _film_scales(roughness: float, parameters: Parameters) -> FilmScales:
    """Lines of ln W and ln H_c over ln viscosity, drawn through the ends of what oils have."""
    ends = np.log(OIL_VISCOSITIES)
    films = Film.of(np.array(OIL_VISCOSITIES), roughness, parameters)
    log_parameters, log_thicknesses = films.crossing()
    parameter_slope, thickness_slope = (
        float(np.diff(values)[0] / np.diff(ends)[0]) for values in (log_parameters, log_thicknesses)
    )
    thickest, _ = films.thickness(films.turning())
    log_area = math.log(parameters.apparent_area / parameters.ball_radius**2)
    return FilmScales(
        root=math.exp((log_parameters[0] - parameter_slope * ends[0] - log_area) / ROOT),
        root_exponent=parameter_slope / ROOT,
        per_crossing=math.exp(thickness_slope * ends[0] - log_thicknesses[0])
        * roughness
        / parameters.ball_radius,
        per_crossing_exponent=-thickness_slope,
        thickest=float(thickest[0] / math.exp(log_thicknesses[0])),
    )
