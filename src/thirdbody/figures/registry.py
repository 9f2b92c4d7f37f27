"""The figures of the paper, and what each panel of theirs shows.

A figure of curves is a row here; what its curves are computed for stands under the same name in
``config/scenes.yaml``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from matplotlib.figure import Figure

from thirdbody.data.schematic import Section
from thirdbody.figures import schematics
from thirdbody.figures.curves import Content, CurveFigure
from thirdbody.figures.shown import AREA_OVER_TWO_BODY

RATIO = Content("particle_contact_area_ratio")  # A_sa,t*
AREA = Content("total_contact_area")  # A_t*
SOLID = Content("solid_load_fraction")  # L_s
FILM = Content("film_thickness")  # H_c
RELATIVE = Content(AREA_OVER_TWO_BODY)  # A_t* over that of dry two-body contact
WINDOW = Content("turning_point_ratio", x="diameter_ratio")
SMOOTHEST, ROUGHEST = 0, -1

SCHEMATICS: dict[str, Callable[[Sequence[Section]], Figure]] = {
    "fig01": schematics.plot_interface,
    "fig02": schematics.plot_modes,
}
CURVE_FIGURES = {
    # dry: from the p-s over the hybrid to the s-s mode
    "fig03": CurveFigure("particle_diameter", (RATIO, AREA, RELATIVE)),
    # lubricants, beside dry and two-body contact; then on two surfaces
    "fig04": CurveFigure("viscosity", (RATIO, AREA, SOLID, FILM)),
    "fig05": CurveFigure("viscosity", (SOLID,), each_surface=True),
    # lubricated beside dry contact
    "fig06": CurveFigure("particle_diameter", (AREA, SOLID, RATIO, RELATIVE)),
    "fig07": CurveFigure("particle_density", (AREA, SOLID, RATIO, RELATIVE)),
    "fig08": CurveFigure("roughness", (AREA, SOLID, RATIO, RELATIVE), two_body=False),
    # dry: where the turning point occurs
    "fig09": CurveFigure(
        "particle_diameter",
        (RATIO, replace(AREA, locus=True), replace(RELATIVE, locus=True), WINDOW),
        two_body=False,
    ),
    "fig10": CurveFigure("diameter_ratio", (RATIO, WINDOW), each_surface=True),
    # where lubricants shift it: over the load and over the film; on two surfaces
    "fig11": CurveFigure(
        "viscosity", (RATIO, SOLID, Content("particle_contact_area_ratio", x="film_thickness"))
    ),
    "fig12": CurveFigure(
        "viscosity",
        (
            Content("particle_contact_area_ratio", surface=SMOOTHEST),
            Content("solid_load_fraction", surface=SMOOTHEST),
            Content("particle_contact_area_ratio", surface=ROUGHEST),
        ),
    ),
    # and with other numbers of particles
    "fig13": CurveFigure("particle_density", (RATIO,), each_surface=True),
}


def curve_figure(name: str) -> CurveFigure:
    """The row of a figure of curves.

    Raises
    ------
    ValueError
        If it has none.
    """
    if name not in CURVE_FIGURES:
        allowed = ", ".join(CURVE_FIGURES)
        raise ValueError(f"{name} has no row in {__name__}; allowed: {allowed}")
    return CURVE_FIGURES[name]
