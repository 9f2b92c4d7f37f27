"""The verdict on every statement of the paper, as tables.

``judge_everything`` evaluates all statements for many sets of inputs: the default, its ensemble,
the inputs of every interpretation, and those of every fold of the cross-validation; the other
functions make tables of the result.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import pandas as pd

from thirdbody.data.places import part_of_paper
from thirdbody.data.spread import spread
from thirdbody.data.tables import TABLES
from thirdbody.study.calibration import Interpretation, Objective, make_folds
from thirdbody.study.checks import Judge, Verdict
from thirdbody.study.claims import Claim
from thirdbody.study.evidence import FULL_EFFORT, QUICK_EFFORT

HOLDS, FAILS, NOT_TESTED = "holds", "fails", "not tested"
CONTRADICTED = "contradicted by the paper itself"
FAINT = 0.01  # half of PROMINENCE, for which the counts are also reported
FAINT_EFFORT = replace(FULL_EFFORT, window=replace(FULL_EFFORT.window, prominence=FAINT))
NO_RANGE = (np.nan, np.nan)
Verdicts = Mapping[str, Verdict]  # by the id of the statement


@dataclass(frozen=True)
class Judged:
    """All statements, evaluated for all sets of inputs.

    ``settings`` is the content of ``config/calibration.yaml``, ``default`` that of the calibrated
    file with the default inputs.  ``verdicts`` are for these inputs, ``faint`` for turning points
    from ``FAINT`` on, ``members`` for the members of the ensemble.  ``interpretations`` has the
    verdicts for the inputs of each interpretation, ``predicted`` those of the default on statements
    whose figure was left out, and ``comparison`` is the table from ``compare``.
    """

    claims: tuple[Claim, ...]
    settings: Mapping[str, Any]
    default: Mapping[str, Any]
    verdicts: Verdicts
    faint: Verdicts
    members: tuple[Verdicts, ...]
    interpretations: dict[str, Verdicts]
    predicted: Verdicts
    comparison: pd.DataFrame

    @cached_property
    def table(self) -> pd.DataFrame:
        """The table ``claims`` of ``thirdbody.data.tables``: a row for each statement, in the order of the paper."""
        claims = self.claims
        verdicts = [self.verdicts[claim.id] for claim in claims]
        ranges = [
            number_ranges(self, claim.id)[verdict.worst] if verdict.numbers else NO_RANGE
            for claim, verdict in zip(claims, verdicts, strict=True)
        ]
        range_low, range_high = np.transpose(ranges)
        sets = {"ensemble": self.members, "interpretations": self.interpretations.values()}
        table = pd.DataFrame(claims).join(pd.DataFrame(verdicts))
        table = table.assign(
            curves=[claim.curves_text for claim in claims],
            published=[published_text(claim) for claim in claims],
            score=[verdict.score for verdict in verdicts],
            value=[verdict.value for verdict in verdicts],
            range_low=range_low,
            range_high=range_high,
            tolerance_kind=np.where(table["relative"], "relative", "absolute"),
            verdict=[outcome(*each) for each in zip(claims, verdicts, strict=True)],
            predicted=[
                outcome(claim, self.predicted[claim.id]) if claim.id in self.predicted else ""
                for claim in claims
            ],
            contradicts=[" ".join(claim.contradicts) for claim in claims],
            **{
                f"{name}_agree": [_agreeing(self, some, claim.id) for claim in claims]
                for name, some in sets.items()
            },
            **{f"{name}_size": len(some) for name, some in sets.items()},
        )
        return table[[column.name for column in TABLES["claims"]]]


def judge_everything(
    judge_all: Judge,
    default: Mapping[str, Any],
    contents: Sequence[Mapping[str, Any]],
    settings: Mapping[str, Any],
) -> Judged:
    """Evaluate all statements for all sets of inputs: ``contents`` are those of the calibrated
    files of all interpretations, the others are as in ``Judged``."""
    inputs = judge_all.base | default["inputs"]
    interpretations = {each["interpretation"]: judge_all(each["inputs"]) for each in contents}
    predicted = {each["interpretation"]: predict(judge_all, each) for each in contents}
    return Judged(
        judge_all.claims,
        settings,
        default,
        judge_all(inputs),
        judge_all(inputs, FAINT_EFFORT),
        tuple(judge_all({**inputs, **member}, QUICK_EFFORT) for member in default["ensemble"]),
        interpretations,
        predicted.get(default["interpretation"], {}),
        compare(judge_all, contents, interpretations, predicted, settings),
    )


def predict(judge_all: Judge, content: Mapping[str, Any]) -> Verdicts:
    """Evaluate each statement for the inputs found without its figure, from the ``content`` of a
    calibrated file; empty without a cross-validation."""
    entries = content.get("folds", ())
    folds = make_folds(judge_all.claims, [each["figures"] for each in entries])
    found = {}
    for fold, entry in zip(folds, entries, strict=True):
        found |= judge_all(entry["inputs"], claims=fold.judged)
    return found


def compare(
    judge_all: Judge,
    contents: Sequence[Mapping[str, Any]],
    interpretations: Mapping[str, Verdicts],
    predicted: Mapping[str, Verdicts],
    settings: Mapping[str, Any],
) -> pd.DataFrame:
    """Compare the interpretations, in the order of the rule that chooses the default.

    The rule: most statements predicted when their figure is left out, then the most plausible
    inputs, then the fewest unknowns.  ``predicted_fraction`` is nan without a cross-validation.
    """
    objective = Objective.of(judge_all.claims, settings, judge_all.base)
    rows = []
    for content in contents:
        name = content["interpretation"]
        interpretation = Interpretation.of(name, settings)
        verdicts = interpretations[name]
        penalty = interpretation.penalty(content["inputs"])
        scores = [verdicts[claim.id].score for claim in objective.claims]
        right, of = count_once(judge_all.claims, predicted[name])
        rows.append(
            {
                "interpretation": name,
                "predicted_fraction": right / of if of else np.nan,
                "predicted": f"{right}/{of}" if of else "not cross-validated",
                "fitted": "{}/{}".format(*count_once(judge_all.claims, verdicts)),
                "penalty": round(penalty, 2),
                "inputs": len(interpretation.unknowns),
                "objective": round(objective.value(penalty, scores), 2),
            }
            | {
                id: verdicts[id].computed + (" ✓" if verdicts[id].holds else "")
                for id in settings["headline"]
                if id in verdicts
            }
        )
    order = ["predicted_fraction", "penalty", "inputs"]
    table = pd.DataFrame(rows, columns=None if rows else order)
    return table.sort_values(order, ascending=[False, True, True], ignore_index=True)


def outcome(claim: Claim, verdict: Verdict) -> str:
    """The word for a verdict; a claim that is set aside neither holds nor fails."""
    if claim.aside:
        return CONTRADICTED
    if not verdict.tested:
        return NOT_TESTED
    return HOLDS if verdict.holds else FAILS


def count_once(claims: Iterable[Claim], verdicts: Verdicts) -> tuple[int, int]:
    """Numbers of statements that hold and are tested; a cluster holds once, if all tested in it do."""
    held: dict[str, bool] = {}
    for claim in claims:
        word = outcome(claim, verdicts[claim.id]) if claim.id in verdicts else NOT_TESTED
        if word in (HOLDS, FAILS):
            held[claim.counted_as] = held.get(claim.counted_as, True) and word == HOLDS
    return sum(held.values()), len(held)


def counts_by_figure(judged: Judged) -> pd.DataFrame:
    """Number of statements with each verdict, by part of the paper."""
    part = judged.table["place"].map(part_of_paper).rename("figure")
    words = [HOLDS, FAILS, NOT_TESTED, CONTRADICTED]
    counts = pd.crosstab(part, judged.table["verdict"])
    counts = counts.reindex(index=part.unique(), columns=words, fill_value=0)
    parts = [
        [claim for claim in judged.claims if part_of_paper(claim.place) == name]
        for name in counts.index
    ]
    held = ["{} of {}".format(*count_once(claims, judged.verdicts)) for claims in parts]
    return counts.assign(**{"hold, repeats once": held}).reset_index()


def headline_table(judged: Judged) -> pd.DataFrame:
    """The headline numbers in the paper, in the model and in the ensemble.

    A number counts as reached if its statement holds, or if it is within its entry of
    ``headline_tolerances``.
    """
    table = judged.table[judged.table["id"].isin(judged.settings["headline"])]
    tolerances = table["id"].map(judged.settings["headline_tolerances"]).fillna(0.0)
    near = table["verdict"].ne(NOT_TESTED) & table["deviation"].abs().le(tolerances)
    return pd.DataFrame(
        {
            "statement": table["statement"],
            "id": table["id"],
            "paper": table["published"],
            "model": table["computed"].map(once),
            "ensemble, 90 %": [once(_range_text(judged, id)) for id in table["id"]],
            "verdict": table["verdict"],
            "reached": table["verdict"].eq(HOLDS) | near,
        }
    )


def _range_text(judged: Judged, id: str) -> str:
    """The range of each number or, without numbers, how many members agree with the verdict."""
    ends = number_ranges(judged, id)
    if not judged.members:
        return "no ensemble"
    if np.isfinite(ends).any():
        return ", ".join(f"{low:.3g} to {high:.3g}" for low, high in ends)
    same = _agreeing(judged, judged.members, id)
    return f"{same} of {len(judged.members)} agree"


def number_ranges(judged: Judged, id: str) -> np.ndarray:
    """Range of 90 % of the ensemble for each number of a statement, shape (numbers, 2); nan if no
    member has the number."""
    members = [each[id].numbers for each in judged.members if each[id].numbers]
    places = range(len(judged.verdicts[id].numbers))
    ends = [spread(each[place] for each in members) or NO_RANGE for place in places]
    return np.reshape(ends, (-1, 2))


def published_text(claim: Claim) -> str:
    """The published value as text; empty if it is neither numbers nor a sequence of states."""
    if claim.published is None:
        return ""
    separator = " > " if claim.kind.endswith("_sequence") else ", "
    return separator.join(str(each) for each in np.atleast_1d(claim.published))


def once(text: str) -> str:
    """A list of results, reduced to one if all are equal: ``0.2, 0.2`` to ``0.2``."""
    parts = text.split(", ")
    return parts[0] if len(set(parts)) == 1 else text


def _agreeing(judged: Judged, sets: Iterable[Verdicts], id: str) -> int:
    """Number of sets of verdicts that agree with the default on a statement."""
    same = judged.verdicts[id].tested, judged.verdicts[id].holds
    return sum((other[id].tested, other[id].holds) == same for other in sets)
