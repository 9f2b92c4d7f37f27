"""``equivalent_roughness``: sigma of two surfaces from their roughness parameters."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from thirdbody.arguments import checked_array, common_index, is_column
from thirdbody.messages import format_value
from thirdbody.units import has_unit, plain_numbers


def equivalent_roughness(
    *, Rq: tuple[Any, Any] | None = None, Ra: tuple[Any, Any] | None = None
) -> Any:
    """Equivalent root mean square roughness sigma of two surfaces, sqrt(Rq_1^2 + Rq_2^2).

    Parameters
    ----------
    Rq, Ra : pair of numbers
        Root mean square, or arithmetic mean, of the heights of both surfaces: numbers in one unit,
        quantities, or columns of one table of pandas.  For Gaussian heights Rq is sqrt(pi/2) Ra.

    Returns
    -------
    float, quantity or column
        sigma, in the unit of the first surface.

    Raises
    ------
    ValueError
        Unless exactly one pair is given, of numbers that are not negative, or of lengths.

    Examples
    --------
    >>> import thirdbody as tb
    >>> sigma_nm = tb.equivalent_roughness(Rq=(240, 180))
    >>> sigma_nm
    300.0
    """
    given = {name: pair for name, pair in (("Rq", Rq), ("Ra", Ra)) if pair is not None}
    if len(given) != 1:
        raise ValueError(
            f"Rq is {format_value(Rq)} and Ra {format_value(Ra)}; allowed: one of them"
        )
    ((name, pair),) = given.items()
    try:
        one, other = pair
    except (TypeError, ValueError):
        raise ValueError(f"{name} is {format_value(pair)}; allowed: two numbers") from None
    common_index({f"{name} of surface 1": one, f"{name} of surface 2": other})
    one, other = (_checked_heights(name, each) for each in (one, other))
    factor = math.sqrt(math.pi / 2.0) if name == "Ra" else 1.0
    try:
        return factor * (one**2 + other**2) ** 0.5
    except Exception:  # pint raises many types
        allowed = "two numbers, or two lengths with units"
        raise ValueError(f"{name} is {format_value(pair)}; allowed: {allowed}") from None


def _checked_heights(name, given):
    """Heights as given, lists as arrays; ``ValueError`` unless they are lengths and not negative."""
    allowed = "zero or positive numbers"
    bare = given.to_numpy() if is_column(given) else plain_numbers(name, given, "m")
    numbers = checked_array(name, bare, allowed)
    if not ((numbers >= 0.0) & np.isfinite(numbers)).all():
        raise ValueError(f"{name} is {format_value(given)}; allowed: {allowed}")
    if is_column(given) or has_unit(given):
        return given
    return numbers if numbers.ndim else float(numbers)
