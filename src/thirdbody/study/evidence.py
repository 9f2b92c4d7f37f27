"""Curves, turning points and windows of the model, which statements are judged on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves.turning_point import turning_points
from thirdbody.curves.windows import WindowSearch, turning_point_windows
from thirdbody.data.conditions import Condition
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import has_values
from thirdbody.solver.solution import VARIABLES
from thirdbody.solver.solve import DEFAULT_RTOL, solve

WINDOW_DENSITY = 1e11  # eta_a [m-2] for which the paper gives its windows
# A point is evidence up to this error: statements are judged to per cents, whatever rtol is.
LARGEST_ERROR = 1e-3


@dataclass(frozen=True)
class Curve:
    """A solved curve over the load: arrays of shape (loads,), named as in the datasets.

    Attributes
    ----------
    load, normal_load : array
        F_t* [1], increasing, and F_t [N].
    total_contact_area, particle_contact_area_ratio : array
        A_t* and A_sa,t* [1].
    solid_load_fraction, fluid_load_fraction : array
        L_s and L_f [1].
    film_thickness, separation : array
        d/R_x [1], with or without a film, and d [m].
    solved : array of bool
        Which points have values with an error bound of at most ``LARGEST_ERROR``.
    """

    load: NDArray[np.float64]
    normal_load: NDArray[np.float64]
    total_contact_area: NDArray[np.float64]
    particle_contact_area_ratio: NDArray[np.float64]
    solid_load_fraction: NDArray[np.float64]
    fluid_load_fraction: NDArray[np.float64]
    film_thickness: NDArray[np.float64]
    separation: NDArray[np.float64]
    solved: NDArray[np.bool_]

    @cached_property
    def solid_load(self) -> NDArray[np.float64]:
        """Dimensionless load that the solids carry, L_s F_t* [1]."""
        return self.solid_load_fraction * self.load

    @cached_property
    def total_contact_area_slope(self) -> NDArray[np.float64]:
        """d ln A_t*/d ln F_t* [1]: the slope of the curve on logarithmic axes."""
        area = np.maximum(self.total_contact_area, np.finfo(float).tiny)
        return np.gradient(np.log(area), np.log(self.load))

    @cached_property
    def _samples(self) -> dict[str, tuple[NDArray[np.float64], bool]]:
        return {}

    def samples(self, quantity: str) -> tuple[NDArray[np.float64], bool]:
        """Values of an attribute, nan where unsolved, and whether they are logarithms.

        They are logarithms if the attribute is positive everywhere.
        """
        if quantity not in self._samples:
            values = getattr(self, quantity)
            logarithmic = bool((values > 0.0).all())
            values = np.log(values) if logarithmic else values
            self._samples[quantity] = np.where(self.solved, values, np.nan), logarithmic
        return self._samples[quantity]


class TurningPoint(NamedTuple):
    """The most prominent interior maximum of A_sa,t* over the load; nan where there is none.

    Attributes
    ----------
    load, peak_ratio, solid_load_fraction : float
        F_TPCA*, and A_sa,t* and L_s there [1].
    prominence : float
        Height of the maximum above the higher of the least values on both sides [1].
    """

    load: float
    peak_ratio: float
    solid_load_fraction: float
    prominence: float


@dataclass(frozen=True)
class Effort:
    """How finely curves and windows are solved: number of loads, ``rtol``, search for windows."""

    loads: int
    rtol: float
    window: WindowSearch


FULL_EFFORT = Effort(240, DEFAULT_RTOL, WindowSearch(np.linspace(0.3, 2.5, 111)))
# For many sets of inputs; its errors are far below the tolerances of all statements.
QUICK_EFFORT = Effort(
    60, 1e-4, WindowSearch(np.linspace(0.5, 2.0, 31), 24, tolerance=np.inf, rtol=1e-4)
)
SOLVED_FIELDS = tuple(field.name for field in fields(Curve) if field.name in VARIABLES)


class SolvedEvidence:
    """Curves, turning points and windows for one set of inputs, solved when first asked for.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    asked : mapping
        What can be asked for, from ``thirdbody.study.claims.referenced_conditions``.
    newtons : tuple of float
        First and last normal load of every curve [N].
    effort : Effort
        How finely everything is solved.

    Attributes
    ----------
    load_range : tuple of float
        First and last load F_t* [1].
    loads : array
        F_t* [1] of the points of every curve, increasing.

    Examples
    --------
    >>> from thirdbody import load_parameters
    >>> dry = Condition(0.0, 300e-9, 300e-9, 1e11)
    >>> asked = {"curve": {dry}, "turning_point": {dry}, "window": set()}
    >>> evidence = SolvedEvidence(load_parameters(), asked, (0.04, 80.0), QUICK_EFFORT)
    >>> evidence.curve(*dry).total_contact_area.shape
    (60,)
    >>> evidence.turning_point(*dry).prominence > 0.02
    True
    """

    def __init__(
        self,
        parameters: Parameters,
        asked: Mapping[str, set],
        newtons: tuple[float, float],
        effort: Effort = FULL_EFFORT,
    ):
        self.parameters = parameters
        self.effort = effort
        self.load_range = tuple(force / parameters.newtons_per_load for force in newtons)
        self.loads = np.geomspace(*self.load_range, effort.loads)
        self._asked = asked

    def curve(self, *condition: float) -> Curve:
        """The curve over all loads at the four numbers of a ``Condition``, SI."""
        return self._curves[Condition(*condition)]

    def turning_point(self, *condition: float) -> TurningPoint:
        """The turning point of the curve at the four numbers of a ``Condition``, SI."""
        return self._turning_points[Condition(*condition)]

    def window(self, roughness: float) -> tuple[float, float]:
        """Ends of the range of x_a/sigma [1] with a dry turning point at ``roughness`` sigma [m]."""
        return self._windows[roughness]

    @cached_property
    def _conditions(self) -> list[Condition]:
        return sorted(self._asked["curve"] | self._asked["turning_point"])

    @cached_property
    def _solution(self):
        return solve(
            load=self.loads[:, None],
            **Condition(*np.array(self._conditions).T)._asdict(),
            parameters=self.parameters,
            rtol=self.effort.rtol,
            variables=(*SOLVED_FIELDS, "solution_status", "error_bound"),
        )

    @cached_property
    def _curves(self) -> dict[Condition, Curve]:
        solution = self._solution
        newtons = self.loads * self.parameters.newtons_per_load
        solved = has_values(solution.solution_status) & (solution.error_bound <= LARGEST_ERROR)
        return {
            condition: Curve(
                load=self.loads,
                normal_load=newtons,
                solved=solved[:, index],
                **{name: getattr(solution, name)[:, index] for name in SOLVED_FIELDS},
            )
            for index, condition in enumerate(self._conditions)
        }

    @cached_property
    def _windows(self) -> dict[float, tuple[float, float]]:
        wanted = sorted(self._asked["window"])
        found = turning_point_windows(
            [self.effort.window] * len(wanted),
            wanted,
            WINDOW_DENSITY,
            self.load_range,
            self.parameters,
        )
        return {
            roughness: (window.low, window.high)
            for roughness, window in zip(wanted, found, strict=True)
        }

    @cached_property
    def _turning_points(self) -> dict[Condition, TurningPoint]:
        wanted = sorted(self._asked["turning_point"])
        chosen = [self._conditions.index(condition) for condition in wanted]
        found = turning_points(
            self._solution.separation[:, chosen],
            *np.array(wanted).T,
            self.parameters,
            self.effort.rtol,
        )
        columns = found.load, found.peak_ratio, found.solid_load_fraction, found.prominence
        return {
            condition: TurningPoint(*map(float, row))
            for condition, row in zip(wanted, np.array(columns).T, strict=True)
        }
