"""Tables for reading, as HTML and LaTeX: one row per curve, in engineering units, beside the numbers of the paper."""

import math
import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from html import escape
from itertools import groupby
from pathlib import Path
from statistics import fmean, median
from string import Template
from typing import NamedTuple

from tabulate import tabulate

from thirdbody.curves import row_key
from thirdbody.paper.typeset import html, latex
from thirdbody.variables import AXES, CONDITION_AXES

DIGITS = 3
NEGLIGIBLE = 0.005  # of an elasticity
LOAD_UNIT = 1e-6  # of F_t* in headings
RESULTS = {
    "turning_point_load": "turning point: load",
    "turning_point_ratio": "turning point: Aₛₐ,ₜ*",
    "window_low": "window: low end",
    "window_high": "window: high end",
    "solid_load_fraction": "load where Lₛ = {:.0%}",
    "particle_contact_area_ratio": "load where Aₛₐ,ₜ* = {:g}",
}
CROSSINGS = {  # columns of the transitions: heading, quantity and level
    "Lₛ = 90 % [N]": ("solid_load_fraction", 0.9),
    "Lₛ = 3 % [N]": ("solid_load_fraction", 0.03),
    "Aₛₐ,ₜ* = 0.95 [N]": ("particle_contact_area_ratio", 0.95),
    "Aₛₐ,ₜ* = 0.05 [N]": ("particle_contact_area_ratio", 0.05),
}
NEWTONS = "Newtons are F_t* A_n E_ss of the inputs: the paper prints no A_n."
ARROWS = {"rising": "↑ ", "falling": "↓ "}
HEADING = re.compile(r"(.+) \[(.+)\]")  # a name and its unit
UNITS_IN_LATEX = {
    "nm": r"\nm",
    "cSt": "cSt",
    "N": r"\N",
    "%": r"\percent",
    "m-2": r"\per\m\squared",
}
NUMBER = re.compile(r"[+-]?[0-9.]+(e-?[0-9]+)?( ± [0-9.]+)?")
DOCUMENT = r"""% needs \usepackage{{booktabs, longtable, siunitx}} and \sisetup{{separate-uncertainty}}
\begin{{longtable}}{{{columns}}}
\caption{{{title}. {note}}}\label{{tab:{label}}}\\
\toprule
{headings}
\midrule
\endhead
\bottomrule
\endfoot
{rows}
\end{{longtable}}
"""


class Sheet(NamedTuple):
    """A table for reading: title, note, and rows of texts by heading."""

    title: str
    note: str
    rows: Sequence[Mapping[str, str]]

    def html(self) -> str:
        """The rows as HTML, with subscripts and powers of ten."""
        rows = [{html(name): html(text) for name, text in row.items()} for row in self.rows]
        return tabulate(rows, headers="keys", tablefmt="unsafehtml", disable_numparse=True)

    def latex(self, label: str) -> str:
        """The table for LaTeX, with its caption and ``label``; columns of numbers are those of siunitx."""
        names = [*self.rows[0]] if self.rows else []
        numeric = {name: all(map(_is_number, (row[name] for row in self.rows))) for name in names}
        lines = [
            " & ".join(_latex_cell(text, numeric[name]) for name, text in row.items())
            for row in self.rows
        ]
        return DOCUMENT.format(
            columns="".join("S" if numeric[name] else "l" for name in names) or "l",
            title=latex(self.title),
            note=latex(self.note),
            label=label,
            headings=" & ".join(map(_latex_heading, names)) + r" \\",
            rows="\n".join(rf"{line} \\" for line in lines),
        )


def rounded(value: float | None, error: float = 0.0, digits: int = DIGITS) -> str:
    """``value`` with ``digits`` significant digits, or fewer if its ``error`` is larger; None (missing)
    gives an empty text, and nan (does not exist) gives "none"."""
    if value is None:
        return ""
    if math.isnan(value):
        return "none"
    if value == 0.0:
        return "0"
    places = digits - 1 - int(f"{value:.{digits - 1}e}".partition("e")[2])
    if error > 0.0:
        places = min(places, -math.floor(math.log10(error)))
    return f"{round(value, places) + 0.0:.{max(places, 0)}f}"


def result_name(row: Mapping) -> str:
    """The result in a row of the table ``sensitivity``, with the condition that distinguishes it."""
    name = RESULTS[row["quantity"] or row["output"]].format(row["level"]).replace("%", " %")
    varied = {"window": "roughness", "turning": "viscosity", "transition": "particle_diameter"}
    axis = AXES[varied[row["output"].partition("_")[0]]]
    value = row[axis.column]
    if axis.name == "viscosity" and value == 0.0:
        return f"{name}, dry"
    return f"{name}, {axis.sign} = {_in_unit(axis.name, value)} {axis.alias_unit}"


def readable(
    table: str, rows: Sequence[Mapping], printed: Sequence[Mapping], newtons_per_load: float
) -> list[Sheet]:
    """The sheets of a ``table`` of ``READABLE`` from its ``rows`` and those of the table
    ``printed``, without empty columns; ``newtons_per_load`` is F_t/F_t* [N]."""
    sheets = []
    for title, note, lines in READABLE[table](rows, printed, newtons_per_load):
        kept = [name for name in lines[0] if any(line[name] for line in lines)] if lines else []
        filled = [{name: line[name] for name in kept} for line in lines]
        sheets.append(Sheet(title, note if lines else "There are none.", filled))
    return sheets


def page(sheets: Sequence[Sheet]) -> str:
    """A self-contained HTML page of ``sheets``, one below the other."""
    parts = (
        f"<p><strong>{html(each.title)}.</strong> {html(each.note)}</p>\n{each.html()}"
        for each in sheets
    )
    template = Template(Path(__file__).with_name("sheets.html").read_text(encoding="utf-8"))
    return template.substitute(title=escape(sheets[0].title), tables="\n".join(parts))


def latex_text(table: str, sheets: Sequence[Sheet]) -> str:
    """The ``sheets`` of a ``table`` for LaTeX, one below the other."""
    labels = [table, *(f"{table}-{number}" for number in range(2, len(sheets) + 1))]
    return "\n".join(sheet.latex(label) for sheet, label in zip(sheets, labels, strict=True))


def _is_number(text):
    return text in ("", "none") or NUMBER.fullmatch(text) is not None


def _latex_cell(text, numeric):
    """A number as siunitx reads it, or a text."""
    if numeric and NUMBER.fullmatch(text):
        return text.replace("±", r"\pm")
    return f"{{{latex(text)}}}" if numeric and text else latex(text)


def _latex_heading(name):
    """A heading, with its unit by siunitx; in braces, so that it is not read as a number."""
    parts = HEADING.fullmatch(name)
    if parts is None:
        return f"{{{latex(name)}}}"
    unit = UNITS_IN_LATEX.get(parts[2])
    in_unit = rf"\unit{{{unit}}}" if unit else latex(parts[2])
    return f"{{{latex(parts[1])} [{in_unit}]}}"


def _paper_table(title, rows, _printed, _newtons_per_load) -> list[Sheet]:
    """A table of the paper, with printed and recomputed values side by side."""
    lines = [
        {name: row[name] for name in ("property", "symbol", "unit")}
        | {name: _range(row, name) for name in ("printed", "recomputed")}
        | {"verdict": row["verdict"], "remark": row["remark"] or ""}
        for row in rows
    ]
    title += ", as printed and recomputed"
    return [Sheet(title, "Recomputed from the other printed values where possible.", lines)]


def _turning_points(rows, printed, newtons_per_load) -> list[Sheet]:
    lines = []
    ratio, solid = "turning_point_ratio", "turning_point_solid_load_fraction"
    for curve, some, paper in _curves(rows, printed):
        row = some[0]
        load, error = row["load"], row["load_error"]
        lines.append(
            curve
            | {
                "F_TPCA* [10⁻⁶]": rounded(load / LOAD_UNIT, error / LOAD_UNIT),
                "F_TPCA* (paper)": _spread(paper, LOAD_UNIT, quantity="turning_point_load"),
                "F_TPCA [N]": rounded(load * newtons_per_load, error * newtons_per_load),
                "Aₛₐ,ₜ*": rounded(row["peak_ratio"]),
                "Aₛₐ,ₜ* (paper)": _spread(paper, quantity=ratio),
                "Lₛ [%]": rounded(100.0 * row["solid_load_fraction"]),
                "Lₛ (paper)": _spread(paper, 0.01, quantity=solid),
                "d [nm]": rounded(row["separation_m"] / 1e-9),
                "status": _statuses(some),
            }
        )
    note = f"Each row is a curve. Numbers of the paper are given with their tolerances. {NEWTONS}"
    return [Sheet("Turning points of the contact area", note, lines)]


def _windows(rows, printed, _newtons_per_load) -> list[Sheet]:
    lines = []
    for roughness, ends in groupby(rows, key=lambda row: row["roughness_m"]):
        line, sizes = {"σ [nm]": _in_unit("roughness", roughness)}, []
        for row in ends:
            end, ratio, error = (row[n] for n in ("end", "diameter_over_roughness", "error"))
            paper = _spread(printed, quantity=f"window_{end}", roughness_m=roughness)
            line |= {f"{end} end of xₐ/σ": rounded(ratio, error), f"{end} end (paper)": paper}
            sizes.append(rounded(ratio * roughness / 1e-9, error * roughness / 1e-9))
        lines.append(line | {"xₐ [nm]": " to ".join(sizes)})
    note = "Turning points occur between two ends of xₐ/σ. Ends of the paper have their tolerances."
    return [Sheet("Windows of the turning point in dry contact", note, lines)]


def _transitions(rows, printed, newtons_per_load) -> list[Sheet]:
    lines = []
    for line, some, paper in _curves(rows, printed):
        for heading, (quantity, level) in CROSSINGS.items():
            found = {
                rounded(row["load"] * newtons_per_load): ARROWS[row["direction"]]
                for row in some
                if (row["quantity"], row["level"]) == (quantity, level)
            }
            texts = [arrow + load for load, arrow in found.items()]
            at = {"quantity": "load", "at_quantity": quantity, "at_level": level}
            spread = _spread(paper, 1.0 / newtons_per_load, **at)
            published = f"(paper: {spread})" if spread else ""
            line[heading] = f"{', '.join(texts)} {published}".strip()
        lines.append(line | {"status": _statuses(some)})
    note = (
        "Each row is a curve. ↓: the quantity decreases with the load, ↑: it increases. Without an entry "
        f"it does not cross the limit within the loads. {NEWTONS}"
    )
    return [Sheet("Loads at which the regime or mode changes", note, lines)]


def _sensitivities(rows, _printed, _newtons_per_load) -> list[Sheet]:
    cells = [
        ({"input": row["input"].replace("_", " ")}, result_name(row), _elasticity(row))
        for row in rows
        if row["elasticity"] is not None
    ]
    title = "Sensitivities: elasticities, d ln(result)/d ln(input)"
    return [Sheet(title, f"0 means less than {NEGLIGIBLE:g}.", _pivoted(cells))]


def _chart(title, limited, below, beyond, rows, _printed, _newtons_per_load) -> list[Sheet]:
    """A design chart: one column per load, with the ensemble range in brackets; ``below`` and
    ``beyond`` are the texts for limits outside the ends of the axis ``limited``."""
    outside = {0.0: below, math.inf: beyond}
    held = [axis for axis in CONDITION_AXES if axis.column in rows[0]]
    cells = []
    for row in rows:
        limit, *ends = (
            outside.get(row[name]) or rounded(AXES[limited].from_si(row[name]))
            for name in ("limit", "low", "high")
        )
        texts = f"{limit} ({' to '.join(dict.fromkeys(ends))})", _statuses([row])
        cells.append(
            (_conditions(row, held), f"{row['load_N']:g} N", ", ".join(filter(None, texts)))
        )
    note = (
        "At the load of each column, with the range, 5 to 95 % of the calibrated ensemble, in "
        f"brackets. none, all: of the {limited.replace('_', ' ')} values in the atlas."
    )
    return [Sheet(title, note, _pivoted(cells))]


def _deviations(rows, _printed, _newtons_per_load) -> list[Sheet]:
    sizes = sorted(abs(row["deviation"]) for row in rows)
    lines = [
        {
            "place": row["place"].removesuffix(", section 3.3"),
            "statement": row["statement"],
            "printed": _short(f"{row['printed']:.4g}"),
            "computed": "none" if row["computed"] is None else _short(f"{row['computed']:.4g}"),
            "deviation": f"{100.0 * row['deviation']:+.1f} %",
        }
        for row in rows
    ]
    note = (
        f"All numbers that the headline statements print. The median of the deviations is "
        f"{100.0 * median(sizes):.1f} %, the mean {100.0 * fmean(sizes):.1f} %. Ends of ranges of H_c are those from "
        "0.04 to 80 N."
    )
    return [Sheet("Printed numbers and computed ones", note, lines)]


def _departures(rows, _printed, _newtons_per_load) -> list[Sheet]:
    lines = [
        {
            "taken back": row["departure"],
            "inputs": row["inputs"] or "",
            "statements that hold": f"{row['holds']:g} of {row['judged']:g}",
            "headline": "" if row["headline"] is None else f"{row['headline']:g}",
            "median deviation": _percent(row["median_deviation"]),
            "mean deviation": _percent(row["mean_deviation"]),
        }
        for row in rows
    ]
    note = (
        "Each departure of the calibrated inputs from the words of the paper is taken back alone."
    )
    return [Sheet("What carries the agreement", note, lines)]


def _percent(fraction) -> str:
    return "" if fraction is None else f"{100.0 * fraction:.1f} %"


READABLE: dict[str, Callable[..., list[Sheet]]] = {
    "table1": partial(_paper_table, "Table 1. Properties of the materials"),
    "table2": partial(_paper_table, "Table 2. Operating conditions"),
    "tpca_loads": _turning_points,
    "tpca_windows": _windows,
    "transitions": _transitions,
    "sensitivity": _sensitivities,
    "deviations": _deviations,
    "departures": _departures,
    "largest_particle": partial(
        _chart,
        "Largest particles that avoid the particle-surface mode [nm]",
        *("particle_diameter", "none", "all"),
    ),
    "least_viscosity": partial(
        _chart,
        "Least viscosity that leaves boundary lubrication [cSt]",
        *("viscosity", "all", "none"),
    ),
}


def _pivoted(cells) -> list[dict[str, str]]:
    """One row for all ``cells`` (first columns, further column, text) with the same first columns."""
    columns = dict.fromkeys((column for _, column, _ in cells), "")
    lines: dict[tuple, dict] = {}
    for first, column, text in cells:
        lines.setdefault(tuple(first.values()), first | columns)[column] = text
    return [*lines.values()]


def _curves(rows, printed):
    """The cells of each curve, which several figures may share, its rows, and its printed numbers."""
    names = "roughness", "particle_diameter", "particle_density", "viscosity"
    ordered = sorted(rows, key=lambda row: [row[AXES[name].column] for name in names])
    for key, group in groupby(ordered, key=row_key):
        some = [*group]
        numbers = dict.fromkeys(row["figure"].removeprefix("fig") for row in some)
        figures = ", ".join(str(int(number)) for number in numbers if number.isdigit())
        cells = {"figures": figures, **_conditions(some[0], CONDITION_AXES)}
        yield cells, some, [number for number in printed if row_key(number) == key]


def _conditions(row, axes) -> dict[str, str]:
    return {
        f"{axis.sign} [{axis.alias_unit}]": _in_unit(axis.name, row[axis.column]) for axis in axes
    }


def _in_unit(name, value) -> str:
    return _short(f"{AXES[name].from_si(value):.6g}")


def _statuses(rows) -> str:
    """Statuses of points that have not converged."""
    statuses = dict.fromkeys(row["solution_status"] for row in rows)
    return ", ".join(each.replace("_", " ") for each in statuses if each != "converged")


def _range(row, name) -> str:
    """A range in a row, or a single value."""
    ends = row[f"{name}_low"], row[f"{name}_high"]
    digits = 6 if name == "printed" else 4
    return " to ".join(_short(f"{value:.{digits}g}") for value in ends if value is not None)


def _short(text) -> str:
    """A number without the sign and the zero of an exponent."""
    return re.sub(r"e\+?(-?)0*", r"e\1", text)


def _elasticity(row) -> str:
    """An elasticity to hundredths."""
    value, error = row["elasticity"], max(row["error"] or 0.0, NEGLIGIBLE)
    return "0" if abs(value) < NEGLIGIBLE else rounded(value, error)


def _spread(printed, unit=1.0, **fields) -> str:
    """The printed numbers that have these ``fields``, with their tolerances, in ``unit``."""
    texts = {}
    for number in printed:
        if fields.items() <= number.items():
            value, low, high = (number[name] / unit for name in ("value", "low", "high"))
            is_even = math.isclose(high - value, value - low, rel_tol=1e-6)
            tolerance = f"± {high - value:.2g}" if is_even else f"({low:.3g} to {high:.3g})"
            texts[f"{value:.3g} {tolerance}"] = None
    return "; ".join(texts)
