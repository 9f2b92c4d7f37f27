"""What claims are judged on: curves, turning points and windows solved for one set of inputs."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np

from thirdbody.curves.turning_point import turning_points
from thirdbody.curves.windows import WindowSearch, turning_point_windows
from thirdbody.data.conditions import Condition
from thirdbody.model.parameters import Parameters
from thirdbody.solver.solution import COVERAGE_EXCEEDED, VARIABLES
from thirdbody.solver.solve import DEFAULT_RTOL, solve
from thirdbody.study.checks import Curve, TurningPoint

# variables of ``Solution`` that a ``Curve`` has, and what else must be solved
SHOWN = tuple(field.name for field in fields(Curve) if field.name in VARIABLES)
NEEDED = (*SHOWN, "solution_status")
WINDOW_DENSITY = 1e11  # eta_a [m-2] of the paper's windows


@dataclass(frozen=True)
class Effort:
    """How finely evidence is gathered: loads a curve, the relative error of what is solved, and
    the search for the windows."""

    loads: int
    rtol: float
    window: WindowSearch


FULL_EFFORT = Effort(240, DEFAULT_RTOL, WindowSearch(np.linspace(0.3, 2.5, 111)))
# for the many evaluations of a calibration: its errors stay far below every tolerance
QUICK_EFFORT = Effort(
    60, 1e-4, WindowSearch(np.linspace(0.5, 2.0, 31), 24, tolerance=np.inf, rtol=1e-4)
)


class SolvedEvidence:
    """Evidence for claims (``thirdbody.study.checks.Evidence``) from the solved model.

    ``asked`` is what ``thirdbody.study.claims.referenced_conditions`` returns; all its curves are
    solved together over ``newtons``, the first and last normal load [N]; ``places`` are those of
    the loads that are looked at, by default all.
    """

    def __init__(
        self,
        parameters: Parameters,
        asked: dict,
        newtons,
        effort: Effort = FULL_EFFORT,
        places=slice(None),
    ):
        self.parameters = parameters
        self.effort = effort
        self.load_range = tuple(force / parameters.newtons_per_load for force in newtons)
        self.loads = np.geomspace(*self.load_range, effort.loads)[places]
        self._asked = asked

    def curve(self, *condition) -> Curve:
        """The curve over the whole load range at a ``Condition`` (SI)."""
        return self._curves[Condition(*condition)]

    def turning_point(self, *condition) -> TurningPoint:
        """The turning point of that curve."""
        return self._turning_points[Condition(*condition)]

    def window(self, roughness) -> tuple[float, float]:
        """Ends of the range of x_a/sigma [1] with a turning point, dry, at ``roughness`` [m]."""
        return self._windows[roughness]

    @cached_property
    def _conditions(self) -> list[Condition]:
        return sorted(self._asked["curve"] | self._asked["turning_point"])

    @cached_property
    def _solution(self):
        columns = np.array(self._conditions).T
        return solve(self.loads[:, None], *columns, self.parameters, self.effort.rtol, NEEDED)

    @cached_property
    def _curves(self) -> dict[Condition, Curve]:
        solution = self._solution
        newtons = self.loads * self.parameters.newtons_per_load
        solved = solution.solution_status < COVERAGE_EXCEEDED
        return {
            condition: Curve(
                load=self.loads,
                normal_load=newtons,
                solved=solved[:, index],
                **{name: getattr(solution, name)[:, index] for name in SHOWN},
            )
            for index, condition in enumerate(self._conditions)
        }

    @cached_property
    def _windows(self) -> dict[float, tuple[float, float]]:
        wanted = sorted(self._asked["window"])
        searches = [self.effort.window] * len(wanted)
        found = turning_point_windows(
            searches, wanted, WINDOW_DENSITY, self.load_range, self.parameters
        )
        return {
            roughness: (window.low, window.high)
            for roughness, window in zip(wanted, found, strict=True)
        }

    @cached_property
    def _turning_points(self) -> dict[Condition, TurningPoint]:
        wanted = sorted(self._asked["turning_point"])
        chosen = [self._conditions.index(condition) for condition in wanted]
        columns = np.array(wanted).T
        found = turning_points(
            self._solution.separation[:, chosen], *columns, self.parameters, self.effort.rtol
        )
        fields = found.load, found.peak_ratio, found.solid_load_fraction
        return {
            condition: TurningPoint(*map(float, row), exists=bool(np.isfinite(row[0])))
            for condition, row in zip(wanted, np.array(fields).T, strict=True)
        }
