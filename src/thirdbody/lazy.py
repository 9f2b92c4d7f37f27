"""Names of states for xarray, made from their codes when they are used: grids may be large."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from xarray.backends import BackendArray
from xarray.core import indexing

from thirdbody.core.regimes import states_of

TEXT = np.dtype(object, metadata={"element_type": str})  # which xarray writes as it is


class LazyStates(BackendArray):
    """The states of the flag ``name`` with these ``codes``."""

    def __init__(self, name: str, codes: NDArray[np.int8]) -> None:
        self.name, self.codes, self.shape, self.dtype = name, codes, codes.shape, TEXT

    def __getitem__(self, key: indexing.ExplicitIndexer) -> Any:
        support = indexing.IndexingSupport.BASIC
        return indexing.explicit_indexing_adapter(key, self.shape, support, self._states)

    def _states(self, key: tuple) -> NDArray:
        return states_of(self.name, self.codes[key])


def lazy_states(name: str, codes: NDArray[np.int8]) -> Any:
    """An array for ``xarray.Variable``: the states of the flag ``name`` with these ``codes``."""
    return indexing.LazilyIndexedArray(LazyStates(name, codes))
