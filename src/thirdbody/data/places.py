"""Groups of statements by their place in the paper."""

import re

FIGURE = re.compile(r"Figures? (\d+)")


def part_of_paper(place: str) -> str:
    """The first part of the paper in the ``place`` of a claim in ``config/claims.yaml``: Figure 4
    for "Figures 4B and 4C, section 3.3"."""
    figure = FIGURE.match(place)
    if figure:
        return f"Figure {figure[1]}"
    return "Conclusions" if place.startswith("Conclusion") else place.split(",")[0]
