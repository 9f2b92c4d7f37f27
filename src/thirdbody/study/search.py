"""Searching the unprinted inputs of a reading for those that explain most of the paper."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import cma
import numpy as np
from numpy.typing import NDArray
from scipy.stats.qmc import LatinHypercube

from thirdbody.study.calibration import Found, Objective, Reading

FIRST_STEP = 0.2  # deviation of the first steps of a search, in the unit cube
SAME_HEIGHT = 0.03  # a descent has converged when objectives differ by no more [1]
RESTARTS = 9  # more than any number of evaluations reaches


def search(
    reading: Reading,
    objective: Objective,
    budget: Mapping[str, int],
    seed: int,
    report: Callable[[str], object] = print,
    see: Callable[[Found], object] = lambda found: None,
) -> NDArray[np.float64]:
    """Search the unknowns of a reading for the least objective, and record every evaluation.

    An evolution strategy that adapts the covariance of its steps begins at the best of some places
    that are scattered over the unit cube and know nothing.  Once it has converged it begins anew
    with twice the population, as long as evaluations are left.

    Parameters
    ----------
    reading : Reading
        Its unknowns are searched, two at least.
    objective : Objective
        What ``objective.found(reading, positions)`` names as the objective is minimised.
    budget : mapping
        How much to evaluate: ``scattered`` places before each descent, the ``population`` of the
        first one, and ``evaluations`` of all descents, which the last generation may exceed.
    seed : int
        Of the random numbers, from 1: the same seed gives the same result.
    report : callable
        Is given a line of text from time to time.
    see : callable
        Is given what is found by every evaluation.

    Returns
    -------
    array, shape (evaluations, unknowns + 1)
        Positions [1], and in the last column the objective there [1], in the order of evaluation.

    References
    ----------
    Hansen & Ostermeier (2001), doi:10.1162/106365601750190398; Auger & Hansen (2005),
    doi:10.1109/CEC.2005.1554902.

    Examples
    --------
    An objective of one's own, least where the ratio is 1.5 and the mean 1:

    >>> from thirdbody.study.calibration import Found, Unknown
    >>> ratio = Unknown("gap_ratio", (0.0, 4.0), (1.0, 2.0), logarithmic=False)
    >>> mean = Unknown("mean_ratio", (0.0, 2.0), (0.0, 2.0), logarithmic=False)
    >>> reading = Reading("two", {}, (ratio, mean))
    >>> class Valley:
    ...     def found(self, reading, positions):
    ...         values = reading.values(positions)
    ...         return Found((values["gap_ratio"] - 1.5) ** 2 + (values["mean_ratio"] - 1.0) ** 2)
    >>> budget = {"scattered": 20, "population": 8, "evaluations": 200}
    >>> rows = search(reading, Valley(), budget, seed=1, report=lambda line: None)
    >>> best = rows[rows[:, -1].argmin()]
    >>> round(reading.values(best[:-1])["gap_ratio"], 1)
    1.5
    """
    rows: list[np.ndarray] = []

    def recorded(positions):
        found = objective.found(reading, positions)
        see(found)
        rows.append(np.append(positions, found.objective))
        if len(rows) % 50 == 0:
            least = min(row[-1] for row in rows)
            report(f"{reading.name} seed {seed}: {len(rows)} evaluations, best {least:.3f}")
        return rows[-1][-1]

    rng = np.random.default_rng(seed)
    options = {
        "bounds": [0.0, 1.0],
        "popsize": budget["population"],
        "maxfevals": budget["evaluations"],
        "tolfun": SAME_HEIGHT,
        "tolfunhist": SAME_HEIGHT,
        "seed": seed,
        "verbose": -9,
    }

    def start():
        places = LatinHypercube(len(reading.unknowns), rng=rng).random(budget["scattered"])
        return min(places, key=recorded)

    cma.fmin2(recorded, start, FIRST_STEP, options, restarts=RESTARTS)
    return np.array(rows)
