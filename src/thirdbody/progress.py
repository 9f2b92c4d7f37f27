"""The progress bar of a long call."""

import sys
from contextlib import AbstractContextManager, nullcontext
from types import SimpleNamespace
from typing import Any

FIRST = 2.0  # s until a bar is shown


def progress_bar(total: int, is_shown: bool) -> AbstractContextManager[Any]:
    """A bar for ``total`` points, with the method ``update(count)`` for points that are solved.

    The bar appears if ``is_shown``, on a terminal, and if the call takes longer than ``FIRST``.
    """
    if not (is_shown and sys.stderr is not None and sys.stderr.isatty()):
        return nullcontext(SimpleNamespace(update=lambda count: None))
    from tqdm.std import tqdm  # here, as its import takes as long as solving 10^4 points

    return tqdm(total=total, unit=" points", unit_scale=True, delay=FIRST)
