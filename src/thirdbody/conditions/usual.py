"""How far the conditions of real interfaces reach: what lies beyond is told, and solved.

The paper has loads F_t* up to 1e-4, oils up to 150 cSt, sizes up to 1 um and 5e12 particles per square
metre; each limit is more than fifty times as high.  What is given in another unit, a load in newtons
or a size in nanometres, is beyond its limit.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Mapping

MOST = {  # SI, with the unit that messages give
    "load": (2e-2, ""),
    "viscosity": (1e-2, " m2/s"),
    "particle_diameter": (1e-3, " m"),
    "roughness": (1e-3, " m"),
    "particle_density": (1e16, " m-2"),
}


class OutOfRangeWarning(UserWarning):
    """Conditions are beyond those of real interfaces: probably they are in another unit.

    Examples
    --------
    >>> import warnings
    >>> import thirdbody as tb
    >>> with warnings.catch_warnings(record=True) as told:
    ...     point = tb.solve(
    ...         load=1e-5,
    ...         viscosity=90,
    ...         particle_diameter=0.0,
    ...         roughness=300e-9,
    ...         particle_density=0.0,
    ...         parameters=tb.load_parameters(),
    ...     )
    >>> print(told[0].message)
    viscosity is 90 m2/s; usual: up to 0.01 m2/s
    """


def warn_beyond_usual(greatest: Mapping[str, float]) -> None:
    """Issue one ``OutOfRangeWarning``, at the caller of the package, for what is beyond ``MOST`` of
    the ``greatest`` values of conditions."""
    told = [
        f"{name} is {greatest[name]:g}{unit}; usual: up to {most:g}{unit}"
        for name, (most, unit) in MOST.items()
        if greatest[name] > most
    ]
    if told:
        warnings.warn(", and ".join(told), OutOfRangeWarning, stacklevel=_outside_of_package())


def _outside_of_package() -> int:
    """The ``stacklevel`` of the nearest caller that is no part of this package."""
    frame, level = sys._getframe(1), 1
    package = __name__.partition(".")[0]
    while frame and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        frame, level = frame.f_back, level + 1
    return level
