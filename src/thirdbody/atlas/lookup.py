"""The smallest table from which L_s and A_sa,t* are interpolated, for monitoring in real time.

Over the five conditions themselves both shares leap: the first particle that touches lightly loaded
surfaces takes all of their contact area.  Over the separation d nothing leaps.  The table therefore
holds, over d, what summits, particles and film bear by themselves, each a function of few conditions:

    ln F_ss*, ln A_ss/A_n                  of (d/sigma)^2 and ln sigma
    height of the plane that particles meet, over sigma  of ln sigma
    A_sa/A_n and coverages over eta_a x_a^2  of (d less that height)/x_a
    ln W of the film, over that at which both terms of Eq. 7 are equal, of ln H_c over that there;
    where that is, a product of powers   of ln nu and ln sigma

What solids and film hold together falls with d; where it is the load, L_s and A_sa,t* are read off.
That takes no iteration: the loads at some separations tell between which two d lies, and those at some
in between the rest.
"""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike

import numpy as np
import xarray as xr
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import RegularGridInterpolator

from thirdbody.data.netcdf import load
from thirdbody.model.readings import FilmLoad

GRIDS = {  # axes of each table
    "summits": ("gap_squared", "log_roughness"),
    "height": ("log_roughness",),
    "particles": ("separation_over_diameter",),
    "crossing": ("log_viscosity", "log_film_roughness"),
    "film": ("log_relative_thickness",),
}
FIRST, SECOND = 64, 32  # separations at which the loads are compared, and between two of them
PIECE = 4096  # conditions looked up together
NOTHING = -600.0  # logarithm of what is borne where summits bear nothing
ALL = 1e15  # A_sa/A_ss-sa where particles have all of the area
LEAST_BARE = 1e-12  # share of the interface that particles leave bare at least
SLACK = 1e-9  # of the ends of what is spanned


@dataclass(frozen=True)
class Lookup:
    """A table that gives L_s and A_sa,t*; see the head of this module.

    Attributes
    ----------
    tables : xarray.Dataset
        What it interpolates, with what it is good for in the attributes.
    """

    tables: xr.Dataset

    def __post_init__(self):
        tables = self.tables
        for name, axes in GRIDS.items():
            nodes = tuple(tables[axis].values for axis in axes)
            interpolate = RegularGridInterpolator(
                nodes, tables[name].values, bounds_error=False, fill_value=None
            )
            object.__setattr__(self, f"_{name}", interpolate)
        first, last = tables.attrs["range_separation"]
        object.__setattr__(self, "_held", FilmLoad.known[tables.attrs["film_load"]].total_load)
        object.__setattr__(self, "_across", np.linspace(np.log(last), np.log(first), FIRST))

    @classmethod
    def read(cls, path: str | PathLike) -> Lookup:
        """The table in a file; ``OSError`` in one line if it cannot be read."""
        return cls(load(path, GRIDS).to_xarray())

    def __call__(
        self,
        load_N: ArrayLike,
        viscosity_cSt: ArrayLike,
        particle_diameter_nm: ArrayLike,
        roughness_nm: ArrayLike,
        particle_density_per_m2: ArrayLike,
    ) -> tuple[NDArray, NDArray]:
        """L_s and A_sa,t* [1] at conditions that broadcast; nan beyond what the table spans."""
        given = np.broadcast_arrays(
            np.divide(load_N, self.tables.attrs["newtons_per_load"]),
            np.multiply(viscosity_cSt, 1e-6),
            np.multiply(particle_diameter_nm, 1e-9),
            np.multiply(roughness_nm, 1e-9),
            np.asarray(particle_density_per_m2, float),
        )
        columns = [column.ravel() for column in given]
        found = [
            self._shares(*(column[first : first + PIECE] for column in columns))
            for first in range(0, columns[0].size, PIECE)
        ]
        shape = given[0].shape
        return tuple(np.concatenate(each).reshape(shape) for each in zip(*found, strict=True))

    def _shares(self, load, viscosity, diameter, roughness, density):
        layer = viscosity, diameter, roughness, density
        across = np.broadcast_to(self._across[:, np.newaxis], (FIRST, load.size))
        bracket, _ = self._bracket(load, across, layer)
        inner = np.linspace(*bracket, SECOND)
        _, (solid, total, odds) = self._bracket(load, inner, layer)
        with np.errstate(divide="ignore", invalid="ignore"):  # where the table says nothing
            share = np.clip((load - total[0]) / (total[1] - total[0]), 0.0, 1.0)
        solid, total, odds = (low + share * (high - low) for low, high in (solid, total, odds))
        spanned = self._spans(load, *layer)
        return tuple(
            np.where(spanned, found, np.nan) for found in (solid / total, odds / (1.0 + odds))
        )

    def _spans(self, load, viscosity, diameter, roughness, density):
        """Whether the table spans conditions."""
        spanned = np.ones(load.shape, bool)
        attributes = self.tables.attrs
        for name, values, absent in (
            ("newtons", load * attributes["newtons_per_load"], False),
            ("viscosity", viscosity, True),
            ("particle_diameter", diameter, True),
            ("roughness", roughness, False),
            ("particle_density", density, True),
        ):
            low, high = attributes[f"range_{name}"]
            inside = (values >= low * (1.0 - SLACK)) & (values <= high * (1.0 + SLACK))
            spanned &= inside | (absent & (values == 0.0))
        return spanned

    def _bracket(self, load, log_separation, layer):
        """The two neighbours among separations of either side of the balance, and what is there."""
        solid, film, odds = self._borne(np.exp(log_separation), *layer)
        total = self._held(solid, film)  # which rises, as separations fall
        beyond = np.where(total[-1] > load, (total > load).argmax(axis=0), len(total) - 1)
        ends = np.stack([np.maximum(beyond - 1, 0), np.maximum(beyond, 1)])
        picked = (np.take_along_axis(each, ends, 0) for each in (solid, total, odds))
        return np.take_along_axis(log_separation, ends, 0), tuple(picked)

    def _borne(self, separation, viscosity, diameter, roughness, density):
        """F* [1] of solids and film at ``separation`` d [m], and A_sa/A_ss-sa [1]."""
        log_roughness = np.broadcast_to(np.log(roughness), separation.shape)
        gap = separation / roughness
        log_load, log_area = np.moveaxis(self._summits(_points(gap * gap, log_roughness)), -1, 0)
        height = self._height(np.log(roughness)[:, np.newaxis]) * roughness
        nodes = self.tables["separation_over_diameter"].values
        with np.errstate(divide="ignore", invalid="ignore"):  # where there are no particles
            place = np.clip((separation - height) / diameter, nodes[0], nodes[-1])
            place = np.where(diameter > 0.0, place, nodes[-1])
        particles = np.moveaxis(self._particles(place[..., np.newaxis]), -1, 0)
        area, *coverages = particles * (density * diameter**2)
        bare_load, bare_area = (np.maximum(1.0 - coverage, LEAST_BARE) for coverage in coverages)
        pressure = self.tables.attrs["particle_pressure"]
        solid = np.exp(np.maximum(log_load, NOTHING)) * bare_load + pressure * area
        odds = np.minimum(area / np.exp(np.maximum(log_area, NOTHING)) / bare_area, ALL)
        return solid, self._film_load(separation, viscosity, log_roughness), odds

    def _film_load(self, separation, viscosity, log_roughness):
        """F* [1] at which a film is ``separation`` d [m] thick (Eq. 7)."""
        wet = viscosity > 0.0
        log_viscosity = np.log(np.where(wet, viscosity, 1.0))
        where = self._crossing(_points(log_viscosity, log_roughness[0]))
        thickness = np.log(separation / self.tables.attrs["ball_radius"]) - where[:, 1]
        log_parameter = where[:, 0] + self._film(thickness[..., np.newaxis])
        load = np.exp(log_parameter) * self.tables.attrs["load_per_parameter"]
        return np.where(wet, load, 0.0)


def _points(*columns):
    """Places as an interpolator takes them: the last axis runs over ``columns``."""
    return np.stack(np.broadcast_arrays(*columns), axis=-1)
