"""Sensitivity of results to the unprinted inputs: elasticities and total Sobol indices.

Outputs are loads and ratios of turning points, ends of the windows of x_a/sigma, and loads at which
the regime or mode changes; nan where they do not occur.  The elasticity is d ln(output)/d ln(input).
A total Sobol index is the part of the variance of ln(output) to which an input contributes.  For it a
quadratic is fitted to evenly scattered sets of inputs, whose terms are products of Legendre polynomials:
the square of a coefficient is the variance of its term (Sudret 2008, doi:10.1016/j.ress.2007.04.002).
``scipy.stats.sobol_indices`` is not used: from twice as many sets its indices are off by 0.06, where the
quadratics of turning points and windows leave less than 0.001 of a variance unexplained; and it takes no
sets in which an output does not occur.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.stats.qmc import LatinHypercube

from thirdbody.core.parameters import BOUNDS, Parameters
from thirdbody.core.transitions import LIMITS, limit_crossings
from thirdbody.core.windows import WindowSearch
from thirdbody.data.conditions import Condition
from thirdbody.study.evidence import (
    FULL_EFFORT,
    QUICK_EFFORT,
    WINDOW_DENSITY,
    Effort,
    Evidence,
    solve_evidence,
)
from thirdbody.variables import AXES

# Relative change of an input, at which the errors of the difference and of the solver balance
STEP = FULL_EFFORT.rtol ** (1.0 / 3.0)
# Finite differences of second order: steps, and weights of the values over the step.
CENTRAL = (-1.0, 1.0), (-0.5, 0.5)
INWARD = (-2.0, -1.0, 0.0), (0.5, -2.0, 1.5)
# Relative distance of two samples from the end of a window: more than STEP moves it, and so small that
# interpolation between them leaves an error of 3e-4 in an elasticity.
REACH = 0.003
LEAST_SETS = 1.2  # solved sets of inputs for each term of a response surface
TURNING_POINT, WINDOW = ("turning_point_load", "turning_point_ratio"), ("window_low", "window_high")


@dataclass(frozen=True)
class Subject:
    """Outputs to compute: the curves, the surfaces (sigma [m]) and the first and last load [N]."""

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
            tuple(map(AXES["roughness"].to_si, settings["windows_roughness_nm"])),
            tuple(settings["load_N"]),
        )

    @property
    def outputs(self) -> list[dict[str, Any]]:
        """Description of each number from ``values``: columns of the table ``sensitivity``."""
        surfaces = [Condition(0.0, np.nan, each, WINDOW_DENSITY) for each in self.window_roughness]
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
        asked = {
            "curve": set(self.transitions),
            "turning_point": set(self.turning_points),
            "window": set(self.window_roughness),
        }
        evidence = solve_evidence(parameters, asked, self.newtons, effort)
        found = [evidence.turning_points[curve] for curve in self.turning_points]
        points = [
            (point.load, point.peak_ratio) if point.exists else (np.nan, np.nan) for point in found
        ]
        windows = [evidence.windows[roughness] for roughness in self.window_roughness]
        return np.concatenate([*points, *windows, *last_crossings(evidence, self.transitions)])

    def effort_near(self, values: NDArray) -> Effort:
        """``FULL_EFFORT`` for outputs close to ``values``: ends of windows are interpolated there."""
        ends = values[[each["output"] in WINDOW for each in self.outputs]]
        if np.isnan(ends).any():
            return FULL_EFFORT
        ratios = np.sort(np.concatenate([ends * (1.0 - REACH), ends * (1.0 + REACH)]))
        return replace(FULL_EFFORT, window=WindowSearch(ratios, tolerance=np.inf))


def last_crossings(evidence: Evidence, conditions: Sequence[Condition]) -> NDArray:
    """Last load F_t* [1] at which each curve crosses each of ``LIMITS``, or nan: shape (curves, limits)."""
    found = np.full((len(conditions), len(LIMITS)), np.nan)
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
        np.fmax.at(found, (curve, limit), load)
    return found


def varied_inputs(parameters: Parameters, names: Sequence[str]) -> dict[str, float]:
    """Values of the inputs ``names`` by name, SI, except zeros."""
    values = {name: getattr(parameters, name) for name in names}
    return {name: value for name, value in values.items() if value != 0.0}


class Found(NamedTuple):
    """Sensitivities by one ``measure``: ``value`` and its uncertainty ``error`` [1], shape (outputs, inputs);
    the fraction of the solved sets of inputs in which an output ``occurs``, and the fraction of its
    variance that is ``unexplained``, nan for elasticities."""

    measure: str
    value: NDArray
    error: NDArray
    occurs: NDArray
    unexplained: NDArray


def elasticities(
    values: Callable[[dict[str, float]], NDArray], base: NDArray, inputs: Mapping[str, float]
) -> Found:
    """Elasticities of the outputs, ``base`` at ``inputs``, by central differences, one-sided at an upper
    bound; the error is the difference from twice the step.  ``values`` solves for changed inputs."""
    solved = []

    def slopes(width):
        columns = []
        for name, value in inputs.items():
            highest = BOUNDS.get(name, (-np.inf, np.inf))[1]
            steps, weights = INWARD if value * (1.0 + width) > highest else CENTRAL
            changed = [values({name: value * (1.0 + each * width)}) for each in steps]
            columns.append(np.dot(weights, changed) / (width * base))
            solved.extend(changed)
        return np.transpose(columns)

    found = slopes(STEP)
    error = np.abs(found - slopes(2.0 * STEP))
    occurs = np.isfinite(solved).mean(axis=0)
    return Found("elasticity", found, error, occurs, np.full(base.shape, np.nan))


def legendre_terms(positions: NDArray) -> tuple[NDArray, NDArray]:
    """Terms of a quadratic at ``positions``, shape (sets, inputs), each with mean square 1: shape (sets,
    terms); and whether a term depends on an input, shape (terms, inputs)."""
    first = np.sqrt(3.0) * positions
    second = np.sqrt(5.0) * (1.5 * positions**2 - 0.5)
    one, other = np.triu_indices(positions.shape[1], k=1)
    terms = [np.ones((len(positions), 1)), first, second, first[:, one] * first[:, other]]
    inputs = np.eye(positions.shape[1], dtype=bool)
    involved = [np.zeros_like(inputs[:1]), inputs, inputs, inputs[one] | inputs[other]]
    return np.hstack(terms), np.vstack(involved)


def total_indices(positions: NDArray, values: NDArray) -> tuple[NDArray, float]:
    """Total Sobol index of each input, shape (inputs,), in the logarithm of an output ``values`` [sets] at
    ``positions`` [sets, inputs], and the fraction of the variance missed in leave-one-out
    cross-validation; nan if it occurs in too few sets."""
    terms, involved = legendre_terms(positions)
    known = np.isfinite(values)
    if known.sum() < LEAST_SETS * terms.shape[1]:
        return np.full(positions.shape[1], np.nan), np.nan
    terms, logarithms = terms[known], np.log(values[known])
    basis, triangle = np.linalg.qr(terms)
    coefficients = np.linalg.solve(triangle, basis.T @ logarithms)
    # Leave-one-out error of each set: residual over (1 - leverage).
    missed = (logarithms - terms @ coefficients) / (1.0 - np.sum(basis**2, axis=1))
    variances = coefficients[1:] ** 2
    indices = variances @ involved[1:] / variances.sum()
    return indices, float(np.mean(missed**2) / np.var(logarithms))


def default_indices(
    subject: Subject,
    parameters: Parameters,
    inputs: Mapping[str, float],
    base: NDArray,
    settings: Mapping[str, Any],
) -> Found:
    """Total Sobol indices of the outputs, ``base`` at ``parameters``, for ``inputs``, SI.  The error is the
    fraction that the quadratic misses: any input may contribute to it."""
    scattered = LatinHypercube(len(inputs), rng=settings["seed"]).random(settings["solved"])
    sides = np.array([1.0 - settings["spread"], 1.0 + settings["spread"]])
    ends = [np.clip(value * sides, *BOUNDS[name]) for name, value in inputs.items()]
    low, high = np.transpose(ends)
    solved = np.full((len(scattered), base.size), np.nan)
    for place, values in enumerate((low + (high - low) * scattered).tolist()):
        with suppress(ValueError):  # no surface has these inputs
            changed = replace(parameters, **dict(zip(inputs, values, strict=True)))
            solved[place] = subject.values(changed, QUICK_EFFORT)
    value = np.full((base.size, len(inputs)), np.nan)
    unexplained = np.full(base.shape, np.nan)
    for index in np.flatnonzero(np.isfinite(base)):
        value[index], unexplained[index] = total_indices(2.0 * scattered - 1.0, solved[:, index])
    error = np.broadcast_to(unexplained[:, None], value.shape)
    occurs = np.isfinite(solved).mean(axis=0)
    return Found("sobol_total", value, error, occurs, unexplained)


def sensitivity_rows(
    subject: Subject, base: NDArray, inputs: Mapping[str, float], found: Found
) -> list[dict[str, Any]]:
    """Rows of the table ``sensitivity``: one for each output and input, or a single one of an output that
    does not occur at the default ``inputs``, in ``base``."""
    rows = []
    for index, output in enumerate(subject.outputs):
        same = {"measure": found.measure, **output, "value": base[index]}
        same |= {"occurs": found.occurs[index], "unexplained": found.unexplained[index]}
        columns = "input", "input_value", "sensitivity", "error"
        cells = list(zip(inputs, inputs.values(), found.value[index], found.error[index]))
        if np.isnan(base[index]):
            cells = [("", np.nan, np.nan, np.nan)]
        rows += [same | dict(zip(columns, each, strict=True)) for each in cells]
    return [{key: None if value != value else value for key, value in row.items()} for row in rows]
