"""Where in the paper a statement stands, as a name for its group."""

from __future__ import annotations

import re

FIGURE = re.compile(r"Figures? (\d+)")


def part_of_paper(where: str) -> str:
    """The part that ``where`` names first: ``Figure 4``, ``Conclusions``, ``Abstract``, ...

    ``where`` is the field of a claim, such as ``Figures 4B and 4C, section 3.3``.
    """
    figure = FIGURE.match(where)
    if figure:
        return f"Figure {figure[1]}"
    if where.startswith("Conclusion"):
        return "Conclusions"
    return where.split(",")[0]
