"""Datasets as the workflow solves, stores and draws them: what xarray calls alike, without it.

Loading xarray and the pandas that it needs takes longer than solving or drawing a figure does.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray as xr


class Variable(NamedTuple):
    """An array with named dimensions, and what a file says of it; xarray takes it as it is."""

    dims: tuple[str, ...]
    values: NDArray
    attrs: Mapping[str, Any] = {}


@dataclass(frozen=True, eq=False)
class PlainDataset:
    """Variables over shared dimensions, coordinates and attributes, under the names that they have in
    ``xarray.Dataset``: what takes one takes the other as well."""

    data_vars: Mapping[str, Variable]
    coords: Mapping[str, Variable]
    attrs: Mapping[str, Any]

    @property
    def variables(self) -> dict[str, Variable]:
        """Variables and coordinates, in the order in which a file holds them."""
        return {**self.data_vars, **self.coords}

    @property
    def sizes(self) -> dict[str, int]:
        """The length of each dimension."""
        each = self.variables.values()
        return {name: size for one in each for name, size in zip(one.dims, one.values.shape)}

    def __contains__(self, name: str) -> bool:
        return name in self.variables

    def __getitem__(self, name: str) -> Variable:
        return self.variables[name]

    def to_xarray(self) -> xr.Dataset:
        """The same as a dataset of xarray."""
        import xarray as xr

        return xr.Dataset(self.data_vars, self.coords, self.attrs)
