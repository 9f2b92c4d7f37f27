"""Captions and alternative texts, from the tables below and from the panels of a figure."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from thirdbody.curves import Condition
from chenhorng.figures import printed
from chenhorng.figures.curve_figures import HEADLINES, OURS
from chenhorng.typeset import markdown_text
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
from thirdbody.variables import AXES

LEAST_OUTSIDE = 0.005  # of a curve, of a fraction or of its height: half a line's width


@dataclass(frozen=True, kw_only=True)
class Caption:
    """The place of a figure in the paper and its title, what it shows, what the paper concludes from it, and a
    text in its place."""

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


# figures whose captions do not follow from curves
CAPTIONS = {
    "fig01": Caption(
        place="Figure 1",
        title="A lubricated interface with third-body particles",
        message=(
            "The load F_t is carried by summits of both surfaces, by particles, and by the lubricant. "
            "Orange particles carry load, pale ones do not: in the model a particle carries load if its "
            "diameter exceeds d - y - h_e, wherever it lies on the roughness, where y is the height of the "
            "plane on which all particles rest in the model; here also if it is drawn between both "
            "surfaces. The tint is the elastic zone h_e of Eqs. 4 and 5, below the mean plane of surface 1; "
            "of the random sections one is shown with no pale particle in it. Dashed lines are the mean "
            "planes. Surfaces and sizes are drawn from the distributions of the model, at the separation d "
            "computed for the load F_t."
        ),
        alternative=(
            "A cut through two rough surfaces, one above the other, with lubricant and round particles in "
            "the gap. Lines name surfaces, lubricant, a particle and a contact; arrows mark the separation "
            "d, the load and the depth of the tinted zone h_e."
        ),
    ),
    "fig02": Caption(
        place="Figure 2",
        title="The three contact modes",
        message=(
            "At the same load, in the s-s mode (A) summits carry it, in the p-s mode (B) particles, in the "
            "hybrid mode (C) both. Orange particles carry load, by the rule of Figure 1; pale ones, the specks "
            "in A, do not. The tint is the elastic zone h_e. Surfaces and sizes are drawn from the "
            "distributions of the model, at the separation d computed for the load F_t."
        ),
        alternative=(
            "Three cuts through two rough surfaces with round particles between them. In A summits touch "
            "and particles are free; in B only particles carry load; in C both do."
        ),
    ),
    "claims": Caption(
        title="Verdict on each statement of the paper",
        message=(
            "Each bar has the statements of one figure, or of the conclusions and the abstract, by their "
            "verdict; one that the paper repeats counts each time. Below it are all others than those that hold, "
            "in the order of the paper, with their verdicts."
        ),
        alternative=(
            "A stacked bar for each part of the paper with the number of statements of each verdict, and a "
            "list of the statements that do not hold or are not tested."
        ),
    ),
    "sensitivity": Caption(
        title="Sensitivity of results to the unprinted inputs",
        message=(
            "Each column is a result, each row an input. A window is the range of x_a/σ with turning points, from "
            "its low to its high end. An elasticity is the change of the result in per "
            "cent for one per cent of the input. Inputs stand in the order of their largest elasticity. "
            "Cells without a number are near zero; the table has them all. Colours stop at the ends of the "
            "scale, numbers do not."
        ),
        alternative="A heat map with a number in each cell that is not negligible.",
    ),
}
# what the headline of a figure of curves leaves out
MESSAGES = {
    "fig03": "This is said of particles larger than 300 nm. Two-body contact has the largest area.",
    "fig04": "Below 50 cSt it changes little. The slope of the area drops in B at the upright line.",
    "fig05": (
        "There more than 70 cSt is needed, which is held against the curves at 90, 120 and 150 cSt "
        "together: one of them is enough."
    ),
    "fig08": (
        "There the area ratio of particles rises and then falls. In the p-s mode the dry area grows with the "
        "roughness, and near the s-s mode it falls."
    ),
    "fig09": (
        "These are about 250 to 400 nm; the strips in D show what counts as about. Larger ones enter the "
        "p-s mode at low loads."
    ),
    "fig10": "Their loads fall with that ratio.",
    "fig11": (
        "Over the film thickness all curves coincide. In B the diamond at 100 % stands for the boundary "
        "regime, which the paper names without a number. In C the paper prints between which H_c it draws "
        "70 and 120 cSt, but not at which loads."
    ),
    "fig12": "On the smoother surface the film then carries the whole load.",
    "fig13": "On the smoothest surface it hardly changes.",
}
DIFFERENCES = (
    "Where the curves differ from what the paper says, the verdicts on its statements say so."
)
# the middle zone of an axis
ZONES = {
    "contact_mode": (
        "the hybrid mode, A_sa,t* from 0.05 to 0.95, above it the p-s mode, below it the s-s mode"
    ),
    "lubrication_regime": (
        "mixed lubrication (M.L.), L_s from 3 to 90 %, above it boundary (B.L.), below it full-film "
        "lubrication (F.L.)"
    ),
}
# the marks that the key of a figure of curves names
MEANINGS = {
    marks.TURNING_POINTS: (
        "Stars: turning points of the contact area, maxima of A_sa,t* that stand out by at least 0.02 "
        "within these loads; a curve that still rises at the largest load has none."
    ),
    marks.SLIGHT: ("Hollow stars: maxima, however high, that stand out by less and do not count."),
    marks.LOCUS: ("Heavy dashes join the turning points."),
    marks.WINDOW: (
        "Blue vertical lines: limits of the range with turning points, computed between the "
        "sizes of the curves too."
    ),
    printed.PRINTED: "Diamonds: numbers that the paper prints; bars: their tolerances.",
    printed.ALONG_X: (
        "Upright lines of dashes and dots: numbers that the paper prints along x alone, without the height, "
        "in the colour of their curve if it is one; the strip around a line is its tolerance, darker where "
        "strips overlap."
    ),
    printed.OF_ALL: "Dotted upright lines: those that the paper prints for all surfaces.",
    printed.COMPUTED: (
        "Hexagons: the bends or the crossing of the computed curves "
        "for which the line is printed; "
        "outside the strip the model misses the number, unless it is printed for no curve in particular: then "
        "one in the strip is enough."
    ),
    printed.EVERY_LOAD: (
        "Level lines with a stroke at each end: numbers that the paper prints for every load between the strokes; "
        "strips: their tolerances."
    ),
    marks.BAND: (
        "Shaded in colour: the range, 5 to 95 %, over the ensemble of inputs that explain the "
        "paper about equally well, for some curves. The curves are of the default inputs."
    ),
} | {status: f"Crosses: {status.replace('_', ' ')}." for status in marks.STATUSES}


def caption(
    name: str, panels: Sequence[Panel] = (), title: str = "", notes: Sequence[str] = ()
) -> Caption:
    """The caption of a figure; that of a figure of curves follows from the ``title`` of its scene and
    from its ``panels``.  ``notes`` are further sentences on what is shown."""
    if name in CAPTIONS:
        return replace(CAPTIONS[name], shows=" ".join(notes))
    differences = [DIFFERENCES] if name in HEADLINES else []
    return Caption(
        place=f"Figure {int(name.removeprefix('fig'))}" if name in HEADLINES else "",
        title=" ".join(title.split()),
        shows=" ".join([*_notes(panels), *notes, *differences]),
        message=" ".join(filter(None, (HEADLINES.get(name), MESSAGES.get(name)))),
        alternative=" ".join(map(_description, panels)),
    )


def _notes(panels) -> list[str]:
    """Sentences on the panels, the load axis, the conditions, and the meaning of marks and lines."""
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
    sentences += ["Normal load: dimensionless below, in newtons above.", _conditions(conditions)]
    sentences += [sentence for kind, sentence in MEANINGS.items() if kind in named]
    sentences += _outside(panels)
    ours = [panel.letter for panel in panels if OURS in panel.title]
    if ours:
        sentences.append(f"Not in the paper: {_listed(ours)}.")
    if len({condition.is_dry for condition in conditions}) > 1:
        sentences.append(
            "Dashed black curves and black names: dry contact; where dashed curves coincide, one is drawn. Grey names: "
            "several lubricated curves, or one without particles."
        )
    leasts = {panel.least for panel in panels} - {0.0}
    sentences += [f"Values below {least:g} are not drawn." for least in leasts]
    letters: dict[str, list[str]] = {}
    for panel in panels:
        if panel.x != "diameter_ratio":  # where it is not shaded
            letters.setdefault(SCALES[panel.y].zones, []).append(panel.letter)
    shaded = [
        f"in {_listed(letters[zones])} {text}" for zones, text in ZONES.items() if zones in letters
    ]
    return sentences + ([f"Shaded zone: {'; '.join(shaded)}."] if shaded else [])


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
    if not texts:
        return []
    return [
        f"The curve of the default that lies farthest outside its own range does so {', '.join(texts)}."
    ]


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
    listed = ", ".join(value_text(name, value) for value in sorted(values) if value)
    absent = "" if all(values) else f"{ABSENT[name]} and "
    return f"{absent}{AXES[name].sign} = {listed} {unit_text(name)}"


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
        if named and kind not in (marks.LOCUS, marks.BAND):
            x, y = (np.concatenate([getattr(each, axis) for each in named]) for axis in "xy")
            count = len({*zip(x.tolist(), y.tolist())})
            if kind == printed.EVERY_LOAD:  # lines, of which these are the ends
                count //= 2
            parts.append(f"{look['label']}: {count}, {quantity(panel.x)} {_range(panel.x, x)}")
    return f"Panel {panel.letter}: {'; '.join(parts)}."


def _range(name, values) -> str:
    low, high = (axis_text(name, end) for end in (np.nanmin(values), np.nanmax(values)))
    return f"of {low}" if low == high else f"between {low} and {high}"
