"""The figures of curves in the paper, and the content of their panels.

A figure is a row here; the conditions of its curves have the same name in ``config/scenes.yaml``.
Other scenes need no row.  Figures 1 and 2 are in ``schematics``.
"""

from __future__ import annotations

from dataclasses import replace

from thirdbody.data.conditions import Condition
from thirdbody.data.netcdf import PlainDataset
from thirdbody.figures.curves import Content, CurveFigure, curves_in
from thirdbody.figures.marks import RELATIVE_AREA

RATIO = Content("particle_contact_area_ratio")  # A_sa,t*
AREA = Content("total_contact_area")  # A_t*
SOLID = Content("solid_load_fraction")  # L_s
FILM = Content("film_thickness")  # H_c
RELATIVE = Content(RELATIVE_AREA)  # A_t* relative to dry two-body contact
WINDOW = Content("turning_point_ratio", x="diameter_ratio")
SMOOTHEST, ROUGHEST = 0, -1

CURVE_FIGURES = {
    # dry: from the p-s over the hybrid to the s-s mode
    "fig03": CurveFigure("particle_diameter", (RATIO, AREA, RELATIVE)),
    # lubricants, with dry and two-body contact; then on two surfaces
    "fig04": CurveFigure("viscosity", (RATIO, AREA, SOLID, FILM)),
    "fig05": CurveFigure("viscosity", (SOLID,), each_surface=True),
    # lubricated and dry contact
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
    # how lubricants shift it: over the load and over the film; on two surfaces
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
    # and with other particle densities
    "fig13": CurveFigure("particle_density", (RATIO,), each_surface=True),
}


def curve_figure(name: str, data: PlainDataset) -> CurveFigure:
    """The definition of a figure of curves: a row of the registry or, for any other scene in
    ``data``, areas over the load on each surface, also load fractions and film unless all curves
    are dry, with curves that differ in one condition, in addition to dry and lubricated contact.

    ``ValueError`` if more conditions vary than one figure can distinguish.
    """
    if name in CURVE_FIGURES:
        return CURVE_FIGURES[name]
    conditions = [curve.condition for curve in curves_in(data)]
    levels = {axis: {getattr(each, axis) for each in conditions} for axis in Condition._fields}
    absent = {"viscosity": set(), "particle_diameter": {0.0}, "particle_density": {0.0}}
    varying = [axis for axis, none in absent.items() if len(levels[axis] - none) > 1]
    if len(varying) > 1 and len(levels["viscosity"]) == 2 and 0.0 in levels["viscosity"]:
        varying.remove("viscosity")
    if len(varying) > 1:
        raise ValueError(
            f"{name}: {' and '.join(varying)} vary; allowed: one of them beside dry and lubricated "
            "contact, and any number of roughnesses"
        )
    contents = (RATIO, AREA) if levels["viscosity"] == {0.0} else (RATIO, AREA, SOLID, FILM)
    surfaces = len(levels["roughness"])
    if not varying and surfaces > 1:
        return CurveFigure("roughness", contents)
    return CurveFigure(*varying or ["viscosity"], contents, surfaces > 1)
