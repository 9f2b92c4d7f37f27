"""Where a product stands in the report of a run, and under which title.

Snakemake asks these functions while it writes the report: ``report(..., category=part_of_report,
labels=label_in_report)``.  It sorts parts and titles as words.
"""

from __future__ import annotations

import re
from pathlib import Path

PARTS = {  # what all of it can be seen with; as in the paper; what it does not have
    "0 Explorer": ("index",),
    "1 Model": ("fig01", "fig02", "table1", "table2"),
    "2 Load, area and film": ("fig03", "fig04", "fig05", "fig06", "fig07", "fig08", "transitions"),
    "3 Turning point": (
        *("fig09", "fig10", "fig11", "fig12", "fig13"),
        *("tpca_loads", "tpca_windows"),
    ),
    "4 Statements of the paper": ("claims", "fronts"),
    "5 Inputs that are not printed": ("sensitivity",),
    "6 Solver": ("accuracy",),
    "7 Atlas": ("largest_particle", "least_viscosity"),
}
OWN = "8 Scenes of one's own"
FIGURE_SPACE = "\N{FIGURE SPACE}"  # as wide as a digit, and sorted before all digits


def part_of_report(_wildcards, output) -> str:
    """The part of the report that the files ``output`` of a job belong to.

    Examples
    --------
    >>> part_of_report({}, ["results/figures/fig09.png", "results/figures/fig09.md"])
    '3 Turning point'
    >>> part_of_report({}, ["results/figures/mine.png"])
    "8 Scenes of one's own"
    """
    name = Path(output[0]).stem
    return next((part for part, names in PARTS.items() if name in names), OWN)


def label_in_report(_wildcards, output) -> dict[str, str]:
    """The title of a figure or table: the first words of its caption, ``output.md``, which are bold."""
    caption = Path(output.md).read_text(encoding="utf-8")
    title = caption.removeprefix("**").partition(".**")[0]
    return {"title": re.sub(r"^Figure (\d)\.", rf"Figure {FIGURE_SPACE}\1.", title)}
