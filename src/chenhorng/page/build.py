"""The page of the explorer, an HTML file.  It has content from products of the workflow, the
template, style and scripts of the folder ``web/``, and D3.  The page computes its curves."""

import json
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import thirdbody.symbols as symbols
from chenhorng.claims.words import COLOURS
from chenhorng.figures import printed
from chenhorng.figures.curve_figures import RELATIVE_AREA, TURNING_POINTS
from thirdbody.conditioning import FEWEST, LEAST_SPREAD, NEAR
from thirdbody.core.parameters import BOUNDS
from thirdbody.ensembles import RANGE
from thirdbody.plotting import marks
from thirdbody.variables import AXES, DERIVED, NORMAL_LOAD, QUANTITIES, STATUS_MEANINGS

HERE = Path(__file__).parent
FIRST = "main.js"  # the script that imports all others
IMPORT = re.compile(r'^import (\{[^}]*\}) from "\./(\w+\.js)";$', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(?:const|function\*?|class) (\w+))", re.MULTILINE)
NODES = 48  # nodes of the integrals that the page computes
# expressions for LaTeX and Markdown in quotes of the paper, and their plain text; applied in order
MARKUP: dict[str, str | Callable[[re.Match], str]] = {
    r"\\text\s*\{([^}]*)\}": r"\1",
    r"\\(sigma|nu|eta)(?![a-z])": lambda match: symbols.GREEK[match[1]],
    r"\s*\\times\s*": "×",
    r"\\cdot": "·",
    r"\\rightarrow": "→",
    r"\\star|\\\*": "*",
    r"\\([ %])": r"\1",
    r"\^\{?\*\}?": "*",
    r"(?:\^|<sup>)\{?(-?\d+)(?:\}|</sup>)?": lambda match: symbols.unicode(f"^{match[1]}"),
    r"_\{(\w+(?:,t)?)\}": r"_\1",
    r"\$|\*(?=\w+\*)|(?<=nm)\*|(?<=cSt)\*": "",
}
PATTERNS = (
    *("SYMBOL", "IN_TEXT", "IN_SYMBOL", "POWER", "WORD", "BELOW", "TIGHT"),
    *("GREEK", "SUPERSCRIPTS"),
)
# marks that figures have too, by their names in the page
MARKS = {
    "stars": marks.TURNING_POINTS,
    "slight": marks.SLIGHT,
    "locus": printed.LOCUS,
    "printed": printed.PRINTED,
    "computed": printed.COMPUTED,
    "levels": printed.EVERY_LOAD,
    "windows": printed.WINDOW,
    "limits": printed.ALONG_X,
    "ofAll": printed.OF_ALL,
    "strips": "strip",
    "ranges": marks.BAND,
}
OF_PANEL = "curves", "hairlines", "ranged"  # all, the thin ones, those with a range
STATED = (  # the fields of a statement in claims.json that the page shows
    *("id", "part", "place", "statement", "verdict", "finding"),
    *("tolerance", "tolerance_kind", "reason"),
)


def page_content(
    figures: Mapping[str, Mapping[str, Any]],
    judged: Mapping[str, Any],
    departures: Sequence[Mapping[str, Any]],
    inputs: Mapping[str, Any],
    ensemble: Sequence[Mapping[str, Any]],
    ranges: Mapping[str, Sequence[float]],
    rig: Mapping[str, Any],
) -> dict[str, Any]:
    """Collect the data of the page as plain values for JSON.

    ``figures`` are the records of the figures of curves, by name.  ``judged`` is the content of
    ``claims.json``.  ``departures`` has the ``name`` and the ``verdicts`` of each departure from
    the print that is taken back.  ``inputs`` are entries of ``config/inputs.yaml`` with the
    ``value`` in the run and, for an unknown, ``bounds`` and ``scale``.  ``ensemble`` has the inputs
    of each member that differ from the default.  ``ranges`` has the first and the last value of
    each condition in the paper, by symbol, in engineering units.  ``rig`` is for materials, speed
    and oil: ``materials`` has the inputs of each combination; ``oils`` the viscosities [cSt] of
    each grade at 40 and 100 C; ``usual_density`` the density of an oil; and other keys the least
    and the greatest of each number that a reader may enter.
    """
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    return {
        "axes": [
            {
                "name": axis.name,
                "key": axis.alias,
                "scale": axis.scale,
                "range": [float(end) for end in ranges[axis.symbol.rstrip("*")]],
            }
            for axis in AXES.values()
        ],
        "quantities": list(QUANTITIES),
        "variables": {
            variable.name: _variable(variable)
            for variable in (*AXES.values(), NORMAL_LOAD, *QUANTITIES.values(), *DERIVED.values())
        },
        "symbols": {name.lower(): getattr(symbols, name) for name in PATTERNS}
        | {"html": {"symbol": symbols.HTML.symbol, "below": symbols.HTML.below("{}")}},
        "statuses": dict(STATUS_MEANINGS),
        # behind the title of a panel
        "remarks": {panel.y: panel.remark for panel in (RELATIVE_AREA, TURNING_POINTS)},
        "marks": {name: printed.ALL_LOOKS[kind]["label"] for name, kind in MARKS.items()},
        # Gauss-Legendre nodes and weights on the interval from 0 to 1
        "quadrature": np.column_stack([0.5 * (nodes + 1.0), 0.5 * weights]).tolist(),
        "inputs": {
            name: {**entry, **(BOUNDS[name]._asdict() if name in BOUNDS else {})}
            for name, entry in inputs.items()
        },
        "ensemble": list(ensemble),
        "conditioning": {"least_spread": LEAST_SPREAD, "near": NEAR, "fewest": FEWEST},
        "range": RANGE,
        "slight": {"least_rise": marks.LEAST_RISE, "from_zero": marks.FROM_ZERO},
        "rig": dict(rig),
        "figures": [figure_content(name, record) for name, record in figures.items()],
        **{key: judged[key] for key in ("held", "judged", "counts")},
        "statements": [_statement(row, departures) for row in judged["statements"]],
    }


def _variable(variable):
    """The names and the unit of a variable in the page.  A value in this unit is ``factor`` times
    the value in SI."""
    unit = symbols.unicode(variable.shown_unit)
    factor = {} if variable.scale == 1.0 else {"factor": float(f"{1.0 / variable.scale:.12g}")}
    names = {"symbol": variable.symbol, "words": variable.title, "unit": unit}
    return names | factor | {"log": variable.is_logarithmic}


def _statement(row, departures):
    """The fields of a statement that the page shows.  Conditions are in SI, without those that the
    statement leaves open."""
    return {key: row[key] for key in STATED} | {
        "quote": plain_text(row["quote"]),
        "curves": [*map(_specified, row["curves"])],
        "references": [*map(_specified, row["references"])],
        "taken_back": {
            departure["name"]: departure["verdicts"][row["id"]] for departure in departures
        },
    }


def _specified(condition):
    return {name: value for name, value in condition.items() if value is not None}


def plain_text(quote: str) -> str:
    """A ``quote`` of the paper without LaTeX and Markdown: x_a = 300 nm, 3.27×10⁻⁶."""
    for pattern, plain in MARKUP.items():
        quote = re.sub(pattern, plain, quote)
    return quote


def figure_content(name: str, record: Mapping[str, Any]) -> dict[str, Any]:
    """The content of the page on a figure, from its ``record``.  ``curves`` has each curve once,
    and ``panels`` have the indices of theirs."""
    curves: list[dict] = []
    for panel in record["panels"]:
        curves += [curve for curve in panel["curves"] if curve not in curves]
    return {
        "name": name,
        "part": record["place"],
        "title": record["heading"],
        "caption": record["message"],
        "curves": curves,
        "panels": [
            panel | {key: [curves.index(curve) for curve in panel[key]] for key in OF_PANEL}
            for panel in record["panels"]
        ],
    }


def page_text(content: Mapping[str, Any]) -> str:
    """The page as self-contained HTML, from the ``content`` of ``page_content``."""
    data = json.dumps(content, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    parts = {
        "colours.css": _colours(),
        "style.css": _read("web/style.css"),
        "d3.LICENSE": _read("vendor/d3.LICENSE"),
        "d3.min.js": _read("vendor/d3.min.js"),
        "content.json": data.replace("<", "\\u003c"),
        "main.js": _one_script(FIRST),
    }
    return re.sub(r"\{\{([\w.]+)\}\}", lambda match: parts[match[1]], _read("web/index.html"))


def _colours() -> str:
    """The colours of verdicts and tolerances, which all products share, as variables of a style."""
    named = {verdict.split()[0]: colour for verdict, colour in COLOURS.items()}
    named |= {"tolerance": printed.TOLERANCE, "tolerance-edge": printed.EDGE}
    return f":root {{ {' '.join(f'--{name}: {colour};' for name, colour in named.items())} }}"


def _one_script(first: str) -> str:
    """Bundle a script and all its imports: each module becomes a function, which is called once."""
    joined: dict[str, str] = {}

    def join(name):
        if name in joined:
            return
        text = _read(f"web/{name}")
        for _, imported in IMPORT.findall(text):
            join(imported)
        body = IMPORT.sub(r'const \1 = modules["\2"];', EXPORT.sub("", text))
        exports = ", ".join(EXPORT.findall(text))
        joined[name] = f'modules["{name}"] = (() => {{\n{body}\nreturn {{ {exports} }};\n}})();'

    join(first)
    return "const modules = {};\n" + "\n\n".join(joined.values())


def _read(name: str) -> str:
    return (HERE / name).read_text(encoding="utf-8").strip()
