"""The verdicts as pages for readers (Markdown, HTML) and as data for programs (JSON)."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

import pandas as pd
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.study.verdicts import (
    FAILS,
    FAINT,
    Judged,
    count_once,
    counts_by_figure,
    headline_table,
    number_ranges,
    once,
)


def claims_markdown(judged: Judged) -> str:
    """The page ``claims.md``: a summary, then every statement."""
    table = judged.table
    numbers = headline_table(judged)
    failing = table[table["verdict"] == FAILS]
    failing = failing.assign(holds_under=[_holds_under(judged, id) for id in failing["id"]])
    names = failing["cluster"].replace("", None).fillna(failing["id"])
    return ENVIRONMENT.get_template("claims.md.j2").render(
        score=score_sentence(judged),
        reached=numbers["reached"].sum(),
        wider=_wider_tolerances(judged),
        headline=numbers.drop(columns="id").replace({"reached": {True: "yes", False: "no"}}),
        misfits=[rows.to_dict("records") for _, rows in failing.groupby(names, sort=False)],
        default=judged.default,
        claims=judged.claims,
        verdicts=judged.verdicts,
        words=dict(zip(table["id"], table["verdict"], strict=True)),
        counts=counts_by_figure(judged),
        comparison=judged.comparison.drop(columns="predicted_fraction", errors="ignore"),
        statements=table.to_dict("records"),
        failing=failing.to_dict("records"),
    )


def claims_html(judged: Judged) -> str:
    """The statements and their verdicts as a table, an HTML page."""
    score = score_sentence(judged).replace("**", "")
    rows = judged.table.to_dict("records")
    return ENVIRONMENT.get_template("claims.html.j2").render(score=score, rows=rows)


def claims_json(judged: Judged) -> str:
    """The same data for programs: a JSON object, with null for missing numbers.

    A statement has the columns of the table ``claims``, the last ones as lists and objects, SI, and
    the ensemble range of each of its numbers.
    """
    held, of = count_once(judged.claims, judged.verdicts)
    predicted, tested = count_once(judged.claims, judged.predicted)
    rows = judged.table.drop(columns=["range_low", "range_high"]).to_dict("records")
    content = {
        "score": score_sentence(judged).replace("**", ""),
        "held": held,
        "judged": of,
        "predicted": predicted,
        "predicted_of": tested,
        "interpretation": judged.default["interpretation"],
        "inputs": judged.default["inputs"],
        "identification": judged.default["identification"],
        "headline": headline_table(judged).to_dict("records"),
        "interpretations": judged.comparison.to_dict("records"),
        "statements": [
            row
            | {
                "curves": [condition._asdict() for condition in claim.curves],
                "references": [condition._asdict() for condition in claim.references],
                "loads": claim.limits,
                "published": claim.published,
                "numbers": judged.verdicts[claim.id].numbers,
                "range": number_ranges(judged, claim.id).tolist(),
                "contradicts": list(claim.contradicts),
            }
            for row, claim in zip(rows, judged.claims, strict=True)
        ],
    }
    return json.dumps(_without_nan(content), indent=1, ensure_ascii=False) + "\n"


def score_sentence(judged: Judged) -> str:
    """Numbers of statements that hold: predicted, fitted, and with fainter turning points."""
    held, of = count_once(judged.claims, judged.verdicts)
    right, tested = count_once(judged.claims, judged.predicted)
    predicted = (
        f"Of {tested} distinct statements {right} are predicted when their figure is left out of the search. "
        if tested
        else "No cross-validation has been run for these inputs. "
    )
    percentage = f" ({100 * held / of:.0f} %)" if of else ""
    faint, faint_of = count_once(judged.claims, judged.faint)
    return (
        f"**{predicted}Of {of} that can be judged {held} hold{percentage}**, with one set of inputs for all "
        f"figures. Turning points count if they stand out by {PROMINENCE:g}, a line's width; "
        f"if {FAINT:g} were enough, {faint} of {faint_of} would hold."
    )


def _holds_under(judged: Judged, id: str) -> str:
    """The interpretations with whose inputs a statement holds."""
    names = [name for name, each in judged.interpretations.items() if each[id].holds]
    return ", ".join(names) or f"none of the {len(judged.interpretations)} interpretations"


def _wider_tolerances(judged: Judged) -> str:
    """Tolerances within which headline numbers count as reached, if wider than those of their
    statements."""
    wider: dict[str, str] = {}
    for claim in judged.claims:
        size = judged.settings["headline_tolerances"].get(claim.id)
        if size is not None:
            text = f"{100 * size:g} %" if claim.relative else f"{size:g}"
            wider[text] = claim.place.split(", section")[0]
    return " or ".join(f"within {text} ({place})" for text, place in wider.items())


def _tolerance(row: Mapping[str, Any]) -> str:
    """The tolerance as text, as a percentage of the number or in its unit."""
    size = row["tolerance"]
    relative = row["tolerance_kind"] == "relative"
    return f"{100 * size:g} %, relative" if relative else f"{size:g}, absolute"


def _cell(value: Any) -> str:
    """A value as a cell of a table in Markdown."""
    return str(value).replace("|", "\\|")


def _as_markdown(table: pd.DataFrame) -> str:
    return table.map(_cell).to_markdown(index=False, disable_numparse=True)


ENVIRONMENT = Environment(
    loader=PackageLoader("thirdbody.study", "."),
    autoescape=select_autoescape(["html.j2"]),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
)
FILTERS = {"markdown": _as_markdown, "once": once, "tolerance": _tolerance, "cell": _cell}
ENVIRONMENT.filters |= FILTERS


def _without_nan(content):
    """The content with null for every number that is nan or infinite."""
    if isinstance(content, Mapping):
        return {name: _without_nan(value) for name, value in content.items()}
    if isinstance(content, (list, tuple)):
        return [_without_nan(value) for value in content]
    if isinstance(content, float) and not math.isfinite(content):
        return None
    return content
