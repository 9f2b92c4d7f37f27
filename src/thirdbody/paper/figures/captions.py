"""Captions and alternative texts, from ``captions.toml`` and from the panels of a figure."""

import re
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import NamedTuple

import numpy as np

from thirdbody.curves import Condition
from thirdbody.plotting import marks
from thirdbody.plotting.panels import CURVE, Panel
from thirdbody.plotting.scales import (
    SCALES,
    axis_text,
    label,
    note,
    quantity,
    unit_text,
    value_text,
)
from thirdbody.toml_tables import toml_beside
from thirdbody.variables import AXES

WORDS = toml_beside(__file__)
ZONES = WORDS.pop("zones")
MARKUP = re.compile(r"[\\`*_<>\[\]|]")  # characters with a meaning in Markdown
ESCAPED = re.compile(rf"\\({MARKUP.pattern})")
MEANINGS = WORDS.pop("marks") | {
    status: f"Crosses: {status.replace('_', ' ')}." for status in marks.STATUSES
}


class Caption(NamedTuple):
    """The title of a figure, a text on all that it shows, and a text in place of it."""

    title: str
    text: str
    alternative: str

    def markdown(self) -> str:
        """Two paragraphs of Markdown or reStructuredText."""
        title = MARKUP.sub(r"\\\g<0>", self.title)
        return f"**{title}.** {self.text}\n\n**Alternative text.** {self.alternative}\n"


def read_caption(path: str | PathLike) -> Caption:
    """The caption in a file that ``Caption.markdown`` made."""
    first, _, alternative = Path(path).read_text(encoding="utf-8").partition("\n\n")
    title, _, text = first.removeprefix("**").partition(".** ")
    return Caption(
        title=ESCAPED.sub(r"\1", title),
        text=text,
        alternative=alternative.removeprefix("**Alternative text.** ").rstrip("\n"),
    )


def caption(
    name: str, panels: Sequence[Panel] = (), title: str = "", notes: Sequence[str] = ()
) -> Caption:
    """The caption of a figure; that of a figure of curves follows from the ``title`` of its scene and
    from its ``panels``.  ``notes`` are further sentences on what is shown."""
    words = WORDS.get(name, {})
    if "title" not in words:
        number = f"Figure {int(name.removeprefix('fig'))}. " if words else ""
        described = " ".join(map(_description, panels))
        words = {"title": number + title, "text": "", "alternative": described} | words
        notes = [*_notes(panels), *notes]
    return Caption(
        title=" ".join(words["title"].split()),
        text=" ".join(filter(None, [*notes, words["text"]])),
        alternative=words["alternative"],
    )


def _notes(panels) -> list[str]:
    """Sentences on the panels, the load axis, the conditions, and the meaning of marks and lines."""
    conditions = {curve.curve for panel in panels for curve in panel.of_kind(CURVE)}
    labels = {series.look.get("label") for panel in panels for series in panel.series}
    named = {kind for kind, look in marks.LOOKS.items() if look.get("label", "") in labels}
    contents = []
    for panel in panels:
        own = [panel.conditions] if panel.conditions else []
        viscosities = {curve.curve.viscosity for curve in panel.of_kind(CURVE)}
        if 1 < len(viscosities) < len({condition.viscosity for condition in conditions}):
            own.append(_levels("viscosity", viscosities))
        own = f" at {', '.join(own)}" if own else ""
        over = "" if panel.x == "load" else f" over the {quantity(panel.x)}"
        letter = f"({panel.letter}) " if len(panels) > 1 else ""
        contents.append(f"{letter}{quantity(panel.y)}{own}{over}")
    sentences = ["; ".join(contents) + "."]
    sentences += ["Normal load: dimensionless below, in newtons above.", _conditions(conditions)]
    sentences += [sentence for kind, sentence in MEANINGS.items() if kind in named]
    if len({condition.is_dry for condition in conditions}) > 1:
        sentences.append("Broad grey curves: dry contact.")
    sentences += [
        ZONES[zones] for zones in dict.fromkeys(SCALES[panel.y].zones for panel in panels) if zones
    ]
    return sentences


def _conditions(conditions) -> str:
    """The values of the four conditions of the curves, of sizes over the roughness where these are fewer."""
    parts = []
    ratios = {f"{condition.diameter_ratio:.4g}" for condition in conditions}
    for name, taken in zip(Condition._fields, zip(*conditions), strict=True):
        if name == "particle_diameter" and len(ratios) < len({*taken}):
            parts.append(f"xₐ/σ = {', '.join(sorted(ratios, key=float))}")
            continue
        parts.append(_levels(name, {*taken}))
    return f"Conditions: {'; '.join(parts)}."


def _levels(name, values) -> str:
    if len(values) == 1:
        return note(name, *values)
    zero = "dry and " if name == "viscosity" else "two-body and "
    listed = ", ".join(value_text(name, value) for value in sorted(values) if value)
    return f"{'' if all(values) else zero}{AXES[name].sign} = {listed} {unit_text(name)}"


def _description(panel) -> str:
    """Alternative text of a panel: its curves with their ends, and the number of marks."""
    curves = panel.of_kind(CURVE)
    parts = []
    if curves:
        y = np.concatenate([curve.y for curve in curves])
        parts.append(f"{len(curves)} curves of {quantity(panel.y)} {_range(panel.y, y)}")
        taken = zip(*(curve.curve for curve in curves), strict=True)
        varying = [name for name, values in zip(Condition._fields, taken) if len({*values}) > 1]
        for curve in dict.fromkeys((curves[0], curves[-1])):
            own = ", ".join(note(name, getattr(curve.curve, name)) for name in varying)
            ends = " to ".join(axis_text(panel.y, end) for end in curve.y[[0, -1]])
            parts.append(f"the curve at {own or label(curve.curve)} runs from {ends}")
    for kind, look in marks.LOOKS.items():
        named = [s for s in panel.series if s.look.get("label", "") == look.get("label")]
        if named and kind not in (marks.LOCUS, marks.BAND):
            x, y = (np.concatenate([getattr(each, axis) for each in named]) for axis in "xy")
            count = len({*zip(x.tolist(), y.tolist())})
            if kind == marks.EVERY_LOAD:  # lines, of which these are the ends
                count //= 2
            parts.append(f"{look['label']}: {count}, {quantity(panel.x)} {_range(panel.x, x)}")
    return f"Panel {panel.letter}: {'; '.join(parts)}."


def _range(name, values) -> str:
    low, high = (axis_text(name, end) for end in (np.nanmin(values), np.nanmax(values)))
    return f"of {low}" if low == high else f"between {low} and {high}"
