"""What Snakemake's command line takes wrongly, told before Snakemake fails over it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from itertools import takewhile

CONFIG = "--config", "-C"


def require_settings(words: Sequence[str]) -> None:
    """End with one line if a target stands among the settings that follow ``--config``.

    Snakemake takes all words up to the next option for settings.

    Parameters
    ----------
    words : sequence of str
        The command line.

    Examples
    --------
    >>> require_settings(["snakemake", "results/figures/fig04.svg", "--config", "rtol=1e-6"])
    >>> require_settings(["snakemake", "--config", "rtol=1e-6", "results/figures/fig04.svg"])
    Traceback (most recent call last):
    SystemExit: results/figures/fig04.svg stands after --config; allowed there: KEY=VALUE; targets go first
    """
    for place, word in enumerate(words):
        if word in CONFIG:
            settings = takewhile(lambda each: not each.startswith("-"), words[place + 1 :])
            target = next((each for each in settings if "=" not in each), None)
            if target is not None:
                sys.exit(
                    f"{target} stands after {word}; allowed there: KEY=VALUE; targets go first"
                )
