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

    A search is repeated from its seed and takes the recorded values as long as its positions are
    the recorded ones.  The last record is evaluated anew first; if it differs, all are dropped, as
    the statements, the settings or the code have changed.

    ``function`` gives the objective at positions, shape (unknowns,); ``path`` has a line for each
    evaluation, and its folder is made; ``rows`` are the positions and objectives of this search.
    """

    def __init__(self, function: Callable[[NDArray[np.float64]], float], path: Path):
        self._function = function
        self._path = path
        self.rows: list[NDArray[np.float64]] = []
        path.parent.mkdir(parents=True, exist_ok=True)
        self._known = self._read()

    def _read(self) -> list[list[float]]:
        """The complete lines of the record, if they still belong to this objective."""
        text = self._path.read_text(encoding="ascii") if self._path.exists() else ""
        complete = text[: text.rfind("\n") + 1].splitlines()
        known = [[float.fromhex(each) for each in line.split()] for line in complete]
        if known and self._function(np.array(known[-1][:-1])) != known[-1][-1]:
            known = []
        self._write("w", known)
        return known

    def _write(self, mode: str, rows) -> None:
        with open(self._path, mode, encoding="ascii") as stream:
            stream.writelines(" ".join(float(x).hex() for x in row) + "\n" for row in rows)

    def __call__(self, positions: NDArray[np.float64]) -> float:
        """The objective at positions, from the record if it is there."""
        place = len(self.rows)
        row = self._known[place] if place < len(self._known) else None
        if row is None or row[:-1] != list(positions):
            row = [*positions, self._function(positions)]
            if place < len(self._known):
                self._known = self._known[:place]
                self._write("w", self._known)
            self._write("a", [row])
        self.rows.append(np.array(row))
        return row[-1]
