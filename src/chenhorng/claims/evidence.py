"""Curves, turning points and windows of the model, on which statements are evaluated."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from chenhorng.sampling import TINY, SolvedCurve, area_slope
from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import has_values
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.core.turning_points import TurningPoints, turning_points
from thirdbody.core.windows import WindowSearch, turning_point_windows
from thirdbody.curves import Condition
from thirdbody.variables import QUANTITIES

WINDOW_DENSITY = 1e11  # ASSUME: eta_a [m-2] of all windows; the paper gives it for 300 nm
# Points with larger errors are not used: statements are accurate to per cents at any rtol.
LARGEST_ERROR = 1e-3


@dataclass(frozen=True)
class Effort:
    """Resolution of curves and windows: the number of loads, the relative tolerance ``rtol`` of a
    solution, and the search for windows."""

    loads: int
    rtol: float
    window: WindowSearch


FULL_EFFORT = Effort(240, DEFAULT_RTOL, WindowSearch(np.linspace(0.3, 2.5, 111)))
# For many sets of inputs.  The errors are far below all tolerances of statements.
QUICK_EFFORT = Effort(
    60, 1e-4, WindowSearch(np.linspace(0.5, 2.0, 31), 24, tolerance=np.inf, rtol=1e-4)
)


@dataclass(frozen=True)
class Evidence:
    """Results of the model for one set of inputs.

    ``curves``, from ``curve_of``, and ``turning_points``, with single numbers, are by condition.
    ``windows`` are the lower and upper ends of x_a/sigma [1], by sigma [m].
    """

    parameters: Parameters
    effort: Effort
    curves: dict[Condition, SolvedCurve]
    turning_points: dict[Condition, TurningPoints]
    windows: dict[float, tuple[float, float]]


def curve_of(solved: SolvedCurve) -> SolvedCurve:
    """The quantities of a curve over the load, from ``QUANTITIES``, ``load`` and ``normal_load``.
    ``film_thickness`` is d/R_x [1], with or without a film."""
    solid_load = solved["solid_load_fraction"] * solved["load"]
    return {
        **solved,
        "solid_load": solid_load,
        "real_contact_pressure": solid_load / np.maximum(solved["total_contact_area"], TINY),
        "total_contact_area_slope": area_slope(solved["load"], solved["total_contact_area"]),
    }


def solve_evidence(
    parameters: Parameters,
    asked: Mapping[str, set],
    newtons: tuple[float, float],
    effort: Effort = FULL_EFFORT,
) -> Evidence:
    """Solve the conditions ``asked``, from ``referenced_conditions``, between the first and the
    last normal load of ``newtons`` [N].  Quantities are nan if the solution has no values, or an
    error bound above ``LARGEST_ERROR``."""
    first, last = (force / parameters.newtons_per_load for force in newtons)
    loads = np.geomspace(first, last, effort.loads)
    shared = {"load": loads, "normal_load": loads * parameters.newtons_per_load}
    conditions = sorted(asked["curve"] | asked["turning_point"])
    curves, points = {}, {}
    if conditions:
        columns = np.transpose(conditions)
        solution = solve_points(
            {"load": loads[:, None], **Condition(*columns)._asdict()},
            parameters,
            effort.rtol,
            (*QUANTITIES, "solution_status", "error_bound"),
        )
        accurate = solution["error_bound"] <= LARGEST_ERROR
        accurate &= has_values(solution["solution_status"])
        solved = {name: np.where(accurate, solution[name], np.nan) for name in QUANTITIES}
        for index, condition in enumerate(conditions):
            own = {name: values[:, index] for name, values in solved.items()}
            curves[condition] = curve_of(shared | own)
        indices = [
            index
            for index, condition in enumerate(conditions)
            if condition in asked["turning_point"]
        ]
        separation = solution["separation"][:, indices]
        turning = turning_points(
            separation,
            **Condition(*columns[:, indices])._asdict(),
            parameters=parameters,
            rtol=effort.rtol,
        )
        fields = zip(*(values.tolist() for values in vars(turning).values()), strict=True)
        for index, numbers in zip(indices, fields, strict=True):
            points[conditions[index]] = TurningPoints(*numbers)
    surfaces = sorted(asked["window"])
    ends = turning_point_windows(
        effort.window, np.array(surfaces), WINDOW_DENSITY, (first, last), parameters
    )
    windows = {
        sigma: (window.low, window.high) for sigma, window in zip(surfaces, ends, strict=True)
    }
    return Evidence(parameters, effort, curves, points, windows)
