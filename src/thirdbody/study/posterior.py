"""What a calibration found: the best inputs, an ensemble, what is identified and correlated."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from thirdbody.study.calibration import Reading, acceptable, spread_out

DIGITS = 6  # of an input in the calibrated file
IDENTIFIED_SHARE = 0.25  # of its bounds: an input whose acceptable range is wider is not identified
NOTABLE_CORRELATION = 0.6
PROFILE_BINS = 12


def summary(reading: Reading, searches: Sequence[np.ndarray], settings: dict) -> dict:
    """The content of ``config/calibrated/<reading>.yaml``.

    ``searches`` are the rows of ``thirdbody.study.calibration.search``, one array a seed.
    """
    rows = np.concatenate(searches)
    good = acceptable(rows, settings["acceptance"])
    members = spread_out(good, settings["ensemble"])
    return {
        "reading": reading.name,
        "objective": _rounded(good[0, -1]),
        "objective_of_each_seed": [_rounded(each[:, -1].min()) for each in searches],
        "evaluations": len(rows),
        "acceptable": len(good),
        "inputs": {**reading.fixed, **_inputs(reading, good[0])},
        "ensemble": [_inputs(reading, member) for member in members],
        "objective_of_each_member": [_rounded(member[-1]) for member in members],
        "identification": _identification(reading, rows, good),
        "correlations": _correlations(reading, good),
    }


def _rounded(value) -> float:
    return float(f"{value:.{DIGITS}g}")


def _inputs(reading: Reading, row) -> dict:
    return {name: _rounded(value) for name, value in reading.values(row[:-1]).items()}


def _identification(reading: Reading, rows, good) -> dict:
    """Of each input: its acceptable range, whether that identifies it, and its profile.

    The profile is the least objective found with the input in each of equal parts of its bounds.
    """
    result = {}
    for index, unknown in enumerate(reading.unknowns):
        low, high = good[:, index].min(), good[:, index].max()
        part = np.minimum((rows[:, index] * PROFILE_BINS).astype(int), PROFILE_BINS - 1)
        least = [rows[part == each, -1].min(initial=np.inf) for each in range(PROFILE_BINS)]
        result[unknown.name] = {
            "acceptable": [_rounded(unknown.value(low)), _rounded(unknown.value(high))],
            "identified": bool(high - low < IDENTIFIED_SHARE),
            "profile": [_rounded(value) if np.isfinite(value) else None for value in least],
        }
    return result


def _correlations(reading: Reading, good) -> list[dict]:
    """Pairs of inputs that the statements leave free together."""
    if len(good) < 3:
        return []
    with np.errstate(invalid="ignore"):
        matrix = np.corrcoef(good[:, :-1].T)
    names = [unknown.name for unknown in reading.unknowns]
    return [
        {"between": [names[a], names[b]], "coefficient": float(f"{matrix[a, b]:.2f}")}
        for a, b in zip(*np.triu_indices(len(names), 1), strict=True)
        if abs(matrix[a, b]) >= NOTABLE_CORRELATION
    ]
