"""The variables of the datasets: name, symbol, unit, equation and meaning, in ``quantities.toml``."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Condition
from thirdbody.model.regimes import FLAG_MEANINGS
from thirdbody.toml_tables import toml_beside

if TYPE_CHECKING:
    from thirdbody.data.netcdf import PlainDataset

STATUS = "solution_status"  # the flag that qualifies all other variables
# Values of points that a figure does not show: the fill values of NetCDF.  For a flag it is a value
# with a meaning, not_shown, because xarray converts integers with missing values to floats.
FILL_FLOAT = 9.969209968386869e36
FILL_FLAG = np.int8(-127)
ENDS = (0.05, 0.95)  # quantiles at the ends of the range over an ensemble


class Quantity(NamedTuple):
    """One variable of datasets and of ``thirdbody.Solution``: ``symbol`` of the paper in ASCII,
    ``equation`` or section that defines it, ``units`` SI in UDUNITS spelling."""

    name: str
    long_name: str
    symbol: str = "none"
    equation: str = "none"
    units: str = "1"
    comment: str = ""

    @property
    def meanings(self) -> tuple[str, ...]:
        """Meanings of the values 0, 1, ... of a flag; empty for a number."""
        return FLAG_MEANINGS.get(self.name, ())


DESCRIBED = toml_beside(__file__)
STATUS_MEANINGS = DESCRIBED["statuses"]
QUANTITIES, FLAGS, OTHERS = (
    {name: Quantity(name, **described) for name, described in DESCRIBED[kind].items()}
    for kind in ("quantities", "flags", "others")
)
STATUS_COMMENT = "; ".join(f"{status}: {text}" for status, text in STATUS_MEANINGS.items())
FLAGS[STATUS] = FLAGS[STATUS]._replace(comment=STATUS_COMMENT)
NORMAL_LOAD, ERROR_BOUND = OTHERS.values()
# variables of a dataset
NUMBERS = QUANTITIES | {ERROR_BOUND.name: ERROR_BOUND}
VARIABLES = NUMBERS | FLAGS


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
