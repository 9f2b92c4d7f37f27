"""Tables as people read them: a row a curve, engineering units, the paper's numbers beside.

Programs read the CSV files of the same names, which hold every digit in SI.  Here a number has three
digits, or fewer where its error is larger than that.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape

from thirdbody.data.conditions import AXES, CONDITION_AXES

DIGITS = 3
NEGLIGIBLE = 0.005  # of an elasticity or a share of variance
# curves stand in the order of these
ORDER = [
    AXES[name].column
    for name in ("roughness", "particle_diameter", "particle_density", "viscosity")
]
LOAD_UNIT = 1e-6  # of F_t* in headings
PLUS_MINUS = " ± "
RESULTS = {
    "turning_point_load": "turning point: load",
    "turning_point_ratio": "turning point: Aₛₐ,ₜ*",
    "window_low": "window: low end",
    "window_high": "window: high end",
    "solid_load_fraction": "load where Lₛ = {:g}",
    "particle_contact_area_ratio": "load where Aₛₐ,ₜ* = {:g}",
}
MEASURES = {
    "elasticity": "Sensitivities: elasticities, d ln(result)/d ln(input)",
    "sobol_total": "Sensitivities: total Sobol indices",
}
CROSSINGS = (  # columns of the transitions: quantity, level, heading
    ("solid_load_fraction", 0.9, "Lₛ = 90 % [N]"),
    ("solid_load_fraction", 0.03, "Lₛ = 3 % [N]"),
    ("particle_contact_area_ratio", 0.95, "Aₛₐ,ₜ* = 0.95 [N]"),
    ("particle_contact_area_ratio", 0.05, "Aₛₐ,ₜ* = 0.05 [N]"),
)
FIGURES, PAPER = "figures", "paper"  # headings of what curves of one's own do not have
STATUS = "status"  # heading of what is left out where it is converged everywhere
CONVERGED = "converged"
ARROWS = {"rising": "↑ ", "falling": "↓ "}


@dataclass(frozen=True)
class Sheet:
    """A table as it is read: a title and a note above it, headings, and rows of texts."""

    title: str
    note: str
    headings: Sequence[str]
    rows: Sequence[Sequence[str]]


def rounded(value: float | None, error: float = 0.0, digits: int = DIGITS) -> str:
    """``value`` with so many digits, or fewer where ``error`` leaves fewer.

    None is empty, and nan is none: what is missing, and what does not exist.

    Examples
    --------
    >>> rounded(0.123456), rounded(0.123456, error=0.04), rounded(1234.5)
    ('0.123', '0.12', '1230')
    """
    if value is None:
        return ""
    if math.isnan(value):
        return "none"
    if value == 0.0:
        return "0"
    places = digits - 1 - _exponent(float(f"{value:.{digits - 1}e}"))
    if error > 0.0:
        places = min(places, -_exponent(error))
    return f"{round(value, places) + 0.0:.{max(places, 0)}f}"


def with_error(value: float, error: float) -> str:
    """``value`` ± ``error``, which has one digit.

    Examples
    --------
    >>> with_error(0.5234, 0.0612)
    '0.52 ± 0.06'
    """
    return f"{rounded(value, error)}{PLUS_MINUS}{rounded(error, digits=1)}"


def result_name(row: Mapping) -> str:
    """The result that a row of the table ``sensitivity`` is about, with what tells it from others."""
    name = RESULTS[row["quantity"] or row["output"]].format(row["level"])
    if row["output"].startswith("window"):
        return f"{name}, {_condition('roughness', row)}"
    if row["output"].startswith("turning_point"):
        return f"{name}, {_condition('viscosity', row)}"
    return f"{name}, {_condition('particle_diameter', row)}"


def readable(
    table: str, rows: Sequence[Mapping], printed: Sequence[Mapping], newtons_per_load: float
) -> list[Sheet]:
    """A table as it is read.

    Parameters
    ----------
    table : str
        One of ``READABLE``.
    rows : sequence of Mapping
        Its rows.
    printed : sequence of Mapping
        Rows of the table ``printed``.
    newtons_per_load : float
        F_t/F_t* [N].
    """
    return READABLE[table](rows, printed, newtons_per_load)


def markdown(sheets: Sequence[Sheet]) -> str:
    """Text of ``sheets``, one below the other, each with its caption as a first paragraph."""
    return "\n".join(
        f"{_caption(sheet, '**{}.**')}\n\n{_table(sheet, 'github')}\n" for sheet in sheets
    )


def page(sheets: Sequence[Sheet]) -> str:
    """HTML page of ``sheets``, one below the other; it needs no other file.

    Examples
    --------
    >>> text = page([Sheet("Sizes", "All of them.", ["x"], [["x < 3"]])])
    >>> "<strong>Sizes.</strong> All of them." in text, "<td>x &lt; 3</td>" in text
    (True, True)
    """
    shown = "\n".join(
        f"<p>{_caption(sheet, '<strong>{}.</strong>', escape)}</p>\n{_table(sheet, 'html')}"
        for sheet in sheets
    )
    return PAGE.format(title=escape(sheets[0].title), shown=shown)


PAGE = """\
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{title}</title>
<style>
body {{ background: white; color: black; font: 14px/1.4 sans-serif; margin: 1em; }}
table {{ border-collapse: collapse; margin-bottom: 2em; }}
th, td {{ border: 1px solid #bbb; padding: 0.2em 0.6em; text-align: left; vertical-align: top; }}
th {{ background: #eee; }}
</style>
</head>
<body>
{shown}
</body>
</html>
"""


def _caption(sheet, title, written=str) -> str:
    return f"{title.format(written(sheet.title))} {written(sheet.note)}".rstrip()


def _table(sheet, style) -> str:
    from tabulate import tabulate

    return tabulate(sheet.rows, sheet.headings, tablefmt=style, disable_numparse=True)


def _paper_table(title) -> Callable[..., list[Sheet]]:
    """How a table of the paper is read: printed and recomputed values side by side."""
    note = "Recomputed from the other printed values where that is possible."
    headings = ["property", "symbol", "unit", "printed", "recomputed", "verdict", "remark"]

    def sheets(rows, _printed, _newtons_per_load) -> list[Sheet]:
        lines = [
            [
                *(row[name] for name in ("property", "symbol", "unit")),
                *(_ends(row[f"{name}_low"], row[f"{name}_high"]) for name in headings[3:5]),
                row["verdict"],
                row["remark"] or "",
            ]
            for row in rows
        ]
        return [Sheet(title, note, headings, lines)]

    return sheets


def _turning_points(rows, printed, newtons_per_load) -> list[Sheet]:
    numbers = _by_curve(printed)
    headings = [*CURVE_HEADINGS, "F_TPCA* [10⁻⁶]", PAPER, "F_TPCA [N]", "Aₛₐ,ₜ*", PAPER]
    headings += ["Lₛ [%]", PAPER, "d [nm]", STATUS]
    lines = []
    for key, some in _curves(rows):
        row, paper = some[0], numbers.get(key, {})
        load, error = row["load"], row["load_error"]
        lines.append(
            [
                *_curve_cells(some),
                rounded(load / LOAD_UNIT, error / LOAD_UNIT),
                _paper(paper, "turning_point_load", LOAD_UNIT),
                rounded(load * newtons_per_load, error * newtons_per_load),
                rounded(row["peak_ratio"]),
                _paper(paper, "turning_point_ratio"),
                rounded(100.0 * row["solid_load_fraction"]),
                _paper(paper, "turning_point_solid_load_fraction", 0.01),
                rounded(row["separation_m"] / 1e-9),
                _status(some),
            ]
        )
    title = "Turning points of the contact area"
    note = "A row is a curve. Beside the model's numbers stand the paper's, with their tolerances."
    return [_sheet_beside(printed, title, note, headings, lines)]


def _windows(rows, printed, _) -> list[Sheet]:
    headings = ["σ [nm]", "low end of xₐ/σ", PAPER, "high end of xₐ/σ", PAPER, "xₐ [nm]"]
    surfaces: dict[float, dict] = {}
    for row in rows:
        surfaces.setdefault(row["roughness_m"], {})[row["end"]] = row
    lines = []
    for roughness, ends in surfaces.items():
        line, diameters = [_shown("roughness", roughness)], []
        for name, row in ends.items():
            value = row["diameter_over_roughness"]
            paper = [
                _spread(number)
                for number in printed
                if number["quantity"] == f"window_{name}" and number["roughness_m"] == roughness
            ]
            line += [rounded(value, row["error"]), "; ".join(dict.fromkeys(paper))]
            diameters.append(rounded(value * roughness / 1e-9, row["error"] * roughness / 1e-9))
        lines.append([*line, " to ".join(diameters)])
    title = "Windows of the turning point in dry contact"
    note = (
        "It occurs between two ends of xₐ/σ. Beside them stand the paper's, with their tolerances."
    )
    return [Sheet(title, note, headings, lines)]


def _transitions(rows, printed, newtons_per_load) -> list[Sheet]:
    numbers = [number for number in printed if number["quantity"] == "load"]
    headings = [*CURVE_HEADINGS, *(heading for *_, heading in CROSSINGS), STATUS]
    lines = []
    for key, some in _curves(rows):
        line = _curve_cells(some)
        for quantity, level, _ in CROSSINGS:
            found = {
                rounded(row["load"] * newtons_per_load): ARROWS[row["direction"]]
                for row in some
                if (row["quantity"], row["level"]) == (quantity, level)
            }
            paper = [
                f"(paper: {_spread(number, 1.0 / newtons_per_load)})"
                for number in numbers
                if _key(number) == key
                and (number["at_quantity"], number["at_level"]) == (quantity, level)
            ]
            line.append(", ".join([arrow + load for load, arrow in found.items()] + paper))
        lines.append([*line, _status(some)])
    title = "Loads at which the regime or mode changes"
    note = "A row is a curve. ↓ the quantity falls with the load, ↑ it rises."
    return [_sheet_beside(printed, title, note, headings, lines)]


def _sensitivities(rows, _printed, _newtons_per_load) -> list[Sheet]:
    sheets = []
    names = list(dict.fromkeys(result_name(row) for row in rows if row["input"]))
    note = f"0 stands for less than {NEGLIGIBLE:g}."
    for measure, title in MEASURES.items():
        inputs: dict[str, dict] = {}
        for row in rows:
            if row["measure"] == measure and row["input"] and row["sensitivity"] is not None:
                cells = inputs.setdefault(row["input"].replace("_", " "), {})
                cells[result_name(row)] = _response(row)
        lines = [[name, *(cells.get(one, "") for one in names)] for name, cells in inputs.items()]
        sheets.append(Sheet(title, note, ["input", *names], lines))
    return sheets


def _chart(title, note, limited, below, beyond) -> Callable[..., list[Sheet]]:
    """How the table of a design chart is read: a column a load, the range of the ensemble in brackets.

    ``limited`` is the axis that the limit is on; ``below`` and ``beyond`` stand for limits beyond
    either end of it.
    """

    def told(value) -> str:
        if math.isinf(value) or value == 0.0:
            return beyond if value else below
        return rounded(AXES[limited].from_si(value))

    def sheets(rows, _printed, _newtons_per_load) -> list[Sheet]:
        held = [axis for axis in CONDITION_AXES if axis.column in rows[0]]
        loads = list(dict.fromkeys(row["load_N"] for row in rows))
        lines: dict[tuple, dict] = {}
        for row in rows:
            key = tuple(_shown(axis.name, row[axis.column]) for axis in held)
            ends = [told(row[name]) for name in ("low", "high")]
            span = f" ({ends[0]} to {ends[1]})" if ends[0] != ends[1] else f" ({ends[0]})"
            status = f", {_status([row])}" if _status([row]) else ""
            lines.setdefault(key, {})[row["load_N"]] = told(row["limit"]) + span + status
        headings = [f"{axis.sign} [{axis.unit}]" for axis in held]
        headings += [f"{load:g} N" for load in loads]
        cells = [[*key, *(line[load] for load in loads)] for key, line in lines.items()]
        return [Sheet(title, note, headings, cells)]

    return sheets


READABLE: dict[str, Callable[..., list[Sheet]]] = {
    "table1": _paper_table("Table 1. Properties of the materials, as printed and recomputed"),
    "table2": _paper_table("Table 2. Operating conditions, as printed and recomputed"),
    "tpca_loads": _turning_points,
    "tpca_windows": _windows,
    "transitions": _transitions,
    "sensitivity": _sensitivities,
    "largest_particle": _chart(
        "Largest particles that stay out of the particle-surface mode [nm]",
        "At the load of each column; in brackets between which values nine in ten members of the "
        "calibrated ensemble lie. none, all: of the diameters in the atlas.",
        "particle_diameter",
        "none",
        "all",
    ),
    "least_viscosity": _chart(
        "Least viscosity that leaves boundary lubrication [cSt]",
        "At the load of each column; in brackets between which values nine in ten members of the "
        "calibrated ensemble lie. none, all: of the viscosities in the atlas.",
        "viscosity",
        "all",
        "none",
    ),
}
CURVE_HEADINGS = [FIGURES, *(f"{axis.sign} [{axis.unit}]" for axis in CONDITION_AXES)]


def _sheet_beside(printed, title, note, headings, lines) -> Sheet:
    """A table of curves; where nothing is printed of them, without columns for what the paper says,
    and where all have converged, without one that says so."""
    absent = set() if printed else {FIGURES, PAPER}
    absent |= set() if any(line[headings.index(STATUS)] for line in lines) else {STATUS}
    kept = [place for place, heading in enumerate(headings) if heading not in absent]
    shown = [[line[place] for place in kept] for line in lines]
    return Sheet(title, note, [headings[place] for place in kept], shown)


def _status(rows) -> str:
    """Statuses of some points, but for that of those that have converged."""
    statuses = dict.fromkeys(row["solution_status"] for row in rows)
    return ", ".join(each.replace("_", " ") for each in statuses if each != CONVERGED)


def _ends(low, high) -> str:
    """A range, or the one value that there is."""
    return " to ".join(f"{value:.6g}" for value in (low, high) if value is not None)


def _response(row) -> str:
    """A sensitivity: an elasticity to hundredths, a Sobol index with its error."""
    value, error = row["sensitivity"], row["error"] or 0.0
    if abs(value) < NEGLIGIBLE:
        return "0"
    if row["measure"] == "elasticity":
        return rounded(value, max(error, NEGLIGIBLE))
    return with_error(value, max(error, NEGLIGIBLE))


def _exponent(value) -> int:
    return math.floor(math.log10(abs(value)))


def _key(row) -> tuple[str, ...]:
    """The curve of a row, free of the rounding of files."""
    return tuple("" if row[a.column] is None else f"{row[a.column]:.9g}" for a in CONDITION_AXES)


def _curves(rows):
    """Rows by curve: figures share some."""
    groups: dict[tuple, list] = {}
    for row in sorted(rows, key=lambda row: [row[name] for name in ORDER]):
        groups.setdefault(_key(row), []).append(row)
    return groups.items()


def _by_curve(printed) -> dict[tuple, dict]:
    """Printed numbers by curve and quantity."""
    numbers: dict[tuple, dict] = {}
    for row in printed:
        numbers.setdefault(_key(row), {}).setdefault(row["quantity"], row)
    return numbers


def _curve_cells(rows) -> list[str]:
    figures = dict.fromkeys(
        str(int(row["figure"].removeprefix("fig"))) for row in rows if _numbered(row)
    )
    return [
        ", ".join(figures),
        *(_shown(axis.name, rows[0][axis.column]) for axis in CONDITION_AXES),
    ]


def _numbered(row) -> bool:
    return row["figure"].removeprefix("fig").isdigit()


def _shown(name, value) -> str:
    return f"{AXES[name].from_si(value):.6g}".replace("e+", "e")


def _condition(name, row) -> str:
    axis = AXES[name]
    if name == "viscosity" and row[axis.column] == 0.0:
        return "dry"
    return f"{axis.sign} = {_shown(name, row[axis.column])} {axis.unit}"


def _paper(numbers, quantity, unit=1.0) -> str:
    return _spread(numbers[quantity], unit) if quantity in numbers else ""


def _spread(number, unit=1.0) -> str:
    """A printed number and its tolerance, in ``unit``."""
    value, reach = number["value"] / unit, (number["high"] - number["low"]) / (2.0 * unit)
    return f"{value:.3g}{PLUS_MINUS}{reach:.2g}"
