"""``Tabular``: tabular results for pandas, xarray and notebooks."""

from dataclasses import fields
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


class Tabular:
    """A result with ``to_dataframe`` and ``to_dataset``, and a table in notebooks.

    A dataclass whose fields are numbers, or arrays of one shape, becomes a table with one row per
    element.  Other classes override ``to_dataframe``.
    """

    def to_dataframe(self) -> "pd.DataFrame":
        """The fields as columns."""
        import pandas as pd

        return pd.DataFrame(
            {each.name: np.ravel(getattr(self, each.name)) for each in fields(self)}
        )

    def to_dataset(self) -> "xr.Dataset":
        """The same table over the dimension ``row``."""
        return self.to_dataframe().rename_axis("row").to_xarray()

    def __eq__(self, other: object) -> bool:
        """Whether both are results of one kind with the same table."""
        if type(self) is not type(other):
            return NotImplemented
        return self.to_dataframe().equals(other.to_dataframe())

    __hash__ = None

    def _repr_html_(self) -> str | None:
        try:
            return self.to_dataframe().to_html(index=False, max_rows=60)
        except ModuleNotFoundError:  # notebooks then use __repr__
            return None
