"""The usual range of each condition: points outside it are solved with a warning.

A load given in newtons, or a size in nanometres, is outside.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import numpy as np
from numpy.typing import NDArray

# SI, far wider than the ranges of the paper; 0 means no oil, or no particles
USUAL = {
    "load": (1e-13, 2e-2),
    "viscosity": (3e-7, 1e-2),
    "particle_diameter": (1e-9, 1e-3),
    "roughness": (1e-9, 1e-3),
    "particle_density": (1e6, 1e16),
}

# steel in oil: defaults of comparisons with measurements
BOUNDARY_FRICTION, FILM_FRICTION = 0.12, 0.03
RESISTIVITY_OHM_M = 2.2e-7


class OutOfRangeWarning(UserWarning):
    """Numbers are outside their usual range, probably because they are in another unit.

    Examples
    --------
    >>> import warnings
    >>> import thirdbody as tb
    >>> with warnings.catch_warnings(record=True) as caught:
    ...     inputs = tb.bearing(pressure_viscosity_per_GPa=0.02)
    >>> print(caught[0].message)
    pressure_viscosity_per_GPa is 0.02 GPa-1; usual: 1 to 100 GPa-1
    """


def warn_outside(given: Mapping[str, tuple[NDArray, NDArray, str]]) -> None:
    """Issue one ``OutOfRangeWarning``, attributed to the caller of the package, for values, by
    name, outside their usual range in the same unit."""
    found = []
    for name, (values, (least, most), unit) in given.items():
        values = np.ravel(values)
        outside = values[((values < least) & (values != 0.0)) | (values > most)]
        if outside.size:
            suffix = "" if unit == "1" else f" {unit}"
            ends = " to ".join(f"{float(f'{end:.2g}'):g}" for end in (least, most))
            found.append(f"{name} is {outside[0]:g}{suffix}; usual: {ends}{suffix}")
    if found:
        warnings.warn(", and ".join(found), OutOfRangeWarning, stacklevel=_outside_of_package())


@contextmanager
def without_warnings() -> Iterator[None]:
    """Suppress warnings of conditions that have been checked."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OutOfRangeWarning)
        yield


def _outside_of_package() -> int:
    """The ``stacklevel`` of the nearest caller outside this package."""
    frame, level = sys._getframe(1), 1
    package = __name__.partition(".")[0]
    while frame and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        frame, level = frame.f_back, level + 1
    return level
