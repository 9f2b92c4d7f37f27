"""``equivalent_roughness``: sigma of two surfaces from their roughness parameters."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from thirdbody.conditions import common_index


def equivalent_roughness(
    *, Rq: tuple[Any, Any] | None = None, Ra: tuple[Any, Any] | None = None
) -> Any:
    """Equivalent root mean square roughness sigma of two surfaces, sqrt(Rq_1^2 + Rq_2^2).

    Parameters
    ----------
    Rq, Ra : pair of numbers
        Root mean square, or arithmetic mean, of the heights of both surfaces: numbers or arrays in one
        unit, quantities, or columns of one table of pandas.  For Gaussian heights Rq is sqrt(pi/2) Ra.

    Returns
    -------
    float, quantity or column
        sigma, in the unit of the first surface.

    Raises
    ------
    ValueError
        Unless exactly one pair is given; for a negative number, and columns with different indexes.

    Examples
    --------
    >>> import thirdbody as tb
    >>> sigma_nm = tb.lab.equivalent_roughness(Rq=(240, 180))
    >>> sigma_nm
    300.0
    """
    pairs = [pair for pair in (Rq, Ra) if pair is not None]
    if len(pairs) != 1:
        raise ValueError("allowed: one of Rq and Ra")
    one, other = pairs[0]
    common_index({"surface 1": one, "surface 2": other})
    if np.any(one < 0) or np.any(other < 0):
        raise ValueError(f"roughnesses are {one!r} and {other!r}; allowed: zero or positive")
    factor = math.sqrt(math.pi / 2.0) if Rq is None else 1.0
    return factor * (one**2 + other**2) ** 0.5
