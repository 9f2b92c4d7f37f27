"""Styles of curves: colours, dashes and markers that also differ in grey."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib
import numpy as np
from matplotlib import rcParams
from matplotlib.colors import to_rgb

from thirdbody.data.conditions import Condition
from thirdbody.figures.scales import value_text

MARKERS = "osD^vPX"  # every second one is hollow, so that neighbouring levels differ
DARKEST, LIGHTEST = 0.05, 0.87  # of the colour map: black is two-body contact, white is paper
GREY = "0.5"
BLUE = "#0072B2"  # of a single curve of an interface, or of the model
MARKERS_PER_CURVE = 5
# Dry curves are drawn over the lubricated ones, which are visible between the dashes.
DRY = {"linestyle": (0, (2.4, 1.8)), "linewidth": 1.7, "zorder": 2.3}
DRY_TWO_BODY = {"linestyle": (0, (1.0, 1.3)), "linewidth": 1.7, "zorder": 2.2, "color": GREY}
TINT = 0.13  # of the colour in a range, the rest is white


def level_styles(count: int, size: int = 1) -> list[dict]:
    """Line properties of curves of ``size`` points at ``count`` ordered levels: colours become
    lighter, and each has its own marker, at other points than the next one."""
    colours = matplotlib.colormaps[rcParams["image.cmap"]](np.linspace(DARKEST, LIGHTEST, count))
    step = max(size // MARKERS_PER_CURVE, 1)
    return [
        {"color": colour, "marker": MARKERS[index % len(MARKERS)], "linestyle": "-"}
        | {"markerfacecolor": "white" if index % 2 else colour, "markeredgecolor": colour}
        | {"markevery": (int(step * (index + 0.5) / count), step)}
        for index, colour in enumerate(map(tuple, colours.tolist()))
    ]


def band_style(colour) -> dict:
    """Properties of the area of a range: opaque with an edge, because several may overlap."""
    tint = 1.0 - TINT * (1.0 - np.array(to_rgb(colour)))
    return {"facecolor": tint, "edgecolor": (colour, 0.6), "linewidth": 0.5, "zorder": 1.5}


def curve_styles(
    curves: Sequence[Condition], parameter: str, size: int
) -> dict[Condition | str, dict]:
    """Line properties of ``curves`` of ``size`` points that differ in one ``parameter``, labelled by
    its level, and of dry and lubricated contact if they are compared.

    Two-body contact is black or grey.  With lubricated contact, dry contact is dashed, or dotted
    without particles, and has no markers.
    """
    media = {each.viscosity for each in curves}
    compares_media = parameter != "viscosity" and len({each.is_dry for each in curves}) == 2
    levels = sorted({getattr(each, parameter) for each in curves} - {0.0})
    looks = dict(zip(levels, level_styles(len(levels), size), strict=True))
    looks[0.0] = {"color": "black"}
    styles = {}
    for each in curves:
        look = looks[getattr(each, parameter)]
        if each.is_dry and parameter == "viscosity" and each.is_two_body:
            look = DRY_TWO_BODY
        elif each.is_dry and any(media):
            look = look | DRY | {"marker": "none"}
        if not (compares_media and each.is_dry):
            look = look | {"label": _level_text(each, parameter)}
        styles[each] = look
    for viscosity in sorted(media, reverse=True) if compares_media else ():
        text = f"{value_text('viscosity', viscosity)} cSt" if viscosity else "dry"
        styles[text] = ({} if viscosity else DRY) | {"color": GREY, "label": text}
    return styles


def _level_text(condition, parameter):
    level = getattr(condition, parameter)
    if level:
        return value_text(parameter, level)
    if parameter == "viscosity":
        return "dry, two-body" if condition.is_two_body else "dry"
    return "none (two-body)"
