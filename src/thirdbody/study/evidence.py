"""What claims are judged on: curves, turning points and windows, solved for one set of inputs."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves.turning_point import turning_points
from thirdbody.curves.windows import WindowSearch, turning_point_windows
from thirdbody.data.conditions import Condition
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import is_as_asked
from thirdbody.solver.solution import VARIABLES
from thirdbody.solver.solve import DEFAULT_RTOL, solve
from thirdbody.study.checks import Curve, TurningPoint

# Variables of ``Solution`` that a ``Curve`` has, and those that must be solved to make one.
SHOWN = tuple(field.name for field in fields(Curve) if field.name in VARIABLES)
NEEDED = (*SHOWN, "solution_status")
WINDOW_DENSITY = 1e11  # eta_a [m-2] for which the paper gives its windows


@dataclass(frozen=True)
class Effort:
    """How finely curves and windows are solved.

    Attributes
    ----------
    loads : int
        Number of loads on a curve.
    rtol : float
        Relative error asked for [1].
    window : WindowSearch
        How the ends of windows are sought.
    """

    loads: int
    rtol: float
    window: WindowSearch


FULL_EFFORT = Effort(240, DEFAULT_RTOL, WindowSearch(np.linspace(0.3, 2.5, 111)))
# For many sets of inputs; its errors are far below the tolerances of all claims.
QUICK_EFFORT = Effort(
    60, 1e-4, WindowSearch(np.linspace(0.5, 2.0, 31), 24, tolerance=np.inf, rtol=1e-4)
)


class SolvedEvidence:
    """Curves, turning points and windows of the model: the ``Evidence`` that claims are judged on.

    Nothing is solved before it is asked for; then everything of its kind is solved together.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    asked : dict of set
        What can be asked for, as ``thirdbody.study.claims.referenced_conditions`` returns it.
    newtons : tuple of float
        First and last normal load of every curve [N].
    effort : Effort
        How finely everything is solved.
    places : slice or array of int
        Which of the loads are solved; all by default.

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
    >>> evidence.turning_point(*dry).exists
    True
    """

    def __init__(
        self,
        parameters: Parameters,
        asked: dict[str, set],
        newtons: tuple[float, float],
        effort: Effort = FULL_EFFORT,
        places: slice | NDArray[np.intp] = slice(None),
    ):
        self.parameters = parameters
        self.effort = effort
        self.load_range = tuple(force / parameters.newtons_per_load for force in newtons)
        self.loads = np.geomspace(*self.load_range, effort.loads)[places]
        self._asked = asked

    def curve(self, *condition: float) -> Curve:
        """The curve over all loads at the four numbers of a ``Condition``, SI.

        Raises
        ------
        KeyError
            If it was not among what can be asked for.
        """
        return self._curves[Condition(*condition)]

    def turning_point(self, *condition: float) -> TurningPoint:
        """The turning point of the curve at the four numbers of a ``Condition``, SI.

        Raises
        ------
        KeyError
            If it was not among what can be asked for.
        """
        return self._turning_points[Condition(*condition)]

    def window(self, roughness: float) -> tuple[float, float]:
        """Ends of the range of x_a/sigma [1] within which dry curves have a turning point.

        Parameters
        ----------
        roughness : float
            sigma [m].

        Raises
        ------
        KeyError
            If it was not among what can be asked for.
        """
        return self._windows[roughness]

    @cached_property
    def _conditions(self) -> list[Condition]:
        return sorted(self._asked["curve"] | self._asked["turning_point"])

    @cached_property
    def _solution(self):
        columns = Condition(*np.array(self._conditions).T)
        return solve(
            load=self.loads[:, None],
            **columns._asdict(),
            parameters=self.parameters,
            rtol=self.effort.rtol,
            variables=NEEDED,
        )

    @cached_property
    def _curves(self) -> dict[Condition, Curve]:
        solution = self._solution
        newtons = self.loads * self.parameters.newtons_per_load
        solved = is_as_asked(solution.solution_status)
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
        fields = found.load, found.peak_ratio, found.solid_load_fraction, found.prominence
        return {
            condition: TurningPoint(*map(float, row))
            for condition, row in zip(wanted, np.array(fields).T, strict=True)
        }
