"""Answers of the command: tables of quantities with their range over the ensemble.

The functions take the conditions of an interface, and return a table with a row for each quantity.
The columns are the ``symbol``, the ``quantity`` in words, the ``unit``, the ``value`` for the best
set, the ends ``low`` and ``high`` of the range, the number of ``members`` of the ensemble, and how
many of them ``agree``: they also have a number, or have the same state.  ``attrs`` has a title,
notes, and ``found``: whether the question has an answer.
"""

import math
import textwrap
import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd

from thirdbody.bearings import hardness_notes, hertz_contact
from thirdbody.conditions import OutOfRangeWarning, axis_of, check_count
from thirdbody.core.film import film_parameter
from thirdbody.core.regimes import WITHOUT_VALUES
from thirdbody.core.turning_points import PROMINENCE
from thirdbody.ensembles import Ensemble, range_over_members
from thirdbody.inputs import or_calibrated
from thirdbody.notes import (
    WIDTH,
    area_note,
    few_notes,
    layer_notes,
    note_lines,
    number_text,
    outside_notes,
    range_note,
    speed_notes,
    wrapped,
)
from thirdbody.points import solve
from thirdbody.searches import LOADS, RATIOS, transitions, turning_point, turning_window
from thirdbody.variables import FLAGS, NORMAL_LOAD, QUANTITIES, STATUS_MEANINGS, VARIABLES

COMPLEMENTS = "surface_contact_area_ratio", "fluid_load_fraction"  # 1 minus another row
SHOWN = [name for name in (*QUANTITIES, *FLAGS) if name not in COMPLEMENTS]
INVALID = "outside_film_formula", "area_exceeded"  # changes with these statuses are left out
DIGITS = 3  # of a number, or fewer if its range is wide
COLUMNS = ["symbol", "quantity", "unit", "value", "low", "high", "agree", "members"]
Interface = Mapping[str, Any]  # the conditions of an interface, by alias


def state(parameters: Ensemble, conditions: Interface, verbose: bool = False) -> pd.DataFrame:
    """Load sharing, contact area, regime and mode; ``verbose``: also the nominal pressures."""
    values, of_members = _states(parameters, conditions)
    rows = [_row(name, values[name], [each[name] for each in of_members]) for name in SHOWN]
    rows.append(_lambda_row(parameters, conditions))
    rows += _nominal_rows(parameters, conditions) if verbose else []
    notes = _notes(parameters, conditions, values["solution_status"])
    notes.append(f"H_c is {VARIABLES['film_thickness'].comment}")
    is_solved = isinstance(values["separation"], float)
    return _table(f"State at {_words(conditions)}", rows, notes, is_solved)


def compare_interfaces(
    parameters: Ensemble, conditions: Interface, other: Ensemble, others: Interface
) -> pd.DataFrame:
    """Compare two interfaces: ``value`` is of the first, ``other`` of the second.

    The range is of the difference, second minus first.
    """
    values, of_members = _states(parameters, conditions)
    other_values, of_other_members = _states(other, others)
    rows = []
    for name in SHOWN:
        if name in FLAGS:
            same = [
                (one[name], two[name]) == (values[name], other_values[name])
                for one, two in zip(of_members, of_other_members)
            ]
            row = _row(name, values[name], []) | {"agree": sum(same), "members": len(same)}
        else:
            differences = [
                two[name] - one[name]
                for one, two in zip(of_members, of_other_members)
                if isinstance(one[name], float) and isinstance(two[name], float)
            ]
            row = _row(name, values[name], differences)
        rows.append(row | {"other": other_values[name]})
    statuses = values["solution_status"], other_values["solution_status"]
    notes = [f"first: {_words(conditions)}", f"second: {_words(others)}"]
    for inputs, given, status in zip((parameters, other), (conditions, others), statuses):
        notes += _notes(inputs, given, status)
    are_solved = all(isinstance(each["separation"], float) for each in (values, other_values))
    return _table("Two interfaces", rows, list(dict.fromkeys(notes)), are_solved)


def changes_along(
    parameters: Ensemble,
    conditions: Interface,
    along: str,
    between: tuple[float, float] | None,
) -> pd.DataFrame:
    """The values of a condition, the alias ``along``, at which regime or mode changes."""
    table = transitions(
        along, between=between, parameters=parameters, members=True, progress=False, **conditions
    )
    tables = [
        table[table.index.get_level_values("member") == member]
        for member in range(len(parameters.members))
    ]
    invalid = tables[0][tables[0]["solution_status"].isin(INVALID)]
    best, *_ = of_members = [_by_change(table, along) for table in tables]
    of_members = of_members if len(of_members) > 1 else []
    axis = axis_of(along)
    rows = []
    for key in dict.fromkeys([*best, *(key for each in of_members for key in each)]):
        flag, before, after, number = key
        row = {
            "symbol": (NORMAL_LOAD if along == "load_N" else axis).symbol,
            "quantity": f"{before} to {after}" + (f", number {number + 1}" if number else ""),
            "unit": axis.alias_unit,
        }
        numbers = [each[key] for each in of_members if key in each]
        rows.append(_with_range(row, best.get(key, math.nan), numbers, len(of_members)))
    ends = between or axis.searched
    notes = [f"searched: {axis.words} {ends[0]:g} to {ends[1]:g} {axis.alias_unit}"]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OutOfRangeWarning)  # the search has warned already
        for end in ends:
            point = solve(**{**conditions, along: end}, parameters=parameters)
            states = point.to_dataframe()[[*FLAGS]].iloc[0].dropna()
            notes.append(f"at {end:g} {axis.alias_unit}: {', '.join(states)}")
    notes += [
        f"left out at {row[along]:.4g} {axis.alias_unit}: {STATUS_MEANINGS[row['solution_status']]}"
        for _, row in invalid.iterrows()
    ]
    notes += _ensemble_notes(parameters, conditions, {along: [*best.values()]})
    title = f"Changes along the {axis.words} at {_words(conditions)}"
    return _table(title, rows, notes, bool(best))


def turning_load(
    parameters: Ensemble, conditions: Interface, between_N: tuple[float, float] = LOADS
) -> pd.DataFrame:
    """The load at the turning point of the contact area, and the sizes with a turning point."""
    values, of_members = _turning_values(parameters, conditions, between_N)
    rows = []
    for name, (symbol, quantity, unit) in TURNING.items():
        numbers = [each[name] for each in of_members if math.isfinite(each[name])]
        row = {"symbol": symbol, "quantity": quantity, "unit": unit}
        rows.append(_with_range(row, values[name], numbers, len(of_members)))
    notes = [
        f"the curve runs from {between_N[0]:g} to {between_N[1]:g} N; the maximum of A_sa,t* "
        f"stands out by {PROMINENCE:g} on both sides",
        f"particle sizes are searched from {RATIOS[0]:g} to {RATIOS[-1]:g} times the roughness",
        *_last_load_notes(parameters, conditions, between_N[1]),
        *(["A_sa,t* still rises at the last load"] if values["is_cut"] else []),
        *_ensemble_notes(parameters, conditions, {"load_N": values["load_N"]}),
    ]
    title = f"Turning point at {_words(conditions)}"
    return _table(title, rows, notes, math.isfinite(values["load_N"]))


def _last_load_notes(parameters, conditions, last) -> list[str]:
    """A note if the ``last`` load [N] has no dry solution."""
    dry = {**conditions, "viscosity_cSt": 0.0, "load_N": last}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OutOfRangeWarning)  # turning_point has warned already
        status = str(solve(**dry, parameters=parameters).solution_status)
    if status not in WITHOUT_VALUES:
        return []
    return [f"dry at {last:g} N, {status}: {STATUS_MEANINGS[status]}; a dry curve ends before"]


TURNING = {
    "load_N": ("F_t", "load at the turning point", "N"),
    "load": ("F_TPCA*", "the same over A_n E_ss", "1"),
    "peak_ratio": ("A_sa,t*", "contact area of particles over the total there", "1"),
    "solid_load_fraction": ("L_s", "fraction of the load carried by the solids there", "1"),
    "low": ("x_a", "least particle size with a turning point (dry)", "nm"),
    "high": ("x_a", "largest particle size with a turning point (dry)", "nm"),
}


def curve(
    parameters: Ensemble,
    conditions: Interface,
    along: str,
    between: tuple[float, float],
    count: int,
) -> pd.DataFrame:
    """All variables along the condition with the alias ``along``.

    The first column is the condition.  Variables are in SI, with their ranges in columns ``_low``
    and ``_high``.  Regime, mode and status are names.  Notes say what is outside the paper.
    """
    check_count(count)
    numbers = np.geomspace(*between, count)
    points = solve(
        **{**conditions, along: numbers}, parameters=parameters, members=True, progress=False
    )
    columns: dict[str, Any] = {along: numbers}
    for name in QUANTITIES:
        values = getattr(points, name)
        columns[name] = values[0]
        if len(values) > 1:
            columns[f"{name}_low"], columns[f"{name}_high"] = range_over_members(values)
    best = points.to_dataframe().iloc[: len(numbers)]
    table = pd.DataFrame(columns | {name: best[name].to_numpy() for name in FLAGS})
    given = {**conditions, along: numbers}
    table.attrs["notes"] = [
        *outside_notes(given, or_calibrated(None).speed),
        *hardness_notes(given["load_N"], parameters),
    ]
    return table


def table_text(table: pd.DataFrame) -> str:
    """The title, the numbers, the states and the notes of a table as text of ``WIDTH`` columns."""
    values = {"first": "value", "second": "other"} if "other" in table else {"value": "value"}
    heading = f"range of {max(table['members'], default=0)} sets"
    if "other" in table:
        heading = "range of the change"
    numbers, states = [["symbol", *values, heading, "quantity [unit]"]], []
    for _, row in table.iterrows():
        texts = [_value_text(row, column) for column in values.values()]
        if row.get("name") in FLAGS:
            states.append([row["quantity"], *texts, _agree_text(row)])
        else:
            unit = "" if row["unit"] == "1" else f" [{row['unit']}]"
            numbers.append([row["symbol"], *texts, _range_text(row), row["quantity"] + unit])
    parts = [numbers if len(numbers) > 1 else [["none"]], states]
    title = wrapped(table.attrs["title"])
    return "\n\n".join(
        [
            title,
            *("\n".join(aligned(part)) for part in parts if part),
            note_lines(table.attrs["notes"]),
        ]
    )


def aligned(rows: list[list[str]]) -> list[str]:
    """The lines of ``rows`` of cells, the last cell wrapped at ``WIDTH`` columns."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = []
    for *cells, last in rows:
        before = "".join(cell.ljust(width + 2) for cell, width in zip(cells, widths))
        after = textwrap.wrap(last, WIDTH - len(before)) or [""]
        lines += [(before + after[0]).rstrip(), *(" " * len(before) + line for line in after[1:])]
    return lines


def _table(title, rows, notes, is_found) -> pd.DataFrame:
    table = pd.DataFrame(rows, columns=None if rows else COLUMNS)
    table.attrs = {"title": title, "notes": list(notes), "found": is_found}
    return table


def _row(name, value, of_members) -> dict:
    """The row of the variable ``name``: of a number, or of a flag with the name of its state."""
    variable = VARIABLES[name]
    unit = "" if name in FLAGS else "1" if variable.unit == "1" else variable.shown_unit
    symbol = "" if name in FLAGS else variable.symbol
    row = {"name": name, "symbol": symbol, "quantity": variable.label, "unit": unit}
    if name in FLAGS:
        same = sum(member == value for member in of_members)
        return row | {"value": value, "agree": same, "members": len(of_members)}
    numbers = [member for member in of_members if isinstance(member, float)]
    return _with_range(row, value, numbers, len(of_members))


def _with_range(row, value, numbers, members) -> dict:
    """The ``row`` with a number, and the range of ``numbers``, those of members that have one."""
    low, high = range_over_members(numbers).tolist() if numbers else (math.nan, math.nan)
    return row | {
        "value": value,
        "low": low,
        "high": high,
        "agree": len(numbers),
        "members": members,
    }


def _states(parameters, conditions) -> tuple[dict, list[dict]]:
    """The variables of one point for the best set, and for all members if there are several.

    They are numbers, d in its shown unit, or names of states.
    """
    points = solve(**conditions, parameters=parameters, members=True)

    def values(member):
        numbers = {name: float(getattr(points, name)[member]) for name in QUANTITIES}
        numbers["separation"] = float(VARIABLES["separation"].from_si(numbers["separation"]))
        known = {name: value if math.isfinite(value) else None for name, value in numbers.items()}
        states = {name: str(getattr(points, name)[member]) for name in FLAGS}
        if states["lubrication_regime"] == "full_film":
            states["contact_mode"] = "none"
        return known | states

    return _best_and_members([values(member) for member in range(len(parameters.members))])


def _best_and_members(values: list) -> tuple[Any, list]:
    """The values of the best set, and those of all members: an empty list for a single member."""
    return values[0], values if len(values) > 1 else []


def _lambda_row(parameters, conditions) -> dict:
    """The row of lambda: the film of smooth bodies under the whole load, over sigma."""
    given = {key: axis_of(key).to_si(conditions[key]) for key in ("viscosity_cSt", "roughness_nm")}
    films = {"viscosity": np.asarray(given["viscosity_cSt"])}
    if "speed_m_per_s" in conditions:
        films["speed"] = np.asarray(conditions["speed_m_per_s"])
    of_members = []
    for member in parameters.members:
        viscosity = parameters.setup.without_speed(films, member)["viscosity"]
        load = conditions["load_N"] / member.newtons_per_load
        of_members.append(float(film_parameter(load, viscosity, given["roughness_nm"], member)))
    row = {"symbol": "lambda", "quantity": "film of smooth bodies under F_t, over sigma"}
    value, of_members = _best_and_members(of_members)
    return _with_range(row | {"unit": "1"}, value, of_members, len(of_members))


def _nominal_rows(parameters, conditions) -> list[dict]:
    """The rows of A_n and the nominal pressure F_t/A_n, and of the Hertz area and pressure."""
    load = conditions["load_N"]
    area, pressure = hertz_contact(load, parameters)
    numbers = {
        ("A_n", "nominal area of the model, an input", "mm2"): 1e6 * parameters.apparent_area,
        ("p_n", "nominal pressure F_t/A_n", "MPa"): 1e-6 * load / parameters.apparent_area,
        ("A_H", "Hertz area of the smooth ball", "mm2"): 1e6 * area,
        ("p_H", "mean Hertz pressure on it", "MPa"): 1e-6 * pressure,
    }
    members = parameters.members if len(parameters.members) > 1 else ()
    of_members = {
        "A_n": [1e6 * member.apparent_area for member in members],
        "p_n": [1e-6 * load / member.apparent_area for member in members],
    }
    return [
        _with_range(
            {"symbol": symbol, "quantity": quantity, "unit": unit},
            value,
            of_members.get(symbol, []),
            len(of_members.get(symbol, [])),
        )
        for (symbol, quantity, unit), value in numbers.items()
    ]


def _by_change(table, along) -> dict[tuple, float]:
    """The values of the condition at valid changes.

    The keys are the flag, the states, and the number of equal changes at smaller values.
    """
    valid = table[~table["solution_status"].isin(INVALID)]
    keys = ["flag", "before", "after"]
    numbers = valid.groupby(keys).cumcount()
    return {
        (*row, number): value
        for row, number, value in zip(
            valid[keys].itertuples(index=False, name=None), numbers, valid[along], strict=True
        )
    }


def _turning_values(parameters, conditions, between_N) -> tuple[dict, list[dict]]:
    """The numbers of ``turning_load`` for the best set, and of all members if there are several."""
    layer = {name: conditions[name] for name in ("roughness_nm", "particle_density_per_m2")}
    others = {key: value for key, value in conditions.items() if key != "load_N"}
    arguments = {"parameters": parameters, "between_N": between_N, "members": True}
    points = turning_point(**arguments, **others, progress=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", OutOfRangeWarning)  # turning_point has warned already
        windows = turning_window(**arguments, **layer)
    names = "load_N", "load", "peak_ratio", "solid_load_fraction"
    values = []
    for (_, point), (_, window) in zip(points.iterrows(), windows.iterrows(), strict=True):
        numbers = {name: float(point[name]) if point["exists"] else math.nan for name in names}
        sizes = {end: float(window[end] * conditions["roughness_nm"]) for end in ("low", "high")}
        values.append(numbers | sizes | {"is_cut": point["is_cut"]})
    return _best_and_members(values)


def _notes(parameters, conditions, status) -> list[str]:
    """The notes on a state."""
    notes = [] if status == "converged" else [f"{status}: {STATUS_MEANINGS[status]}"]
    notes += few_notes(conditions["particle_density_per_m2"], parameters.apparent_area)
    return notes + _ensemble_notes(parameters, conditions)


def _ensemble_notes(parameters, conditions, found: Interface | None = None) -> list[str]:
    """The notes on conditions outside Table 2, on the nominal area, on the speed of an oil unless
    it is a condition, on the sizes if there are particles, and on ranges.

    ``found`` has the values of a condition that was searched along.
    """
    given = {**conditions, **(found or {})}
    notes = [
        *outside_notes(given, or_calibrated(None).speed),
        *hardness_notes(given.get("load_N", ()), parameters),
        area_note(parameters),
    ]
    if conditions.get("viscosity_cSt") != 0.0 and "speed_m_per_s" not in given:
        notes += speed_notes(parameters)
    notes += layer_notes(conditions, parameters.best)
    return [*notes, range_note(parameters)]


def _words(conditions) -> str:
    """The conditions in words."""
    return ", ".join(
        f"{axis_of(key).words} {value:g} {axis_of(key).alias_unit}"
        for key, value in conditions.items()
    )


def _value_text(row, column) -> str:
    """The text of a state, or of a number with the digits that its range allows."""
    value = row[column]
    if value is None or (isinstance(value, float) and math.isnan(value)):
        return "none"
    return value if isinstance(value, str) else number_text(value, _digits(value, row))


def _digits(value, row) -> int:
    """``DIGITS``, or fewer where the range in the ``row`` of a number is wide."""
    width = row.get("high", math.nan) - row.get("low", math.nan)
    if not width > 0.0 or value == 0.0:
        return DIGITS
    certain = math.floor(math.log10(abs(value))) - math.floor(math.log10(width)) + 2
    return min(DIGITS, max(2, certain))


def _range_text(row) -> str:
    """The text of a range that has a width, and of how many members agree if not all do."""
    ends = [row.get(end, math.nan) for end in ("low", "high")]
    texts = [number_text(end, _digits(end, row)) for end in ends if math.isfinite(end)]
    parts = [" to ".join(texts)] if len({*texts}) > 1 else []
    return ", ".join([*parts, *([_agree_text(row)] if row["agree"] < row["members"] else [])])


def _agree_text(row) -> str:
    """How many members agree."""
    return f"{row['agree']} of {row['members']}" if row["members"] else ""
