"""The verdicts as a page for a reviewer: counts, then every statement, then those that fail."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tabulate import tabulate

from thirdbody.study.verdicts import (
    FAILS,
    Trial,
    counted_once,
    counts,
    discriminating,
    explanations,
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
        Markdown: counts, how near each reading comes, every verdict, and for each statement that
        fails what would change it.
    """
    rows, why = verdict_rows(trial), explanations(trial)
    compared = reading_rows(trial, readings, headline)
    parts = [
        "# Verdict on every statement of the paper",
        f"Inputs: the best of the reading `{default['reading']}` (objective "
        f"{default['objective']:g} when it was found). A statement holds if it is met within its tolerance; the "
        "statements, tolerances and their reasons are in `config/claims.yaml`, the inputs and "
        "their ensemble in `config/calibrated/`. Statements that repeat one another count once, as held "
        "if all of them hold that are tested; one is not tested if the model does not come to its "
        "condition within the loads. Those that the paper itself contradicts stand apart.",
        _summary(rows),
        f"Of the statements, {len(discriminating(trial))} discriminate between the "
        f"{len(trial.readings)} readings: they hold under some and fail under others.",
        "## Counts by role",
        _counted(rows, "role"),
        "## Counts by figure",
        _counted(rows, "figure"),
        "## How near each reading comes",
        "At the best inputs of each, solved as coarsely as in the calibration (windows to about "
        "0.01); ✓ marks what is within the statement's tolerance. How far the members of each "
        "ensemble come is drawn in `results/figures/conflict.png`.",
        tabulate(compared, headers="keys", tablefmt="github", disable_numparse=True),
        "## Where the paper contradicts itself",
        "Of two sentences that exclude each other one is taken, and the other stays outside the shares "
        "and the calibration.",
        _contradictions(trial, rows),
        "## The statements",
        _statements(rows),
        "## What fails, and what would change it",
        "Scores count tolerances up to 1 and their logarithm beyond. Each input was moved by "
        "itself by 8 % of its bounds, and each reading was judged at its own best inputs.",
        *(_miss(row, why[row["id"]]) for row in rows if row["verdict"] == FAILS),
    ]
    return "\n\n".join(parts) + "\n"


def _summary(rows) -> str:
    outcomes = [(row["cluster"] or row["id"], row["verdict"]) for row in rows]
    held, judged = counted_once(outcomes)
    share = f", {100 * held / judged:.0f} %" if judged else ""
    return f"**{held} of {judged} hold{share}.**"


def _counted(rows, by: str) -> str:
    return tabulate(counts(rows, by), headers="keys", tablefmt="github", disable_numparse=True)


def _contradictions(trial: Trial, rows) -> str:
    """Each statement that stands aside, whether it would hold, and those that are taken instead."""
    verdicts = {row["id"]: row["verdict"] for row in rows}
    cells = [
        {
            "set aside": claim.id,
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
    columns = ("id", "role", "published", "measured", "tolerance", "score", "verdict")
    cells = [
        [
            *(_cell(row[column]) for column in columns),
            f"{row['ensemble_agree']}/{row['ensemble_size']}",
            f"{row['readings_agree']}/{row['readings_size']}",
        ]
        for row in rows
    ]
    headers = [*columns, "ensemble agrees", "readings agree"]
    return tabulate(cells, headers, tablefmt="github", disable_numparse=True)


def _cell(value) -> str:
    if isinstance(value, float):
        return "" if value != value else f"{value:.3g}"
    return str(value).replace("|", "\\|")


def _miss(row: Mapping, paragraph: str) -> str:
    published = f" Published: {row['published']}." if row["published"] else ""
    return (
        f'**{row["id"]}** ({row["where"]}). {row["statement"]} The paper: "{row["sentence"]}"'
        f"{published} {paragraph}"
    )
