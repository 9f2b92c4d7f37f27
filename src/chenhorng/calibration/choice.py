"""The rule that chooses the default among calibrated interpretations.

1. Each interpretation has a left-out loss.  It sums the losses of the statements of all folds,
   for the inputs that were found without them.
2. Interpretations are equal if their loss is above the least by no more than one standard error of
   the difference, from the differences by figure (Breiman et al. 1984, Classification and
   Regression Trees; Hastie, Tibshirani & Friedman 2009, The Elements of Statistical Learning,
   section 7.10).
3. The default is the equal with the fewest unknowns: the most parsimonious model within one
   standard error.  Then the least left-out loss decides, then the least penalty.
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
    """An interpretation that may be the default.

    ``content`` is that of its calibrated file, and ``verdicts`` are for its inputs.  ``predicted``
    has the verdict on each statement for the inputs of the fold that leaves the statement out.
    """

    content: Mapping[str, Any]
    verdicts: Verdicts
    predicted: Verdicts

    @classmethod
    def of(cls, judge: Judge, content: Mapping[str, Any], verdicts: Verdicts | None = None) -> Self:
        """Evaluate all statements for the ``content`` of a calibrated file; ``verdicts`` are for
        its inputs, if they are known.
        """
        entries = content.get("folds", ())
        predicted: Verdicts = {}
        for entry in entries:  # a statement that was in no search is not predicted
            left_out = tuple(claim for claim in judge.claims if claim.id in entry["left_out"])
            predicted |= judge(entry["inputs"], claims=left_out)
        fitted = verdicts or judge(content["inputs"])
        return cls(content=content, verdicts=fitted, predicted=predicted)

    @property
    def name(self) -> str:
        """The name of the interpretation in ``config/calibration.yaml``."""
        return self.content["interpretation"]


def left_out_losses(objective: Objective, predicted: Verdicts) -> pd.Series:
    """Losses [1] of the ``predicted`` statements, summed by their first figure; empty without
    predicted statements."""
    claims = [claim for claim in objective.claims if claim.id in predicted]
    figures = [min(claim.all_figures) for claim in claims]
    losses = objective.losses([predicted[claim.id].score for claim in claims], claims)
    return pd.Series(losses, index=figures, dtype=float).groupby(level=0).sum()


def excess_over(losses: pd.Series, least: pd.Series) -> tuple[float, float]:
    """Sum of the differences of two ``left_out_losses`` [1], and its standard error from the
    differences by figure.
    """
    differences = losses - least
    return differences.sum(), math.sqrt(len(differences)) * differences.std()


def printed_numbers(
    claims: Iterable[Claim], verdicts: Verdicts, ids: Sequence[str]
) -> pd.DataFrame:
    """Each printed number of the statements ``ids``, the computed number, its relative deviation,
    which is -1 if the model has no such number, and whether it lies inside the tolerance."""
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
            low, high = sorted(claim.interval(printed))
            rows[-1]["inside"] = "yes" if low <= number <= high else "no"
    return pd.DataFrame(rows)


def rank_interpretations(
    judge: Judge, candidates: Iterable[Candidate], settings: Mapping[str, Any]
) -> pd.DataFrame:
    """Compare the interpretations: a row for each, in the order of the rule.

    A row has the left-out loss, its excess above the least loss, the standard error of the excess,
    and whether the interpretation is ``equal``.
    """
    objective = Objective.of(judge.claims, settings, judge.base)
    candidates = list(candidates)
    losses = {
        candidate.name: left_out_losses(objective, candidate.predicted) for candidate in candidates
    }
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
                "fitted": "{}/{}".format(*count_once(judge.claims, verdicts)),
                "headline": f"{len(reached)}/{len(settings['headline'])}",
                "summit_parameter": largest_summit_parameter(judge.base | inputs, settings),
                "apparent_area": (judge.base | inputs)["apparent_area"],
                "penalty": round(penalty, 2),
                "unknowns": len(interpretation.unknowns),
                "objective": round(objective.value(penalty, scores), 2),
            }
        )
    table = pd.DataFrame(rows)
    if table.empty:
        return table
    table["unequal"] = ~table["equal"]
    # interpretations that are not equal are in the order of their losses
    table["first"] = table["left_out_loss"].where(table["unequal"], 0.0)
    order = ["unequal", "first", "unknowns", "left_out_loss", "penalty"]
    return table.sort_values(order, ignore_index=True).drop(columns=["unequal", "first"])


def largest_summit_parameter(inputs: Mapping[str, Any], settings: Mapping[str, Any]) -> float:
    """The largest eta_s R sigma [1] of the ``inputs`` on the surfaces of Table 2."""
    ends = 1e-9 * np.array(settings["roughness_nm"])
    relative = ends / inputs["reference_roughness"]
    power = inputs["summit_parameter_exponent"]
    return float(np.max(inputs["summit_parameter"] * relative**power))
