"""The summits under points: by quadrature, or read off a table of their surface."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from thirdbody.interpolation import HermiteTable
from thirdbody.model.asperity import SummitPopulation, area_growth
from thirdbody.model.parameters import Parameters, Surface

TABLE_RANGE = -5.0, 40.0  # of t = (d - y_s)/sigma_s
# Pieces of tables: errors, which fall with their sixth power, are at most a hundredth of rtol, so that
# few points magnify them beyond; the most pieces leave what rounding does.
PIECES_AT_ONE, FEWEST_PIECES, MOST_PIECES = 11.0, 45, 720
QUADRATURE_ERROR = 5e-14  # of ln F_ss and ln A_ss


@dataclass(frozen=True, eq=False)
class RoughSurfaces:
    """The summits under each of many points, as ``thirdbody.model.contact`` asks for them.

    ``surfaces`` and ``population`` have an element for each roughness, and ``which`` says on which of them
    a point is.  ``table`` has ln F_ss* and ln A_ss* over t, of one surface after the other; None: by
    quadrature.
    """

    surfaces: Surface
    population: SummitPopulation
    table: HermiteTable | None
    which: NDArray

    @classmethod
    def of(
        cls, roughness: NDArray, parameters: Parameters, table_rtol: float | None
    ) -> RoughSurfaces:
        """The surfaces of points of ``roughness`` sigma [m], 1-D; tables are good for a relative error
        ``table_rtol``, and None means by quadrature.

        Raises ``ValueError`` where the summit parameter leaves no variance to the summits.
        """
        values, which = np.unique(roughness, return_inverse=True)
        surfaces = parameters.surface(values)
        table = None
        if table_rtol is not None:
            table = _table_of(tuple(values.tolist()), parameters, table_rtol)
        return cls(surfaces, SummitPopulation.of(surfaces, parameters), table, which)

    def take(self, chosen) -> RoughSurfaces:
        """The surfaces of the points that an index or mask ``chosen`` picks."""
        return replace(self, which=self.which[chosen])

    @cached_property
    def offset(self):
        """y_s [m]."""
        return self.surfaces.summit_offset[self.which]

    @cached_property
    def deviation(self):
        """sigma_s [m]."""
        return self.surfaces.summit_deviation[self.which]

    @cached_property
    def error(self):
        """What ln F_ss* and ln A_ss* may be wrong by, beside rounding."""
        if self.table is None:
            return QUADRATURE_ERROR
        errors = self.table.error.reshape(-1, 2).max(axis=1)
        return errors[self.which] + QUADRATURE_ERROR

    def log_load(self, t: NDArray) -> tuple[NDArray, NDArray]:
        """ln F_ss* and its slope d/dt at summit separations ``t`` [1]."""
        if self.table is None:
            return self.population.take(self.which).log_load(t)
        return self._read(t, 0)

    def log_load_and_area(self, t: NDArray) -> tuple:
        """ln F_ss* and ln(A_ss/A_n), each with its slope d/dt, at summit separations ``t`` [1]."""
        if self.table is None:
            return tuple(self.population.take(self.which).log_load_and_area(t)[:, :2])
        return self._read(t, 0), self._read(t, 1)

    def _read(self, t, function):
        """ln F_ss* or ln A_ss* and its slope off the table, as ``function`` is 0 or 1."""
        inside = self.table.covers(t)
        value, slope = self.table(np.where(inside, t, 0.0), 2 * self.which + function)
        if not inside.all():
            summits = self.population.take(np.broadcast_to(self.which, t.shape)[~inside])
            outside = summits.log_load_and_area(t[~inside])
            value[~inside], slope[~inside] = outside[function, :2]
        return value, slope

    def first_separation(self, log_load: NDArray) -> NDArray:
        """About the t [1] at which summits carry ``log_load`` ln F_t*."""
        summits = self.population.take(self.which)
        wanted = log_load - np.log(summits.hardness_ratio * summits.summit_parameter)
        t, loads = _plastic_summits()
        found = np.interp(wanted, loads, t)
        for _ in range(2):  # a typical summit tells how far from plastic they are
            ratio = 3.0 / (np.maximum(found, 0.0) + 1.5) / summits.yield_interference
            growth = area_growth(ratio, summits.plastic_ratio)
            softer = np.log(0.5 * growth * summits.pressure(ratio))
            found = np.interp(wanted - softer, loads, t)
        return found


def pieces_for(rtol: float) -> int:
    """Number of pieces of a table of summits that is good for a relative error ``rtol``."""
    doubled = max(np.ceil(np.log2(PIECES_AT_ONE * rtol ** (-1.0 / 6.0) / FEWEST_PIECES)), 0.0)
    return min(FEWEST_PIECES * 2 ** int(doubled), MOST_PIECES)


@lru_cache(maxsize=128)
def _table_of(roughness: tuple, parameters: Parameters, rtol: float) -> HermiteTable:
    """The table of surfaces of so many ``roughness`` [m] that is good for a relative error ``rtol``."""
    if len(roughness) > 1:
        return HermiteTable.joined([_table_of((each,), parameters, rtol) for each in roughness])
    summits = SummitPopulation.of(parameters.surface(roughness[0]), parameters)
    return HermiteTable(summits.log_load_and_area, *TABLE_RANGE, pieces_for(rtol))


@lru_cache
def _plastic_summits():
    """t, and increasing ln F_ss* there of summits that all are plastic, of unit hardness and density."""
    t = np.linspace(*TABLE_RANGE, 91)[::-1]
    loads, _ = SummitPopulation(1.0, 1e300, 1.0, 1.0, 1.0).log_load(t)
    return t, loads
