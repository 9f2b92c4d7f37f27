"""Places in the paper: the figures that a place names, and the part of the paper that has it."""

import re

FIGURE = re.compile(r"Figures? (\d+)")
# "Figure 4B", "Figures 4B and 4C", "Figures 4 to 7": the first number, and the last one of a range
FIGURES = re.compile(r"(?:Figures? |and (?=\d))(\d+)[A-D]?(?: to (\d+))?")


def part_of_paper(place: str) -> str:
    """The first part of the paper that the ``place`` of a claim names: "Figure 4" for "Figures 4B
    and 4C, section 3.3"."""
    figure = FIGURE.match(place)
    if figure:
        return f"Figure {figure[1]}"
    return "Conclusions" if place.startswith("Conclusion") else place.split(",")[0]


def figures_named(place: str) -> frozenset[int]:
    """Numbers of the figures that a ``place`` names, such as "Figures 4B and 5C" or "Figures 4 to
    7"."""
    ends = FIGURES.findall(place)
    return frozenset().union(*(range(int(one), int(last or one) + 1) for one, last in ends))
