"""The summits under the points: by quadrature, or read off tables of it.

One roughness is prepared once, as a ``RoughSurface``; the points of one or several roughnesses
see them as ``RoughSurfaces``, which is the ``Summits`` of ``thirdbody.model.contact``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from thirdbody.model.asperity import SummitPopulation
from thirdbody.model.parameters import Parameters, Surface
from thirdbody.solver.tabulation import PiecewisePolynomial, sample_points

FIRST_SAMPLES = np.linspace(-5.0, 40.0, 46)  # t where a first guess is read off
TABLE_START, TABLE_END = -5.0, 40.0  # summit separations t [1]
# (least rtol, pieces, degree): tables whose error in ln F_ss and ln A_ss is a tenth of it or less
TABLE_SIZES = ((1e-5, 60, 5), (1e-7, 180, 5), (0.0, 180, 7))


def table_size(rtol: float) -> tuple[int, int]:
    """Pieces and degree of the tables that are good for a relative error ``rtol``."""
    return next(tuple(size) for least, *size in TABLE_SIZES if rtol >= least)


@dataclass(frozen=True, eq=False)
class SummitTables:
    """Tables of ln F_ss* and ln(A_ss/A_n) over t, of one surface or of several side by side."""

    log_load: PiecewisePolynomial
    log_area: PiecewisePolynomial

    @classmethod
    def of(cls, population: SummitPopulation, rtol: float) -> SummitTables:
        """Tables of a ``population`` that are good for a relative error ``rtol``."""
        size = TABLE_START, TABLE_END, *table_size(rtol)
        (loads, _), (areas, _) = population.log_load_and_area(sample_points(*size))
        return cls(
            PiecewisePolynomial(population.log_load, *size, loads),
            PiecewisePolynomial(population.log_area, *size, areas),
        )

    @classmethod
    def joined(cls, members: Sequence[SummitTables]) -> SummitTables:
        """The tables of several surfaces, all of one size, side by side."""
        if len(members) == 1:
            return members[0]
        return cls(
            PiecewisePolynomial.joined([tables.log_load for tables in members]),
            PiecewisePolynomial.joined([tables.log_area for tables in members]),
        )

    @property
    def error(self) -> float:
        """What both logarithms are wrong by at most."""
        return max(self.log_load.error, self.log_area.error)


@dataclass(frozen=True, eq=False)
class RoughSurface:
    """Summits of one roughness.

    ``population`` gives their load and area by quadrature; ``tables`` stand in for it, or are
    None.  ``guesses`` are increasing values of ln F_ss* and the t at which summits bear them.
    """

    surface: Surface
    population: SummitPopulation
    tables: SummitTables | None
    guesses: tuple[NDArray, NDArray]


@lru_cache(maxsize=512)
def prepare_surface(
    roughness: float, parameters: Parameters, table_rtol: float | None
) -> RoughSurface:
    """The surface of one roughness, prepared once for all points that share it.

    Parameters
    ----------
    roughness : float
        sigma [m].
    parameters : Parameters
        Inputs of the model.
    table_rtol : float or None
        Relative error for which its tables are good; None: no tables, by quadrature.

    Returns
    -------
    RoughSurface

    Raises
    ------
    ValueError
        Where the summit parameter leaves no variance to the summits.
    """
    surface = parameters.surface(roughness)
    population = SummitPopulation.of(surface, parameters)
    if table_rtol is None:
        loads, _ = population.log_load(FIRST_SAMPLES)
        return RoughSurface(surface, population, None, (loads[::-1], FIRST_SAMPLES[::-1]))
    tables = SummitTables.of(population, table_rtol)
    centres = tables.log_load.centres
    loads, _ = tables.log_load(centres)
    return RoughSurface(surface, population, tables, (loads[::-1], centres[::-1]))


@dataclass(frozen=True, eq=False)
class RoughSurfaces:
    """The summits under each of many points, whose surfaces all have tables or all have none.

    ``members`` are the surfaces, one of each roughness; ``which`` is the index of that of each
    point, or 0 where all points share the only one.  ``columns`` and ``tables`` hold the numbers
    and the tables of all members.
    """

    members: Sequence[RoughSurface]
    which: NDArray | int
    parameters: Parameters
    columns: Surface
    tables: SummitTables | None

    @classmethod
    def of(
        cls, roughness: NDArray, parameters: Parameters, table_rtol: float | None
    ) -> RoughSurfaces:
        """The surfaces of points with ``roughness`` sigma [m], 1-D.

        ``table_rtol`` and what is raised are as in ``prepare_surface``.
        """
        if (roughness == roughness[0]).all():
            values, which = roughness[:1], 0
        else:
            values, which = np.unique(roughness, return_inverse=True)
        members = [prepare_surface(sigma, parameters, table_rtol) for sigma in values.tolist()]
        columns = zip(*(vars(member.surface).values() for member in members), strict=True)
        tables = None
        if table_rtol is not None:
            tables = SummitTables.joined([member.tables for member in members])
        return cls(members, which, parameters, Surface(*map(np.array, columns)), tables)

    @property
    def is_shared(self) -> bool:
        """Whether all points are on one surface."""
        return np.ndim(self.which) == 0

    def take(self, chosen) -> RoughSurfaces:
        """The surfaces of the points that an index or mask ``chosen`` picks."""
        return self if self.is_shared else replace(self, which=self.which[chosen])

    @property
    def roughness(self):
        """sigma [m]."""
        return self.columns.roughness[self.which]

    @property
    def offset(self):
        """y_s [m]."""
        return self.columns.summit_offset[self.which]

    @property
    def deviation(self):
        """sigma_s [m]."""
        return self.columns.summit_deviation[self.which]

    @property
    def is_tabulated(self) -> bool:
        """Whether load and area are read off tables."""
        return self.tables is not None

    @property
    def table_error(self):
        """What ln F_ss* and ln(A_ss/A_n) are wrong by at most; zero by quadrature."""
        errors = [member.tables.error if member.tables else 0.0 for member in self.members]
        return np.array(errors)[self.which]

    def log_load(self, t: NDArray) -> tuple[NDArray, NDArray]:
        """ln F_ss* and its slope d/dt at summit separations ``t`` [1]."""
        return self._evaluated("log_load", t)

    def log_area(self, t: NDArray) -> tuple[NDArray, NDArray]:
        """ln(A_ss/A_n) and its slope d/dt at summit separations ``t`` [1]."""
        return self._evaluated("log_area", t)

    def _evaluated(self, name, t):
        by_quadrature = partial(self._by_quadrature, name)
        if self.tables is None:
            return by_quadrature(t, self.which)
        return getattr(self.tables, name).evaluated(t, self.which, by_quadrature)

    def _by_quadrature(self, name, t, which):
        if self.is_shared:
            population = self.members[0].population
        else:
            numbers = Surface(*(column[which] for column in vars(self.columns).values()))
            population = SummitPopulation.of(numbers, self.parameters)
        return getattr(population, name)(t)

    def first_separation(self, log_load: NDArray) -> NDArray:
        """About the t [1] at which summits bear ``log_load`` ln F_t*."""
        if self.is_shared:
            return np.interp(log_load, *self.members[0].guesses)
        found = np.empty_like(log_load)
        for index in np.unique(self.which):
            mine = self.which == index
            found[mine] = np.interp(log_load[mine], *self.members[index].guesses)
        return found
