"""What the searches of a calibration found, as the content of a file of calibrated inputs.

Such a file tells the best inputs of a reading, an ensemble of others that explain the paper's
statements about equally well, which inputs the statements identify, and which are correlated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.study.calibration import Reading, acceptable
from thirdbody.study.fronts import merged

DIGITS = 6  # significant ones of a number in the file
# An input is identified if its acceptable values span less than this share of its bounds.
IDENTIFIED_SHARE = 0.25
NOTABLE_CORRELATION = 0.6  # smaller coefficients are not told
SHARES = 0.05, 0.5, 0.95  # quantiles that are told of what each seed draws
PROFILE_BINS = 12  # equal parts of an input's bounds


def summary(
    reading: Reading,
    searches: Sequence[NDArray[np.float64]],
    samples: Sequence[NDArray[np.float64]],
    fronts: Sequence[Mapping[str, Sequence[Sequence[float]]]],
    settings: Mapping[str, Any],
    choose: Callable[[NDArray[np.float64]], NDArray[np.float64]],
) -> dict[str, Any]:
    """Sum up the searches of a reading.

    Parameters
    ----------
    reading : Reading
        The reading whose unknowns were searched.
    searches : sequence of array, shape (evaluations, unknowns + 1)
        What ``thirdbody.study.calibration.search`` returned for each seed.
    samples : sequence of array, shape (samples, unknowns + 1)
        What ``thirdbody.study.sampling.posterior_sample`` returned for each seed.
    fronts : sequence of mapping
        What a ``thirdbody.study.fronts.Witness`` has seen of the search of each seed.
    settings : mapping
        Content of ``config/calibration.yaml``, of which ``acceptance`` and ``ensemble`` are used.
    choose : callable
        Takes one of the acceptable sets, the best of which is the first.

    Returns
    -------
    dict
        Content of ``config/calibrated/<reading>.yaml``, SI: ``objective`` is the least found,
        ``inputs`` are those that are chosen, with their ``penalty``, ``ensemble`` a number of
        sampled sets after them; ``identification`` tells of each
        unknown the acceptable range, whether it is narrow, the median and the 90 % range of the
        samples of each seed, and the least objective in each part of its bounds; ``correlations``
        tells pairs of unknowns that the statements constrain together only; ``fronts`` tells of
        each chief statement what the others lose as it comes to hold.

    Examples
    --------
    >>> from thirdbody.study.calibration import Unknown
    >>> ratio = Unknown("gap_ratio", (0.0, 4.0), (1.0, 2.0), logarithmic=False)
    >>> reading = Reading("one", {}, (ratio,))
    >>> evaluated = np.array([[0.10, 7.0], [0.50, 3.0], [0.55, 3.4]])
    >>> sampled = np.array([[0.55, 3.4]])
    >>> settings = {"acceptance": 1.0, "ensemble": 2}
    >>> found = summary(reading, [evaluated], [sampled], [], settings, lambda sets: sets[0])
    >>> found["inputs"], found["ensemble"]
    ({'gap_ratio': 2.0}, [{'gap_ratio': 2.0}, {'gap_ratio': 2.2}])
    >>> found["identification"]["gap_ratio"]["identified"]
    True
    """
    rows = np.concatenate([*searches, *samples])
    good = acceptable(rows, settings["acceptance"])
    pooled = np.concatenate(samples)
    drawn = np.linspace(0, len(pooled) - 1, settings["ensemble"] - 1).round().astype(int)
    chosen = choose(good)
    members = [chosen, *pooled[drawn]]
    return {
        "reading": reading.name,
        "objective": _rounded(good[0, -1]),
        "penalty": _rounded(penalty_of(reading, chosen)),
        "objective_of_each_seed": [_rounded(each[:, -1].min()) for each in searches],
        "evaluations": sum(map(len, searches)),
        "acceptable": len(good),
        "inputs": {**reading.fixed, **inputs_of(reading, chosen)},
        "ensemble": [inputs_of(reading, member) for member in members],
        "objective_of_each_member": [_rounded(member[-1]) for member in members],
        "identification": _identification(reading, rows, good, samples),
        "correlations": _correlations(reading, pooled),
        "fronts": _fronts(fronts),
    }


def _rounded(value) -> float:
    return float(f"{value:.{DIGITS}g}")


def penalty_of(reading: Reading, row: NDArray[np.float64]) -> float:
    """How unusual the inputs of a row are [1]: the sum of the penalties of all unknowns."""
    values = reading.values(row[:-1])
    return sum(unknown.penalty(values[unknown.name]) for unknown in reading.unknowns)


def inputs_of(reading: Reading, row: NDArray[np.float64]) -> dict[str, float]:
    """The unknowns of a row, SI, by name, with as many digits as the file has."""
    return {name: _rounded(value) for name, value in reading.values(row[:-1]).items()}


def _identification(reading: Reading, rows, good, samples) -> dict:
    """For each unknown: its acceptable range, whether that is narrow, what is drawn, its profile.

    The profile is the least objective found with the unknown in each of equal parts of its bounds.
    """
    result = {}
    for index, unknown in enumerate(reading.unknowns):
        low, high = good[:, index].min(), good[:, index].max()
        part = np.minimum((rows[:, index] * PROFILE_BINS).astype(int), PROFILE_BINS - 1)
        drawn = [
            [_rounded(unknown.value(place)) for place in np.quantile(each[:, index], SHARES)]
            for each in samples
        ]
        least = [rows[part == each, -1].min(initial=np.inf) for each in range(PROFILE_BINS)]
        result[unknown.name] = {
            "acceptable": [_rounded(unknown.value(low)), _rounded(unknown.value(high))],
            "identified": bool(high - low < IDENTIFIED_SHARE),
            "median_of_each_seed": [median for _, median, _ in drawn],
            "range_of_each_seed": [[first, last] for first, _, last in drawn],
            "profile": [_rounded(value) if np.isfinite(value) else None for value in least],
        }
    return result


def _fronts(fronts) -> dict:
    """For each chief statement: pairs of its score and the objective without it, best ones only."""
    return {
        name: [
            list(map(_rounded, point)) for point in merged(np.array(each[name]) for each in fronts)
        ]
        for name in (fronts[0] if fronts else ())
    }


def _correlations(reading: Reading, sample) -> list[dict]:
    """Pairs of unknowns that are correlated among the sets that are drawn."""
    if len(sample) < 3:
        return []
    with np.errstate(invalid="ignore"):
        matrix = np.atleast_2d(np.corrcoef(sample[:, :-1].T))
    names = [unknown.name for unknown in reading.unknowns]
    return [
        {"between": [names[a], names[b]], "coefficient": float(f"{matrix[a, b]:.2f}")}
        for a, b in zip(*np.triu_indices(len(names), 1), strict=True)
        if abs(matrix[a, b]) >= NOTABLE_CORRELATION
    ]
