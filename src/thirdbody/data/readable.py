"""Tables for reading: a row a curve, engineering units, the paper's numbers beside.

Programs read the CSV files of the same names, which hold every digit in SI.  Here a number has three
digits, or fewer where its error is larger than that.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from html import escape
from itertools import groupby
from pathlib import Path
from string import Template

from thirdbody.data.conditions import AXES, CONDITION_AXES, row_key

DIGITS = 3
NEGLIGIBLE = 0.005  # of an elasticity or a fraction of variance
LOAD_UNIT = 1e-6  # of F_t* in headings
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
CROSSINGS = {  # columns of the transitions: heading, quantity and level
    "Lₛ = 90 % [N]": ("solid_load_fraction", 0.9),
    "Lₛ = 3 % [N]": ("solid_load_fraction", 0.03),
    "Aₛₐ,ₜ* = 0.95 [N]": ("particle_contact_area_ratio", 0.95),
    "Aₛₐ,ₜ* = 0.05 [N]": ("particle_contact_area_ratio", 0.05),
}
ARROWS = {"rising": "↑ ", "falling": "↓ "}
FIGURES, PAPER, STATUS = "figures", "(paper)", "status"  # headings, PAPER the end of some


@dataclass(frozen=True)
class Sheet:
    """A table for reading: a title and a note above it, and rows of texts by their headings."""

    title: str
    note: str
    rows: Sequence[Mapping[str, str]]

    def table(self, style: str) -> str:
        """The rows in a ``style`` of tabulate."""
        from tabulate import tabulate

        return tabulate(self.rows, headers="keys", tablefmt=style, disable_numparse=True)


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
    return f"{rounded(value, error)} ± {rounded(error, digits=1)}"


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
    """The sheets of a ``table`` of ``READABLE`` from its ``rows`` and those of the table ``printed``;
    ``newtons_per_load`` is F_t/F_t* [N]."""
    return READABLE[table](rows, printed, newtons_per_load)


def markdown(sheets: Sequence[Sheet]) -> str:
    """Text of ``sheets``, one below the other, each with its caption as a first paragraph."""
    return "\n".join(
        f"{f'**{sheet.title}.** {sheet.note}'.rstrip()}\n\n{sheet.table('github')}\n"
        for sheet in sheets
    )


def page(sheets: Sequence[Sheet]) -> str:
    """HTML page of ``sheets``, one below the other; it needs no other file."""
    parts = [
        f"<p>{f'<strong>{escape(sheet.title)}.</strong> {escape(sheet.note)}'.rstrip()}</p>\n"
        f"{sheet.table('html')}"
        for sheet in sheets
    ]
    template = Template(Path(__file__).with_name("page.html").read_text(encoding="utf-8"))
    return template.substitute(title=escape(sheets[0].title), tables="\n".join(parts))


def _paper_table(title, rows, _printed, _newtons_per_load) -> list[Sheet]:
    """A table of the paper: printed and recomputed values side by side."""
    lines = [
        {
            **{name: row[name] for name in ("property", "symbol", "unit")},
            "printed": _ends(row["printed_low"], row["printed_high"]),
            "recomputed": _ends(row["recomputed_low"], row["recomputed_high"]),
            "verdict": row["verdict"],
            "remark": row["remark"] or "",
        }
        for row in rows
    ]
    return [Sheet(title, "Recomputed from the other printed values where that is possible.", lines)]


def _turning_points(rows, printed, newtons_per_load) -> list[Sheet]:
    lines = []
    for key, some in _curves(rows):
        row = some[0]
        load, error = row["load"], row["load_error"]
        paper = {
            number["quantity"]: number for number in reversed(printed) if row_key(number) == key
        }
        load_paper, ratio_paper, solid_paper = (
            _spread(paper.get(f"turning_point_{name}"), unit)
            for name, unit in (("load", LOAD_UNIT), ("ratio", 1.0), ("solid_load_fraction", 0.01))
        )
        lines.append(
            _curve_cells(some)
            | {
                "F_TPCA* [10⁻⁶]": rounded(load / LOAD_UNIT, error / LOAD_UNIT),
                f"F_TPCA* {PAPER}": load_paper,
                "F_TPCA [N]": rounded(load * newtons_per_load, error * newtons_per_load),
                "Aₛₐ,ₜ*": rounded(row["peak_ratio"]),
                f"Aₛₐ,ₜ* {PAPER}": ratio_paper,
                "Lₛ [%]": rounded(100.0 * row["solid_load_fraction"]),
                f"Lₛ {PAPER}": solid_paper,
                "d [nm]": rounded(row["separation_m"] / 1e-9),
                STATUS: _statuses(some),
            }
        )
    note = "A row is a curve. Beside the model's numbers stand the paper's, with their tolerances."
    return [_sheet_beside(printed, "Turning points of the contact area", note, lines)]


def _windows(rows, printed, _) -> list[Sheet]:
    lines: dict[float, dict] = {}
    sizes: dict[float, list] = {}
    for row in rows:
        roughness, end, ratio = (row[n] for n in ("roughness_m", "end", "diameter_over_roughness"))
        line = lines.setdefault(roughness, {"σ [nm]": _in_unit("roughness", roughness)})
        paper = [
            _spread(number)
            for number in printed
            if (number["quantity"], number["roughness_m"]) == (f"window_{end}", roughness)
        ]
        line[f"{end} end of xₐ/σ"] = rounded(ratio, row["error"])
        line[f"{end} end {PAPER}"] = "; ".join(dict.fromkeys(paper))
        size = rounded(ratio * roughness / 1e-9, row["error"] * roughness / 1e-9)
        sizes.setdefault(roughness, []).append(size)
    note = (
        "It occurs between two ends of xₐ/σ. Beside them stand the paper's, with their tolerances."
    )
    title = "Windows of the turning point in dry contact"
    rows = [line | {"xₐ [nm]": " to ".join(sizes[key])} for key, line in lines.items()]
    return [Sheet(title, note, rows)]


def _transitions(rows, printed, newtons_per_load) -> list[Sheet]:
    lines = []
    for key, some in _curves(rows):
        line = _curve_cells(some)
        for heading, crossing in CROSSINGS.items():
            found = {
                rounded(row["load"] * newtons_per_load): ARROWS[row["direction"]]
                for row in some
                if (row["quantity"], row["level"]) == crossing
            }
            paper = [
                f"(paper: {_spread(number, 1.0 / newtons_per_load)})"
                for number in printed
                if number["quantity"] == "load"
                and row_key(number) == key
                and (number["at_quantity"], number["at_level"]) == crossing
            ]
            line[heading] = ", ".join([arrow + load for load, arrow in found.items()] + paper)
        lines.append(line | {STATUS: _statuses(some)})
    note = "A row is a curve. ↓ the quantity falls with the load, ↑ it rises."
    return [_sheet_beside(printed, "Loads at which the regime or mode changes", note, lines)]


def _sensitivities(rows, _printed, _newtons_per_load) -> list[Sheet]:
    given = [row for row in rows if row["input"]]
    results = list(dict.fromkeys(map(result_name, given)))
    sheets = []
    for measure, title in MEASURES.items():
        cells = [
            ({"input": row["input"].replace("_", " ")}, result_name(row), _response(row))
            for row in given
            if row["measure"] == measure and row["sensitivity"] is not None
        ]
        note = f"0 stands for less than {NEGLIGIBLE:g}."
        sheets.append(Sheet(title, note, _pivoted(cells, results)))
    return sheets


def _chart(title, limited, below, beyond, rows, _printed, _newtons_per_load) -> list[Sheet]:
    """A design chart: a column a load, the range of the ensemble in brackets.

    ``limited`` is the axis that the limit is on; ``below`` and ``beyond`` stand for limits beyond
    either end of it.
    """

    def text(value) -> str:
        if math.isinf(value) or value == 0.0:
            return beyond if value else below
        return rounded(AXES[limited].from_si(value))

    def cell(row) -> str:
        ends = dict.fromkeys((text(row["low"]), text(row["high"])))
        status = _statuses([row])
        return f"{text(row['limit'])} ({' to '.join(ends)})" + (f", {status}" if status else "")

    held = [axis for axis in CONDITION_AXES if axis.column in rows[0]]
    loads = [f"{row['load_N']:g} N" for row in rows]
    conditions = [
        {_heading(axis): _in_unit(axis.name, row[axis.column]) for axis in held} for row in rows
    ]
    cells = zip(conditions, loads, map(cell, rows), strict=True)
    note = (
        "At the load of each column; in brackets between which values nine in ten members of "
        f"the calibrated ensemble lie. none, all: of the {limited.replace('_', ' ')} values in "
        "the atlas."
    )
    return [Sheet(title, note, _pivoted(cells, loads))]


READABLE: dict[str, Callable[..., list[Sheet]]] = {
    "table1": partial(
        _paper_table, "Table 1. Properties of the materials, as printed and recomputed"
    ),
    "table2": partial(_paper_table, "Table 2. Operating conditions, as printed and recomputed"),
    "tpca_loads": _turning_points,
    "tpca_windows": _windows,
    "transitions": _transitions,
    "sensitivity": _sensitivities,
    "largest_particle": partial(
        _chart,
        "Largest particles that stay out of the particle-surface mode [nm]",
        "particle_diameter",
        "none",
        "all",
    ),
    "least_viscosity": partial(
        _chart,
        "Least viscosity that leaves boundary lubrication [cSt]",
        "viscosity",
        "all",
        "none",
    ),
}


def _pivoted(cells, columns) -> list[dict[str, str]]:
    """One row for the ``cells`` (first columns, further column, text) that share the first columns."""
    lines: dict[tuple, dict] = {}
    for first, column, text in cells:
        line = lines.setdefault(tuple(first.values()), first | dict.fromkeys(columns, ""))
        line[column] = text
    return [*lines.values()]


def _sheet_beside(printed, title, note, lines) -> Sheet:
    """A table of curves, without columns that are empty because nothing is printed of the curves, or
    because all have converged."""
    if not lines:
        return Sheet(title, "There are none.", [])
    kept = [
        name
        for name in lines[0]
        if (printed or not (name == FIGURES or name.endswith(PAPER)))
        and (name != STATUS or any(line[STATUS] for line in lines))
    ]
    return Sheet(title, note, [{name: line[name] for name in kept} for line in lines])


def _curves(rows):
    """Rows by curve, some of which figures share."""
    names = "roughness", "particle_diameter", "particle_density", "viscosity"
    ordered = sorted(rows, key=lambda row: [row[AXES[name].column] for name in names])
    return [(key, [*some]) for key, some in groupby(ordered, key=row_key)]


def _curve_cells(rows) -> dict[str, str]:
    numbers = dict.fromkeys(row["figure"].removeprefix("fig") for row in rows)
    figures = ", ".join(str(int(number)) for number in numbers if number.isdigit())
    conditions = {
        _heading(axis): _in_unit(axis.name, rows[0][axis.column]) for axis in CONDITION_AXES
    }
    return {FIGURES: figures} | conditions


def _heading(axis) -> str:
    return f"{axis.sign} [{axis.unit}]"


def _in_unit(name, value) -> str:
    return f"{AXES[name].from_si(value):.6g}".replace("e+", "e")


def _condition(name, row) -> str:
    axis = AXES[name]
    if name == "viscosity" and row[axis.column] == 0.0:
        return "dry"
    return f"{axis.sign} = {_in_unit(name, row[axis.column])} {axis.unit}"


def _statuses(rows) -> str:
    """Statuses of some points, except of those that have converged."""
    statuses = dict.fromkeys(row["solution_status"] for row in rows)
    return ", ".join(each.replace("_", " ") for each in statuses if each != "converged")


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


def _spread(number, unit=1.0) -> str:
    """A printed number and its tolerance, in ``unit``; empty if there is none."""
    if number is None:
        return ""
    value, reach = number["value"] / unit, (number["high"] - number["low"]) / (2.0 * unit)
    return f"{value:.3g} ± {reach:.2g}"


def _exponent(value) -> int:
    return math.floor(math.log10(abs(value)))
