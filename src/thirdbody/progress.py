"""Progress of a long call: a bar of tqdm on a terminal, nothing elsewhere."""

import sys
from contextlib import AbstractContextManager, nullcontext
from types import SimpleNamespace
from typing import Any

FIRST = 2.0  # s until a bar is shown


def progress_bar(total: int, is_shown: bool) -> AbstractContextManager[Any]:
    """A bar for ``total`` points, whose ``update`` counts those that are solved.

    It is shown if ``is_shown``, on a terminal, in calls that take longer than ``FIRST``.
    """
    if not (is_shown and sys.stderr is not None and sys.stderr.isatty()):
        return nullcontext(SimpleNamespace(update=lambda count: None))
    from tqdm.std import tqdm  # imported where it is used: its import takes as long as 10^4 points

    return tqdm(total=total, unit=" points", unit_scale=True, delay=FIRST)
