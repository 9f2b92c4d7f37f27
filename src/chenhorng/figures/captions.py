"""Captions and alternative texts: words of ``captions.yaml``, and what follows from the panels."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from chenhorng.figures import printed
from chenhorng.markdown import markdown_text
from thirdbody.core.parameters import BOUNDS
from thirdbody.curves import Condition
from thirdbody.ensembles import RANGE
from thirdbody.files import read_yaml
from thirdbody.inputs import or_calibrated
from thirdbody.netcdf import KEYS, Dataset, model_attribute
from thirdbody.plotting import marks
from thirdbody.plotting.panels import CURVE, Panel
from thirdbody.plotting.scales import (
    ABSENT,
    SCALES,
    axis_text,
    label,
    note,
    quantity,
    unit_text,
    value_text,
)
from thirdbody.symbols import unicode
from thirdbody.variables import AXES

LEAST_OUTSIDE = 0.005  # of a curve, of a fraction or of its height: half a line's width


@dataclass(frozen=True, kw_only=True)
class Caption:
    """The caption of a figure: its ``place`` in the paper, its title, what it shows, the
    ``message`` of the paper, and the ``alternative`` text."""

    place: str = ""
    title: str
    shows: str = ""
    message: str = ""
    alternative: str

    @property
    def heading(self) -> str:
        """The title behind the place."""
        return ". ".join(filter(None, (self.place, self.title)))

    def markdown(self) -> str:
        """Paragraphs of Markdown or reStructuredText."""
        first = f"**{markdown_text(self.heading)}.** {self.message}".rstrip()
        last = f"**Alternative text.** {self.alternative}\n"
        return "\n\n".join(filter(None, (first, self.shows, last)))


WORDS = read_yaml(Path(__file__).with_suffix(".yaml"))
FIGURES, MARKS, SENTENCES = WORDS["figures"], WORDS["marks"], WORDS["sentences"]
REMARKS = WORDS["remarks"]
UNITS = {key: BOUNDS[name].unit for name, key in KEYS["body"].items()}  # SI, of the inputs


def caption(
    name: str,
    panels: Sequence[Panel] = (),
    title: str = "",
    notes: Sequence[str] = (),
    headline: Sequence[str] = (),
) -> Caption:
    """The caption of a figure; that of a figure of curves follows from the ``title`` of its scene
    and from its ``panels``.  ``notes`` are further sentences on what is shown; ``headline`` says
    what the curves show, and what the paper says."""
    words = FIGURES.get(name, {})
    if panels:
        notes = [*_notes(panels), *notes]
    return Caption(
        place=place_of(name),
        title=words.get("title") or " ".join(title.split()),
        shows=" ".join(notes),
        message=" ".join(filter(None, (*headline, words.get("message")))),
        alternative=words.get("alternative") or " ".join(map(_description, panels)),
    )


def place_of(name: str) -> str:
    """The place in the paper of a figure: Figure 4 for ``fig04``, empty for one that is ours."""
    of_paper = name in FIGURES and name.startswith("fig")
    return f"Figure {int(name.removeprefix('fig'))}" if of_paper else ""


def inputs_sentence(data: Dataset) -> str:
    """Of which inputs the points of a dataset are: the default, or those that it names."""
    default = model_attribute(or_calibrated(None).best, data["roughness"].values)
    solved, expected = json.loads(data.attrs["model_parameters"]), json.loads(default)
    texts = [_input_text(key, value) for key, value in solved.items() if value != expected[key]]
    return SENTENCES["others"].format(", ".join(texts)) if texts else SENTENCES["default"]


def labels_sentences(data: Dataset) -> str:
    """What loads and sizes in all figures mean for the inputs of a dataset."""
    area = json.loads(data.attrs["model_parameters"])["A_n"]
    sizes = data["particle_diameter"].attrs["comment"]
    return SENTENCES["labels"].format(area=1e6 * area, sizes=sizes)


def _input_text(key, value) -> str:
    """An input with its value; of those that follow the roughness, the range."""
    if isinstance(value, list):
        value = f"{min(value):.3g} to {max(value):.3g}" if len(value) > 1 else value[0]
    text = value if isinstance(value, str) else f"{value:.4g}"
    unit = UNITS.get(key, "1")
    return f"{unicode(key, is_symbol=True)} = {unicode(text)}" + (f" {unit}" if unit != "1" else "")


def _notes(panels) -> list[str]:
    """Sentences on the panels, the load axis, the conditions, marks and lines."""
    conditions = {curve.curve for panel in panels for curve in panel.of_kind(CURVE)}
    labels = {series.look.get("label") for panel in panels for series in panel.series}
    named = {kind for kind, look in printed.ALL_LOOKS.items() if look.get("label", "") in labels}
    contents = []
    for panel in panels:
        own = [panel.conditions] if panel.conditions else []
        viscosities = {curve.curve.viscosity for curve in panel.of_kind(CURVE)}
        if 1 < len(viscosities) < len({condition.viscosity for condition in conditions}):
            own.append(_levels("viscosity", viscosities))
        at = f" at {', '.join(own)}" if own else ""
        over = "" if panel.x == "load" else f" over the {quantity(panel.x)}"
        letter = f"({panel.letter}) " if len(panels) > 1 else ""
        contents.append(f"{letter}{quantity(panel.y)}{at}{over}")
    sentences = ["; ".join(contents) + "."]
    sentences += [_conditions(conditions)]
    sentences += [sentence.format(RANGE) for kind, sentence in MARKS.items() if kind in named]
    statuses = [status.replace("_", " ") for status in marks.STATUSES if status in named]
    sentences += map(SENTENCES["status"].format, statuses)
    sentences += _outside(panels)
    ours = [panel.letter for panel in panels if REMARKS["ours"] in panel.title]
    if ours:
        sentences.append(SENTENCES["ours"].format(_listed(ours)))
    if len({condition.is_dry for condition in conditions}) > 1:
        sentences.append(SENTENCES["media"])
    leasts = {panel.least for panel in panels} - {0.0}
    sentences += map(SENTENCES["least"].format, leasts)
    letters: dict[str, list[str]] = {}
    for panel in panels:
        if panel.x != "diameter_ratio":  # where it is not shaded
            letters.setdefault(SCALES[panel.y].zones, []).append(panel.letter)
    shaded = [
        f"in {_listed(letters[zones])} {text}"
        for zones, text in WORDS["zones"].items()
        if zones in letters
    ]
    return sentences + ([SENTENCES["shaded"].format("; ".join(shaded))] if shaded else [])


def _listed(texts) -> str:
    """Texts as in a sentence: A, B and C."""
    return " and ".join(filter(None, (", ".join(texts[:-1]), texts[-1])))


def _outside(panels) -> list[str]:
    """A sentence on how far curves lie outside their own ranges, if one is seen to."""
    texts = []
    for panel in panels:
        is_fraction = bool(SCALES[panel.y].zones)
        curves = {curve.name: curve for curve in panel.of_kind(CURVE)}
        most = 0.0
        for band in panel.of_kind(marks.BAND):
            x, low, high = marks.ends_of(band)
            y = np.interp(x, curves[band.name].x, curves[band.name].y)
            beyond = np.maximum(low - y, y - high)
            most = max(most, float(np.max(beyond if is_fraction else beyond / y)))
        if most >= LEAST_OUTSIDE:
            text = (
                axis_text(panel.y, most) if is_fraction else f"{100.0 * most:.2g} % of its height"
            )
            texts.append(f"by {text} in {panel.letter}")
    return [SENTENCES["outside"].format(", ".join(texts))] if texts else []


def _conditions(conditions) -> str:
    """The values of the four conditions; x_a/σ in place of x_a if it has fewer values."""
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
    listed = ", ".join(value_text(name, value) for value in sorted(values) if value)
    absent = "" if all(values) else f"{ABSENT[name]} and "
    return f"{absent}{unicode(AXES[name].symbol)} = {listed} {unit_text(name)}"


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
    for kind, look in printed.ALL_LOOKS.items():
        named = [s for s in panel.series if s.look.get("label", "") == look.get("label")]
        if named and kind not in (printed.LOCUS, marks.BAND):
            x, y = (np.concatenate([getattr(each, axis) for each in named]) for axis in "xy")
            count = len({*zip(x.tolist(), y.tolist())})
            if kind == printed.EVERY_LOAD:  # lines, of which these are the ends
                count //= 2
            parts.append(f"{look['label']}: {count}, {quantity(panel.x)} {_range(panel.x, x)}")
    return f"Panel {panel.letter}: {'; '.join(parts)}."


def _range(name, values) -> str:
    low, high = (axis_text(name, end) for end in (np.nanmin(values), np.nanmax(values)))
    return f"of {low}" if low == high else f"between {low} and {high}"
