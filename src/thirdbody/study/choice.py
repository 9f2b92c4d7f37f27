"""Which of the sets of inputs that explain the paper's statements about equally well a reading takes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from thirdbody.study.calibration import Reading
from thirdbody.study.claims import CALIBRATION
from thirdbody.study.evidence import FULL_EFFORT, QUICK_EFFORT, Effort
from thirdbody.study.posterior import inputs_of, penalty_of
from thirdbody.study.verdicts import Court, count_held


def most_held(reading: Reading, sets: NDArray[np.float64], court: Court) -> NDArray[np.float64]:
    """The set under which most statements of the calibration hold; of several the least unusual.

    It is the rule by which the default is chosen among readings.

    Parameters
    ----------
    reading : Reading
        Says what the positions stand for.
    sets : array, shape (sets, unknowns + 1)
        Positions and objective of sets that are acceptable.
    court : Court
        Judges the statements.

    Returns
    -------
    array, shape (unknowns + 1,)
        One of the ``sets``.

    Notes
    -----
    Statements are counted with the effort of a search, and once more in full under the sets that
    come out first.
    """

    def held(row: NDArray[np.float64], effort: Effort) -> int:
        inputs = {**reading.fixed, **inputs_of(reading, row)}
        judgement = court.judge(reading.name, inputs, effort)
        return count_held(court.claims, judgement, CALIBRATION)[0]

    counts = np.array([held(row, QUICK_EFFORT) for row in sets])
    first = sets[counts == counts.max()]
    return min(first, key=lambda row: (-held(row, FULL_EFFORT), penalty_of(reading, row)))
