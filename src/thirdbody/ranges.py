"""Values of points that have none, the curves of a dataset, and ranges over an ensemble."""

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves import Condition
from thirdbody.variables import STATUS

if TYPE_CHECKING:
    from thirdbody.netcdf import PlainDataset

# Values of points that a figure does not show: the fill values of NetCDF.  For a flag it is a value
# with a meaning, not_shown, because xarray converts integers with missing values to floats.
FILL_FLOAT = 9.969209968386869e36
FILL_FLAG = np.int8(-127)
ENDS = (0.05, 0.95)  # quantiles at the ends of the range over an ensemble


def curves_of(dataset: "PlainDataset") -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """The curves of a dataset, with at least one point with a status: their conditions, SI, in the
    order of ``Condition``, shape (4, curves); and their index in a variable after its load axis,
    ``values[:, index]``."""
    status = dataset[STATUS].values
    # nan where xarray has masked points, which it converts to floats
    shown = (np.isfinite(status) & (status != FILL_FLAG)).any(axis=0)
    axes = [dataset[name].values for name in Condition._fields]
    conditions = np.stack([grid[shown] for grid in np.meshgrid(*axes, indexing="ij")])
    return conditions, shown


def spread(values: Iterable[float]) -> tuple[float, float] | None:
    """The range, 5 to 95 %, of ``values``, those of an ensemble; None if there are none."""
    known = [value for value in values if np.isfinite(value)]
    return tuple(np.quantile(known, ENDS).tolist()) if known else None


def ranges(name: str, members: list[NDArray]) -> dict[str, NDArray]:
    """The same at each of several points, as columns ``_low`` and ``_high``; none of no members."""
    import pandas as pd

    ends = pd.DataFrame(members).quantile(ENDS).to_numpy() if members else ()  # ignores nan
    return dict(zip((f"{name}_low", f"{name}_high"), ends))
