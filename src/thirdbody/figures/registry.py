"""The figures of curves: those of the paper, from ``registry.toml``, and those of other scenes.

Figures 1 and 2 are in ``schematics``.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

from thirdbody.data.conditions import Condition
from thirdbody.data.plain import PlainDataset
from thirdbody.figures.curves import Content, CurveFigure, curves_in

DRY = ("particle_contact_area_ratio", "total_contact_area")
LUBRICATED = (*DRY, "solid_load_fraction", "film_thickness")

CURVE_FIGURES = {
    name: CurveFigure(**row | {"contents": tuple(Content(**each) for each in row["contents"])})
    for name, row in tomllib.loads(
        Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
    ).items()
}


def curve_figure(name: str, data: PlainDataset) -> CurveFigure:
    """The figure ``name`` of the paper or, for any other scene in ``data``, areas over the load on each
    surface, also load fractions and film unless all curves are dry.

    ``ValueError`` if more conditions vary than one figure can distinguish: one, beside dry and
    lubricated contact.
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
    contents = tuple(map(Content, DRY if levels["viscosity"] == {0.0} else LUBRICATED))
    surfaces = len(levels["roughness"])
    if not varying and surfaces > 1:
        return CurveFigure("roughness", contents)
    return CurveFigure(*varying or ["viscosity"], contents, surfaces > 1)
