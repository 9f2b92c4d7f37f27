"""The summits under the points: by quadrature, or read off tables of it.

In units of eta_s R sigma_s, load and area of the summits depend on t = (d - y_s)/sigma_s and
w_1 = omega_1/sigma_s alone.  A ``Sheet`` is what has tables: the surfaces of one w_1, or all whose
w_1 lies in a cell of its logarithm.  ``RoughSurfaces`` are the surfaces of points, and the
``Summits`` of ``thirdbody.model.contact``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.asperity import SummitPopulation
from thirdbody.model.parameters import Parameters, Surface
from thirdbody.solver.tabulation import PiecewisePolynomial, chebyshev_points, sample_points

# Up to so many roughnesses have tables of their own; more share those of cells, each of which takes
# as long to make as the tables of some ten.
FEW_SURFACES = 64
_most_with_their_own = ContextVar("most_with_their_own", default=FEW_SURFACES)
CELL = 0.25  # width of a cell in ln w_1,
LAST_CELL = 3000  # which is not beyond this in float64
FIRST_SAMPLES = np.linspace(-5.0, 40.0, 46)  # t where a first guess is read off
# Summit separations t [1] of tables: cells would need more terms below
TABLE_START, CELL_START, TABLE_END = -5.0, -2.0, 40.0
# (least rtol, pieces in a unit of t, degree, terms in ln w_1): tables whose error in ln F_ss and
# ln A_ss is a tenth of it or less
TABLE_SIZES = ((1e-5, 4 / 3, 5, 6), (1e-7, 4.0, 5, 8), (0.0, 4.0, 7, 10))


def table_size(rtol: float) -> tuple[float, int, int]:
    """Pieces in a unit of t, degree and terms of the tables that are good for an error ``rtol``."""
    return next(tuple(size) for least, *size in TABLE_SIZES if rtol >= least)


class Sheet(NamedTuple):
    """The surfaces that share tables.

    ``middle`` is their ln w_1, ``half_width`` by how much it may differ, 0 for tables of one w_1;
    ``materials`` are those of ``SummitPopulation``.
    """

    middle: float
    half_width: float
    materials: tuple[float, float, float]

    @classmethod
    def of_one(cls, log_yield: float, materials: tuple) -> Sheet:
        """The sheet of one ln w_1."""
        return cls(float(log_yield), 0.0, materials)

    @classmethod
    def of_cell(cls, number: float, materials: tuple) -> Sheet:
        """The sheet of the cell with a number of ``cells_of``."""
        return cls((float(number) + 0.5) * CELL, 0.5 * CELL, materials)

    @property
    def is_cell(self) -> bool:
        """Whether the tables depend on w_1 too."""
        return self.half_width > 0.0

    def place(self, log_yield: ArrayLike) -> ArrayLike:
        """Where ln w_1 lies between the ends of the cell, from -1 to 1."""
        return (log_yield - self.middle) / self.half_width if self.is_cell else 0.0

    def terms(self, rtol: float) -> int:
        """Number of powers of w_1's place in its tables, to which the time to make them is
        proportional."""
        return table_size(rtol)[2] if self.is_cell else 1

    def population(self, place: float) -> SummitPopulation:
        """Summits of eta_s R sigma_s = 1 at a place from -1 to 1 between the ends of the cell."""
        return SummitPopulation.of_unit(
            np.exp(self.middle + self.half_width * place), self.materials
        )


def summits_of(
    roughness: float | NDArray, parameters: Parameters
) -> tuple[Surface, SummitPopulation]:
    """The summits of a surface of ``roughness`` [m], or of several."""
    surface = parameters.surface(roughness)
    return surface, SummitPopulation.of(surface, parameters)


summits_of_one = lru_cache(maxsize=512)(summits_of)  # of a surface: made once


def log_yields(population: SummitPopulation) -> ArrayLike:
    """ln w_1 of a population, or of each of several."""
    return np.log(population.yield_interference)


@lru_cache(maxsize=512)
def sheet_of_one(roughness: float, parameters: Parameters) -> Sheet:
    """The sheet of the surface of one ``roughness`` [m]."""
    _, summits = summits_of_one(roughness, parameters)
    return Sheet.of_one(log_yields(summits), summits.materials)


def cells_of(log_yield: ArrayLike) -> NDArray:
    """Numbers of the cells in which ln w_1 lies; what overflows is in the last ones."""
    return np.clip(np.nan_to_num(np.floor(log_yield / CELL)), -LAST_CELL, LAST_CELL)


def are_equal(values: NDArray) -> bool:
    """Whether all ``values`` are equal, or there are none."""
    return values.size < 2 or not np.count_nonzero(values != values[0])


@contextmanager
def shared_tables() -> Iterator[None]:
    """Context in which all surfaces share the tables of cells.

    These depend on the materials alone: of very many sets of inputs each surface would have tables of
    its own to make.
    """
    before = _most_with_their_own.set(0)
    try:
        yield
    finally:
        _most_with_their_own.reset(before)


def few_surfaces(roughness: NDArray, is_one: bool = False) -> NDArray | None:
    """All values of ``roughness`` in order, or None if these are too many to have tables of their
    own; ``is_one`` if it is known that all are equal."""
    most = _most_with_their_own.get()
    if most == 0:
        return None
    if is_one or are_equal(roughness):
        return roughness[:1]
    for some in (roughness[:: max(roughness.size // (4 * most), 1)], roughness):
        values = np.unique(some)
        if values.size > most:
            return None
    return values


@dataclass(frozen=True, eq=False)
class SummitTables:
    """Tables of a sheet, or of several side by side.

    ``log_load`` and ``log_area`` are ln F_ss* and ln(A_ss/A_n) over t in units of eta_s R sigma_s.
    """

    log_load: PiecewisePolynomial
    log_area: PiecewisePolynomial

    @classmethod
    def joined(cls, members: Sequence[SummitTables]) -> SummitTables:
        """The tables of several sheets, all of one size, side by side."""
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


@lru_cache(maxsize=128)
def prepare_tables(sheet: Sheet, rtol: float) -> SummitTables:
    """The tables of a sheet that are good for a relative error ``rtol``, made once."""
    density, degree, terms = table_size(rtol)
    start = CELL_START if sheet.is_cell else TABLE_START
    size = start, TABLE_END, round(density * (TABLE_END - start)), degree

    def at(place):
        population = sheet.population(place)
        (loads, _), (areas, _) = population.log_load_and_area(sample_points(*size))
        return (
            PiecewisePolynomial(population.log_load, *size, loads),
            PiecewisePolynomial(population.log_area, *size, areas),
        )

    if not sheet.is_cell:
        return SummitTables(*at(0.0))
    members = zip(*map(at, chebyshev_points(terms - 1)), strict=True)
    return SummitTables(*map(PiecewisePolynomial.between, members, at(0.0)))


@lru_cache(maxsize=512)
def prepare_guesses(sheet: Sheet, table_rtol: float | None) -> tuple[NDArray, NDArray]:
    """Increasing ln F_ss* in units of eta_s R sigma_s in the middle of a sheet, and the t at which
    summits bear it; by quadrature if ``table_rtol`` is None, else by tables."""
    if table_rtol is None:
        t = FIRST_SAMPLES
        loads, _ = sheet.population(0.0).log_load(t)
    else:
        table = prepare_tables(sheet, table_rtol).log_load
        t = table.centres
        loads, _ = table(t)
    return loads[::-1], t[::-1]


@dataclass(frozen=True, eq=False)
class RoughSurfaces:
    """The summits under each of many points.

    ``columns`` and ``population`` hold scalars where all points share one surface, else a number
    for each point.  ``sheets`` are those of the surfaces, with ``tables`` unless all is done by
    quadrature; ``which`` of them and at what ``place`` a point is may be one number for all.
    """

    columns: Surface
    population: SummitPopulation
    sheets: Sequence[Sheet]
    which: NDArray | int
    place: NDArray | float
    table_rtol: float | None
    tables: SummitTables | None

    @classmethod
    def of(
        cls,
        roughness: NDArray,
        parameters: Parameters,
        table_rtol: float | None,
        shared: bool | None = None,
    ) -> RoughSurfaces:
        """The surfaces of points.

        Parameters
        ----------
        roughness : array
            sigma [m], 1-D.
        parameters : Parameters
            Inputs of the model.
        table_rtol : float or None
            Relative error for which tables are good; None: no tables, by quadrature.
        shared : bool, optional
            Whether surfaces share the tables of cells; by default if they are many.

        Raises
        ------
        ValueError
            Where the summit parameter leaves no variance to the summits.
        """
        if shared is None:
            shared = few_surfaces(roughness) is None
        if (roughness == roughness[0]).all():
            roughness = float(roughness[0])
        columns = parameters.surface(roughness)
        population = SummitPopulation.of(columns, parameters)
        log_yield, which, place = log_yields(population), 0, 0.0
        in_cells = shared or table_rtol is None
        values = cells_of(log_yield) if in_cells else log_yield
        if np.ndim(values):
            values, which = np.unique(values, return_inverse=True)
        make = Sheet.of_cell if in_cells else Sheet.of_one
        sheets = [make(value, population.materials) for value in np.atleast_1d(values)]
        if in_cells:
            middles = np.array([sheet.middle for sheet in sheets])
            place = (log_yield - middles[which]) / (0.5 * CELL)
        tables = None
        if table_rtol is not None:
            tables = SummitTables.joined([prepare_tables(sheet, table_rtol) for sheet in sheets])
        return cls(columns, population, sheets, which, place, table_rtol, tables)

    @property
    def is_shared(self) -> bool:
        """Whether all points are on one surface."""
        return np.ndim(self.columns.roughness) == 0

    def take(self, chosen) -> RoughSurfaces:
        """The surfaces of the points that an index or mask ``chosen`` picks."""
        if self.is_shared:
            return self
        return replace(
            self,
            columns=self.columns.take(chosen),
            population=self._populations(chosen),
            which=self.which[chosen] if np.ndim(self.which) else self.which,
            place=self.place[chosen] if np.ndim(self.place) else self.place,
        )

    def _populations(self, chosen):
        population = self.population
        return replace(
            population,
            summit_parameter=population.summit_parameter[chosen],
            sharpness=population.sharpness[chosen],
        )

    @property
    def roughness(self):
        """sigma [m]."""
        return self.columns.roughness

    @property
    def offset(self):
        """y_s [m]."""
        return self.columns.summit_offset

    @property
    def deviation(self):
        """sigma_s [m]."""
        return self.columns.summit_deviation

    @property
    def is_tabulated(self) -> bool:
        """Whether load and area are read off tables."""
        return self.tables is not None

    @property
    def table_error(self):
        """What ln F_ss* and ln(A_ss/A_n) are wrong by at most; zero by quadrature."""
        if self.tables is None:
            return 0.0
        errors = [prepare_tables(sheet, self.table_rtol).error for sheet in self.sheets]
        return np.array(errors)[self.which]

    def log_load(self, t: NDArray) -> tuple[NDArray, NDArray]:
        """ln F_ss* and its slope d/dt at summit separations ``t`` [1]."""
        return self._evaluated("log_load", t)

    def log_area(self, t: NDArray) -> tuple[NDArray, NDArray]:
        """ln(A_ss/A_n) and its slope d/dt at summit separations ``t`` [1]."""
        return self._evaluated("log_area", t)

    def _evaluated(self, name, t):
        if self.tables is None:
            return getattr(self.population, name)(t)
        unit = np.log(self.population.summit_parameter)

        def beyond(t, chosen):
            alone, population = unit, self.population
            if not self.is_shared:
                point = np.broadcast_to(np.arange(self.roughness.size), chosen.shape)[chosen]
                alone, population = unit[point], self._populations(point)
            value, slope = getattr(population, name)(t)
            return value - alone, slope

        table = getattr(self.tables, name)
        value, slope = table.evaluated(t, self.which, self.place, beyond)
        return value + unit, slope

    def first_separation(self, log_load: NDArray) -> NDArray:
        """About the t [1] at which summits bear ``log_load`` ln F_t*."""
        log_load = log_load - np.log(self.population.summit_parameter)
        if np.ndim(self.which) == 0:
            return np.interp(log_load, *prepare_guesses(self.sheets[self.which], self.table_rtol))
        found = np.empty_like(log_load)
        for index in np.unique(self.which):
            mine = self.which == index
            guesses = prepare_guesses(self.sheets[index], self.table_rtol)
            found[mine] = np.interp(log_load[mine], *guesses)
        return found
