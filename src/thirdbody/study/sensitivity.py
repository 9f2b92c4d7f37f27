"""How results respond to the inputs that the paper does not print: elasticities at the default.

Outputs are turning points, ends of the windows of x_a/sigma, and loads at which the regime or mode
changes.  An output that does not occur, such as the load of a turning point where the ratio has no
maximum, is nan, and so is all that would need it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from scipy.interpolate import BarycentricInterpolator
from scipy.special import logit

from thirdbody.curves.transitions import LIMITS
from thirdbody.curves.windows import WindowSearch, turning_point_windows
from thirdbody.data.conditions import AXES, Condition
from thirdbody.model.parameters import Parameters
from thirdbody.study.checks import Curve
from thirdbody.study.evidence import FULL_EFFORT, WINDOW_DENSITY, Effort, SolvedEvidence

# of an input, up and down: the truncation error of a central difference grows with the square of
# the step, the solver's part with its inverse, and together they are least about here
STEP = FULL_EFFORT.rtol ** (1.0 / 3.0)
REACH = 0.01  # of a window's end, to either side: where its shift is interpolated
SIDE = 2  # points on each side of a crossing that locate it
AROUND = 6  # loads on each side of a result within which a small change of an input leaves it


class Output(NamedTuple):
    """One number that responds to the inputs, and what it belongs to.

    Attributes
    ----------
    output : str
        Which number: ``turning_point_load``, ``window_low``, ...
    condition : Condition
        The curve that it belongs to; nan where a condition has no meaning.
    quantity : str
        Of a load of transition, the variable that crosses a limit; empty for others.
    level : float
        That limit; nan for others.
    """

    output: str
    condition: Condition
    quantity: str = ""
    level: float = np.nan

    @property
    def columns(self) -> dict:
        """All of it by the names of the columns of the table ``sensitivity``."""
        same = {"output": self.output, "quantity": self.quantity, "level": self.level}
        return same | self.condition.columns


@dataclass(frozen=True)
class Subject:
    """What is asked about: curves with turning points, curves with transitions, windows.

    ``window_roughness`` is sigma [m]; ``newtons`` the first and last normal load [N].
    """

    turning_points: tuple[Condition, ...]
    transitions: tuple[Condition, ...]
    window_roughness: tuple[float, ...]
    newtons: tuple[float, float]

    @classmethod
    def of(cls, settings: Mapping) -> Subject:
        """The subject that ``config/sensitivity.yaml`` describes."""
        return cls(
            tuple(map(Condition.of, settings["turning_points"])),
            tuple(map(Condition.of, settings["transitions"])),
            tuple(map(AXES["roughness"].to_si, settings["windows_roughness_nm"])),
            tuple(settings["load_N"]),
        )

    @property
    def outputs(self) -> list[Output]:
        """What ``values`` returns, in its order."""
        names = "turning_point_load", "turning_point_ratio"
        return [
            *(Output(name, curve) for curve in self.turning_points for name in names),
            *(
                Output(f"window_{end}", Condition(0.0, np.nan, sigma, WINDOW_DENSITY))
                for sigma in self.window_roughness
                for end in ("low", "high")
            ),
            *(
                Output("transition_load", curve, quantity, level)
                for curve in self.transitions
                for quantity, level in LIMITS
            ),
        ]

    def values(
        self, parameters: Parameters, effort: Effort, searches=None, places=slice(None)
    ) -> np.ndarray:
        """The outputs with these ``parameters``; nan where one does not occur.

        ``searches`` are those for the window of each roughness, if not that of ``effort``;
        ``places`` are those of the loads that are looked at, by default all.
        """
        searches = searches or [effort.window] * len(self.window_roughness)
        asked = {
            "curve": set(self.transitions),
            "turning_point": set(self.turning_points),
            "window": set(),
        }
        evidence = SolvedEvidence(parameters, asked, self.newtons, effort, places)
        points = [evidence.turning_point(*curve)[:2] for curve in self.turning_points]
        windows = turning_point_windows(
            searches, self.window_roughness, WINDOW_DENSITY, evidence.load_range, parameters
        )
        curves = [evidence.curve(*curve) for curve in self.transitions]
        ends = [(window.low, window.high) for window in windows]
        return np.concatenate([*points, *ends, *map(last_crossings, curves)])

    def local_searches(self, values: np.ndarray) -> list[WindowSearch]:
        """Searches for windows whose ends are about those among the outputs ``values``.

        The ends lie in the middle between two ratios, so that what interpolation adds to them is
        the same on either side and cancels in a central difference.
        """
        first = 2 * len(self.turning_points)
        searches = []
        for index in range(first, first + 2 * len(self.window_roughness), 2):
            ends = values[index : index + 2]
            near = np.concatenate([ends * (1.0 - REACH), ends * (1.0 + REACH)])
            known = np.isfinite(near).all() and (np.diff(np.sort(near)) > 0.0).all()
            local = WindowSearch(np.sort(near), tolerance=np.inf)
            searches.append(local if known else FULL_EFFORT.window)
        return searches

    def local_places(self, values: np.ndarray, parameters: Parameters) -> np.ndarray:
        """Places of the loads of a full effort that are about those among the outputs ``values``
        with these ``parameters``."""
        is_load = [output.output.endswith("_load") for output in self.outputs]
        found = values[is_load] * parameters.newtons_per_load
        grid = np.geomspace(*self.newtons, FULL_EFFORT.loads)
        beyond = np.searchsorted(grid, found[np.isfinite(found)])
        near = beyond[:, None] + np.arange(-AROUND, AROUND)
        return np.unique(near.clip(0, grid.size - 1))


def last_crossings(curve: Curve) -> list[float]:
    """Last load F_t* [1] at which ``curve`` crosses each of the limits of regimes and modes.

    Interpolated among the four loads around it; nan where a limit is not crossed.
    """
    found = []
    for quantity, level in LIMITS:
        with np.errstate(divide="ignore"):
            excess = logit(getattr(curve, quantity)) - logit(level)
        steps = np.flatnonzero((excess[1:] > 0.0) != (excess[:-1] > 0.0))
        around = slice(steps[-1] + 1 - SIDE, steps[-1] + 1 + SIDE) if steps.size else slice(0)
        known = excess[around]
        usable = known.size == 2 * SIDE and np.isfinite(known).all() and _is_monotonic(known)
        # its order of summation is drawn at random: the seed makes every run give the same bits
        found.append(
            np.exp(BarycentricInterpolator(known, np.log(curve.load[around]), rng=0)(0.0))
            if usable
            else np.nan
        )
    return found


def _is_monotonic(values) -> bool:
    return np.abs(np.sign(np.diff(values)).sum()) == values.size - 1


def varied_inputs(parameters: Parameters, names: Sequence[str]) -> dict[str, float]:
    """Values of those of ``names`` that have a relative change: an input of 0 plays no part."""
    values = {name: getattr(parameters, name) for name in names}
    return {name: value for name, value in values.items() if value != 0.0}


def elasticities(values, base: np.ndarray, inputs: Mapping[str, float], step: float = STEP):
    """d ln(output)/d ln(input) by central differences, and by how much twice the step differs.

    ``values(changes)`` gives the outputs with ``changes`` in the place of some ``inputs``; ``base``
    are the outputs without.  Both results have shape (outputs, inputs).
    """

    def slopes(width):
        columns = []
        for name, value in inputs.items():
            ends = [values({name: value * (1.0 + sign * width)}) for sign in (-1.0, 1.0)]
            columns.append((ends[1] - ends[0]) / (2.0 * width * base))
        return np.transpose(columns)

    found = slopes(step)
    return found, np.abs(found - slopes(2.0 * step))


class Found(NamedTuple):
    """One measure of sensitivity of every output to every input.

    ``value`` and ``error`` have shape (outputs, inputs); ``occurs`` is the share of the solved sets
    of inputs in which an output occurs, ``unexplained`` the share of its variance that is lost.
    """

    measure: str
    value: np.ndarray
    error: np.ndarray
    occurs: np.ndarray
    unexplained: np.ndarray


def default_elasticities(subject: Subject, parameters: Parameters, inputs: Mapping[str, float]):
    """Outputs at ``parameters``, and their elasticities there with respect to ``inputs``."""
    base = subject.values(parameters, FULL_EFFORT)
    local = subject.local_searches(base), subject.local_places(base, parameters)
    solved = []

    def values(changes):
        solved.append(subject.values(replace(parameters, **changes), FULL_EFFORT, *local))
        return solved[-1]

    value, error = elasticities(values, base, inputs)
    occurs = np.isfinite(solved).mean(axis=0)
    return base, Found("elasticity", value, error, occurs, np.full(base.shape, np.nan))


def sensitivity_rows(
    subject: Subject, base: np.ndarray, inputs: Mapping[str, float], found: Found
) -> list[dict]:
    """Rows of the table ``sensitivity``: one an output and input; one an output that is missing."""
    rows = []
    for index, output in enumerate(subject.outputs):
        same = {"measure": found.measure, **output.columns, "value": base[index]}
        same |= {"occurs": found.occurs[index], "unexplained": found.unexplained[index]}
        if np.isnan(base[index]):
            nothing = {"input": "", "input_value": np.nan, "sensitivity": np.nan, "error": np.nan}
            rows.append(same | nothing)
            continue
        for place, (name, value) in enumerate(inputs.items()):
            response = found.value[index, place], found.error[index, place]
            column = {"input": name, "input_value": value}
            rows.append(same | column | dict(zip(("sensitivity", "error"), response, strict=True)))
    return [{key: _blank(value) for key, value in row.items()} for row in rows]


def _blank(value):
    """None for what has no value, which tables leave empty."""
    return None if isinstance(value, float) and np.isnan(value) else value
