"""``equivalent_roughness``: sigma of two surfaces from their roughness parameters."""

import math

from thirdbody.conditions import check_number
from thirdbody.messages import format_value


def equivalent_roughness(
    *, Rq: tuple[float, float] | None = None, Ra: tuple[float, float] | None = None
) -> float:
    """Equivalent root mean square roughness sigma of two surfaces, sqrt(Rq_1^2 + Rq_2^2).

    Parameters
    ----------
    Rq, Ra : pair of float
        Root mean square, or arithmetic mean, of the heights of both surfaces, in any unit.  For Gaussian
        heights Rq is sqrt(pi/2) Ra.

    Returns
    -------
    float
        sigma, in the same unit.

    Raises
    ------
    ValueError
        Unless exactly one pair of numbers is given, none negative.

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
    for value in (one, other):
        check_number(name, value, positive=False)
    factor = math.sqrt(math.pi / 2.0) if name == "Ra" else 1.0
    return factor * math.hypot(one, other)
