"""``Tabular``: tabular results for pandas, xarray and notebooks."""

from dataclasses import fields
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


def indexed(table: "pd.DataFrame", index: "pd.Index | None", points: ArrayLike) -> "pd.DataFrame":
    """A table whose rows belong to ``points``, flat indices into an array with the rows of ``index``
    along its last axis, with the labels of these rows; unchanged if ``index`` is None."""
    if index is None:
        return table
    return table.set_index(index.take(np.asarray(points, int) % max(len(index), 1)))


def with_rows(dataset: "xr.Dataset", index: "pd.Index | None") -> "xr.Dataset":
    """A dataset with the ``index`` of the points along its last dimension as a coordinate, one for each level, of
    its name or else ``row``; as text where netCDF has no such type.  Unchanged if ``index`` is None."""
    if index is None:
        return dataset
    dimension, size = [*dataset.sizes.items()][-1]
    rows = index.take(np.arange(size) % max(len(index), 1))
    labels = {}
    for level, name in enumerate(rows.names):
        if name is None or name in (*dataset.variables, *labels):
            name = "row" if rows.nlevels == 1 else f"row_{level}"
        values = np.asarray(rows.get_level_values(level))
        labels[str(name)] = dimension, values.astype(str) if values.dtype == object else values
    return dataset.assign_coords(labels)


class Tabular:
    """A result with ``to_dataframe`` and ``to_dataset``, and a table in notebooks.

    A dataclass whose fields are numbers, or arrays of one shape, becomes a table with one row per
    element.  Other classes override ``to_dataframe``.
    """

    index: "pd.Index | None" = None  # of the columns of pandas that were given

    def to_dataframe(self) -> "pd.DataFrame":
        """The fields as columns."""
        import pandas as pd

        names = [field.name for field in fields(self) if field.name != "index"]
        table = pd.DataFrame({name: np.ravel(getattr(self, name)) for name in names})
        return indexed(table, self.index, range(len(table)))

    def to_dataset(self) -> "xr.Dataset":
        """The same table over the dimension ``row``."""
        table = self.to_dataframe()
        names = dict.fromkeys(table.select_dtypes("category"), object)  # netCDF has no categories
        columns = table.astype(names).reset_index(drop=True).rename_axis("row").to_xarray()
        return with_rows(columns.drop_vars("row"), table.index)

    def __eq__(self, other: object) -> bool:
        """Whether both are results of one kind with the same table."""
        if type(self) is not type(other):
            return NotImplemented
        return self.to_dataframe().equals(other.to_dataframe())

    __hash__ = None

    def __str__(self) -> str:
        """The table, with six significant digits; ``none`` if it has no rows."""
        try:
            table = self.to_dataframe()
        except ModuleNotFoundError:
            return repr(self)
        if table.empty:
            return "none"
        digits = "{:.6g}".format
        return table.to_string(index=self.index is not None, float_format=digits)

    def _repr_html_(self) -> str | None:
        try:
            return self.to_dataframe().to_html(index=self.index is not None, max_rows=60)
        except ModuleNotFoundError:  # notebooks then use __repr__
            return None
