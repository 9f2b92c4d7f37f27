"""Positions and objectives in files, between the jobs of a calibration."""

from __future__ import annotations

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
