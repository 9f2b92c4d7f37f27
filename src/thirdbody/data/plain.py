"""Datasets as the workflow solves, stores and draws them: what xarray calls alike, without it.

Loading xarray and the pandas that it needs takes longer than solving or drawing a figure does.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True, eq=False)
class Variable:
    """An array with named dimensions, and what a file says of it."""

    dims: tuple[str, ...]
    values: NDArray
    attrs: Mapping[str, Any] = field(default_factory=dict)


Given = Variable | Sequence  # a variable, or as xarray takes it: dimensions, values, attributes


class PlainDataset:
    """Arrays over shared dimensions, under the names that they have in ``xarray.Dataset``: what takes
    one takes the other as well.

    Variables, coordinates along the dimensions, and attributes are given by name; each of the first
    two as dimensions, values and attributes, or as a variable of a dataset.

    Examples
    --------
    >>> points = PlainDataset({"height": ("x", [1.0, 2.0])}, {"x": ("x", [0.0, 0.5])}, {})
    >>> points["height"].values, points.sizes, "depth" in points
    (array([1., 2.]), {'x': 2}, False)
    """

    def __init__(
        self, data_vars: Mapping[str, Given], coords: Mapping[str, Given], attrs: Mapping[str, Any]
    ) -> None:
        self.data_vars = {name: _variable(given) for name, given in data_vars.items()}
        self.coords = {name: _variable(given) for name, given in coords.items()}
        self.attrs = dict(attrs)

    @property
    def variables(self) -> dict[str, Variable]:
        """Variables and coordinates, in the order in which a file holds them."""
        return self.data_vars | self.coords

    @property
    def sizes(self) -> dict[str, int]:
        """The length of each dimension."""
        each = self.variables.values()
        return {name: size for one in each for name, size in zip(one.dims, one.values.shape)}

    def __contains__(self, name: str) -> bool:
        return name in self.data_vars or name in self.coords

    def __getitem__(self, name: str) -> Variable:
        return self.data_vars[name] if name in self.data_vars else self.coords[name]

    def assign(self, data_vars: Mapping[str, Given]) -> PlainDataset:
        """The same with further variables."""
        return PlainDataset(self.data_vars | data_vars, self.coords, self.attrs)

    def to_xarray(self) -> xr.Dataset:
        """The same as a dataset of xarray."""
        import xarray as xr

        variables, coords = (
            {name: (one.dims, one.values, one.attrs) for name, one in some.items()}
            for some in (self.data_vars, self.coords)
        )
        return xr.Dataset(variables, coords, self.attrs)


def _variable(given: Given) -> Variable:
    """``given`` as a variable; attributes may be left out, and a single dimension be a word."""
    if hasattr(given, "dims"):
        return Variable(given.dims, given.values, given.attrs)
    dims, values, *attrs = given
    return Variable((dims,) if isinstance(dims, str) else tuple(dims), np.asarray(values), *attrs)
