"""The verdicts as pages for readers (Markdown, HTML) and as data for programs (JSON)."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping

import pandas as pd
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.study.verdicts import (
    CONTRADICTED,
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
    """The page ``claims.md``: first what is understood in two minutes, then every statement."""
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
        inputs=_inputs(judged.default),
        contradictions=_contradictions(judged),
        counts=counts_by_figure(judged),
        comparison=judged.comparison.drop(columns="predicted_fraction", errors="ignore"),
        statements=_statements(table),
        failing=failing.to_dict("records"),
    )


def claims_html(judged: Judged) -> str:
    """The statements and their verdicts as a table, an HTML page."""
    rows = judged.table.assign(tolerance_text=_tolerances(judged.table)).to_dict("records")
    score = score_sentence(judged).replace("**", "")
    return ENVIRONMENT.get_template("claims.html.j2").render(score=score, rows=rows)


def claims_json(judged: Judged) -> str:
    """The same for programs: a JSON object, with null for numbers that do not exist.

    A statement has the columns of the table ``claims``, the last ones as lists and objects, SI, and the range
    of each of its numbers over the ensemble.
    """
    held, of = count_once(judged.claims, judged.verdicts)
    predicted, tested = count_once(judged.claims, judged.default_predicted)
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
    """How many statements hold: predicted, fitted, and with fainter turning points."""
    held, of = count_once(judged.claims, judged.verdicts)
    right, tested = count_once(judged.claims, judged.default_predicted)
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
    """The interpretations under whose inputs a statement holds."""
    names = [name for name, each in judged.interpretations.items() if each[id].holds]
    return ", ".join(names) or f"none of the {len(judged.interpretations)} interpretations"


def _wider_tolerances(judged: Judged) -> str:
    """Within what a headline number counts as reached, where its statement asks for less."""
    wider: dict[str, str] = {}
    for claim in judged.claims:
        size = judged.settings["headline_tolerances"].get(claim.id)
        if size is not None:
            text = f"{100 * size:g} %" if claim.relative else f"{size:g}"
            wider[text] = claim.place.split(", section")[0]
    return " or ".join(f"within {text} ({place})" for text, place in wider.items())


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


def _contradictions(judged: Judged) -> pd.DataFrame:
    """Each statement that stands aside, whether it would hold, and those taken instead."""
    words = judged.table.set_index("id")["verdict"]
    return pd.DataFrame(
        {
            "set aside": claim.statement,
            "would hold": "yes" if judged.verdicts[claim.id].holds else "no",
            "taken instead": ", ".join(
                f"{other} ({words[other]})"
                for other in claim.contradicts
                if words[other] != CONTRADICTED
            ),
            "why": claim.aside,
        }
        for claim in judged.claims
        if claim.aside
    )


def _statements(table: pd.DataFrame) -> pd.DataFrame:
    """The columns of the table that readers need, with short headings."""
    agree = {
        f"{name} {verb}": table[f"{name}_agree"].astype(str)
        + "/"
        + table[f"{name}_size"].astype(str)
        for name, verb in (("ensemble", "agrees"), ("interpretations", "agree"))
    }
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
        }
        | agree
    )


def _tolerances(table: pd.DataFrame) -> list[str]:
    """What still counts as agreement, as a percentage of the number or in its unit."""
    pairs = zip(table["tolerance"], table["tolerance_kind"], strict=True)
    return [
        f"{100 * size:g} %, relative" if kind == "relative" else f"{size:g}, absolute"
        for size, kind in pairs
    ]


def _as_markdown(table: pd.DataFrame) -> str:
    if table.empty:
        return "None."
    cells = table.map(lambda cell: str(cell).replace("|", "\\|"))
    return cells.to_markdown(index=False, disable_numparse=True)


ENVIRONMENT = Environment(
    loader=PackageLoader("thirdbody.study", "."),
    autoescape=select_autoescape(["html.j2"]),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
)
ENVIRONMENT.filters |= {"markdown": _as_markdown, "once": once}


def _without_nan(content):
    """The same content with null for every number that is nan or infinite."""
    if isinstance(content, Mapping):
        return {name: _without_nan(value) for name, value in content.items()}
    if isinstance(content, (list, tuple)):
        return [_without_nan(value) for value in content]
    if isinstance(content, float) and not math.isfinite(content):
        return None
    return content
