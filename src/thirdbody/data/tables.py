"""Tidy tables: one description of columns makes the CSV, its Table Schema, Markdown and LaTeX."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike

from thirdbody.data.conditions import CONDITION_AXES


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Attributes
    ----------
    name : str
        Heading; it ends with the SI unit where there is one.
    kind : str
        Type of the Table Schema: ``number`` or ``string``.
    unit : str
        SI unit, ``1`` of a pure number, empty of a text.
    description : str
        What stands in it, for the Table Schema.
    """

    name: str
    kind: str
    unit: str
    description: str

    def parse(self, texts: Iterable[str]) -> list[float | str | None]:
        """The values that fields of a CSV file stand for; None where one is empty."""
        value = float if self.kind == "number" else str
        return [None if text == "" else value(text) for text in texts]

    def format(self, value: float | str | None, digits: int) -> str:
        """Text of ``value``, a number with so many significant digits; empty for None."""
        if value is None:
            return ""
        return f"{value:.{digits}g}" if self.kind == "number" else str(value)


CONDITIONS = {
    axis.name: Column(axis.column, "number", axis.units, axis.description)
    for axis in CONDITION_AXES
}
CURVE = (  # what tells one curve from another
    Column("figure", "string", "", "figure of the paper whose curves these are"),
    *CONDITIONS.values(),
)
# Columns of the CSV file beside a figure: the points that it draws.
DRAWN_POINTS = (
    Column("panel", "string", "", "letter of the panel"),
    Column("curve", "string", "", "label of the curve"),
    Column("x_name", "string", "", "quantity along x"),
    Column("x", "number", "", "its value, in SI units"),
    Column("y_name", "string", "", "quantity along y"),
    Column("y", "number", "", "its value, in SI units"),
)
POINT_CLASS = (
    Column("medium", "string", "", "dry or lubricated"),
    Column("bodies", "string", "", "two_body or three_body"),
    Column("span", "string", "", "usual: the ranges of Table 2; or extremes"),
)
METHOD = Column("method", "string", "", "library, or the baseline that it is measured against")
RTOL = Column("rtol", "number", "1", "relative error asked for; empty: a method that is not asked")
POINT_COST = Column("microseconds_per_point", "number", "us", "time over the number of points")
STATUS_THERE = Column(
    "solution_status",
    "string",
    "",
    "how to take the values, as in the datasets: status of the point",
)
LIMIT = (  # of a design chart
    Column("load_N", "number", "N", "normal load F_t"),
    Column("load", "number", "1", "F_t* of the default inputs"),
    Column("limit", "number", "SI", "the limit under the default inputs; 0, inf: beyond the atlas"),
    Column("low", "number", "SI", "quantile of 5 % of the calibrated ensemble"),
    Column("median", "number", "SI", "its median"),
    Column("high", "number", "SI", "its quantile of 95 %"),
    Column(
        "solution_status",
        "string",
        "",
        "status of the atlas's point next to the limit; of its last one where the limit is not known",
    ),
)
TABLES = {
    "largest_particle": (
        *(CONDITIONS[name] for name in ("viscosity", "roughness", "particle_density")),
        *LIMIT,
    ),
    "least_viscosity": (
        *(CONDITIONS[name] for name in ("particle_diameter", "roughness", "particle_density")),
        *LIMIT,
    ),
    "tpca_loads": (
        *CURVE,
        Column("load", "number", "1", "F_TPCA*, load of the turning point over A_n E_ss"),
        Column("load_error", "number", "1", "bound on the numerical error of load"),
        Column("peak_ratio", "number", "1", "A_sa,t* at the turning point"),
        Column("solid_load_fraction", "number", "1", "L_s at the turning point"),
        Column("separation_m", "number", "m", "mean separation d at the turning point"),
        STATUS_THERE,
    ),
    "transitions": (
        *CURVE,
        Column("quantity", "string", "", "solid_load_fraction or particle_contact_area_ratio"),
        Column("level", "number", "1", "limit of the regime or mode that the quantity crosses"),
        Column("direction", "string", "", "rising or falling with the load"),
        Column("load", "number", "1", "F_t* of the crossing"),
        Column("load_error", "number", "1", "bound on the numerical error of load"),
        STATUS_THERE,
    ),
    "tpca_windows": (
        CONDITIONS["roughness"],
        CONDITIONS["particle_density"],
        Column("end", "string", "", "low or high end of the range of x_a/sigma"),
        Column("diameter_over_roughness", "number", "1", "x_a/sigma at the end"),
        Column("error", "number", "1", "bound on its numerical error"),
    ),
    "printed": (
        Column("id", "string", "", "name of the statement in config/claims.yaml"),
        Column("figure", "string", "", "figure that the number belongs to; empty: to none alone"),
        *CONDITIONS.values(),
        Column("quantity", "string", "", "what the number is"),
        Column("extreme", "string", "", "minimum or maximum over the loads; empty: neither"),
        Column("at_quantity", "string", "", "what has at_level where the number is taken"),
        Column("at_level", "number", "1", "value of at_quantity"),
        Column("load_max", "number", "1", "largest F_t* of which the paper speaks; empty: any"),
        Column("load_max_N", "number", "N", "largest F_t of which the paper speaks; empty: any"),
        Column("value", "number", "1", "the number"),
        Column("low", "number", "1", "the number less its tolerance"),
        Column("high", "number", "1", "the number and its tolerance"),
    ),
    "paper_table": (
        Column("property", "string", "", "row of the paper's table"),
        Column("symbol", "string", "", "the paper's symbol"),
        Column("unit", "string", "", "unit of the four numbers"),
        Column("printed_low", "number", "unit", "printed value, or low end of the printed range"),
        Column("printed_high", "number", "unit", "high end of the printed range"),
        Column("recomputed_low", "number", "unit", "the same from the other printed values"),
        Column("recomputed_high", "number", "unit", "the same from the other printed values"),
        Column("verdict", "string", "", "agrees, differs, or an input that nothing recomputes"),
        Column("remark", "string", "", "how it is recomputed, what differs"),
    ),
    "claims": (
        Column("id", "string", "", "name of the statement in config/claims.yaml"),
        Column("place", "string", "", "where the paper states it"),
        Column("statement", "string", "", "the statement in our own words"),
        Column("quote", "string", "", "the statement in the paper's words, formulas in TeX"),
        Column("kind", "string", "", "kind of statement, which decides how it is checked"),
        Column("curves", "string", "", "the curves, loads, and what the curves are held against"),
        Column(
            "published", "string", "", "what the paper says, where it says a number or sequence"
        ),
        Column("computed", "string", "", "what the model gives"),
        Column("value", "number", "1", "the computed number that is farthest off"),
        Column("range_low", "number", "1", "low end of its range over 90 % of the ensemble"),
        Column("range_high", "number", "1", "high end of its range over 90 % of the ensemble"),
        Column("deviation", "number", "1", "its deviation, a fraction if the tolerance is one"),
        Column("tolerance", "number", "1", "what still counts as agreement"),
        Column("tolerance_kind", "string", "", "relative: a fraction; absolute: in SI units"),
        Column("score", "number", "1", "tolerances off up to 1, then 1 + their logarithm"),
        Column("verdict", "string", "", "holds, fails, not tested, contradicted by the paper"),
        Column("predicted", "string", "", "the verdict if its figure is left out of the search"),
        Column("ensemble_agree", "number", "1", "members of the ensemble with the same outcome"),
        Column("ensemble_size", "number", "1", "members of the ensemble"),
        Column("readings_agree", "number", "1", "readings whose best inputs give the same outcome"),
        Column("readings_size", "number", "1", "calibrated readings"),
        Column("cluster", "string", "", "name in common of statements that repeat one another"),
        Column("contradicts", "string", "", "statements of the paper that say the opposite"),
    ),
    "sensitivity": (
        Column("measure", "string", "", "elasticity, or sobol_total: total Sobol index"),
        Column("output", "string", "", "the result that responds"),
        *CONDITIONS.values(),
        Column("quantity", "string", "", "of a transition: what crosses the limit"),
        Column("level", "number", "1", "of a transition: the limit"),
        Column("value", "number", "1", "the result at the default inputs; empty: does not occur"),
        Column("occurs", "number", "1", "share of the solved sets of inputs in which it occurs"),
        Column("unexplained", "number", "1", "share of its variance lost by the response surface"),
        Column("input", "string", "", "the unpublished input, as in config/inputs.yaml"),
        Column("input_value", "number", "SI", "its default"),
        Column("sensitivity", "number", "1", "d ln(result)/d ln(input), or the total index"),
        Column("error", "number", "1", "what twice the step changes, or half the 95 % interval"),
    ),
    "atlas_cost": (
        Column("chunk", "string", "", "file of the atlas"),
        Column("conditions", "number", "1", "combinations of the five axes"),
        Column("points", "number", "1", "these for each set of inputs that is solved"),
        RTOL,
        Column("solving_seconds", "number", "s", "processor time of the solver, tables included"),
        Column(
            "searching_seconds",
            "number",
            "s",
            "processor time of the search for limits and turning points",
        ),
        Column("seconds", "number", "s", "processor time of the job"),
        Column("clock_seconds", "number", "s", "time of the job on the clock, without its imports"),
        Column("resident_memory_MB", "number", "MB", "most memory of the process"),
        Column("file_MB", "number", "MB", "size of the file"),
    ),
    "errors": (
        METHOD,
        RTOL,
        *POINT_CLASS,
        Column("variable", "string", "", "variable whose errors these are"),
        Column("points", "number", "1", "points known in multiple precision"),
        Column("unsolved", "number", "1", "those for which the method gives no number"),
        Column("beyond_rtol", "number", "1", "solved points whose relative error is above rtol"),
        Column("largest_error", "number", "1", "largest relative error of the solved points"),
        Column("percentile_99_error", "number", "1", "99th percentile of these errors"),
    ),
    "oracle": (
        Column(
            "place", "string", "", "where points are drawn: anywhere, or next to kinks of F_s(d)"
        ),
        RTOL,
        Column("points", "number", "1", "points compared with extended precision"),
        Column("without_values", "number", "1", "those that have no values, here or there"),
        Column("not_converged", "number", "1", "those with values and the status not_converged"),
        Column("beyond_bound", "number", "1", "those with an error above error_bound"),
        Column(
            "wrong",
            "number",
            "1",
            "those with a good status and an error above rtol, a false number of separations, or none",
        ),
        Column(
            "largest_error", "number", "1", "largest relative error of those with a good status"
        ),
    ),
    "times": (
        METHOD,
        RTOL,
        *POINT_CLASS,
        Column("points", "number", "1", "points solved as one array, or one by one"),
        POINT_COST,
    ),
    "uses": (
        Column("use", "string", "", "what is timed"),
        Column("points", "number", "1", "points solved"),
        RTOL,
        Column("seconds", "number", "s", "time of all; on the clock for files and new processes"),
        POINT_COST,
        Column("resident_memory_MB", "number", "MB", "most memory of the process until then"),
    ),
    "extremes": (
        Column("item", "string", "", "what is extreme"),
        Column("case", "string", "", "how far, and in which contact"),
        Column("origin", "string", "", "how the right answer is known"),
        RTOL,
        Column("expected_status", "string", "", "solution_status of the right answer"),
        Column("status", "string", "", "solution_status that the library gives"),
        Column("largest_error", "number", "1", "largest relative error of all variables"),
        Column("variable", "string", "", "variable that has it"),
        Column("verdict", "string", "", "right; refused, and why; or wrong"),
    ),
    "targets": (
        Column("what", "string", "", "what is measured, and in which unit"),
        Column("sense", "string", "", "at least or at most"),
        Column("target", "number", "1", "what it should be"),
        Column("measured", "number", "1", "what it is in this run"),
        Column("verdict", "string", "", "reached or missed"),
    ),
}


def write_csv(path: str | PathLike, rows: Iterable[Mapping], columns: Sequence[Column]) -> None:
    """Write a table as CSV, numbers with ten significant digits.

    Parameters
    ----------
    path : path
        File to write.
    rows : iterable of Mapping
        A value, or None, for the name of each column.
    columns : sequence of Column
        Columns, in order: one of ``TABLES``.
    """
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([column.name for column in columns])
        for row in rows:
            writer.writerow([column.format(row[column.name], 10) for column in columns])


def read_csv(path: str | PathLike, columns: Sequence[Column]) -> list[dict]:
    """Rows of a table of ``write_csv``: a value, or None, for the name of each column.

    Raises
    ------
    OSError
        If the file is damaged or has other columns: one line names it.
    """
    names = [column.name for column in columns]
    try:
        with open(path, encoding="utf-8", newline="") as stream:
            header, *lines = csv.reader(stream)
        if header != names:
            raise ValueError(f"its columns are {header}")
        fields = zip(header, *lines, strict=True)
        values = [column.parse(each[1:]) for column, each in zip(columns, fields, strict=True)]
        return [dict(zip(names, row, strict=True)) for row in zip(*values, strict=True)]
    except (ValueError, csv.Error) as error:
        reason = " ".join(str(error).split())
        raise OSError(
            f"{path} cannot be read ({reason}); remake it: snakemake -c2 --force {path}"
        ) from None


def write_schema(path: str | PathLike, columns: Sequence[Column]) -> None:
    """Write the Table Schema (Frictionless) of ``columns``, as JSON."""
    fields = [
        {
            "name": column.name,
            "type": column.kind,
            "description": column.description + (f" [{column.unit}]" if column.unit else ""),
        }
        for column in columns
    ]
    with open(path, "w", encoding="utf-8") as stream:
        json.dump({"fields": fields, "missingValues": [""]}, stream, indent=2)
        stream.write("\n")


def write_text(
    path: str | PathLike, rows: Iterable[Mapping], columns: Sequence[Column], style: str
) -> None:
    """Write a table for reading, numbers with six significant digits.

    The arguments are those of ``write_csv``; ``style`` is ``github`` or ``latex_booktabs``.
    """
    from tabulate import tabulate

    cells = [[column.format(row[column.name], 6) for column in columns] for row in rows]
    headers = [column.name for column in columns]
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(tabulate(cells, headers, tablefmt=style, disable_numparse=True) + "\n")
