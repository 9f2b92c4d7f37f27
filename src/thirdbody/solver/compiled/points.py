"""Many points on one surface, by the compiled loop.

Whatever depends on one variable is read from a table: the summits' load and area from t, the
second moment of the particles from alpha, the load of a film from its thickness.  What is left to
do at a point is the balance of forces (Eqs. 1, 2 and 4), as a sum instead of the difference of
logarithms by which ``thirdbody.solver.balance`` survives extremes.  Points for which the loop cannot
promise the error asked for are left to ``thirdbody.solver.solution``.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numba import njit

from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer, has_particles
from thirdbody.model.regimes import contact_mode, lubrication_regime
from thirdbody.solver.compiled.loop import (
    COMPILED,
    GIVEN,
    RESULTS,
    ROOT,
    ROWS,
    STRIDE,
    WIDTH,
    solve_points,
)
from thirdbody.solver.compiled.tables import INTEGERS, prepare_model
from thirdbody.solver.solution import CONVERGED, OUTSIDE_FILM_FORMULA
from thirdbody.solver.surfaces import RoughSurface

OILS = 1e-9, 1e-3  # viscosities [m2/s] between which nothing is extrapolated


class FilmScales(NamedTuple):
    """Where the terms of Eq. 7 are equal, for a viscosity of 1 m2/s; and the powers of viscosity by
    which that changes."""

    root: float  # of F_f* there, as tables hold it
    root_exponent: float
    per_level: float  # sigma/d there
    per_level_exponent: float
    thickest: float  # d, over that there, up to which Eq. 7 has a meaning


class CompiledPoints:
    """What ``SolvedPoints`` is, by the compiled loop; all of ``left`` are to be solved another way.

    ``load`` F_t*, ``viscosity`` [m2/s], ``diameter`` x_a [m] and ``density`` eta_a [m-2] are 1-D;
    all points have a film, which bears the fluid load, or none has, and all have particles or none
    has.  ``rough`` has tables.  Numbers are of type ``real``.  Areas, and what follows from them,
    are only there if ``areas`` says that they are wanted.
    """

    def __init__(
        self,
        rough: RoughSurface,
        parameters: Parameters,
        load,
        viscosity,
        diameter,
        density,
        rtol: float,
        real: type,
        areas: bool,
    ):
        roughness = rough.surface.roughness
        self._parameters = parameters
        self._has_particles = bool(has_particles(diameter[0], density[0]))
        self._scales = _film_scales(roughness, parameters) if viscosity[0] > 0.0 else None
        columns = np.empty((GIVEN, load.size), real)
        per_load, *of_particles, per_level, film_root = columns
        per_load[:] = 1.0 / load.astype(real)
        if self._has_particles:
            sizes = diameter.astype(real), roughness, density.astype(real)
            _fill_particles(ParticleLayer.of(*sizes, parameters), roughness, of_particles)
        if self._scales:
            viscosity = viscosity.astype(real)
            per_level[:] = self._scales.per_level * viscosity**self._scales.per_level_exponent
            film_root[:] = self._scales.root * viscosity**self._scales.root_exponent
            film_root *= np.sqrt(np.sqrt(np.sqrt(np.sqrt(per_load))))
        found = np.empty((RESULTS, load.size))
        work = np.empty(ROWS * int(STRIDE), real)
        _loop()(
            prepare_model(rough, parameters, rtol, real),
            columns,
            self._has_particles,
            self._scales is not None,
            areas,
            work,
            work.view(INTEGERS[real]),
            np.empty(RESULTS * int(STRIDE)),
            np.empty(WIDTH, np.uintp),
            found,
        )
        self.total_contact_area, self.particle_contact_area_ratio = found[:2]
        self.surface_contact_area_ratio, self.solid_load_fraction = found[2:4]
        self.fluid_load_fraction, depth, self.error_bound = found[4:]
        self.separation = depth * roughness
        self.left = ~(self.error_bound <= rtol)
        self._levels = depth * per_level

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
    def solution_status(self):
        status = np.full(self.left.shape, CONVERGED, dtype=np.int8)
        if self._scales:
            status[self._levels > self._scales.thickest] = OUTSIDE_FILM_FORMULA
        return status


def _fill_particles(layer, roughness, columns):
    """Fill the five columns that the loop needs of a layer of particles."""
    parameters = layer.parameters
    mean, per_spread, shift, area, bare = columns
    mean[:] = layer.mean * (1.0 / roughness)
    per_spread[:] = roughness / layer.spread
    shift[:] = parameters.readings.elastic_limits.side * layer.depth
    area[:] = layer.share * parameters.hardness_surface_2
    bare[:] = np.exp(layer.log_bare)  # zeros where Eq. 4 counts those that touch


@lru_cache(maxsize=64)
def _film_scales(roughness: float, parameters: Parameters) -> FilmScales:
    """Both are lines over the logarithm of viscosity, drawn through the ends of oils' viscosities."""
    ends = np.log(OILS)
    films = Film.of(np.array(OILS), roughness, parameters)
    log_parameters, log_thicknesses = films.crossing()
    parameter_slope, thickness_slope = (
        float(np.diff(values)[0] / np.diff(ends)[0]) for values in (log_parameters, log_thicknesses)
    )
    thickest, _ = films.thickness(films.turning())
    log_area = math.log(parameters.apparent_area / parameters.ball_radius**2)
    return FilmScales(
        math.exp((log_parameters[0] - parameter_slope * ends[0] - log_area) / ROOT),
        parameter_slope / ROOT,
        math.exp(thickness_slope * ends[0] - log_thicknesses[0])
        * roughness
        / parameters.ball_radius,
        -thickness_slope,
        float(thickest[0] / math.exp(log_thicknesses[0])),
    )


@lru_cache(maxsize=1)
def _loop():
    """The loop in machine code, which is kept beside its file for later processes; so it must not
    contain a constant of another file."""
    try:
        return njit(**COMPILED, cache=True)(solve_points)
    except RuntimeError:  # no folder that it could be kept in
        return njit(**COMPILED)(solve_points)
