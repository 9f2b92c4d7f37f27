"""``Solution``, the variables of solved points, and how they follow from the forces."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.film import THICKEST, Film, log_load_parameter
from thirdbody.core.floats import TINY
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import (
    FILM_COUNTS,
    FLAG_MEANINGS,
    NO_FLAG,
    codes_to_name,
    contact_mode,
    gravest_status,
    lubrication_regime,
)
from thirdbody.core.root import Balance
from thirdbody.tabular import Tabular, with_rows
from thirdbody.units import SI, Unit

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


@dataclass(frozen=True, eq=False)
class Solution(Tabular):
    """Solved points: what ``solve`` returns.

    Every variable is an array of the broadcast shape of the arguments of ``solve`` (of xarray if
    one of them is), or None if it was not requested.  Points without solution hold nan, or -1 for
    regime and mode.  The printed form lists the variables, with regimes, modes and statuses by name;
    ``to_dataset`` and ``to_dataframe`` return all of them with labels.  A full film has no name of a mode.

    Attributes
    ----------
    total_contact_area : array
        A_t* = (A_sa + A_ss-sa)/A_n [1] (Eq. 3).
    particle_contact_area_ratio, surface_contact_area_ratio : array
        A_sa,t* and A_ss,t* [1] (Eq. 10).
    solid_load_fraction, fluid_load_fraction : array
        L_s and L_f [1] (Eq. 9).
    separation : array
        Mean separation d [m].
    film_thickness : array
        H_c = d/R_x [1] (Eq. 7); in dry contact the separation alone.
    lubrication_regime, contact_mode, solution_status : array of int8
        Indices into the tuples of ``thirdbody.core.regimes``.
    error_bound : array
        Bound on the relative error of every quantity [1], if the quantity is above 2.2e-308: the change of
        loads and areas between two separations at which the forces are too large and too small, plus
        rounding.  Above the requested ``rtol`` the status is ``not_converged``; the values are kept.
    conditions : mapping
        The five conditions by name, SI: arrays that broadcast to the shape.
    units : mapping
        The unit of each condition as it was given, by name; of quantities the one in engineering units.
    newtons_per_load : float, optional
        F_t/F_t* [N]; datasets then include the load in newtons.
    """

    total_contact_area: NDArray | None = None
    particle_contact_area_ratio: NDArray | None = None
    surface_contact_area_ratio: NDArray | None = None
    solid_load_fraction: NDArray | None = None
    fluid_load_fraction: NDArray | None = None
    separation: NDArray | None = None
    film_thickness: NDArray | None = None
    lubrication_regime: NDArray | None = None
    contact_mode: NDArray | None = None
    solution_status: NDArray | None = None
    error_bound: NDArray | None = None
    conditions: Mapping[str, Any] = field(default_factory=dict)
    units: Mapping[str, Unit] = field(default_factory=lambda: SI)
    newtons_per_load: float | None = None

    @property
    def known(self) -> dict[str, Any]:
        """The requested variables, by name."""
        return {name: getattr(self, name) for name in VARIABLES if getattr(self, name) is not None}

    def to_dataset(self) -> xr.Dataset:
        """The points as a dataset: each variable and condition with its name, unit and symbol.

        Returns
        -------
        xarray.Dataset
            The requested variables; flags are integers with ``flag_values`` and ``flag_meanings``.
            The conditions and ``normal_load`` [N] are coordinates.  A dimension is named after the
            condition if only one varies along it, otherwise ``point``; arrays of xarray keep their
            dimensions and coordinates.  The index of columns of a table is a coordinate of its name, or
            ``row``.

        Raises
        ------
        ModuleNotFoundError
            If xarray is not installed: the extra ``data`` installs it.

        Examples
        --------
        >>> import numpy as np
        >>> import thirdbody as tb
        >>> curves = tb.solve(
        ...     load=np.geomspace(1e-6, 1e-4, 5)[:, np.newaxis],
        ...     viscosity=[0.0, 90e-6],
        ...     particle_diameter=3e-7,
        ...     roughness=3e-7,
        ...     particle_density=1e11,
        ...     parameters=tb.load_parameters(),
        ... )
        >>> dataset = curves.to_dataset()
        >>> dict(dataset.sizes)
        {'load': 5, 'viscosity': 2}
        >>> dataset["separation"].attrs["units"]
        'm'
        """
        return with_rows(self._labelled(), self._index)

    def to_dataframe(self) -> pd.DataFrame:
        """The points as a table: one row per point, its conditions first.

        Returns
        -------
        pandas.DataFrame
            Headings have units: conditions are in those in which they were given, variables in SI.
            Flags are categories by name, nan where a point has none.  The index is that of the
            columns of a table, if conditions are such.

        Raises
        ------
        ModuleNotFoundError
            If xarray and pandas are not installed: the extra ``data`` installs them.

        Examples
        --------
        >>> import thirdbody as tb
        >>> points = tb.solve(
        ...     load=[1e-6, 1e-4],
        ...     viscosity=90e-6,
        ...     particle_diameter=3e-7,
        ...     roughness=3e-7,
        ...     particle_density=1e11,
        ...     parameters=tb.load_parameters(),
        ... )
        >>> table = points.to_dataframe()
        >>> table[["load [1]", "lubrication_regime"]].to_dict("list")
        {'load [1]': [1e-06, 0.0001], 'lubrication_regime': ['boundary', 'mixed']}
        """
        from thirdbody.data.labels import labelled_frame

        return labelled_frame(self._labelled(), self.units, self.newtons_per_load, self._index)

    def _labelled(self) -> xr.Dataset:
        from thirdbody.data.labels import labelled_dataset

        return labelled_dataset(self.known, self.conditions, self.units, self.newtons_per_load)

    def __repr__(self) -> str:
        known = {name: np.asarray(each) for name, each in self.known.items()}
        known |= codes_to_name(known)
        shape = next(iter(known.values())).shape if known else ()
        lines = [f"{name:<28}{_in_words(name, each)}" for name, each in known.items()]
        return "\n".join([f"Solution of shape {shape}", *lines])

    __str__ = __repr__


OTHERS = "conditions", "units", "newtons_per_load"
VARIABLES = tuple(each.name for each in fields(Solution) if each.name not in OTHERS)
FLAGS = tuple(FLAG_MEANINGS)
QUANTITIES = tuple(name for name in VARIABLES if name not in (*FLAGS, "error_bound"))


def _in_words(name, values) -> str:
    """A number, or the range of numbers; for a flag the names with their counts."""
    if name in FLAGS:
        words = *FLAG_MEANINGS[name], "none"  # NO_FLAG indexes the last
        if values.size == 1:
            return words[values.item()]
        found = np.unique(values, return_counts=True)
        return ", ".join(f"{words[flag]} ({count})" for flag, count in zip(*found, strict=True))
    known = values[~np.isnan(values)]
    if known.size == 0:
        return "none"
    unit = ""
    if name == "separation":
        known, unit = 1e9 * known, " nm"
    ends = f"{known.min():.6g}", f"{known.max():.6g}"
    return (ends[0] if values.size == 1 else " to ".join(ends)) + unit


def type_of(variable: str) -> type:
    """Data type of a ``variable`` of ``Solution``."""
    return np.int8 if variable in FLAGS else float


def describe(balance: Balance, rtol: float) -> dict[str, NDArray]:
    """Variables of ``Solution`` by name, as 1-D arrays over ``balance.points``, for a requested ``rtol``."""
    points, ends = balance.points, balance.forces
    solid, fluid = fractions(ends.log_solid.value - ends.log_fluid)  # Eq. 9, F_t = F_s + F_f
    both = quantities(
        separation=ends.separation,
        solid_load_fraction=solid,
        fluid_load_fraction=fluid,
        particle_area=ends.solids.particle_area.value,
        log_summit_area=ends.solids.log_summit_area.value,
        parameters=points.parameters,
    )
    found = {name: 0.5 * each.sum(axis=0) for name, each in both.items()}
    error = _error_bound(ends, both)
    error = np.where(balance.certain & (error <= 1.0), error, np.inf)
    found["error_bound"] = error
    particles = points.contact.particles
    covered = particles is not None and particles.covers_all
    unsolved = np.isnan(found["separation"])
    statuses = {
        "not_converged": ~(error <= rtol),
        "coverage_exceeded": covered,
        "load_exceeded": unsolved,
    }
    with_particles = particles is not None
    add_flags(found, points.film, points.log_total, points.parameters, with_particles, **statuses)
    _remove_values(found, unsolved | covered)
    return found


def quantities(
    *,
    separation: NDArray,
    solid_load_fraction: NDArray,
    fluid_load_fraction: NDArray,
    particle_area: NDArray,
    log_summit_area: NDArray,
    parameters: Parameters,
) -> dict[str, NDArray]:
    """The ``QUANTITIES`` by name (Eqs. 3 and 10), in arrays of one shape.

    Parameters
    ----------
    separation : array
        d [m].
    solid_load_fraction, fluid_load_fraction : array
        L_s and L_f [1] (Eq. 9).
    particle_area : array
        A_sa/A_n [1].
    log_summit_area : array
        ln(A_ss-sa/A_n) [1], of the summits beside the particles.
    parameters : Parameters
        Inputs of the model.
    """
    particles, summits = fractions(np.log(particle_area) - log_summit_area)
    return {
        "total_contact_area": particle_area + np.exp(log_summit_area),  # Eq. 3
        "particle_contact_area_ratio": particles,  # Eq. 10
        "surface_contact_area_ratio": summits,
        "solid_load_fraction": solid_load_fraction,
        "fluid_load_fraction": fluid_load_fraction,
        "separation": separation,
        "film_thickness": separation / parameters.ball_radius,
    }


def fractions(log_odds: NDArray) -> tuple[NDArray, NDArray]:
    """The fractions [1] of two parts in their sum, for ln of the first over the second."""
    return 1.0 / (1.0 + np.exp(-log_odds)), 1.0 / (1.0 + np.exp(log_odds))


def _remove_values(found, unsolved):
    """Replace the variables of ``unsolved`` points, except their status, by what stands for none."""
    if not unsolved.any():
        return
    for name, values in found.items():
        if name != "solution_status":
            values[unsolved] = np.nan if type_of(name) is float else NO_FLAG


def add_flags(
    found: dict[str, NDArray],
    film: Film | None,
    log_load: NDArray,
    parameters: Parameters,
    has_particles: bool,
    **statuses: NDArray,
) -> None:
    """Add regime, mode and status to the variables ``found`` under loads ln F_t* [1].

    ``statuses`` are the statuses, by name, that do not follow from the variables.
    """
    found["lubrication_regime"] = lubrication_regime(found["solid_load_fraction"])
    found["contact_mode"] = contact_mode(found["particle_contact_area_ratio"], has_particles)
    statuses["area_exceeded"] = found["total_contact_area"] > 1.0
    if film is not None:
        fluid = found["fluid_load_fraction"]
        log_fluid = np.log(fluid) if parameters.film_shares_load else 0.0
        meaningful = film.is_meaningful(log_load_parameter(log_load + log_fluid, parameters))
        meaningful &= found["film_thickness"] <= THICKEST
        statuses["outside_film_formula"] = ~meaningful & (fluid > FILM_COUNTS)
    found["solution_status"] = gravest_status(**statuses)


def _error_bound(ends, both):
    """Largest relative deviation of loads and areas from the mean of both ends, plus rounding; ``both``
    are the quantities at the ends by name."""
    width = np.diff(ends.separation, axis=0)[0]
    areas = _area_difference(ends.solids, both, width)
    loads, shared = _load_difference(ends, both, width)
    apart = np.maximum(width / ends.separation[0], np.maximum(areas, loads))
    rounding = np.maximum(*ends.errors.rounding)
    rounding += np.where(shared, np.maximum(*ends.solid_noise), 0.0)
    return 0.5 * np.expm1(apart) + rounding


def _area_difference(solids, both, width):
    """Largest relative difference of the areas of summits and particles between both ends."""
    area, log_summits = solids.particle_area, solids.log_summit_area.value
    log_bare = np.log1p(-solids.coverage)
    summits = _difference(log_summits - log_bare) + _difference(log_bare)
    # an area that is negligible alone may matter in a ratio
    smaller = np.minimum(both["particle_contact_area_ratio"], both["surface_contact_area_ratio"])
    # the steeper slope of both ends leaves a margin
    rise = width * np.abs(area.slope).max(axis=0) / area.value.min(axis=0)
    particles = np.maximum(_difference(np.log(area.value)), rise)
    summits = _where_resolved(summits, np.maximum(np.exp(log_summits), smaller))
    return summits + _where_resolved(particles, np.maximum(area.value, smaller))


def _load_difference(ends, both, width):
    """Largest relative difference of the loads of solids and film between both ends, and where both
    carry load."""
    solid, fluid = both["solid_load_fraction"], both["fluid_load_fraction"]
    shared = np.minimum(solid, fluid).max(axis=0) > TINY
    rise = width * np.abs(ends.log_solid.slope).max(axis=0)
    solids = np.maximum(_difference(ends.log_solid.value), rise)
    loads = _where_resolved(solids, solid) + _where_resolved(_difference(ends.log_fluid), fluid)
    return np.where(shared, loads, 0.0), shared


def _difference(both):
    return np.abs(both[0] - both[1])


def _where_resolved(difference, fraction):
    """The ``difference`` of logarithms where float64 holds all digits of ``fraction``; else 0."""
    return np.where(fraction.max(axis=0) > TINY, difference, 0.0)
