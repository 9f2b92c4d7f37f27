"""Results of a function that are kept for later calls, and whether there is one."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable


class Kept:
    """A function of hashable arguments that keeps the results of its latest calls.

    Unlike ``functools.lru_cache`` it tells whether a result is at hand.

    Parameters
    ----------
    function : callable
        The function.
    most : int
        How many results are kept.

    Examples
    --------
    >>> square = Kept(lambda x: x * x, most=1)
    >>> square(3), square.has(3), square.has(4)
    (9, True, False)
    """

    def __init__(self, function: Callable, most: int):
        self._function, self._most = function, most
        self._results: OrderedDict[Hashable, object] = OrderedDict()

    def __call__(self, *arguments):
        try:
            return self._results[arguments]
        except KeyError:
            result = self._results[arguments] = self._function(*arguments)
            while len(self._results) > self._most:
                self._results.popitem(last=False)
            return result

    def has(self, *arguments) -> bool:
        """Whether the result of a call with these arguments is kept."""
        return arguments in self._results

    def cache_clear(self) -> None:
        """Forget all results."""
        self._results.clear()
