"""Curves, turning points and windows of the model, which statements are judged on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves.turning_point import TurningPoints, turning_points
from thirdbody.curves.windows import WindowSearch, turning_point_windows
from thirdbody.data.conditions import Condition
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import has_values
from thirdbody.solver.solution import VARIABLES
from thirdbody.solver.solve import DEFAULT_RTOL, solve

WINDOW_DENSITY = 1e11  # ASSUME: eta_a [m-2] of all windows; the paper names it for that of 300 nm
# A point is evidence up to this error: statements are judged to per cents, whatever rtol is.
LARGEST_ERROR = 1e-3


@dataclass(frozen=True)
class Curve:
    """A solved curve over the load: arrays of shape (loads,), named as in the datasets, SI.

    ``film_thickness`` is d/R_x [1], with or without a film; ``solved`` says which points have values
    with an error bound of at most ``LARGEST_ERROR``.
    """

    load: NDArray[np.float64]
    normal_load: NDArray[np.float64]
    total_contact_area: NDArray[np.float64]
    particle_contact_area_ratio: NDArray[np.float64]
    solid_load_fraction: NDArray[np.float64]
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


@dataclass(frozen=True)
class SolvedEvidence:
    """Curves, turning points and windows for one set of inputs, solved when first asked for.

    ``asked`` is what ``thirdbody.study.claims.referenced_conditions`` gives, ``newtons`` the first and last
    normal load of every curve [N].
    """

    parameters: Parameters
    asked: Mapping[str, set]
    newtons: tuple[float, float]
    effort: Effort = FULL_EFFORT

    @cached_property
    def load_range(self) -> tuple[float, ...]:
        """First and last load F_t* [1] of every curve."""
        return tuple(force / self.parameters.newtons_per_load for force in self.newtons)

    @cached_property
    def _conditions(self):
        return sorted(self.asked["curve"] | self.asked["turning_point"])

    @cached_property
    def _loads(self):
        return np.geomspace(*self.load_range, self.effort.loads)

    @cached_property
    def _solution(self):
        return solve(
            load=self._loads[:, None],
            **Condition(*np.transpose(self._conditions))._asdict(),
            parameters=self.parameters,
            rtol=self.effort.rtol,
            variables=(*SOLVED_FIELDS, "solution_status", "error_bound"),
        )

    @cached_property
    def curves(self) -> dict[Condition, Curve]:
        """The curve over all loads at each condition that was asked for."""
        solution = self._solution
        newtons = self._loads * self.parameters.newtons_per_load
        solved = has_values(solution.solution_status) & (solution.error_bound <= LARGEST_ERROR)
        return {
            condition: Curve(
                load=self._loads,
                normal_load=newtons,
                solved=solved[:, index],
                **{name: getattr(solution, name)[:, index] for name in SOLVED_FIELDS},
            )
            for index, condition in enumerate(self._conditions)
        }

    @cached_property
    def windows(self) -> dict[float, tuple[float, float]]:
        """Ends of the range of x_a/sigma [1] with a dry turning point, by sigma [m]."""
        wanted = sorted(self.asked["window"])
        given = wanted, WINDOW_DENSITY, self.load_range, self.parameters
        found = turning_point_windows(self.effort.window, *given)
        return {sigma: (window.low, window.high) for sigma, window in zip(wanted, found)}

    @cached_property
    def turning_points(self) -> dict[Condition, TurningPoints]:
        """The turning point of the curve at each condition that was asked for one, in single numbers."""
        wanted = sorted(self.asked["turning_point"])
        separation = self._solution.separation[:, [self._conditions.index(each) for each in wanted]]
        found = turning_points(separation, *np.transpose(wanted), self.parameters, self.effort.rtol)
        numbers = zip(*(values.tolist() for values in vars(found).values()), strict=True)
        return {each: TurningPoints(*some) for each, some in zip(wanted, numbers, strict=True)}
