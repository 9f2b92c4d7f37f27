"""The summits at many points, by quadrature or from tables."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.asperity import SummitPopulation, area_growth
from thirdbody.core.interpolation import Guesses, HermiteTable
from thirdbody.core.parameters import Parameters, Surface

TABLE_RANGE = -5.0, 40.0  # of t = (d - y_s)/sigma_s
# Number of pieces of a table.  The error, which falls with their sixth power, is at most a
# hundredth of rtol, so that few points magnify it beyond rtol.  With the most pieces it is no more
# than rounding.
PIECES_AT_ONE, FEWEST_PIECES, MOST_PIECES = 11.0, 45, 720
GUESSES = 1601  # steps of half a unit of ln F_ss*
LOAD, AREA = range(2)  # indices of the functions in a table
QUADRATURE_ERROR = 5e-14  # of ln F_ss and ln A_ss


@dataclass(frozen=True, eq=False)
class Summits:
    """The summits at many points.

    ``surfaces`` and ``population`` have an element per roughness.  ``which`` is the index of the
    roughness, for each point or a single index for all.  ``table`` has ln F_ss* and ln A_ss* over t
    for each roughness in turn; it is None for quadrature.
    """

    surfaces: Surface
    population: SummitPopulation
    table: HermiteTable | None
    which: NDArray

    @classmethod
    def of(cls, roughness: NDArray, parameters: Parameters, table_rtol: float | None) -> Summits:
        """The summits at points with ``roughness`` sigma [m], 1-D.

        ``table_rtol`` is the relative error of the tables, or None for quadrature.
        """
        values = np.unique(roughness)
        which = np.searchsorted(values, roughness) if values.size > 1 else np.zeros((), int)
        surfaces = parameters.surface(values)
        table = None
        if table_rtol is not None:
            table = _table_of(tuple(values.tolist()), parameters, table_rtol)
        return cls(
            surfaces=surfaces,
            population=SummitPopulation.of(surfaces, parameters),
            table=table,
            which=which,
        )

    def take(self, chosen) -> Summits:
        """The summits at the points selected by an index or mask ``chosen``."""
        return replace(self, which=self.which[chosen]) if self.which.ndim else self

    @cached_property
    def offset(self):
        """y_s [m]."""
        return np.take(self.surfaces.summit_offset, self.which)

    @cached_property
    def deviation(self):
        """sigma_s [m]."""
        return np.take(self.surfaces.summit_deviation, self.which)

    @cached_property
    def error(self):
        """Bound on the error of ln F_ss* and ln A_ss*, without rounding."""
        if self.table is None:
            return QUADRATURE_ERROR
        errors = self.table.error.reshape(-1, 2).max(axis=1)
        return errors[self.which] + QUADRATURE_ERROR

    @cached_property
    def here(self) -> SummitPopulation:
        """The population at each point."""
        return self.population.take(self.which)

    def log_load(self, t: NDArray) -> tuple[NDArray, NDArray]:
        """ln F_ss* and its slope d/dt at summit separations ``t`` [1]."""
        return self.here.log_load(t) if self.table is None else self._read(self.table, t, LOAD)

    def log_load_and_area(self, t: NDArray) -> tuple:
        """ln F_ss* and ln(A_ss/A_n), each with its slope d/dt, at summit separations ``t`` [1]."""
        if self.table is None:
            return tuple(self.here.log_load_and_area(t)[:, :2])
        return self._read(self.table, t, LOAD), self._read(self.table, t, AREA)

    def _read(self, table, t, function):
        """ln F_ss* (``function`` LOAD) or ln A_ss* (AREA) from the ``table``, and the slope."""
        inside = table.covers(t)
        value, slope = table(np.where(inside, t, 0.0), 2 * self.which + function)
        if not inside.all():
            summits = self.population.take(np.broadcast_to(self.which, t.shape)[~inside])
            outside = summits.log_load_and_area(t[~inside])
            value[~inside], slope[~inside] = outside[function, :2]
        return value, slope

    def first_separation(self, log_total: NDArray) -> NDArray:
        """Approximate t [1] at which the summits carry ``log_total`` ln F_t*."""
        summits = self.here
        log_load = log_total - np.log(summits.hardness_ratio * summits.scaled_density)
        plastic = _plastic_summits()
        t = plastic(log_load)
        for _ in range(2):  # a correction, as a typical summit is not fully plastic
            ratio = 3.0 / (np.maximum(t, 0.0) + 1.5) / summits.yield_interference
            growth = area_growth(ratio, summits.plastic_ratio)
            softer = np.log(0.5 * growth * summits.pressure(ratio))
            t = plastic(log_load - softer)
        return t


def pieces_for(rtol: float) -> int:
    """Number of pieces of a summit table with a relative error ``rtol``."""
    doubled = max(np.ceil(np.log2(PIECES_AT_ONE * rtol ** (-1.0 / 6.0) / FEWEST_PIECES)), 0.0)
    return min(FEWEST_PIECES * 2 ** int(doubled), MOST_PIECES)


@lru_cache(maxsize=128)
def _table_of(roughness: tuple, parameters: Parameters, rtol: float) -> HermiteTable:
    """The table of the surfaces with ``roughness`` sigma [m], with a relative error ``rtol``."""
    if len(roughness) > 1:
        return HermiteTable.joined([_table_of((each,), parameters, rtol) for each in roughness])
    summits = SummitPopulation.of(parameters.surface(roughness[0]), parameters)
    return HermiteTable(summits.log_load_and_area, *TABLE_RANGE, pieces_for(rtol))


@lru_cache
def _plastic_summits():
    """t over ln F_ss* of fully plastic summits of unit hardness and density."""
    t = np.linspace(*TABLE_RANGE, 181)[::-1]
    summits = SummitPopulation(
        scaled_density=1.0,
        sharpness=1e300,
        hardness_ratio=1.0,
        yield_ratio=1.0,
        plastic_ratio=1.0,
    )
    loads, _ = summits.log_load(t)
    return Guesses(loads, t, GUESSES)
