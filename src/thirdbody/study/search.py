"""Searching the unknown inputs of an interpretation for those that explain most of the paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import cma
import numpy as np
from numpy.typing import NDArray
from scipy.stats.qmc import LatinHypercube

from thirdbody.study.calibration import Interpretation, Unknown
from thirdbody.study.record import Recorded

FIRST_STEP = 0.2  # standard deviation of the first steps of a search, in the unit cube
SAME_HEIGHT = 0.03  # a search has converged when objectives differ by no more [1]


def search(
    interpretation: Interpretation,
    objective: Callable[[Interpretation, NDArray[np.float64]], float],
    budget: Mapping[str, Any],
    seed: int,
    record: Path,
    report: Callable[[str], object] = print,
    start: NDArray[np.float64] | None = None,
) -> NDArray[np.float64]:
    """Search the unknowns of an interpretation for the least objective.

    A CMA evolution strategy, which saves evaluations by a quadratic surrogate, descends from the best
    of some scattered places, half of them among elastic summits.

    Parameters
    ----------
    interpretation : Interpretation
        Its unknowns are searched, two at least.
    objective : callable
        ``objective(interpretation, positions)`` is minimised.
    budget : mapping
        Number of ``scattered`` places; of ``evaluations`` of the descent for each unknown, which the
        last generation may exceed; and ``elastic_radius``, the least summit radius of elastic
        summits [m].
    seed : int
        Of the random numbers, from 1: the same seed gives the same result.
    record : Path
        File that keeps the evaluations while the search runs.
    report : callable
        Is given a line of text at the end.
    start : array, shape (unknowns,), optional
        Where the descent starts, instead of scattered places.

    Returns
    -------
    array, shape (evaluations, unknowns + 1)
        Positions, and in the last column the objective there [1], in the order of evaluation.

    References
    ----------
    Hansen (2019), doi:10.1145/3321707.3321842.

    Examples
    --------
    An objective that is least where the ratio is 1.5 and the mean 1:

    >>> import tempfile
    >>> ratio = Unknown("gap_ratio", (0.0, 4.0), (1.0, 2.0), logarithmic=False)
    >>> mean = Unknown("mean_ratio", (0.0, 2.0), (0.0, 2.0), logarithmic=False)
    >>> two = Interpretation("two", {}, (ratio, mean))
    >>> def valley(interpretation, positions):
    ...     values = interpretation.values(positions)
    ...     return (values["gap_ratio"] - 1.5) ** 2 + (values["mean_ratio"] - 1.0) ** 2
    >>> budget = {"scattered": 20, "evaluations": 50, "elastic_radius": 5e-5}
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     record = Path(folder, "record.txt")
    ...     rows = search(two, valley, budget, seed=1, record=record, report=lambda line: None)
    >>> best = rows[rows[:, -1].argmin()]
    >>> round(two.values(best[:-1])["gap_ratio"], 1)
    1.5
    """
    function = Recorded(lambda positions: objective(interpretation, positions), record)
    unknowns = interpretation.unknowns
    rng = np.random.default_rng(seed)
    if start is None:
        places = LatinHypercube(len(unknowns), rng=rng).random(budget["scattered"])
        places[::2] = _elastic(places[::2], unknowns, budget["elastic_radius"])
        start = min(places, key=function)
    options = {
        "bounds": [0.0, 1.0],
        "maxfevals": budget["evaluations"] * len(unknowns),
        "tolfun": SAME_HEIGHT,
        "tolfunhist": SAME_HEIGHT,
        "seed": int(rng.integers(1, 2**31)),
        "verbose": -9,
    }
    cma.fmin_lq_surr(function, start, FIRST_STEP, options)
    rows = np.array(function.rows)
    report(
        f"{interpretation.name} seed {seed}: "
        f"{len(rows)} evaluations, least objective {rows[:, -1].min():.3f}"
    )
    return rows


def _elastic(places, unknowns: tuple[Unknown, ...], radius: float):
    """The same places with the summit radius moved above ``radius`` [m]."""
    for column, unknown in enumerate(unknowns):
        if unknown.name == "summit_radius":
            least = unknown.position(radius)
            places[:, column] = least + (1.0 - least) * places[:, column]
    return places
