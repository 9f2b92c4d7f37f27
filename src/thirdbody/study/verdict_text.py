"""The verdicts as a page: first what is understood in two minutes, then every statement."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

import pandas as pd
from tabulate import tabulate

from thirdbody.data.readable import Sheet, page
from thirdbody.study.verdicts import (
    FAILS,
    Trial,
    counts,
    discriminating,
    explanations,
    headline_rows,
    held_once,
    once,
    ranges,
    reading_rows,
    verdict_rows,
)


def claims_markdown(
    trial: Trial,
    default: Mapping[str, Any],
    readings: Sequence[Mapping[str, Any]],
    headline: Sequence[str],
) -> str:
    """Write the page ``claims.md``.

    Parameters
    ----------
    trial : Trial
        All statements, judged under all sets of inputs.
    default : mapping
        Content of the calibrated file whose inputs are the default.
    readings : sequence of mapping
        Contents of the calibrated files of all readings, in the order of ``trial.readings``.
    headline : sequence of str
        Ids of the statements by which the readings are compared.

    Returns
    -------
    str
        Markdown: the verdict in a sentence, headline numbers, what fails, the inputs, where the paper
        contradicts itself, predictions; then counts, how near each reading comes, every verdict, and
        for each statement that fails what would change it.
    """
    rows, why = verdict_rows(trial), explanations(trial)
    compared = reading_rows(trial, readings, headline)
    parts = [
        "# Verdict on every statement of the paper",
        _summary(rows),
        "## The paper's numbers",
        "Loads are F_t* [1], film ranges H_c [1], windows ends of x_a/σ [1].",
        _numbers(headline_rows(trial, headline)),
        "## What fails",
        _misfits(rows),
        "## The inputs that it took",
        _inputs(default),
        "## Where the paper contradicts itself",
        "Of two sentences that exclude each other one is taken, and the other stays outside the shares "
        "and the calibration.",
        _contradictions(trial, rows),
        "## Predictions of the numbers that the text keeps back",
        _numbers(headline_rows(trial, _withheld(trial))),
        "## How to read this page",
        f"Inputs: of the sets of the reading `{default['reading']}` that explain the statements about "
        f"equally well (least objective {default['objective']:g}) that under which most of them hold, "
        "those of the role `calibration` alone being counted. A statement holds if it is met within its tolerance; the "
        "statements, tolerances and their reasons are in `config/claims.yaml`, the inputs and "
        "their ensemble in `config/calibrated/`. Statements that repeat one another count once, as held "
        "if all of them hold that are tested; one is not tested if the model does not come to its "
        "condition within the loads. Those that the paper itself contradicts stand apart.",
        f"Of the statements, {len(discriminating(trial))} discriminate between the "
        f"{len(trial.readings)} readings: they hold under some and fail under others.",
        "## Counts by role",
        _counted(rows, "role"),
        "## Counts by figure",
        _counted(rows, "figure"),
        "## How near each reading comes",
        "At the inputs of each, solved as coarsely as in the calibration (windows to about "
        "0.01); ✓ marks what is within the statement's tolerance. The first is the default, by a rule that "
        "knows nothing of `validation`: most statements of the calibration hold, repeats counted once; "
        "then the least penalty for unusual inputs; then the fewest inputs that were searched.",
        tabulate(compared, headers="keys", tablefmt="github", disable_numparse=True),
        "## The statements",
        "A relative tolerance is a share of the number, an absolute one in its unit; `claims.csv` and "
        "`claims.json` tell the curves and the ranges of the ensemble, too.",
        _statements(rows),
        "## What fails, and what would change it",
        "Scores count tolerances up to 1 and their logarithm beyond. Each input was moved by "
        "itself by 8 % of its bounds, and each reading was judged at its own best inputs.",
        *(_miss(row, why[row["id"]]) for row in rows if row["verdict"] == FAILS),
    ]
    return "\n\n".join(parts) + "\n"


def claims_html(trial: Trial) -> str:
    """The statements and their verdicts as a table, an HTML page.

    Parameters
    ----------
    trial : Trial
        All statements, judged under all sets of inputs.
    """
    rows = verdict_rows(trial)
    headings = ("place", "statement", "paper", "model", "tolerance", "verdict")
    columns = ("place", "statement", "published", "measured")
    cells = [[*(row[name] for name in columns), _tolerance(row), row["verdict"]] for row in rows]
    title = "The paper's statements and their verdicts"
    return page(
        [Sheet(title, _summary(rows).replace("**", ""), pd.DataFrame(cells, columns=headings))]
    )


def claims_json(
    trial: Trial,
    default: Mapping[str, Any],
    readings: Sequence[Mapping[str, Any]],
    headline: Sequence[str],
) -> str:
    """The same for programs: what ``claims_markdown`` says, as a JSON object.

    Parameters are those of ``claims_markdown``; numbers that are none are null.  A statement has the
    columns of the table ``claims``, but ``curves`` and what they are held against, ``references``, as
    conditions in SI, ``loads`` that are bounded or named, ``published`` numbers or states as such, all
    ``numbers`` that are compared, the ``range`` of each over the ensemble, and ``contradicts`` as a list.
    """
    rows = verdict_rows(trial)
    held, judged = held_once(rows)
    content = {
        "held": held,
        "judged": judged,
        "reading": default["reading"],
        "inputs": default["inputs"],
        "identification": default["identification"],
        "headline": headline_rows(trial, headline),
        "predictions": headline_rows(trial, _withheld(trial)),
        "readings": reading_rows(trial, readings, headline),
        "statements": [_statement(trial, index, row) for index, row in enumerate(rows)],
    }
    return json.dumps(_without_nan(content), indent=1, ensure_ascii=False) + "\n"


def _statement(trial: Trial, index: int, row: Mapping[str, Any]) -> dict[str, Any]:
    """A row of the table ``claims`` for programs: nothing in it is to be parsed."""
    claim = trial.claims[index]
    changed = {
        "curves": [condition._asdict() for condition in claim.curves],
        "references": [condition._asdict() for condition in claim.references],
        "loads": claim.limits,
        "published": claim.published,
        "numbers": trial.main.verdicts[index].numbers,
        "range": ranges(trial, index).tolist(),
        "contradicts": claim.contradicts,
    }
    parts = {"range_low", "range_high"}
    return {name: value for name, value in row.items() if name not in parts} | changed


def _withheld(trial: Trial) -> list[str]:
    """Ids of the statements whose number the text keeps back."""
    return [claim.id for claim in trial.claims if claim.is_withheld]


def _without_nan(content):
    """The same content with null for every number that is none."""
    if isinstance(content, Mapping):
        return {name: _without_nan(value) for name, value in content.items()}
    if isinstance(content, (list, tuple)):
        return [_without_nan(value) for value in content]
    if isinstance(content, float):
        return content if math.isfinite(content) else None
    return content


def _summary(rows) -> str:
    held, judged = held_once(rows)
    share = f" ({100 * held / judged:.0f} %)" if judged else ""
    return (
        f"**Of {judged} distinct statements of the paper that can be judged {held} hold{share}**, with "
        "one set of inputs for all figures."
    )


def _numbers(rows) -> str:
    """Numbers of the paper and the model side by side."""
    cells = [
        {name: _cell(value) for name, value in row.items() if name != "id" and value}
        for row in rows
    ]
    return tabulate(cells, headers="keys", tablefmt="github", disable_numparse=True)


def _misfits(rows) -> str:
    """Statements that fail, those of a cluster together, each with what was measured."""
    clusters: dict[str, list] = {}
    for row in rows:
        if row["verdict"] == FAILS:
            clusters.setdefault(row["cluster"] or row["id"], []).append(row)
    return "\n".join(
        "- "
        + "; ".join(
            f"{row['place'].split(', section')[0]}: {row['statement']} Measured: {once(row['measured'])}"
            + (f" (paper: {row['published']})" if row["published"] else "")
            for row in some
        )
        for some in clusters.values()
    )


def _inputs(default: Mapping) -> str:
    """The inputs that were searched: the best, and 90 % of what each seed draws."""
    cells = [
        {
            "input": name,
            "chosen": f"{default['inputs'][name]:.3g}",
            "90 % of each seed's sample": ", ".join(
                "{:.3g} to {:.3g}".format(*ends) for ends in found.get("range_of_each_seed", ())
            ),
        }
        for name, found in default["identification"].items()
    ]
    return tabulate(cells, headers="keys", tablefmt="github", disable_numparse=True)


def _counted(rows, by: str) -> str:
    return tabulate(counts(rows, by), headers="keys", tablefmt="github", disable_numparse=True)


def _contradictions(trial: Trial, rows) -> str:
    """Each statement that stands aside, whether it would hold, and those that are taken instead."""
    verdicts = {row["id"]: row["verdict"] for row in rows}
    cells = [
        {
            "set aside": _cell(claim.statement),
            "would hold": "yes" if verdict.holds else "no",
            "taken instead": ", ".join(
                f"{other} ({verdicts[other]})" for other in claim.contradicts
            ),
            "why": _cell(claim.aside),
        }
        for claim, verdict in zip(trial.claims, trial.main.verdicts, strict=True)
        if claim.aside
    ]
    return tabulate(cells, headers="keys", tablefmt="github", disable_numparse=True)


def _statements(rows) -> str:
    cells = [
        {
            "id": row["id"],
            "statement": _cell(row["statement"]),
            "role": row["role"],
            "paper": row["published"],
            "model": once(row["measured"]),
            "tolerance": _tolerance(row),
            "score": _cell(row["score"]),
            "verdict": row["verdict"],
            "ensemble agrees": f"{row['ensemble_agree']}/{row['ensemble_size']}",
            "readings agree": f"{row['readings_agree']}/{row['readings_size']}",
        }
        for row in rows
    ]
    return tabulate(cells, headers="keys", tablefmt="github", disable_numparse=True)


def _tolerance(row: Mapping) -> str:
    """What still counts as agreement, as a share of the number or in its unit."""
    size = row["tolerance"]
    return (
        f"{100 * size:g} %, relative"
        if row["tolerance_kind"] == "relative"
        else f"{size:g}, absolute"
    )


def _cell(value) -> str:
    if isinstance(value, float):
        return "" if value != value else f"{value:.3g}"
    return str(value).replace("|", "\\|")


def _miss(row: Mapping, paragraph: str) -> str:
    published = f" Published: {row['published']}." if row["published"] else ""
    return (
        f'**{row["id"]}** ({row["place"]}). {row["statement"]} The paper: "{row["quote"]}"'
        f"{published} {paragraph}"
    )
