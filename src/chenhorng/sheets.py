"""Sheets: tables for readers, in HTML and LaTeX, with numbers of the paper beside computed ones."""

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import groupby
from pathlib import Path
from statistics import fmean, median

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from chenhorng.claims.words import FAILS, HOLDS, NOT_TESTED, counted_once, number
from chenhorng.tables import TABLES
from thirdbody.core.film import has_film
from thirdbody.curves import row_key
from thirdbody.plotting.scales import ABSENT, note
from thirdbody.symbols import html, latex, short, unicode
from thirdbody.variables import AXES, CONDITION_AXES, QUANTITIES

DIGITS = 3
NEGLIGIBLE = 0.005  # smaller elasticities are shown as 0
LOAD_UNIT = 1e-6  # unit of F_t* in headings
RESULTS = {
    "turning_point_load": "turning point: load",
    "turning_point_ratio": "turning point: Aₛₐ,ₜ*",
    "window_low": "window: low end",
    "window_high": "window: high end",
    "solid_load_fraction": "load where Lₛ = {:.0%}",
    "particle_contact_area_ratio": "load where Aₛₐ,ₜ* = {:g}",
}
CROSSINGS = {  # columns of the transitions: quantity and level by symbol and limit
    ("Lₛ", "90 %"): ("solid_load_fraction", 0.9),
    ("Lₛ", "3 %"): ("solid_load_fraction", 0.03),
    ("Aₛₐ,ₜ*", "0.95"): ("particle_contact_area_ratio", 0.95),
    ("Aₛₐ,ₜ*", "0.05"): ("particle_contact_area_ratio", 0.05),
}
NEWTONS = "Newtons are F_t* A_n E_ss of the inputs: the paper prints no A_n."
ARROWS = {"rising": "↑", "falling": "↓"}
WORDS = ("", "none", ABSENT["viscosity"])  # words that a column of numbers may have
NUMBER = re.compile(r"[+-]?[0-9.]+(e-?[0-9]+)?( ± [0-9.]+)?")
DOCUMENT = r"""% needs \usepackage{{booktabs, longtable, siunitx}} and \sisetup{{separate-uncertainty}}
\begin{{longtable}}{{{columns}}}
\caption{{{title}. {note}}}\label{{tab:{label}}}\\
\toprule
{headings}
\midrule
\endfirsthead
\toprule
{headings}
\midrule
\endhead
\bottomrule
\endfoot
{rows}
\end{{longtable}}
"""


@dataclass(frozen=True, kw_only=True)
class Sheet:
    """A table for readers: title, note, and rows of texts by heading."""

    title: str
    note: str
    rows: Sequence[Mapping[str, str]]

    @cached_property
    def decimals(self) -> dict[str, int]:
        """The largest number of digits behind the point, for each column of numbers."""
        columns = {name: [row[name] for row in self.rows] for name in (self.rows or [{}])[0]}
        return {
            name: max(map(_decimals, texts))
            for name, texts in columns.items()
            if all(text in WORDS or NUMBER.fullmatch(text) for text in texts)
        }

    def padding(self, name: str, text: str) -> str:
        """The characters that a number lacks on its right.  With them the decimal points of a
        column are aligned."""
        missing = self.decimals.get(name, 0) - _decimals(text)
        if missing == 0 or text in WORDS or "e" in text:
            return ""
        return "0" * missing if _decimals(text) else "." + "0" * missing

    def html(self) -> str:
        """The table as a self-contained HTML page."""
        return ENVIRONMENT.get_template("sheets.html").render(sheet=self)

    def latex(self, label: str) -> str:
        """The table for LaTeX, with its caption and ``label``.  Columns of numbers are for siunitx."""
        names = [*self.rows[0]] if self.rows else []
        numeric = {name: name in self.decimals for name in names}
        lines = [
            " & ".join(
                _latex_cell(text, numeric[name], name == "symbol") for name, text in row.items()
            )
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
    """``value`` with ``digits`` significant digits, or fewer if its ``error`` is larger.  None, a
    missing value, is an empty text; nan, a value that does not exist, is "none"."""
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


def power(value: float | None) -> str:
    """``value`` with three significant digits, a small one with a power of ten: 0.210, 3.10e-6."""
    is_small = value is not None and 0.0 < abs(value) < 1e-3
    return short(f"{value:.{DIGITS - 1}e}") if is_small else rounded(value)


def result_name(row: Mapping) -> str:
    """The name of the result in a row of the table ``sensitivity``, with the condition that
    distinguishes the result."""
    name = RESULTS[row["quantity"] or row["output"]].format(row["level"]).replace("%", " %")
    varied = {"window": "roughness", "turning": "viscosity", "transition": "particle_diameter"}
    axis = AXES[varied[row["output"].partition("_")[0]]]
    return f"{name}, {note(axis.name, row[axis.column])}"


def sheet_of(
    table: str, rows: Sequence[Mapping], printed: Sequence[Mapping], newtons_per_load: float
) -> Sheet:
    """The sheet of a ``table`` of ``SHEETS``, without empty columns; its note says if it has no
    rows.

    ``rows`` are those of the table, ``printed`` those of the table ``printed``, and
    ``newtons_per_load`` is F_t/F_t* [N].
    """
    sheet = SHEETS[table](rows, printed, newtons_per_load)
    if not sheet.rows:
        return replace(sheet, note="There are none.")
    names = [name for name in sheet.rows[0] if any(row[name] for row in sheet.rows)]
    return replace(sheet, rows=[{name: row[name] for name in names} for row in sheet.rows])


def _decimals(text):
    """The digits behind the point of the last number in a text."""
    return 0 if "e" in text else len(text.rpartition(" ")[2].partition(".")[2])


def _latex_cell(text, numeric, is_symbol):
    """A cell for LaTeX: a number as siunitx reads it, or a text."""
    if numeric and NUMBER.fullmatch(text):
        return text.replace("±", r"\pm")
    return f"{{{latex(text)}}}" if numeric and text else latex(text, is_symbol)


def _latex_heading(name):
    """A heading in braces, so that siunitx does not read it as a number."""
    return f"{{{latex(name)}}}"


def _paper_table(title, rows, _printed, _newtons_per_load) -> Sheet:
    """A table of the paper, with printed and recomputed values side by side."""
    lines = [
        _headed(
            "paper_table",
            {name: row[name] for name in ("property", "symbol", "unit")}
            | {f"{name}_low": _range(row, name) for name in ("printed", "recomputed")}
            | {"verdict": row["verdict"], "remark": row["remark"] or ""},
        )
        for row in rows
    ]
    title += ", as printed and recomputed"
    note = (
        "Recomputed from the other printed values where possible. A value agrees if it is the "
        "printed one once it is rounded to as many digits as the paper prints."
    )
    return Sheet(title=title, note=note, rows=lines)


def _turning_points(rows, printed, newtons_per_load) -> Sheet:
    lines = []
    ratio, solid = "turning_point_ratio", "turning_point_solid_load_fraction"
    for curve, its_rows, paper in _curves(rows, printed):
        row = its_rows[0]
        load, error = row["load"], row["load_error"]
        texts = {
            "load": rounded(load / LOAD_UNIT, error / LOAD_UNIT),
            "normal_load_N": rounded(load * newtons_per_load, error * newtons_per_load),
            "peak_ratio": rounded(row["peak_ratio"]),
            "solid_load_fraction": rounded(100.0 * row["solid_load_fraction"]),
            "separation_m": rounded(row["separation_m"] / 1e-9),
            "solution_status": _statuses(its_rows),
        }
        beside = {
            "load": _with_tolerances(paper, LOAD_UNIT, quantity="turning_point_load"),
            "peak_ratio": _with_tolerances(paper, quantity=ratio),
            "solid_load_fraction": _with_tolerances(paper, 0.01, quantity=solid),
        }
        lines.append(curve | _headed("tpca_loads", texts, beside))
    note = f"Each row is a curve. Numbers of the paper are given with their tolerances. {NEWTONS}"
    return Sheet(title="Turning points of the contact area", note=note, rows=lines)


def _windows(rows, printed, _newtons_per_load) -> Sheet:
    lines = []
    for roughness, ends in groupby(rows, key=lambda row: row["roughness_m"]):
        line, sizes = {"σ [nm]": _in_unit("roughness", roughness)}, []
        for row in ends:
            end, ratio, error = (row[n] for n in ("end", "diameter_over_roughness", "error"))
            own: dict[str, object] = {"quantity": f"window_{end}", "roughness_m": roughness}
            paper = _with_tolerances(printed, **own)
            line |= {f"{end} end of xₐ/σ": rounded(ratio, error), f"{end} end (paper)": paper}
            inside = [n["low"] <= ratio <= n["high"] for n in printed if own.items() <= n.items()]
            line[f"{end} end misses"] = _miss(all(inside))
            sizes.append(rounded(ratio * roughness / 1e-9, error * roughness / 1e-9))
        lines.append(line | {"xₐ [nm]": " to ".join(sizes)})
    note = (
        "Turning points occur between two ends of xₐ/σ. Ends of the paper have their tolerances; ✗ "
        "marks an end outside of one."
    )
    return Sheet(title="Windows of the turning point in dry contact", note=note, rows=lines)


def _transitions(rows, printed, newtons_per_load) -> Sheet:
    lines = []
    for line, its_rows, paper in _curves(rows, printed):
        for (symbol, limit), (quantity, level) in CROSSINGS.items():
            for direction, arrow in ARROWS.items():
                loads = dict.fromkeys(
                    rounded(row["load"] * newtons_per_load)
                    for row in its_rows
                    if (row["quantity"], row["level"], row["direction"])
                    == (quantity, level, direction)
                )
                line[f"{symbol} {arrow} {limit} [N]"] = ", ".join(loads)
            at = {"quantity": "load", "at_quantity": quantity, "at_level": level}
            heading = f"{symbol} = {limit} (paper) [N]"
            line[heading] = _with_tolerances(paper, 1.0 / newtons_per_load, **at)
        lines.append(line | {"status": _statuses(its_rows)})
    note = (
        "Each row is a curve. ↓: the quantity falls to the limit, ↑: it rises to it. Without an "
        f"entry it does not cross the limit within the loads. {NEWTONS}"
    )
    return Sheet(title="Loads at which the regime or mode changes", note=note, rows=lines)


def _sensitivities(rows, _printed, _newtons_per_load) -> Sheet:
    known = [row for row in rows if row["elasticity"] is not None]
    results = dict.fromkeys(map(result_name, known), "")
    lines: dict[str, dict[str, str]] = {}
    for row in known:
        line = lines.setdefault(row["input"], {"input": row["input"].replace("_", " "), **results})
        line[result_name(row)] = _elasticity(row)
    title = "Sensitivities: elasticities, d ln(result)/d ln(input)"
    note = f"0 means less than {NEGLIGIBLE:g}."
    return Sheet(title=title, note=note, rows=[*lines.values()])


def _deviations(rows, _printed, _newtons_per_load) -> Sheet:
    sizes = sorted(abs(row["deviation"]) for row in rows)
    lines = [
        _headed(
            "deviations",
            {
                **_number_cells(row),
                "deviation": f"{100.0 * row['deviation']:+.1f} %".replace("-0.0", "0.0"),
                "inside": _miss(row["inside"] == "yes"),
            },
        )
        for row in rows
    ]
    note = (
        "The numbers of the headline statements alone: those by which interpretations of the "
        "equations are compared, as config/calibration.yaml names them. The page of statements has "
        "all others. ✗ marks numbers outside of their tolerances. The median of the deviations is "
        f"{100.0 * median(sizes):.1f} %, the mean {100.0 * fmean(sizes):.1f} %. Ends of ranges of "
        "H_c are those from 0.04 to 80 N."
    )
    return Sheet(
        title="Numbers of the headline statements, as printed and computed", note=note, rows=lines
    )


def _miss(is_inside: bool) -> str:
    """The mark of a number outside of its tolerance."""
    return "" if is_inside else "✗"


def _number_cells(row) -> dict[str, str]:
    """The cells of a printed number, and of the computed one."""
    computed = row["computed"]
    return {
        "place": row["place"].removesuffix(", section 3.3"),
        "statement": row["statement"],
        "printed": number(row["printed"], 4),
        "computed": "none" if computed is None else power(computed),
    }


def _departures(rows, _printed, _newtons_per_load) -> Sheet:
    lines = [
        _headed(
            "departures",
            {
                "departure": row["departure"],
                "inputs": (row["inputs"] or "").replace("_", " "),
                "holds": _of(row["holds"], row["judged"]),
                "headline": _of(row["headline"], row["headline_statements"]),
                "median_deviation": _percent(row["median_deviation"]),
                "mean_deviation": _percent(row["mean_deviation"]),
            },
        )
        for row in rows
    ]
    note = (
        "Each departure of the calibrated inputs from the words of the paper is taken back alone."
    )
    return Sheet(title="What carries the agreement", note=note, rows=lines)


def _held_out(rows, _printed, _newtons_per_load) -> Sheet:
    shown = "place", "quote", "statement", "curves", "finding", "figures", "verdict"
    lines = [_headed("own_claims", {name: row[name] or "" for name in shown}) for row in rows]
    names = [(row["cluster"] or row["id"], row["verdict"]) for row in rows]
    new = [name for name, row in zip(names, rows, strict=True) if not row["figures"]]
    held, tested = counted_once(names)
    untested = sum(row["verdict"] == NOT_TESTED for row in rows)
    left_out = f"{untested} cannot be tested within the loads of Table 2. " if untested else ""
    note = (
        "Other papers say this of the same model, and no search for inputs has seen it. "
        f"{held} of {tested} hold, repeats counted once; {_of(*counted_once(new))} where no figure "
        f"of the paper says the same. {left_out}Curves in an order must be apart by their tolerance "
        "somewhere."
    )
    return Sheet(title="Statements that no search has seen", note=note, rows=lines)


def _coverage(rows, _printed, _newtons_per_load) -> Sheet:
    lines = [
        {
            **_number_cells(row),
            "range without its figure": " to ".join(power(row[end]) for end in ("low", "high")),
            "inside": row["inside"],
        }
        for row in rows
    ]
    inside = sum(row["inside"] == "yes" for row in rows)
    # a number is printed twice if the same is computed for both
    once = counted_once(
        (row["computed"] or row["id"], HOLDS if row["inside"] == "yes" else FAILS)
        for row in rows
        if not row["low"] == row["printed"] == row["high"]
    )
    note = (
        f"Of {len(rows)} printed numbers {inside} lie within the range of the members of the "
        "ensemble that were fitted without their figure. Members differ from row to row, as each "
        "row leaves out the figure of its number. Where the range is the printed number alone, no "
        f"member misses it. Of the other numbers {_of(*once)} lie within. One that is printed "
        "twice counts once there, and must lie within both ranges."
        if rows
        else "The inputs of this run are not the calibrated ones, whose ensemble this table judges."
    )
    return Sheet(title="Printed numbers and ranges that have not seen them", note=note, rows=lines)


def _coverage_of_sets(rows, _printed, _newtons_per_load) -> Sheet:
    lines: dict[str, dict[str, str]] = {}
    for row in rows:
        line = lines.setdefault(row["set"], {"inputs": row["set"]})
        line[QUANTITIES[row["variable"]].symbol] = _percent(row["inside"] / row["conditions"])
    widths = {row["variable"]: row["relative_width"] for row in rows}
    texts = [f"{QUANTITIES[name].symbol} {_percent(width)}" for name, width in widths.items()]
    note = (
        "At how many random conditions of Table 2 other sets of inputs lie within the range of "
        f"the ensemble. Median width of the range: {', '.join(texts)}."
    )
    title = "Other sets of inputs within the range of the ensemble"
    return Sheet(title=title, note=note, rows=[*lines.values()])


def _profiles(rows, _printed, _newtons_per_load) -> Sheet:
    least: dict[str, float] = {}
    for row in rows:
        least[row["along"]] = min(row["objective"], least.get(row["along"], math.inf))
    lines = [
        {
            "held": row["along"].replace("_", " "),
            "W of": "F_t" if row["interpretation"].startswith("total") else "F_f",
            "level": short(f"{row['level']:.4g}"),
            "rise of the objective": f"{row['objective'] - least[row['along']]:.1f}",
        }
        for row in rows
    ]
    note = (
        "All other unknowns are fitted again at each level; the CSV file has them. The rise is above "
        "the least of the same quantity, as searches end at different heights."
    )
    return Sheet(title="Profiles of the objective", note=note, rows=lines)


def _apparent_area(rows, _printed, _newtons_per_load) -> Sheet:
    lines = []
    *of_areas, of_axis = rows
    for area, group in groupby(of_areas, key=lambda row: row["area_m2"]):
        *loads, of_all = group
        texts = {"area_m2": f"{1e6 * area:.2g}"}
        texts |= {
            f"{modulus}_low_m2": _from_to(of_all, f"{modulus}_{{}}_m2", 1e6)
            for modulus in ("printed_modulus", "material_modulus")
        }
        line = _headed("apparent_area", texts)
        for row in loads:
            printed, newtons = short(f"{row['printed']:g}"), f"{row['normal_load_N']:.3g}"
            heading = f"A_n E_ss by {printed}, {row['place']} [kN]"
            line[heading] = f"{_from_to(row, 'stiffness_{}_N', 1e-3)} for {newtons} N"
        lines.append(line | {name: of_all[name] or "" for name in ("verdict", "remark")})
    least = short(f"{of_axis['printed']:g}")
    note = (
        "F_t* = F_t/(A_n E_ss), and the printed loads of lubricated contact double from step to "
        "step. Each is rounded, which leaves A_n E_ss a range; the loads leave A_n a power of two. "
        f"The least W of Table 2 is printed as {least}: {of_axis['remark']}."
    )
    return Sheet(title="The apparent area from the printed loads", note=note, rows=lines)


def _limits(rows, _printed, _newtons_per_load) -> Sheet:
    lines = [
        {
            "quantity": f"{row['quantity']}, {row['condition']}",
            "value": rounded(row["value"]),
            "verdict": row["verdict"] or "",
            "low": rounded(row["low"]),
            "high": rounded(row["high"]),
            "remark": row["remark"] or "",
        }
        for row in rows
    ]
    note = (
        "Isotropic surfaces with Gaussian heights have α = 768 π (η_s R σ)² of at least 1.5 (Nayak "
        "1971), and summits that scatter less than they. The loads are those in W of printed film "
        "thicknesses, for the values of U that are rounded to the printed one."
    )
    return Sheet(title="What cannot be, and what digits leave open", note=note, rows=lines)


def _from_to(row, names, scale) -> str:
    """A range in a row, with four digits."""
    return " to ".join(f"{scale * row[names.format(end)]:.4g}" for end in ("low", "high"))


def _of(count, whole) -> str:
    return "" if count is None else f"{count:g} of {whole:g}"


def _percent(fraction) -> str:
    return "" if fraction is None else f"{100.0 * fraction:.1f} %"


SHEETS: dict[str, Callable[..., Sheet]] = {
    "table1": partial(_paper_table, "Table 1. Properties of the materials"),
    "table2": partial(_paper_table, "Table 2. Operating conditions"),
    "tpca_loads": _turning_points,
    "tpca_windows": _windows,
    "transitions": _transitions,
    "sensitivity": _sensitivities,
    "deviations": _deviations,
    "departures": _departures,
    "coverage": _coverage,
    "coverage_of_sets": _coverage_of_sets,
    "profiles": _profiles,
    "apparent_area": _apparent_area,
    "limits": _limits,
    "held_out": _held_out,
}


def _curves(rows, printed):
    """Yield for each curve its first cells, its rows, and its printed numbers.  Several figures may
    share a curve."""
    names = "roughness", "particle_diameter", "particle_density", "viscosity"
    ordered = sorted(rows, key=lambda row: [row[AXES[name].column] for name in names])
    for key, group in groupby(ordered, key=row_key):
        its_rows = [*group]
        numbers = dict.fromkeys(row["figure"].removeprefix("fig") for row in its_rows)
        figures = ", ".join(str(int(number)) for number in numbers if number.isdigit())
        cells = {"figures": figures}
        for axis in CONDITION_AXES:
            cells[f"{unicode(axis.symbol)} [{axis.alias_unit}]"] = _in_unit(
                axis.name, its_rows[0][axis.column]
            )
        yield cells, its_rows, [number for number in printed if row_key(number) == key]


def _headed(
    table: str, texts: Mapping[str, str], printed: Mapping[str, str] | None = None
) -> dict[str, str]:
    """The ``texts`` of columns of a ``table`` under their headings, and beside them the texts
    ``printed`` in the paper.
    """
    line = {}
    for column in TABLES[table]:
        if column.name in texts:
            heading = column.heading or column.name
            line[heading] = texts[column.name]
            if printed and column.name in printed:
                symbol, space, unit = heading.partition(" [")
                line[f"{symbol} (paper){space}{unit}"] = printed[column.name]
    return line


def _in_unit(name, value) -> str:
    if name == "viscosity" and not has_film(value):
        return ABSENT[name]
    return short(f"{AXES[name].from_si(value):.6g}")


def _statuses(rows) -> str:
    """The statuses of points that have not converged, as text."""
    statuses = dict.fromkeys(row["solution_status"] for row in rows)
    return ", ".join(word.replace("_", " ") for word in statuses if word != "converged")


def _range(row, name) -> str:
    """The ends of a range in a row, or a single value, as text."""
    ends = row[f"{name}_low"], row[f"{name}_high"]
    digits = 6 if name == "printed" else 4
    return " to ".join(short(f"{value:.{digits}g}") for value in ends if value is not None)


ENVIRONMENT = Environment(
    loader=FileSystemLoader(Path(__file__).parent),
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
    undefined=StrictUndefined,
)
ENVIRONMENT.filters["typeset"] = lambda *text: Markup(html(*text))


def _elasticity(row) -> str:
    """The elasticity in a row, rounded to hundredths."""
    value, error = row["elasticity"], max(row["error"] or 0.0, NEGLIGIBLE)
    return "0" if abs(value) < NEGLIGIBLE else rounded(value, error)


def _with_tolerances(printed, unit=1.0, **fields) -> str:
    """The ``printed`` numbers that have these ``fields``, with their tolerances, in ``unit``."""
    texts: dict[str, None] = {}
    for each in printed:
        if fields.items() <= each.items():
            value, low, high = (each[name] / unit for name in ("value", "low", "high"))
            is_even = math.isclose(high - value, value - low, rel_tol=1e-6)
            tolerance = f"± {high - value:.2g}" if is_even else f"({low:.3g} to {high:.3g})"
            texts[f"{value:.3g} {tolerance}"] = None
    return "; ".join(texts)
