"""What the page tells, gathered from products of the workflow: figures, statements, inputs, names.

Curves are not among it, since the page computes them.  Bands are thinned to what the eye resolves.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import AXES, CONDITION_AXES, Condition
from thirdbody.data.places import part_of_paper
from thirdbody.data.quantities import QUANTITIES, STATUS_MEANINGS
from thirdbody.data.tables import DRAWN_POINTS, read_csv
from thirdbody.model.bounds import BOUNDS

SEEN = 1.0 / 1500.0  # of the extent of an outline: less is not seen
DIGITS = 5  # of places in panels
CURVE = re.compile(r"nu = (\S+) cSt; x_a = (\S+) nm; sigma = (\S+) nm; eta_a = (\S+) m-2")
PRINTED, TOLERANCE, BAND = "printed; ", "tolerance; ", "band; "
FLAGS = {  # what a panel shows beside its curves, by the labels of the points drawn
    "turning points": "turning_points",
    "locus of the turning points": "locus",
    "window": "window",
}
STATED = (  # what the page needs of a statement to judge it and to tell of it
    *("id", "place", "statement", "quote", "kind", "quantity", "conditions"),
    *(
        "reference",
        "published",
        "direction",
        "along",
        "extreme",
        "against",
        "open_end",
        "any_curve",
    ),
    *("must_be_reached", "tolerance", "relative", "reason", "aside", "cluster"),
)


def page_content(
    figures: Iterable[tuple[str | PathLike, str | PathLike]],
    claims: Iterable[Mapping[str, Any]],
    verdicts: Mapping[str, Any],
    inputs: Mapping[str, Any],
    interpretations: Mapping[str, Mapping[str, Any]],
    ranges: Mapping[str, Sequence[float]],
) -> dict[str, Any]:
    """Gather what the page tells.

    Parameters
    ----------
    figures : iterable of (path, path)
        Points drawn (.csv) and caption (.md) of each figure of curves.
    claims : iterable of Mapping
        The statements of the paper, by the fields of ``thirdbody.study.claims.Claim``.
    verdicts : Mapping
        Content of ``claims.json``.
    inputs : Mapping
        Of each input of the model its ``symbol``, ``unit``, ``source``, ``value`` as the run has it,
        and either ``allowed`` words or, of a number that is not printed, perhaps ``bounds`` and
        ``scale`` of the search for it.
    interpretations : Mapping
        Inputs by the name of each calibrated interpretation.
    ranges : Mapping
        First and last value of each condition in the paper, by its symbol, in engineering units.

    Returns
    -------
    dict
        Plain values for JSON.

    Raises
    ------
    OSError
        If a file is damaged: one line names it.

    Examples
    --------
    >>> ranges = {"F_t": [0.04, 80], "nu": [0, 150], "x_a": [0, 1000], "sigma": [100, 500]}
    >>> ranges["eta_a"] = [1e10, 5e12]
    >>> content = page_content([], [], {"interpretation": "mine", "statements": []}, {}, {}, ranges)
    >>> content["axes"][0]["key"], content["axes"][0]["range"]
    ('load_N', [0.04, 80.0])
    """
    found = {row["id"]: row for row in verdicts["statements"]}
    return {
        "axes": [_axis(axis, ranges[axis.symbol.rstrip("*")]) for axis in AXES.values()],
        "quantities": {name: _quantity(name) for name in QUANTITIES},
        "statuses": dict(STATUS_MEANINGS),
        "inputs": {name: _input(name, entry) for name, entry in inputs.items()},
        "interpretation": verdicts["interpretation"],
        "interpretations": dict(interpretations),
        "figures": [figure_content(*paths) for paths in figures],
        "claims": [
            {key: claim[key] for key in STATED}
            | {"part": part_of_paper(claim["place"])}
            | {"measured": found[claim["id"]]["computed"], "verdict": found[claim["id"]]["verdict"]}
            for claim in claims
        ],
    }


def _axis(axis, ends):
    unit = {"key": axis.key, "unit": axis.unit}
    if axis.name == "load":
        unit = {"key": "load_N", "unit": "N"}
    return {
        "name": axis.name,
        "sign": axis.sign,
        "scale": axis.scale,
        "range": [float(end) for end in ends],
    } | unit


def _quantity(name):
    quantity = QUANTITIES[name]
    return {
        "symbol": quantity.symbol,
        "unit": quantity.units,
        "long_name": quantity.long_name,
        "equation": quantity.equation,
    }


def _input(name, entry):
    bounds = {"least": BOUNDS[name].least, "most": BOUNDS[name].most} if name in BOUNDS else {}
    return dict(entry) | bounds


def figure_content(points: str | PathLike, caption: str | PathLike) -> dict[str, Any]:
    """What the page tells of a figure of curves.

    Parameters
    ----------
    points, caption : path
        The points drawn (.csv), and the caption with the alternative text (.md).

    Returns
    -------
    dict
        Its ``name``, ``title``, ``caption`` and alternative text ``seen``; ``curves``, the conditions
        [SI] of all that it shows; and ``panels``, each with the indices of its curves, its bands and
        the numbers that the paper prints.

    Raises
    ------
    OSError
        If a file is damaged: one line names it.

    Examples
    --------
    >>> import tempfile
    >>> drawn = "A,nu = 0 cSt; x_a = 0 nm; sigma = 300 nm; eta_a = 0 m-2,load,1e-5,separation,4e-7"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     points, caption = Path(folder, "fig03.csv"), Path(folder, "fig03.md")
    ...     _ = points.write_text("panel,curve,x_name,x,y_name,y\\n" + drawn)
    ...     _ = caption.write_text("**Figure 3. Title.** What it tells.")
    ...     figure = figure_content(points, caption)
    >>> figure["title"], figure["curves"][0]["roughness"], figure["panels"][0]["curves"]
    ('Figure 3. Title', 3e-07, [0])
    """
    rows = read_csv(points, DRAWN_POINTS)
    panels: dict[str, dict] = {}
    for row in rows:
        panel = panels.setdefault(
            row["panel"], {"x": row["x_name"], "y": row["y_name"], "drawn": {}}
        )
        panel["drawn"].setdefault(row["curve"], []).append((row["x"], row["y"]))
    labels = dict.fromkeys(
        label for panel in panels.values() for label in panel["drawn"] if CURVE.fullmatch(label)
    )
    places = {label: place for place, label in enumerate(labels)}
    title, told, seen = _caption(Path(caption).read_text(encoding="utf-8"))
    return {
        "name": Path(points).stem,
        "title": title,
        "caption": told,
        "seen": seen,
        "curves": [_condition(label)._asdict() for label in labels],
        "panels": [_panel(letter, panel, places) for letter, panel in panels.items()],
    }


def _panel(letter, panel, places):
    drawn = panel["drawn"]
    bands = {
        label.removeprefix(BAND): points for label, points in drawn.items() if _is(label, BAND)
    }
    printed = [label.removeprefix(PRINTED) for label in drawn if _is(label, PRINTED)]
    return {
        "letter": letter,
        "x": panel["x"],
        "y": panel["y"],
        "curves": [places[label] for label in drawn if label in places],
        "bands": {places[label]: _rounded(thinned(points)) for label, points in bands.items()},
        "printed": [mark for name in printed for mark in _marks(name, drawn)],
    } | {flag: label in drawn for label, flag in FLAGS.items()}


def _is(label, sort):
    return label.startswith(sort)


def _marks(name, drawn):
    """The numbers of one statement: each a place, and both ends of its tolerance."""
    ends = _rounded(drawn[TOLERANCE + name])
    for place, point in enumerate(_rounded(drawn[PRINTED + name])):
        yield {"id": name, "at": point, "ends": ends[2 * place : 2 * place + 2]}


def _condition(label):
    values = map(float, CURVE.fullmatch(label).groups())
    return Condition(
        *(axis.to_si(value) for axis, value in zip(CONDITION_AXES, values, strict=True))
    )


def _caption(text):
    """Title, caption and alternative text of a file beside a figure, without marks of Markdown."""
    caption, _, seen = text.strip().partition("\n\n")
    title, _, told = caption.removeprefix("**").partition("** ")
    return title.rstrip("."), told, seen.removeprefix("**Alternative text.** ")


def _rounded(points):
    return [[float(f"{value:.{DIGITS}g}") for value in point] for point in points]


def thinned(points: Sequence[Sequence[float]]) -> NDArray[np.float64]:
    """The points of an outline that are needed to see it as it is, on linear and logarithmic axes.

    Parameters
    ----------
    points : sequence of pair
        The outline; positive along x, which is seen on a logarithmic axis.

    Returns
    -------
    array, shape (fewer points, 2)
        Some of them, the first and the last among these.

    References
    ----------
    Douglas and Peucker (1973), Cartographica 10:112.

    Examples
    --------
    >>> thinned([(1.0, 0.0), (10.0, 1.0), (100.0, 2.0), (1000.0, 0.0)]).tolist()
    [[1.0, 0.0], [100.0, 2.0], [1000.0, 0.0]]
    """
    outline = np.asarray(points, dtype=float)
    x, y = np.log(outline[:, 0]), outline[:, 1]
    kept = _needed(x, y)
    if y.min() > 0.0:
        kept |= _needed(x, np.log(y))
    return outline[kept]


def _needed(x, y):
    """Which points of a line are farther than ``SEEN`` of its extent from a line without them."""
    seen = np.column_stack([_over_extent(x), _over_extent(y)])
    kept = np.zeros(len(seen), bool)
    kept[[0, -1]] = True
    waiting = [(0, len(seen) - 1)]
    while waiting:
        first, last = waiting.pop()
        if last - first < 2:
            continue
        along, beside = seen[last] - seen[first], seen[first + 1 : last] - seen[first]
        length = np.hypot(*along)
        across = along[0] * beside[:, 1] - along[1] * beside[:, 0]
        apart = np.abs(across) / length if length > 0.0 else np.hypot(*beside.T)
        place = int(np.argmax(apart))
        if apart[place] > SEEN:
            middle = first + 1 + place
            kept[middle] = True
            waiting += [(first, middle), (middle, last)]
    return kept


def _over_extent(values):
    """``values`` from 0 to 1."""
    extent = np.ptp(values)
    return (values - values.min()) / extent if extent > 0.0 else np.zeros_like(values)
