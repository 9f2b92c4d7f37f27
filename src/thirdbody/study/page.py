"""The verdicts as pages for readers (Markdown, HTML) and as data for programs (JSON)."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import pandas as pd
from jinja2 import Environment, PackageLoader, StrictUndefined

from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.study.verdicts import (
    CONTRADICTED,
    FAILS,
    FAINT,
    Judged,
    count_once,
    counts_by_figure,
    explanation,
    headline_table,
    held_once,
    number_ranges,
    once,
)


def claims_markdown(
    judged: Judged,
    headline: Iterable[str],
    tolerances: Mapping[str, float],
    earlier: Mapping[str, Any],
) -> str:
    """The page ``claims.md``: first what is understood in two minutes, then every statement.

    Parameters
    ----------
    judged : Judged
        All statements, judged under all sets of inputs.
    headline : iterable of str
        Ids of the paper's headline numbers.
    tolerances : mapping
        Deviation up to which a headline number counts as reached, by id, where its statement asks
        for less.
    earlier : mapping
        Content of ``config/earlier_predictions.yaml``.
    """
    table = judged.table
    numbers = headline_table(judged, headline, tolerances)
    numbers["reached"] = numbers["reached"].map({True: "yes", False: "no"})
    failing = table[table["verdict"] == FAILS]
    failing = failing.assign(explanation=[explanation(judged, index) for index in failing.index])
    names = failing["cluster"].replace("", None).fillna(failing["id"])
    return (
        _environment(escaped=False)
        .get_template("claims.md.j2")
        .render(
            score=score_sentence(judged, table),
            reached=(numbers["reached"] == "yes").sum(),
            headline=numbers.drop(columns="id"),
            misfits=[rows.to_dict("records") for _, rows in failing.groupby(names, sort=False)],
            inputs=_inputs(judged.default),
            contradictions=_contradictions(judged, table),
            earlier_note=earlier["note"].strip(),
            earlier=earlier_table(judged, earlier),
            counts=counts_by_figure(table),
            comparison=judged.comparison.drop(columns="predicted_fraction", errors="ignore"),
            statements=_statements(table),
            failing=failing.to_dict("records"),
        )
    )


def claims_html(judged: Judged) -> str:
    """The statements and their verdicts as a table, an HTML page."""
    table = judged.table
    rows = table.assign(tolerance_text=_tolerances(table)).to_dict("records")
    score = score_sentence(judged, table).replace("**", "")
    return _environment(escaped=True).get_template("claims.html.j2").render(score=score, rows=rows)


def claims_json(judged: Judged, headline: Iterable[str], tolerances: Mapping[str, float]) -> str:
    """The same for programs: a JSON object, with null for numbers that do not exist.

    A statement has the columns of the table ``claims``, with ``curves``, ``references``, ``loads``,
    ``published``, all ``numbers`` that are compared with the ``range`` of each over the ensemble, and
    ``contradicts`` as objects and lists, SI.
    """
    table = judged.table
    held, of = held_once(table)
    predicted, tested = held_once(table, "predicted")
    content = {
        "held": held,
        "judged": of,
        "predicted": predicted,
        "predicted_of": tested,
        "interpretation": judged.default["interpretation"],
        "inputs": judged.default["inputs"],
        "identification": judged.default["identification"],
        "headline": headline_table(judged, headline, tolerances).to_dict("records"),
        "interpretations": judged.comparison.to_dict("records"),
        "statements": [
            _statement(judged, index, row) for index, row in enumerate(table.to_dict("records"))
        ],
    }
    return json.dumps(_without_nan(content), indent=1, ensure_ascii=False) + "\n"


def score_sentence(judged: Judged, table: pd.DataFrame) -> str:
    """How many statements hold: predicted, fitted, and with fainter turning points."""
    held, of = held_once(table)
    right, tested = held_once(table, "predicted")
    predicted = (
        f"Of {tested} distinct statements {right} are predicted when their figure is left out of the search. "
        if tested
        else "No cross-validation has been run for these inputs. "
    )
    percentage = f" ({100 * held / of:.0f} %)" if of else ""
    faint, faint_of = count_once(zip(judged.claims, judged.faint, strict=True))
    return (
        f"**{predicted}Of {of} that can be judged {held} hold{percentage}**, with one set of inputs for all "
        f"figures. Turning points count if they stand out by {PROMINENCE:g}, a line's width; "
        f"if {FAINT:g} were enough, {faint} of {faint_of} would hold."
    )


def earlier_table(judged: Judged, earlier: Mapping[str, Any]) -> pd.DataFrame:
    """What earlier calibrations had predicted for numbers that were not known to them.

    Predictions within the tolerance of the statement are marked ✓.
    """
    claims = {claim.id: claim for claim in judged.claims}
    columns = {id: label for id, label in earlier["numbers"].items() if id in claims}
    rows = [
        {"set": "**paper**"} | {label: f"{claims[id].published:g}" for id, label in columns.items()}
    ]
    for name, values in earlier["sets"].items():
        row = {"set": name}
        for id, label in columns.items():
            low, high = values[id] if isinstance(values[id], list) else (values[id], values[id])
            claim = claims[id]
            width = claim.tolerance * (abs(claim.published) if claim.relative else 1.0)
            near = (
                abs(np.array([low, high]) - claim.published) <= width if low is not None else False
            )
            text = "none" if low is None else f"{low:g}" if low == high else f"{low:g} to {high:g}"
            row[label] = text + (" ✓" if np.all(near) else "")
        rows.append(row)
    return pd.DataFrame(rows)


def _inputs(default: Mapping) -> pd.DataFrame:
    """The inputs that were searched, and 90 % of what each seed draws."""
    return pd.DataFrame(
        {
            "input": name,
            "chosen": f"{default['inputs'][name]:.3g}",
            "90 % of each seed's sample": ", ".join(
                "{:.3g} to {:.3g}".format(*ends) for ends in found.get("range_of_each_seed", ())
            ),
        }
        for name, found in default["identification"].items()
    )


def _contradictions(judged: Judged, table: pd.DataFrame) -> pd.DataFrame:
    """Each statement that stands aside, whether it would hold, and those taken instead."""
    words = dict(zip(table["id"], table["verdict"], strict=True))
    return pd.DataFrame(
        {
            "set aside": claim.statement,
            "would hold": "yes" if verdict.holds else "no",
            "taken instead": ", ".join(
                f"{other} ({words[other]})"
                for other in claim.contradicts
                if words[other] != CONTRADICTED
            ),
            "why": claim.aside,
        }
        for claim, verdict in zip(judged.claims, judged.verdicts, strict=True)
        if claim.aside
    )


def _statements(table: pd.DataFrame) -> pd.DataFrame:
    """The columns of the table that readers need, with short headings."""
    return pd.DataFrame(
        {
            "id": table["id"],
            "statement": table["statement"],
            "paper": table["published"],
            "model": table["computed"].map(once),
            "tolerance": _tolerances(table),
            "score": table["score"].map("{:.3g}".format),
            "verdict": table["verdict"],
            "figure left out": table["predicted"],
            "ensemble agrees": _fraction(table, "ensemble"),
            "interpretations agree": _fraction(table, "interpretations"),
        }
    )


def _fraction(table, name):
    return table[f"{name}_agree"].astype(str) + "/" + table[f"{name}_size"].astype(str)


def _tolerances(table: pd.DataFrame) -> list[str]:
    """What still counts as agreement, as a percentage of the number or in its unit."""
    pairs = zip(table["tolerance"], table["tolerance_kind"], strict=True)
    return [
        f"{100 * size:g} %, relative" if kind == "relative" else f"{size:g}, absolute"
        for size, kind in pairs
    ]


def _statement(judged: Judged, index: int, row: Mapping[str, Any]) -> dict[str, Any]:
    """A row of the table ``claims`` for programs: nothing in it has to be parsed."""
    claim = judged.claims[index]
    parsed = {
        "curves": [condition._asdict() for condition in claim.curves],
        "references": [condition._asdict() for condition in claim.references],
        "loads": claim.limits,
        "published": claim.published,
        "numbers": judged.verdicts[index].numbers,
        "range": number_ranges(judged, index).tolist(),
        "contradicts": list(claim.contradicts),
    }
    return {k: v for k, v in row.items() if k not in ("range_low", "range_high")} | parsed


def _environment(escaped: bool) -> Environment:
    environment = Environment(
        loader=PackageLoader("thirdbody.study", "."),
        autoescape=escaped,
        undefined=StrictUndefined,
        keep_trailing_newline=True,
        trim_blocks=False,
    )
    environment.filters["markdown"] = _as_markdown
    environment.filters["once"] = once
    return environment


def _as_markdown(table: pd.DataFrame) -> str:
    if table.empty:
        return "None."
    cells = table.map(lambda cell: str(cell).replace("|", "\\|"))
    return cells.to_markdown(index=False, disable_numparse=True)


def _without_nan(content):
    """The same content with null for every number that is nan or infinite."""
    if isinstance(content, Mapping):
        return {name: _without_nan(value) for name, value in content.items()}
    if isinstance(content, (list, tuple)):
        return [_without_nan(value) for value in content]
    if isinstance(content, np.generic):
        content = content.item()
    if isinstance(content, float):
        return content if math.isfinite(content) else None
    return content
