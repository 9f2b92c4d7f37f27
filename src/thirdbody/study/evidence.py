"""Curves, turning points and windows of the model for the evaluation of statements."""

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

WINDOW_DENSITY = 1e11  # ASSUME: eta_a [m-2] of all windows; the paper gives it for 300 nm
# Points with larger errors are not used: statements are evaluated to per cents, whatever rtol is.
LARGEST_ERROR = 1e-3


@dataclass(frozen=True)
class Curve:
    """A solved curve over the load: arrays of shape (loads,), named as in the datasets, SI.

    ``film_thickness`` is d/R_x [1], with or without a film.  Solved quantities are nan at points
    without values, or with an error bound above ``LARGEST_ERROR``.
    """

    load: NDArray[np.float64]
    normal_load: NDArray[np.float64]
    total_contact_area: NDArray[np.float64]
    particle_contact_area_ratio: NDArray[np.float64]
    solid_load_fraction: NDArray[np.float64]
    film_thickness: NDArray[np.float64]
    separation: NDArray[np.float64]

    @cached_property
    def solid_load(self) -> NDArray[np.float64]:
        """Dimensionless load carried by the solids, L_s F_t* [1]."""
        return self.solid_load_fraction * self.load

    @cached_property
    def total_contact_area_slope(self) -> NDArray[np.float64]:
        """d ln A_t*/d ln F_t* [1]: the slope of the curve on logarithmic axes."""
        area = np.maximum(self.total_contact_area, np.finfo(float).tiny)
        return np.gradient(np.log(area), np.log(self.load))


@dataclass(frozen=True)
class Effort:
    """Resolution of curves and windows: number of loads, ``rtol``, search for windows."""

    loads: int
    rtol: float
    window: WindowSearch


FULL_EFFORT = Effort(240, DEFAULT_RTOL, WindowSearch(np.linspace(0.3, 2.5, 111)))
# For many sets of inputs; the errors are far below all tolerances of statements.
QUICK_EFFORT = Effort(
    60, 1e-4, WindowSearch(np.linspace(0.5, 2.0, 31), 24, tolerance=np.inf, rtol=1e-4)
)
SOLVED_FIELDS = tuple(field.name for field in fields(Curve) if field.name in VARIABLES)


@dataclass(frozen=True)
class Evidence:
    """Results of the model for one set of inputs: curves and turning points (single numbers) by
    condition, and both ends of the windows [1] by sigma [m]."""

    parameters: Parameters
    effort: Effort
    curves: dict[Condition, Curve]
    turning_points: dict[Condition, TurningPoints]
    windows: dict[float, tuple[float, float]]


def solve_evidence(
    parameters: Parameters,
    asked: Mapping[str, set],
    newtons: tuple[float, float],
    effort: Effort = FULL_EFFORT,
) -> Evidence:
    """Solve the conditions ``asked``, from ``thirdbody.study.claims.referenced_conditions``;
    ``newtons`` are the first and last normal load of every curve [N]."""
    load_range = tuple(force / parameters.newtons_per_load for force in newtons)
    loads = np.geomspace(*load_range, effort.loads)
    conditions = sorted(asked["curve"] | asked["turning_point"])
    curves, points = {}, {}
    if conditions:
        columns = np.transpose(conditions)
        solution = solve(
            load=loads[:, None],
            **Condition(*columns)._asdict(),
            parameters=parameters,
            rtol=effort.rtol,
            variables=(*SOLVED_FIELDS, "solution_status", "error_bound"),
        )
        known = has_values(solution.solution_status) & (solution.error_bound <= LARGEST_ERROR)
        solved = {name: np.where(known, getattr(solution, name), np.nan) for name in SOLVED_FIELDS}
        for index, condition in enumerate(conditions):
            curves[condition] = Curve(
                load=loads,
                normal_load=loads * parameters.newtons_per_load,
                **{name: values[:, index] for name, values in solved.items()},
            )
        places = [index for index, each in enumerate(conditions) if each in asked["turning_point"]]
        separation = solution.separation[:, places]
        found = turning_points(separation, *columns[:, places], parameters, effort.rtol)
        numbers = zip(*(values.tolist() for values in vars(found).values()), strict=True)
        for index, some in zip(places, numbers, strict=True):
            points[conditions[index]] = TurningPoints(*some)
    surfaces = sorted(asked["window"])
    given = surfaces, WINDOW_DENSITY, load_range, parameters
    found = turning_point_windows(effort.window, *given)
    windows = {sigma: (each.low, each.high) for sigma, each in zip(surfaces, found, strict=True)}
    return Evidence(parameters, effort, curves, points, windows)
