"""What is known of solved points; a variable that nobody asks for costs nothing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import expit, log_expit

from thirdbody.model.computed_once import computed_once
from thirdbody.model.film import THICKEST
from thirdbody.model.regimes import (
    FILM_COUNTS,
    FLAG_MEANINGS,
    NO_FLAG,
    contact_mode,
    gravest_status,
    lubrication_regime,
)
from thirdbody.solver.balance import BALANCES, dry_balance
from thirdbody.solver.points import Points
from thirdbody.solver.several import may_be_several

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

LEAST_RTOL = 1e-12  # of roots that nothing but rounding limits
ROOT_SHARE = 0.5  # of the error asked for: left by the roots
NARROW = 1e-3  # of the spread of sizes: over so little slopes of areas stay what they are


@dataclass(frozen=True)
class Solution:
    """Solved points: what ``solve`` returns.

    Every attribute is an array of the broadcast shape of the arguments of ``solve``, of xarray if one
    of these is, or None if it was not asked for.  Points without solution hold nan, or -1 where a
    flag has no meaning.  Printed, it says what each is, with regimes, modes and statuses by name;
    ``to_dataset`` and ``to_dataframe`` give all of them with their labels.

    Attributes
    ----------
    total_contact_area : array
        A_t* = (A_sa + A_ss-sa)/A_n [1] (Eq. 5).
    particle_contact_area_ratio, surface_contact_area_ratio : array
        A_sa,t* and A_ss,t* [1] (Eq. 10).
    solid_load_fraction, fluid_load_fraction : array
        L_s and L_f [1] (Eq. 9).
    separation : array
        Mean separation d [m].
    film_thickness : array
        H_c = d/R_x [1] (Eq. 7).
    lubrication_regime, contact_mode, solution_status : array of int8
        Indices into the tuples of ``thirdbody.model.regimes``.
    separation_count : array of int8
        At how many separations the forces balance; of several the largest is given, which closing
        surfaces meet first.
    error_bound : array
        What the relative error of every quantity stays below [1], if the quantity is above 2.2e-308,
        below which float64 loses digits.  Where rounding keeps it above the ``rtol`` that was asked
        for, the status is ``not_converged``, but the values stand.
    conditions : mapping
        The five conditions that were solved, by name, SI: arrays that broadcast to the shape.
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
    separation_count: NDArray | None = None
    error_bound: NDArray | None = None
    conditions: Mapping[str, Any] = field(default_factory=dict)

    @property
    def known(self) -> dict[str, Any]:
        """The variables that were asked for, by name."""
        return {name: getattr(self, name) for name in VARIABLES if getattr(self, name) is not None}

    def to_dataset(self) -> xr.Dataset:
        """The points as a dataset: each variable and condition with its name, unit and symbol.

        Returns
        -------
        xarray.Dataset
            Variables are those that were asked for, flags integers with ``flag_values`` and
            ``flag_meanings``.  The conditions are coordinates.  A dimension has the name of the
            condition that alone varies along it, else it is called ``point``; arrays of xarray keep
            their dimensions and coordinates.

        Raises
        ------
        ModuleNotFoundError
            In one line, if xarray is not installed: the extra ``data`` brings it.

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
        from thirdbody.data.labels import labelled_dataset

        return labelled_dataset(self.known, self.conditions)

    def to_dataframe(self) -> pd.DataFrame:
        """The points as a table: one row a point, its conditions first.

        Returns
        -------
        pandas.DataFrame
            Numbers are in SI, the units in ``attrs["units"]``.  Flags are categories by their names,
            nan where a point has none.

        Raises
        ------
        ModuleNotFoundError
            In one line, if xarray and its pandas are not installed: the extra ``data`` brings them.

        Examples
        --------
        >>> import thirdbody as tb
        >>> points = tb.solve(
        ...     load=[1e-6, 1e-5],
        ...     viscosity=90e-6,
        ...     particle_diameter=3e-7,
        ...     roughness=3e-7,
        ...     particle_density=1e11,
        ...     parameters=tb.load_parameters(),
        ... )
        >>> table = points.to_dataframe()
        >>> table[["load", "lubrication_regime"]].to_dict("list")
        {'load': [1e-06, 1e-05], 'lubrication_regime': ['boundary', 'boundary']}
        """
        from thirdbody.data.labels import labelled_dataset, labelled_frame

        return labelled_frame(labelled_dataset(self.known, self.conditions))

    def __repr__(self) -> str:
        known = {name: np.asarray(each) for name, each in self.known.items()}
        shape = next(iter(known.values())).shape if known else ()
        lines = [f"{name:<28}{_told(name, each)}" for name, each in known.items()]
        return "\n".join([f"Solution of shape {shape}", *lines])


VARIABLES = tuple(each.name for each in fields(Solution) if each.name != "conditions")
FLAGS = tuple(FLAG_MEANINGS)
WHOLE = (*FLAGS, "separation_count")
OF_AREAS = {
    "contact_mode",
    "solution_status",
    *(name for name in VARIABLES if "contact_area" in name),
}
QUANTITIES = tuple(name for name in VARIABLES if name not in (*WHOLE, "error_bound"))


def _told(name, values) -> str:
    """A number, or the least and the greatest; of a flag the names, each with how many have it."""
    if name in FLAGS:
        found, counts = np.unique(values, return_counts=True)
        words = ["none" if index < 0 else FLAG_MEANINGS[name][index] for index in found]
        if values.size == 1:
            return words[0]
        return ", ".join(f"{word} ({count})" for word, count in zip(words, counts, strict=True))
    known = values[~np.isnan(values)]
    if known.size == 0:
        return "none"
    ends = f"{known.min():.6g}", f"{known.max():.6g}"
    return ends[0] if values.size == 1 else " to ".join(ends)


def type_of(variable: str) -> type:
    """Type of the values of a ``variable`` of ``Solution``."""
    return np.int8 if variable in WHOLE else float


class SolvedPoints:
    """Points whose forces are balanced, by quadrature or by tables as their surfaces say.

    Parameters
    ----------
    points : Points
        All with or without particles, all with or without a film.
    rtol : float
        Relative error asked for.  By quadrature the roots are as good as float64 allows.

    Attributes
    ----------
    left : array of bool
        Points that magnify the errors of tables beyond ``rtol``, or that may have several
        separations, and are to be solved by quadrature; by quadrature none is left.

    Notes
    -----
    The variables of ``Solution`` are attributes too, 1-D arrays that are evaluated when read.
    """

    def __init__(self, points: Points, rtol: float):
        self.points = points
        film_load = points.parameters.readings.film_load
        solve = dry_balance if points.film is None else BALANCES[type(film_load)]
        self._balance = solve(
            points, ROOT_SHARE * rtol if points.surfaces.is_tabulated else LEAST_RTOL
        )
        error = self._balance.error + self._error_between_sizes()
        self._error = np.where(error > 1.0, np.inf, error)  # beyond that slopes tell nothing
        self.left = ~(self._error <= rtol) | may_be_several(points)
        self.left &= points.surfaces.is_tabulated
        self._rtol = rtol
        self._void = np.isnan(self._balance.separation) | self._leave_no_room
        self._complete = not self._void.any()

    @computed_once
    def _touching(self):
        """What ``ParticleLayer.contact`` returns there."""
        return self.points.contact.particles.contact(self._balance.separation)

    def _error_between_sizes(self):
        """Relative error of areas from that of d, where slopes there do not tell it: some particles
        lose touch within it, or it may be that none touches.
        """
        particles, balance = self.points.contact.particles, self._balance
        if particles is None:
            return 0.0
        beside = np.abs(particles.reach - balance.separation)
        error = np.where(beside <= balance.width, np.inf, 0.0)
        wide = np.flatnonzero(balance.width > NARROW * particles.spread)
        if wide.size:
            separation, width = balance.separation[wide], balance.width[wide]
            error[wide] += particles.take(wide).change(separation - width, separation + width)
        return error

    @computed_once
    def _leave_no_room(self):
        """Whether particles cover the whole interface."""
        particles = self.points.contact.particles
        if particles is None:
            return np.zeros(self._balance.separation.shape, bool)
        return particles.leave_no_room(self._touching[2])

    @computed_once
    def solution_status(self):
        points, balance = self.points, self._balance
        applies = {
            "several_separations": balance.count > 1,
            "area_exceeded": self.total_contact_area > 1.0,
            "not_converged": ~(self._error <= self._rtol),
            "coverage_exceeded": self._leave_no_room,
            "load_exceeded": self._cannot_bear(),
        }
        if points.film is not None:
            share = points.parameters.readings.film_load.log_share(log_expit(-balance.logit))
            meaningful = points.film.is_meaningful(points.log_load_parameter(share))
            outside = ~meaningful | (self.film_thickness > THICKEST)
            counts = expit(-balance.logit) > FILM_COUNTS
            applies["outside_film_formula"] = outside & counts
        return gravest_status(**applies)

    def _cannot_bear(self):
        """Whether the load is too much for the solids wherever they do not cut across each other's
        mean planes, at d >= 0."""
        cannot = np.isnan(self._balance.separation)
        if not cannot.any():
            return cannot
        some = self.points.take(np.flatnonzero(cannot))
        bears = some.contact.log_solid_load(np.zeros(some.log_load.shape)).value
        cannot[cannot] = bears < some.log_load
        return cannot

    def _valid(self, values, otherwise=np.nan):
        """``values`` where there is a solution, else ``otherwise``."""
        return values if self._complete else np.where(self._void, otherwise, values)

    @property
    def error_bound(self):
        return self._valid(self._error)

    @property
    def separation_count(self):
        return self._valid(self._balance.count, 0)

    @computed_once
    def _areas(self):
        """A_sa/A_n and ln(A_ss/A_n)."""
        touching = self.points.contact.particles and self._touching
        particles, log_summits = self.points.contact.areas(self._balance.separation, touching)
        return self._valid(particles), self._valid(log_summits)

    @computed_once
    def _log_area_odds(self):
        """ln(A_sa/A_ss)."""
        particles, log_summits = self._areas
        return np.log(particles) - log_summits

    @computed_once
    def total_contact_area(self):
        particles, log_summits = self._areas
        return particles + np.exp(log_summits)  # Eq. 3

    @computed_once
    def particle_contact_area_ratio(self):
        return expit(self._log_area_odds)

    @property
    def surface_contact_area_ratio(self):
        return expit(-self._log_area_odds)

    @computed_once
    def solid_load_fraction(self):
        return self._valid(expit(self._balance.logit))

    @property
    def fluid_load_fraction(self):
        return self._valid(expit(-self._balance.logit))

    @computed_once
    def separation(self):
        return self._valid(self._balance.separation)

    @property
    def film_thickness(self):
        return self.separation / self.points.parameters.ball_radius

    @property
    def lubrication_regime(self):
        return self._valid(lubrication_regime(self.solid_load_fraction), NO_FLAG)

    @property
    def contact_mode(self):
        mode = contact_mode(
            self.particle_contact_area_ratio, self.points.contact.particles is not None
        )
        return self._valid(mode, NO_FLAG)
