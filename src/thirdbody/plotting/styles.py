"""How curves are drawn: colours and markers of levels, dry contact black and dashed."""

from collections.abc import Mapping, Sequence
from typing import Any

import matplotlib
import numpy as np
from matplotlib import rcParams

from thirdbody.curves import Condition
from thirdbody.plotting.scales import unit_text, value_text

Look = Mapping[str, Any]  # properties of a line

# every second marker is hollow, so that neighbouring levels differ; diamonds are printed values
MARKERS = "os^vPX>"
MARKERS_PER_CURVE = 5
# of the colour map: two-body contact is darker, lighter is faint on white paper
DARKEST, LIGHTEST = 0.05, 0.59
BLUE = "#0072B2"  # of a single curve of an interface, or of the model
# Dry curves are dashes on the lubricated ones, which then are seen below them; black differs from
# all colours of levels, whatever colours a reader sees.
DRY = {"color": "black", "linestyle": (0, (4.0, 2.5)), "linewidth": 1.0, "zorder": 2.6}
DRY_TWO_BODY = {"color": "black", "linestyle": (0, (1.0, 1.6)), "linewidth": 1.6, "zorder": 2.6}
TWO_BODY = "none (two-body)"  # label of a level
DRY_TWO_BODY_TEXT = "two-body (dry)"
HAIRLINE = {"linewidth": 0.4, "marker": "None"}  # of levels between the strong ones


def level_styles(count: int, size: int = 1) -> list[dict[str, Any]]:
    """Line properties of curves of ``size`` points at ``count`` ordered levels.  Colours become
    lighter; neighbours have different markers, at different points."""
    step = max(size // MARKERS_PER_CURVE, 1)
    return [
        {"color": colour, "linestyle": "-"}
        | _marker(colour, index)
        | {"markevery": (int(step * (index + 0.5) / count), step)}
        for index, colour in enumerate(_colours(count))
    ]


def _colours(count) -> list[tuple[float, ...]]:
    ramp = matplotlib.colormaps[rcParams["image.cmap"]]
    return [*map(tuple, ramp(np.linspace(DARKEST, LIGHTEST, count)).tolist())]


def _marker(colour, index) -> dict[str, Any]:
    face = "white" if index % 2 else colour
    marker = MARKERS[index % len(MARKERS)]
    return {"marker": marker, "markerfacecolor": face, "markeredgecolor": colour}


def curve_styles(
    curves: Sequence[Condition],
    parameter: str,
    size: int,
    strong: Sequence[float] = (),
    hairlines: bool = True,
) -> tuple[dict[Condition, dict[str, Any]], list[list[Look]]]:
    """Line properties of ``curves`` of ``size`` points that differ in one ``parameter``, labelled
    by its level, and the entries of the key, grouped.

    Two-body contact is black; with lubricated contact, dry contact is black and dashed, or dotted
    without particles.  If some levels are ``strong``, the others are hairlines with one entry, or
    without ``hairlines`` have no look.
    """
    media = {each.viscosity for each in curves}
    compares_media = parameter != "viscosity" and len({each.is_dry for each in curves}) == 2
    levels = sorted({getattr(each, parameter) for each in curves} - {0.0})
    weak = [level for level in levels if strong and not np.isclose(level, strong, rtol=1e-9).any()]
    marked = [level for level in levels if level not in weak]
    looks = dict(zip(marked, level_styles(len(marked), size), strict=True))
    for level, colour in zip(levels, _colours(len(levels)), strict=True):
        if level in weak:
            looks[level] = HAIRLINE | {"color": colour, "linestyle": "-"}
        else:
            looks[level] |= {"color": colour} | _marker(colour, marked.index(level))
    looks[0.0] = {"color": "black"}
    styles = {}
    for each in curves:
        level = getattr(each, parameter)
        if level in weak and not hairlines:
            continue
        look = looks[level] | {"label": _level_text(each, parameter)}
        if level in weak:
            look["label"] = f"_{look['label']}"  # one entry for all
        if each.is_dry and parameter == "viscosity" and each.is_two_body:
            look = DRY_TWO_BODY | {"label": look["label"]}
        elif each.is_dry and (compares_media or (parameter == "viscosity" and any(media))):
            hidden = "_" if compares_media else ""  # written at the curve, but not in the key
            thin = HAIRLINE if level in weak else {}
            look = DRY | thin | {"label": hidden + look["label"].lstrip("_")}
        styles[each] = look
    by_label = {look["label"]: look for look in styles.values()}
    # of entries for several levels: to some readers a grey would be that of the last one
    _, neutral, _ = _colours(3)
    entries = [look for label, look in by_label.items() if not label.startswith("_")]
    if weak and hairlines:
        text = ", ".join(value_text(parameter, level) for level in weak)
        entries.append({"color": neutral, "linewidth": 0.6, "label": text})
    key: list[list[Look]] = [entries]
    if compares_media:
        wet = {"color": neutral, "linestyle": "-"}
        unit = unit_text("viscosity")
        texts = {v: f"{value_text('viscosity', v)} {unit}" if v else "dry" for v in sorted(media)}
        key.append([(wet if v else DRY) | {"label": text} for v, text in texts.items()])
    return styles, key


def _level_text(condition, parameter):
    level = getattr(condition, parameter)
    if level:
        return value_text(parameter, level)
    if parameter == "viscosity":
        return DRY_TWO_BODY_TEXT if condition.is_two_body else "dry"
    return TWO_BODY
