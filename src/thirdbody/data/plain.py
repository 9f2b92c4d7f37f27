"""Datasets of the workflow, with the names of xarray but without importing it.

Importing xarray and pandas takes longer than solving or drawing a figure.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray as xr


class Variable(NamedTuple):
    """An array with named dimensions and attributes, in a form that xarray accepts."""

    dims: tuple[str, ...]
    values: NDArray
    attrs: Mapping[str, Any] = {}


@dataclass(frozen=True, eq=False)
class PlainDataset:
    """Variables over shared dimensions, coordinates and attributes, with the interface of
    ``xarray.Dataset``: functions accept either."""

    data_vars: Mapping[str, Variable]
    coords: Mapping[str, Variable]
    attrs: Mapping[str, Any]

    @property
    def variables(self) -> dict[str, Variable]:
        """Variables and coordinates, in the order of a file."""
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
        """The same data as an ``xarray.Dataset``."""
        import xarray as xr

        return xr.Dataset(self.data_vars, self.coords, self.attrs)
