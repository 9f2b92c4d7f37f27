"""Sensitivity of results to the unprinted inputs: elasticities d ln(result)/d ln(input).

Results are loads and ratios of turning points, ends of the windows of x_a/sigma, and loads at which
the regime or mode changes.  A result that does not occur is nan.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chenhorng.claims.evidence import (
    FULL_EFFORT,
    WINDOW_DENSITY,
    Effort,
    Evidence,
    solve_evidence,
)
from thirdbody.core.parameters import BOUNDS, Parameters
from thirdbody.core.transitions import LIMITS, limit_crossings
from thirdbody.core.windows import WindowSearch
from thirdbody.curves import Condition
from thirdbody.variables import AXES

# Relative change of an input.  At this change the errors of the difference and of the solver
# balance.
STEP = FULL_EFFORT.rtol ** (1.0 / 3.0)
# Finite differences of second order: steps, and weights of the values divided by the step.
CENTRAL = (-1.0, 1.0), (-0.5, 0.5)
INWARD = (-2.0, -1.0, 0.0), (0.5, -2.0, 1.5)
# Relative distance of two samples from the end of a window.  A step moves the end by less than
# this.  Interpolation between the samples leaves an error of 3e-4 in an elasticity.
REACH = 0.003
TURNING_POINT, WINDOW = ("turning_point_load", "turning_point_ratio"), ("window_low", "window_high")


@dataclass(frozen=True)
class Subject:
    """The outputs to compute: curves for turning points and transitions, sigma [m] of the surfaces
    for windows, and the first and the last load [N]."""

    turning_points: tuple[Condition, ...]
    transitions: tuple[Condition, ...]
    window_roughness: tuple[float, ...]
    newtons: tuple[float, float]

    @classmethod
    def of(cls, settings: Mapping[str, Any]) -> Subject:
        """The subject from ``settings``, the content of ``config/sensitivity.yaml``."""
        return cls(
            tuple(map(Condition.of, settings["turning_points"])),
            tuple(map(Condition.of, settings["transitions"])),
            tuple(
                float(AXES["roughness"].to_si(sigma)) for sigma in settings["windows_roughness_nm"]
            ),
            tuple(settings["load_N"]),
        )

    @property
    def outputs(self) -> list[dict[str, Any]]:
        """Descriptions of the numbers from ``values``: columns of the table ``sensitivity``."""
        surfaces = [
            Condition(0.0, np.nan, sigma, WINDOW_DENSITY) for sigma in self.window_roughness
        ]
        numbers = [
            (curve, name, "", np.nan) for curve in self.turning_points for name in TURNING_POINT
        ]
        numbers += [(surface, name, "", np.nan) for surface in surfaces for name in WINDOW]
        numbers += [
            (curve, "transition_load", *limit) for curve in self.transitions for limit in LIMITS
        ]
        return [
            {"output": name, "quantity": quantity, "level": level} | curve.columns
            for curve, name, quantity, level in numbers
        ]

    def values(self, parameters: Parameters, effort: Effort) -> NDArray:
        """Solve for all ``outputs``: loads F_t* and ratios [1], shape (outputs,)."""
        asked: dict[str, set] = {
            "curve": set(self.transitions),
            "turning_point": set(self.turning_points),
            "window": set(self.window_roughness),
        }
        evidence = solve_evidence(parameters, asked, self.newtons, effort)
        turning = [evidence.turning_points[curve] for curve in self.turning_points]
        points = [
            (point.load, point.peak_ratio) if point.exists else (np.nan, np.nan)
            for point in turning
        ]
        windows = [evidence.windows[roughness] for roughness in self.window_roughness]
        return np.concatenate([*points, *windows, *last_crossings(evidence, self.transitions)])

    def effort_near(self, values: NDArray) -> Effort:
        """``FULL_EFFORT`` for outputs close to ``values``: ends of windows are interpolated between
        samples close to them."""
        ends = values[[output["output"] in WINDOW for output in self.outputs]]
        if np.isnan(ends).any():
            return FULL_EFFORT
        ratios = np.sort(np.concatenate([ends * (1.0 - REACH), ends * (1.0 + REACH)]))
        return replace(FULL_EFFORT, window=WindowSearch(ratios, tolerance=np.inf))


def last_crossings(evidence: Evidence, conditions: Sequence[Condition]) -> NDArray:
    """The last load F_t* [1] at which each curve crosses each of ``LIMITS``, or nan without a
    crossing: shape (curves, limits).
    """
    last = np.full((len(conditions), len(LIMITS)), np.nan)
    if conditions:
        curves = [evidence.curves[condition] for condition in conditions]
        values = {name: np.column_stack([curve[name] for curve in curves]) for name, _ in LIMITS}
        limit, curve, load, *_ = limit_crossings(
            np.column_stack([curve["separation"] for curve in curves]),
            values,
            np.transpose(conditions),
            evidence.parameters,
            evidence.effort.rtol,
        )
        np.fmax.at(last, (curve, limit), load)
    return last


def varied_inputs(parameters: Parameters, names: Sequence[str]) -> dict[str, float]:
    """Values of the inputs ``names`` by name, SI, without inputs of zero."""
    values = {name: getattr(parameters, name) for name in names}
    return {name: value for name, value in values.items() if value != 0.0}


def elasticities(
    values: Callable[[dict[str, float]], NDArray], base: NDArray, inputs: Mapping[str, float]
) -> tuple[NDArray, NDArray]:
    """Elasticities of the outputs, and their errors: both of shape (outputs, inputs).

    The outputs are ``base`` at ``inputs``, and ``values`` returns them for changed inputs.
    Differences are central, and one-sided at an upper bound.  The error is the change of the
    elasticity with twice the step.
    """

    def slopes(width):
        columns = []
        for name, value in inputs.items():
            highest = BOUNDS.get(name, (-np.inf, np.inf))[1]
            steps, weights = INWARD if value * (1.0 + width) > highest else CENTRAL
            changed = [values({name: value * (1.0 + step * width)}) for step in steps]
            columns.append(np.dot(weights, changed) / (width * base))
        return np.transpose(columns)

    single = slopes(STEP)
    return single, np.abs(single - slopes(2.0 * STEP))


def sensitivity_rows(
    subject: Subject, base: NDArray, inputs: Mapping[str, float], values: NDArray, errors: NDArray
) -> list[dict[str, Any]]:
    """Rows of the table ``sensitivity``, from the ``values`` and ``errors`` of ``elasticities``.

    Each output and input has a row.  An output that does not occur at the default ``inputs``, nan
    in ``base``, has a single row.
    """
    rows = []
    for index, output in enumerate(subject.outputs):
        same = {**output, "value": base[index]}
        columns = "input", "input_value", "elasticity", "error"
        cells = list(zip(inputs, inputs.values(), values[index], errors[index]))
        if np.isnan(base[index]):
            cells = [("", np.nan, np.nan, np.nan)]
        rows += [same | dict(zip(columns, cell, strict=True)) for cell in cells]
    return [{key: None if value != value else value for key, value in row.items()} for row in rows]
