"""Captions and alternative texts, as data and as Markdown.

A caption has a title, what each panel shows, the conditions, the marks, and what the paper concludes
from the figure.  The alternative text of a figure of curves is made from the curves drawn.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from string import ascii_uppercase

import numpy as np

from thirdbody.data.conditions import AXES, Condition
from thirdbody.figures import marks
from thirdbody.figures.drawing import CURVE, Panel
from thirdbody.figures.naming import label, note, unit_text, value_text
from thirdbody.figures.scales import SCALES

MARKUP = re.compile(r"[\\`*_<>\[\]|]")  # letters that Markdown takes for markup


@dataclass(frozen=True)
class Caption:
    """What is written below a figure: its title, what to look for or what the paper concludes from it,
    and the text for those who cannot see it; what each panel shows, and sentences on conditions and
    marks."""

    title: str
    text: str = ""
    alternative: str = ""
    panels: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    def markdown(self) -> str:
        """Caption and alternative text, two paragraphs of Markdown or reStructuredText."""
        panels = "; ".join(
            f"({letter}) {text}" for letter, text in zip(ascii_uppercase, self.panels, strict=False)
        )
        title = MARKUP.sub(r"\\\g<0>", " ".join(self.title.split()))
        sentences = [f"**{title}.**", panels and f"{panels}.", *self.notes, self.text]
        caption = " ".join(filter(None, sentences))
        return f"{caption}\n\n**Alternative text.** {self.alternative}\n"


CAPTIONS = {
    "fig01": Caption(
        "Figure 1. A lubricated interface with third particles, true to scale",
        "Surfaces and particles are drawn from the distributions that the model assumes, at the "
        "separation that it finds. Particles that carry load are marked. They may be smaller than the "
        "gap where the elastic zone h_e of Eqs. 4 and 5 is wide.",
        "A cut through two rough surfaces, one above the other, with lubricant and round particles "
        "in the gap; an arrow marks the separation d, two arrows the load.",
    ),
    "fig02": Caption(
        "Figure 2. The three contact modes, true to scale",
        "In the s-s mode (A) summits carry the load, in the p-s mode (B) particles, in the hybrid "
        "mode (C) both. Where the elastic zone h_e of Eqs. 4 and 5 is wide, particles carry load in "
        "gaps that are wider than they are.",
        "Three cuts through two rough surfaces with round particles between them. In A summits touch "
        "and no particle carries load; in B only particles carry it; in C both do.",
    ),
    "claims": Caption(
        "Verdict on each statement of the paper",
        "A shaded line has the statements of one figure that hold; every other statement has a line "
        "of its own. Each marker stands at the deviation of the model in tolerances, linear up to one "
        "and logarithmic beyond; a statement holds up to the vertical line. Diamonds do not hold when "
        "their figure is left out of the search for inputs. Hollow markers: less than three quarters "
        "of the ensemble give the same verdict.",
        "Markers in horizontal lines, grouped by the figure of the paper; the statements beyond one "
        "tolerance are named.",
    ),
    "fronts": Caption(
        "Pareto fronts: what each headline number costs all other statements",
        "Each panel is a headline number of the paper, each line an interpretation of the equations. "
        "A Pareto front joins the best evaluations of the search: for a given deviation from the "
        "number, the least objective of all other statements. Left of the vertical line the number is met. The best possible "
        "front lies on the line or below it.",
        "Panels with falling steps, one line for each interpretation, and a vertical line at one "
        "tolerance.",
    ),
    "sensitivity": Caption(
        "Sensitivity of results to the inputs that the paper does not print",
        "Each column is a result, each row an input. An elasticity is the change of the result in "
        "per cent for one per cent of the input. A total Sobol index is the fraction of the variance "
        "of the result's logarithm in which the input takes part.",
        "Two heat maps, one above the other, with a number in each cell that is not negligible.",
    ),
    "largest_particle": Caption(
        "Largest particles that stay out of the particle-surface mode",
        "Below the curve summits have at least 5 % of the contact area (A_sa,t* = 0.95 on the "
        "curve). Shaded: range of nine in ten members of the ensemble at the same normal "
        "load. Where a curve or its range ends, the limit is beyond the sizes of the atlas.",
        "One panel for each viscosity and particle density: a diameter over the normal load, a "
        "curve with a shaded range for each roughness.",
    ),
    "least_viscosity": Caption(
        "Least viscosity out of boundary lubrication",
        "Above the curve the film carries more than a tenth of the load (L_s = 0.90 on the curve). "
        "Shaded: range of nine in ten members of the ensemble at the same normal load. "
        "Where a curve or its range ends, the limit is beyond the viscosities of the atlas.",
        "One panel for each particle diameter and density: a viscosity over the normal load, a "
        "curve with a shaded range for each roughness.",
    ),
    "accuracy": Caption(
        "Errors of the solver against computing time",
        "Lower left is better. Lines join the relative errors asked for.",
        "Two scatter plots with logarithmic axes: usual points and extremes.",
    ),
}


# what the paper concludes from its figures of curves; their titles are those of the scenes
CONCLUSIONS = {
    "fig03": "as the load grows, contact with particles larger than 300 nm passes from the p-s through "
    "the hybrid to the s-s mode, and its area rises to that of two-body contact, which is the "
    "largest.",
    "fig04": "below 50 cSt a lubricant changes little; above 70 cSt it carries more of the load as the "
    "load grows, and the slope of the contact area drops where that begins.",
    "fig05": "on the smoother surface a thin lubricant is enough for mixed lubrication; on the rougher "
    "one more than 70 cSt is needed.",
    "fig06": "the larger the particles, the smaller the dry contact area; with a film between the "
    "surfaces the order is reversed at high loads.",
    "fig07": "more particles make the contact area smaller, but larger at high loads once the "
    "lubrication is mixed.",
    "fig08": "in the p-s mode the contact area grows with the roughness, near the s-s mode it falls; "
    "on the roughest surface the area ratio of particles rises and then falls, which is the "
    "turning point of the contact area.",
    "fig09": "particles of about 250 to 400 nm have a turning point; larger ones enter the p-s mode at "
    "low loads.",
    "fig10": "turning points occur at about the same ratios of diameter to roughness on either "
    "surface, at loads that fall with that ratio.",
    "fig11": "viscosity shifts the turning point to higher loads once the lubrication is mixed, but "
    "not its height; over the film thickness all curves coincide.",
    "fig12": "on the smoother surface there is no turning point from 50 cSt on, as the film carries "
    "the whole load; on the rougher one viscosity changes nothing.",
    "fig13": "on the smoothest surface the density hardly changes the load of the turning point; the "
    "rougher the surface, the more it rises with the density.",
}


def caption(name: str, panels: Sequence[Panel] = (), title: str = "") -> Caption:
    """Caption of a figure: one of ``CAPTIONS``, or of a scene with this ``title`` and ``panels``."""
    if name in CAPTIONS:
        return CAPTIONS[name]
    if name in CONCLUSIONS:
        title = f"Figure {int(name.removeprefix('fig'))}. {title}"
    return Caption(
        title,
        f"The paper: {CONCLUSIONS[name]}" if name in CONCLUSIONS else "",
        alternative=" ".join(map(_description, panels)),
        panels=tuple(map(_content, panels)),
        notes=tuple(_notes(panels)),
    )


def _content(panel) -> str:
    """The quantities of a panel, and the conditions that its title names."""
    own = f" at {panel.title}" if panel.title != SCALES[panel.y].title else ""
    over = "" if panel.x == "load" else f" over the {_quantity(panel.x)}"
    return f"{_quantity(panel.y)}{own}{over}"


def _quantity(name) -> str:
    title = SCALES[name].title
    return title[0].lower() + title[1:]


def _notes(panels) -> list[str]:
    """Sentences on the axis of loads, the conditions, and what marks and lines mean."""
    conditions = {curve.condition for panel in panels for curve in panel.of_kind(CURVE)}
    kinds = {series.kind for panel in panels for series in panel.series}
    sentences = ["Normal load: dimensionless below, in newtons above.", _conditions(conditions)]
    sentences += [sentence for kind, sentence in MEANINGS.items() if kind in kinds]
    if len({condition.is_dry for condition in conditions}) > 1:
        sentences.append("Dashed and dotted curves: dry contact.")
    return sentences


def _conditions(conditions) -> str:
    """The values of the four conditions that the curves take."""
    parts = []
    for name in Condition._fields:
        values = sorted({getattr(condition, name) for condition in conditions})
        if len(values) == 1:
            parts.append(note(name, values[0]))
            continue
        zero = {"viscosity": "dry and ", "roughness": ""}.get(name, "two-body and ")
        listed = ", ".join(value_text(name, value) for value in values if value)
        start = "" if all(values) else zero
        parts.append(f"{start}{AXES[name].sign} = {listed} {unit_text(name)}")
    return f"Conditions: {'; '.join(parts)}."


MEANINGS = {
    marks.TURNING_POINTS: "Stars: turning points of the contact area.",
    marks.LOCUS: "Heavy dashes join the turning points.",
    marks.WINDOW: "Blue vertical lines: limits of the range with turning points.",
    marks.PRINTED: "Open squares and black vertical lines: numbers that the paper prints; bars and "
    "grey areas: their tolerances.",
    marks.BAND: "Shaded: ensemble range.",
} | {kind: f"Crosses: {text}." for kind, (text, _) in marks.STATUS_MARKS.items()}


def _description(panel) -> str:
    """Alternative text of a panel: its curves with their ends, and how many marks it has."""
    curves = panel.of_kind(CURVE)
    parts = []
    if curves:
        y = np.concatenate([curve.y for curve in curves])
        parts.append(f"{len(curves)} curves of {_quantity(panel.y)} {_range(y)}")
        taken = zip(*(curve.condition for curve in curves), strict=True)
        varying = [name for name, values in zip(Condition._fields, taken) if len({*values}) > 1]
        for curve in dict.fromkeys((curves[0], curves[-1])):
            own = ", ".join(note(name, getattr(curve.condition, name)) for name in varying)
            ends = f"{curve.y[0]:.2g} to {curve.y[-1]:.2g}"
            parts.append(f"the curve at {own or label(curve.condition)} runs from {ends}")
    for kind, (text, _) in marks.MARKS.items():
        places = [series.x for series in panel.of_kind(kind)]
        if places and kind != marks.LOCUS:
            x = np.concatenate(places)
            parts.append(f"{text}: {x.size}, {_quantity(panel.x)} {_range(x)}")
    return f"Panel {panel.letter}: {'; '.join(parts)}."


def _range(values) -> str:
    low, high = np.nanmin(values), np.nanmax(values)
    return f"of {low:.2g}" if low == high else f"between {low:.2g} and {high:.2g}"
