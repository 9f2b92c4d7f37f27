"""Evaluations in files: while a search runs, so that it goes on if interrupted, and when it ends."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.files import atomic_write


def write_rows(path: Path, rows: NDArray[np.float64]) -> None:
    """Write positions and objectives, shape (rows, unknowns + 1), with all their digits."""
    with atomic_write(path) as part:
        np.savetxt(part, rows, fmt="%.17g", delimiter=",")


def read_rows(path: Path) -> NDArray[np.float64]:
    """What ``write_rows`` wrote."""
    return np.loadtxt(path, delimiter=",", ndmin=2)


class Recorded:
    """An objective whose evaluations are kept in a file, so that an interrupted search goes on.

    A search is repeated from its seed and finds the values of its positions in the record.  The last
    record is evaluated anew first; if it differs, all are dropped, as the statements, the settings or
    the code have changed.

    ``function`` gives the objective at positions, shape (unknowns,); ``path`` has a line for each
    evaluation, and its folder is made; ``rows`` are the positions and objectives of this search.
    """

    def __init__(self, function: Callable[[NDArray[np.float64]], float], path: Path):
        self._function = function
        self._path = path
        self.rows: list[NDArray[np.float64]] = []
        path.parent.mkdir(parents=True, exist_ok=True)
        text = path.read_text(encoding="ascii") if path.exists() else ""
        complete = text[: text.rfind("\n") + 1]
        rows = [tuple(map(float, line.split())) for line in complete.splitlines()]
        is_stale = rows and function(np.array(rows[-1][:-1])) != rows[-1][-1]
        self._known = {} if is_stale else {row[:-1]: row[-1] for row in rows}
        path.write_text("" if is_stale else complete, encoding="ascii")

    def __call__(self, positions: NDArray[np.float64]) -> float:
        """The objective at positions, from the record if it is there."""
        place = tuple(map(float, positions))
        if place not in self._known:
            self._known[place] = float(self._function(positions))
            with open(self._path, "a", encoding="ascii") as stream:
                print(*place, self._known[place], file=stream)
        self.rows.append(np.array([*place, self._known[place]]))
        return self._known[place]
