"""What each figure is called and what it is to be read for, and what it shows for those who cannot.

A caption is a few plain sentences: title, panels, conditions, marks, what the paper reads from it.
The alternative text tells what is drawn, from what is drawn.  Both are written beside the figure, in
words that are Markdown and reStructuredText alike.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from thirdbody.data.conditions import AXES, Condition
from thirdbody.figures.marks import MARKS, STATUS_MARKS
from thirdbody.figures.sheet.naming import SUPERSCRIPTS, note, value_text
from thirdbody.figures.sheet.panel import NamedOutlines, NamedPoints, Panel
from thirdbody.figures.sheet.scales import SCALES
from thirdbody.figures.shown import shown_curves

if TYPE_CHECKING:  # figures without a dataset do without
    import xarray as xr


@dataclass(frozen=True)
class Caption:
    """What stands below a figure.

    Attributes
    ----------
    title : str
        What it shows.
    reading : str
        What to look for; of a figure of the paper, what the paper reads from it.
    seen : str
        Alternative text; empty where it is told from the curves that are drawn.
    """

    title: str
    reading: str
    seen: str = ""


CAPTIONS = {
    "fig01": Caption(
        "Figure 1. A lubricated interface with third particles, true to scale",
        "Surfaces and particles are drawn from the distributions that the model assumes, at the "
        "separation that it finds. Particles that the model lets bear load are marked: where the "
        "elastic zone h_e of Eqs. 4 and 5 is wide, the gap may be wider than they are.",
        "A cut through two rough surfaces, one above the other, with lubricant and round particles "
        "in the gap; an arrow marks the separation d, two arrows the load.",
    ),
    "fig02": Caption(
        "Figure 2. The three contact modes, true to scale",
        "In the s-s mode (A) summits bear the load, in the p-s mode (B) particles, in the hybrid "
        "mode (C) both. Where the elastic zone h_e of Eqs. 4 and 5 is wide, particles bear load in "
        "gaps that are wider than they are.",
        "Three cuts through two rough surfaces with round particles between them. In A summits touch "
        "and no particle bears load; in B particles alone bear it; in C both summits and particles do.",
    ),
    "fig03": Caption(
        "Figure 3. Contact modes in dry contact with particles of various diameters",
        "The paper: as the load grows, contact with particles larger than 300 nm passes from the "
        "p-s over the hybrid to the s-s mode, and its area climbs to that of two bodies, which is "
        "the largest.",
    ),
    "fig04": Caption(
        "Figure 4. Contact with lubricants of various viscosities",
        "The paper: below 50 cSt a lubricant changes little; above 70 cSt it takes over load from "
        "the solid as the load grows, and the slope of the contact area drops where that begins.",
    ),
    "fig05": Caption(
        "Figure 5. Load percentage of solid on a smoother and a rougher surface",
        "The paper: on the smoother surface a thin lubricant is enough for mixed lubrication; on "
        "the rougher one more than 70 cSt is needed.",
    ),
    "fig06": Caption(
        "Figure 6. Lubricated beside dry contact with particles of various diameters",
        "The paper: the larger the particles, the smaller the dry contact area; with a film between "
        "the surfaces the order is reversed at high loads.",
    ),
    "fig07": Caption(
        "Figure 7. Lubricated beside dry contact with various particle densities",
        "The paper: more particles make the contact area smaller, but larger at high loads once the "
        "lubrication is mixed.",
    ),
    "fig08": Caption(
        "Figure 8. Lubricated beside dry contact on surfaces of various roughness",
        "The paper: in the p-s mode the contact area grows with the roughness, near the s-s mode it "
        "falls; on the roughest surface the particles' share rises and then falls, which is the "
        "turning point of the contact area.",
    ),
    "fig09": Caption(
        "Figure 9. Turning point of the contact area in dry contact",
        "The paper: particles of about 250 to 400 nm have a turning point; larger ones enter the "
        "p-s mode at low loads.",
    ),
    "fig10": Caption(
        "Figure 10. Turning point of the contact area on a smoother and a rougher surface",
        "The paper: turning points occur at about the same ratios of diameter to roughness on "
        "either surface, at loads that fall with that ratio.",
    ),
    "fig11": Caption(
        "Figure 11. Turning point of the contact area with lubricants of various viscosities",
        "The paper: viscosity shifts the turning point to higher loads once the lubrication is "
        "mixed, but not its height; over the film thickness all curves are one.",
    ),
    "fig12": Caption(
        "Figure 12. Turning point on a smoother and a rougher surface with lubricants",
        "The paper: on the smoother surface no turning point is left from 50 cSt on, as the film "
        "bears all of the load; on the rougher one viscosity changes nothing.",
    ),
    "fig13": Caption(
        "Figure 13. Turning point of the contact area with various particle densities",
        "The paper: on the smoothest surface the density hardly changes the load of the turning "
        "point; the rougher the surface, the more it rises with the density.",
    ),
    "claims": Caption(
        "The verdict on each statement of the paper",
        "A line is a statement: its length is how far the model is off, counted in tolerances up to "
        "one and logarithmically beyond; up to the vertical line the statement holds.",
        "Two columns of horizontal lines that end in markers, grouped by the figure of the paper; "
        "the statements beyond the line of one tolerance are named.",
    ),
    "fronts": Caption(
        "What it costs the other statements that one of them holds",
        "A panel is a chief statement, then one of the validation, which searches do not minimise; a line "
        "is a reading of the equations. To the left of the vertical line the statement holds; the lower a "
        "line is there, the better all others are explained together with it. Each line joins the best "
        "that any evaluation of the searches has found, so that what is really possible lies on it or "
        "below.",
        "Panels with falling steps, one line a reading, and a vertical line at one tolerance.",
    ),
    "sensitivity": Caption(
        "How results respond to the inputs that the paper does not print",
        "A result is a column, an input a row. Elasticities tell by how many percent the result "
        "changes with one percent of the input; total Sobol indices which share of its variance the "
        "input has a part in.",
        "Two heat maps, one above the other, with a number in each cell that counts.",
    ),
    "largest_particle": Caption(
        "The largest particles that stay out of the particle-surface mode",
        "Smaller particles than the curve leave at least 5 % of the contact area to the summits "
        "(A_sa,t* = 0.95 on the curve). Shaded: between which values nine in ten members of the "
        "calibrated ensemble lie, at the same normal load; where a curve or its shade ends, the limit "
        "is beyond the sizes of the atlas.",
        "A panel for each viscosity and particle density: a diameter over the normal load, a curve with "
        "a shade around it for each roughness.",
    ),
    "least_viscosity": Caption(
        "The least viscosity that leaves boundary lubrication",
        "With a thicker oil than the curve the film bears more than a tenth of the load (L_s = 0.90 on "
        "the curve). Shaded: between which values nine in ten members of the calibrated ensemble lie, "
        "at the same normal load; where a curve or its shade ends, the limit is beyond the viscosities "
        "of the atlas.",
        "A panel for each particle diameter and density: a viscosity over the normal load, a curve with "
        "a shade around it for each roughness.",
    ),
    "accuracy": Caption(
        "Errors of the solver against the time that it takes",
        "Down and to the left is better. Lines join the relative errors that can be asked for.",
        "Two scatter plots with logarithmic axes, of usual points and of extremes.",
    ),
}


def caption_text(name: str, figure: Figure, data: xr.Dataset | None = None) -> str:
    """Caption and alternative text of a figure.

    Parameters
    ----------
    name : str
        One of ``CAPTIONS``, or that of a scene of one's own, whose dataset has a title.
    figure : Figure
        The figure as it is drawn.
    data : xarray.Dataset, optional
        Of a figure of curves, their dataset.

    Returns
    -------
    str
        Two paragraphs.
    """
    caption = (
        CAPTIONS[name] if data is None else CAPTIONS.get(name, Caption(data.attrs["title"], ""))
    )
    told = [f"**{caption.title}.**"]
    if data is not None:
        told += [_panels(figure), _conditions(data), *_marks(figure)]
    told += [caption.reading] * bool(caption.reading)
    seen = caption.seen or " ".join(_seen(panel) for panel in figure.axes)
    return f"{' '.join(told)}\n\n**Alternative text.** {seen}\n"


def _panels(figure) -> str:
    """What stands on the axes of each panel."""
    parts = []
    for panel in figure.axes:
        own = f" at {panel.heading}" if panel.heading != SCALES[panel.y_name].title else ""
        over = "" if panel.x_name == "load" else f" over {_named(panel.x_name)}"
        parts.append(f"({panel.letter}) {_named(panel.y_name)}{own}{over}")
    loads = "; over the dimensionless normal load, in newtons at the upper edge"
    return "; ".join(parts) + loads + "."


def _named(name) -> str:
    title = SCALES[name].title
    return title[0].lower() + title[1:]


def _conditions(data) -> str:
    """The values of the four conditions that the curves take."""
    parts = []
    conditions = [curve.condition for curve in shown_curves(data)]
    for name in Condition._fields:
        values = sorted({getattr(condition, name) for condition in conditions})
        known = [value for value in values if value]
        if len(values) == 1:
            parts.append(note(name, values[0]))
            continue
        none = {"viscosity": "dry", "roughness": ""}.get(name, "two-body")
        listed = ", ".join(value_text(name, value) for value in known)
        unit = AXES[name].unit.translate(SUPERSCRIPTS)
        zero = f"{none} and " * (len(known) < len(values))
        parts.append(f"{zero}{AXES[name].sign} = {listed} {unit}")
    return f"Conditions: {'; '.join(parts)}."


def _marks(figure) -> list[str]:
    """What the marks and lines mean that the figure shows."""
    lines = [line for panel in figure.axes for line in panel.lines]
    labels = {line.get_label() for line in lines}
    told = [sentence for label, sentence in MEANINGS.items() if label in labels]
    curves = [line for panel in figure.axes for line in _curves(panel)]
    if len({line.get_linestyle() for line in curves}) > 1:
        told.append("Dashed and dotted curves: dry contact.")
    if any(isinstance(each, NamedOutlines) for panel in figure.axes for each in panel.collections):
        told.append("Shaded: between which values the calibrated ensemble lies.")
    return told


MEANINGS = {
    "turning points": "Stars: turning points of the contact area.",
    "locus of the turning points": "Heavy dashes join the turning points.",
    "window": "Diamonds: the ends of the range in which there are turning points, at no height of their own.",
    "printed": "Open squares: numbers that the paper prints, with bars as long as their tolerances.",
} | {label: f"Crosses: {text}." for label, (text, _) in STATUS_MARKS.items()}


def _curves(panel) -> list:
    """The lines of ``panel`` that are curves, and not marks upon them."""
    return [
        line
        for line in panel.lines
        if not isinstance(line, NamedPoints)
        and not line.get_label().startswith("_")
        and line.get_label() not in MARKS
    ]


# of marks: what one and what more stand for
COUNTED = {
    "turning points": ("turning point", "turning points"),
    "window": ("end of the range with turning points", "ends of the range with turning points"),
    "printed": ("printed number with its tolerance", "printed numbers with their tolerances"),
} | {
    label: (f"point with {text}", f"points with {text}")
    for label, (text, _) in STATUS_MARKS.items()
}


def _seen(panel: Panel) -> str:
    """What can be seen in a panel: its curves with their ends, and how many marks there are."""
    curves = _curves(panel)
    parts = []
    if curves:
        y = np.concatenate([line.get_ydata() for line in curves])
        parts.append(f"{len(curves)} curves of {_named(panel.y_name)} {_range(y)}")
        labels = [set(line.get_label().split("; ")) for line in curves]
        common = set.intersection(*labels)
        for line in dict.fromkeys((curves[0], curves[-1])):
            own = [part for part in line.get_label().split("; ") if part not in common]
            ends = [f"{line.get_ydata()[place]:.2g}" for place in (0, -1)]
            parts.append(f"that of {', '.join(own) or 'all'} runs from {ends[0]} to {ends[1]}")
    for label, (one, more) in COUNTED.items():
        lines = [line for line in panel.lines if line.get_label() == label]
        if lines:
            x = np.concatenate([line.get_xdata() for line in lines])
            parts.append(
                f"{x.size} {one if x.size == 1 else more}, {_named(panel.x_name)} {_range(x)}"
            )
    return f"Panel {panel.letter}: {'; '.join(parts)}."


def _range(values) -> str:
    low, high = np.nanmin(values), np.nanmax(values)
    return f"of {low:.2g}" if low == high else f"between {low:.2g} and {high:.2g}"
