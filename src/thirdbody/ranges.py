"""The range of a result: 5 to 95 % over the ensemble of inputs that explain the paper about equally well."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

ENDS = (0.05, 0.95)  # quantiles at the ends of the range over an ensemble


def spread(values: Iterable[float]) -> tuple[float, float] | None:
    """The range, 5 to 95 %, of ``values``, those of an ensemble; None if there are none."""
    known = [value for value in values if np.isfinite(value)]
    return tuple(np.quantile(known, ENDS).tolist()) if known else None


def ranges(name: str, members: list[NDArray]) -> dict[str, NDArray]:
    """The same at each of several points, as columns ``_low`` and ``_high``; none of no members."""
    import pandas as pd  # slow to import, where a job needs the ends alone

    ends = pd.DataFrame(members).quantile(ENDS).to_numpy() if members else ()  # ignores nan
    return dict(zip((f"{name}_low", f"{name}_high"), ends))
