"""The rule that chooses the default among calibrated interpretations, and the ensemble of its
equals.

1. The loss of what was left out: that of the objective, over the statements of each fold, for the
   inputs that were found without them.
2. Interpretations are equal if their loss is above the least by no more than one standard error of
   the difference, from the differences by figure (Breiman et al. 1984, Classification and
   Regression Trees; Hastie, Tibshirani & Friedman 2009, The Elements of Statistical Learning,
   section 7.10).
3. Of equals, the least mean deviation of the printed numbers; then the fewest unknowns; then the
   least penalty.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
import pandas as pd

from chenhorng.calibration.calibration import Interpretation, Objective
from chenhorng.claims.claim import Claim
from chenhorng.claims.judge import Judge, Verdicts, count_once


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """An interpretation that may be the default: the ``content`` of its calibrated file, the
    ``verdicts`` for its inputs, those ``predicted``, of each statement for the inputs found in the
    fold that leaves it out, and the statements left out of each of the ``folds``."""

    content: Mapping[str, Any]
    verdicts: Verdicts
    predicted: Verdicts
    folds: Sequence[Sequence[Claim]] = ()

    @classmethod
    def of(cls, judge: Judge, content: Mapping[str, Any], verdicts: Verdicts | None = None) -> Self:
        """Evaluate all statements for a calibrated file; ``verdicts`` are those for its inputs, if
        known.
        """
        entries = content.get("folds", ())
        folds: list[Sequence[Claim]] = []
        predicted: Verdicts = {}
        for entry in entries:  # a statement that was in no search is not predicted
            left_out = tuple(claim for claim in judge.claims if claim.id in entry["left_out"])
            folds.append(left_out)
            predicted |= judge(entry["inputs"], claims=left_out)
        fitted = verdicts or judge(content["inputs"])
        return cls(content=content, verdicts=fitted, predicted=predicted, folds=folds)

    @property
    def name(self) -> str:
        """The name of the interpretation in ``config/calibration.yaml``."""
        return self.content["interpretation"]

    @property
    def fold_counts(self) -> list[tuple[int, int]]:
        """Numbers of statements left out of each fold that hold and are tested."""
        return [count_once(left_out, self.predicted) for left_out in self.folds]


def left_out_losses(objective: Objective, predicted: Verdicts) -> pd.Series:
    """Loss [1] of the statements ``predicted`` without their figures, by the figure of a statement;
    empty if there are none."""
    claims = [claim for claim in objective.claims if claim.id in predicted]
    figures = [min(claim.all_figures) for claim in claims]
    losses = objective.losses([predicted[claim.id].score for claim in claims], claims)
    return pd.Series(losses, index=figures, dtype=float).groupby(level=0).sum()


def excess_over(losses: pd.Series, least: pd.Series) -> tuple[float, float]:
    """Sum of the differences of two ``left_out_losses`` [1], and its standard error from those by
    figure.
    """
    differences = losses - least
    return differences.sum(), math.sqrt(len(differences)) * differences.std()


def printed_numbers(
    claims: Iterable[Claim], verdicts: Verdicts, ids: Sequence[str]
) -> pd.DataFrame:
    """Each number that the statements ``ids`` print, the computed one, and the relative deviation
    of the latter; -1 where the model has no such number."""
    rows: list[dict[str, Any]] = []
    for claim in claims:
        if claim.id not in ids or claim.published is None or isinstance(claim.published, str):
            continue
        published = np.atleast_1d(claim.published)
        if published.dtype.kind != "f":
            continue
        verdict = verdicts[claim.id]
        computed = verdict.numbers if published.size > 1 else (verdict.value,)
        for printed, number in zip(published.tolist(), computed, strict=True):
            deviation = number / printed - 1.0 if np.isfinite(number) else -1.0
            rows.append({"id": claim.id, "place": claim.place, "statement": claim.statement})
            rows[-1] |= {"printed": printed, "computed": number, "deviation": deviation}
    return pd.DataFrame(rows)


def rank_interpretations(
    judge: Judge, candidates: Iterable[Candidate], settings: Mapping[str, Any]
) -> pd.DataFrame:
    """Compare the interpretations, in the order of the rule: a row for each, with the loss of what
    was left out, by how much that is above the least, the standard error of the excess, and whether
    it is ``equal``."""
    objective = Objective.of(judge.claims, settings, judge.base)
    candidates = list(candidates)
    losses = {each.name: left_out_losses(objective, each.predicted) for each in candidates}
    totals = {name: series.sum() if len(series) else np.nan for name, series in losses.items()}
    cross_validated = {name: total for name, total in totals.items() if not math.isnan(total)}
    best = min(cross_validated, key=cross_validated.__getitem__, default=None)
    least = None if best is None else losses[best]
    rows = []
    for candidate in candidates:
        inputs, verdicts = candidate.content["inputs"], candidate.verdicts
        interpretation = Interpretation.of(candidate.name, settings)
        penalty = interpretation.penalty(inputs)
        scores = [verdicts[claim.id].score for claim in objective.claims]
        predicted, predicted_of = count_once(judge.claims, candidate.predicted)
        excess, error = np.nan, np.nan
        if predicted_of:
            excess, error = excess_over(losses[candidate.name], least)
        deviations = printed_numbers(judge.claims, verdicts, settings["headline"])["deviation"]
        reached = [id for id in settings["headline"] if id in verdicts and verdicts[id].holds]
        rows.append(
            {
                "interpretation": candidate.name,
                "left_out_loss": round(totals[candidate.name], 2),
                "above_least": round(excess, 2),
                "standard_error": round(error, 2),
                "equal": bool(excess <= error),
                "mean_deviation": deviations.abs().mean(),
                "median_deviation": deviations.abs().median(),
                "predicted": f"{predicted}/{predicted_of}"
                if predicted_of
                else "not cross-validated",
                "folds": ", ".join(f"{held}/{tested}" for held, tested in candidate.fold_counts),
                "fitted": "{}/{}".format(*count_once(judge.claims, verdicts)),
                "headline": f"{len(reached)}/{len(settings['headline'])}",
                "summit_parameter": largest_summit_parameter(judge.base | inputs, settings),
                "penalty": round(penalty, 2),
                "unknowns": len(interpretation.unknowns),
                "objective": round(objective.value(penalty, scores), 2),
            }
        )
    table = pd.DataFrame(rows)
    if table.empty:
        return table
    table["unequal"] = ~table["equal"]
    # what is not equal is in the order of its loss
    table["first"] = table["left_out_loss"].where(table["unequal"], 0.0)
    order = ["unequal", "first", "mean_deviation", "unknowns", "penalty"]
    return table.sort_values(order, ignore_index=True).drop(columns=["unequal", "first"])


def largest_summit_parameter(inputs: Mapping[str, Any], settings: Mapping[str, Any]) -> float:
    """The largest eta_s R sigma [1] of ``inputs`` on the surfaces of Table 2."""
    ends = 1e-9 * np.array(settings["roughness_nm"])
    relative = ends / inputs["reference_roughness"]
    power = inputs["summit_parameter_exponent"]
    return float(np.max(inputs["summit_parameter"] * relative**power))


def choose_default(
    judge: Judge, contents: Sequence[Mapping[str, Any]], settings: Mapping[str, Any]
) -> tuple[dict[str, Any], pd.DataFrame]:
    """What the calibrated file of the default has beside its own content, and all interpretations
    in the order of the rule, from the ``contents`` of their calibrated files."""
    candidates = {each["interpretation"]: Candidate.of(judge, each) for each in contents}
    table = rank_interpretations(judge, candidates.values(), settings)
    equals = table.loc[table["equal"], "interpretation"]
    members, names = equal_ensemble(
        [candidates[name].content for name in equals], settings["ensemble"]
    )
    chosen = {
        "interpretation": table.loc[0, "interpretation"],
        "ensemble": members,
        "ensemble_interpretations": names,
    }
    return chosen, table


def equal_ensemble(
    contents: Sequence[Mapping[str, Any]], least: int
) -> tuple[list[dict[str, Any]], list[str]]:
    """The inputs of an ensemble of at least ``least`` members, SI, and the interpretation of each:
    as many from each of the calibrated files, evenly among theirs, those of the default first."""
    members, names = [], []
    count = math.ceil(least / len(contents))
    for content in contents:
        sets = content["ensemble"]
        places = np.linspace(0, len(sets) - 1, count).round().astype(int)
        members += [{**content["inputs"], **sets[place]} for place in places]
        names += [content["interpretation"]] * count
    return members, names
