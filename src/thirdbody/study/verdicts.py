"""The verdict on every statement of the paper: as tables, pages for readers and data for programs.

``Report.of`` evaluates all statements for many sets of inputs: the default, its ensemble,
the inputs of every interpretation, and those of every fold of the cross-validation.
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Self

import numpy as np
import pandas as pd
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from thirdbody.core.turning_points import PROMINENCE
from thirdbody.data.quantities import spread
from thirdbody.data.tables import TABLES
from thirdbody.places import part_of_paper
from thirdbody.study.calibration import Fold, Interpretation, Objective, make_folds
from thirdbody.study.claim import Claim, Verdict
from thirdbody.study.evidence import FULL_EFFORT, QUICK_EFFORT
from thirdbody.study.judge import Judge
from thirdbody.typeset import html

HOLDS, FAILS, NOT_TESTED = "holds", "fails", "not tested"
CONTRADICTED = "contradicted by the paper itself"
COUNTED = {
    "holds": "hold",
    "fails": "fail",
    CONTRADICTED: "are " + CONTRADICTED,
    "not tested": "are not tested",
}
FAINT = 0.01  # half of PROMINENCE, for which the counts are also reported
FAINT_EFFORT = replace(FULL_EFFORT, window=replace(FULL_EFFORT.window, prominence=FAINT))
NO_RANGE = (np.nan, np.nan)
Verdicts = Mapping[str, Verdict]  # by the id of the statement


@dataclass(frozen=True, kw_only=True)
class Report:
    """All statements, evaluated for all sets of inputs.

    ``settings`` is the content of ``config/calibration.yaml``, ``default`` that of the calibrated file
    whose inputs ``verdicts`` are for.  ``faint`` is for turning points from ``FAINT`` on, ``fine`` for loads read on a fine axis; ``predicted``
    has the statements whose figure was left out, and ``comparison`` is the table from ``rank_interpretations``.
    """

    claims: tuple[Claim, ...]
    settings: Mapping[str, Any]
    default: Mapping[str, Any]
    verdicts: Verdicts
    faint: Verdicts
    fine: Verdicts
    members: tuple[Verdicts, ...]
    interpretations: dict[str, Verdicts]
    predicted: Verdicts
    comparison: pd.DataFrame

    @classmethod
    def of(
        cls,
        judge: Judge,
        default: Mapping[str, Any],
        contents: Sequence[Mapping[str, Any]],
        settings: Mapping[str, Any],
    ) -> Self:
        """Evaluate all statements for all sets of inputs: ``contents`` are calibrated files of all
        interpretations."""
        inputs = judge.base | default["inputs"]
        evidence = judge.evidence(inputs, FULL_EFFORT, judge.claims)
        verdicts = {claim.id: claim.verdict(evidence) for claim in judge.claims}
        candidates = [
            Candidate.of(judge, each, verdicts if judge.base | each["inputs"] == inputs else None)
            for each in contents
        ]
        predicted = {each.name: each.predicted for each in candidates}
        return cls(
            claims=judge.claims,
            settings=settings,
            default=default,
            verdicts=verdicts,
            faint=judge(inputs, FAINT_EFFORT),
            fine={claim.id: claim.on_a_fine_axis().verdict(evidence) for claim in judge.claims},
            members=tuple(
                judge({**inputs, **member}, QUICK_EFFORT) for member in default["ensemble"]
            ),
            interpretations={each.name: each.verdicts for each in candidates},
            predicted=predicted.get(default["interpretation"], {}),
            comparison=rank_interpretations(judge, candidates, settings),
        )

    @cached_property
    def table(self) -> pd.DataFrame:
        """The table ``claims`` of ``thirdbody.data.tables``: a row for each statement, in the order of the paper."""
        rows, others = [], self.interpretations.values()
        for claim in self.claims:
            verdict, predicted = self.verdicts[claim.id], self.predicted.get(claim.id)
            ranges = number_ranges(self, claim.id)
            low, high = ranges[verdict.worst] if verdict.numbers else NO_RANGE
            rows.append(
                {
                    **vars(claim),
                    **verdict._asdict(),
                    "curves": claim.curves_text,
                    "published": claim.published_text,
                    "score": verdict.score,
                    "value": verdict.value,
                    "range_low": low,
                    "range_high": high,
                    "verdict": outcome(claim, verdict),
                    "predicted": outcome(claim, predicted) if predicted else "",
                    "contradicts": " ".join(claim.contradicts),
                    "ensemble_agree": _agreeing(self, self.members, claim.id),
                    "ensemble_size": len(self.members),
                    "interpretations_agree": _agreeing(self, others, claim.id),
                    "interpretations_size": len(others),
                }
            )
        return pd.DataFrame(rows)[[column.name for column in TABLES["claims"]]]


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """An interpretation that may be the default: the ``content`` of its calibrated file, the ``verdicts`` for its
    inputs, and those ``predicted``, of each statement for the inputs found in the fold that leaves it out."""

    content: Mapping[str, Any]
    verdicts: Verdicts
    predicted: Verdicts
    folds: Sequence[Fold] = ()

    @classmethod
    def of(cls, judge: Judge, content: Mapping[str, Any], verdicts: Verdicts | None = None) -> Self:
        """Evaluate all statements for a calibrated file; ``verdicts`` are those for its inputs, if known."""
        entries = content.get("folds", ())
        folds = make_folds(judge.claims, [each["figures"] for each in entries])
        predicted = {}
        for fold, entry in zip(folds, entries, strict=True):
            predicted |= judge(entry["inputs"], claims=fold.left_out)
        own = verdicts or judge(content["inputs"])
        return cls(content=content, verdicts=own, predicted=predicted, folds=folds)

    @property
    def name(self) -> str:
        """The name of the interpretation in ``config/calibration.yaml``."""
        return self.content["interpretation"]

    @property
    def fold_counts(self) -> list[tuple[int, int]]:
        """Numbers of statements left out of each fold that hold and are tested."""
        return [count_once(fold.left_out, self.predicted) for fold in self.folds]


def rank_interpretations(
    judge: Judge, candidates: Iterable[Candidate], settings: Mapping[str, Any]
) -> pd.DataFrame:
    """Compare the interpretations, in the order of the rule that chooses the default: what is ``required``
    is reached, most statements predicted when their figure is left out, the most plausible inputs, the fewest
    unknowns."""
    objective = Objective.of(judge.claims, settings, judge.base)
    rows = []
    for candidate in candidates:
        inputs, verdicts = candidate.content["inputs"], candidate.verdicts
        interpretation = Interpretation.of(candidate.name, settings)
        penalty = interpretation.penalty(inputs)
        scores = [verdicts[claim.id].score for claim in objective.claims]
        right, of = count_once(judge.claims, candidate.predicted)
        required = settings["required"]
        reached = [id for id in settings["headline"] if id in verdicts and verdicts[id].holds]
        summits = largest_summit_parameter(judge.base | inputs, required)
        suits = len(reached) >= required["headline"] and summits < required["summit_parameter"]
        rows.append(
            {
                "interpretation": candidate.name,
                "predicted_fraction": right / of if of else np.nan,
                "predicted": f"{right}/{of}" if of else "not cross-validated",
                "fitted": "{}/{}".format(*count_once(judge.claims, verdicts)),
                "folds": ", ".join(f"{held}/{tested}" for held, tested in candidate.fold_counts),
                "headline": f"{len(reached)}/{len(settings['headline'])}",
                "summit_parameter": f"{summits:.3f}",
                "eligible": suits and of > 0,
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
    order = {"eligible": False, "predicted_fraction": False, "penalty": True, "inputs": True}
    table = pd.DataFrame(rows, columns=None if rows else [*order])
    return table.sort_values([*order], ascending=[*order.values()], ignore_index=True)


def largest_summit_parameter(inputs: Mapping[str, Any], required: Mapping[str, Any]) -> float:
    """The largest eta_s R sigma [1] of ``inputs`` at the ends of the roughnesses that are ``required``."""
    ends = 1e-9 * np.array(required["roughness_nm"])
    relative = ends / inputs["reference_roughness"]
    power = inputs["summit_parameter_exponent"]
    return float(np.max(inputs["summit_parameter"] * relative**power))


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


def counts_by_figure(report: Report) -> pd.DataFrame:
    """Number of statements with each verdict, by part of the paper."""
    parts: dict[str, list[Claim]] = {}
    for claim in report.claims:
        parts.setdefault(part_of_paper(claim.place), []).append(claim)
    rows = []
    for part, claims in parts.items():
        found = [outcome(claim, report.verdicts[claim.id]) for claim in claims]
        counts = {word: found.count(word) for word in (HOLDS, FAILS, NOT_TESTED, CONTRADICTED)}
        held = "{} of {}".format(*count_once(claims, report.verdicts))
        rows.append({"figure": part, **counts, "hold, repeats once": held})
    return pd.DataFrame(rows)


def headline_table(report: Report) -> pd.DataFrame:
    """The headline numbers in the paper, in the model and in the ensemble; they are reached if their
    statement holds, or within their entry of ``headline_tolerances``."""
    table = report.table[report.table["id"].isin(report.settings["headline"])]
    tolerances = table["id"].map(report.settings["headline_tolerances"]).fillna(0.0)
    near = table["verdict"].ne(NOT_TESTED) & table["deviation"].abs().le(tolerances)
    return pd.DataFrame(
        {
            "statement": table["statement"],
            "id": table["id"],
            "paper": table["published"],
            "model": table["computed"].map(once),
            "ensemble, 90 %": [once(_range_text(report, id)) for id in table["id"]],
            "verdict": table["verdict"],
            "reached": table["verdict"].eq(HOLDS) | near,
        }
    )


def _range_text(report: Report, id: str) -> str:
    """The range of each number or, without numbers, how many members agree with the verdict."""
    ends = number_ranges(report, id)
    if not report.members:
        return "no ensemble"
    if np.isfinite(ends).any():
        return ", ".join(f"{low:.3g} to {high:.3g}" for low, high in ends)
    same = _agreeing(report, report.members, id)
    return f"{same} of {len(report.members)} agree"


def number_ranges(report: Report, id: str) -> np.ndarray:
    """Range of 90 % of the ensemble for each number of a statement, nan without it: shape (numbers, 2)."""
    members = [each[id].numbers for each in report.members if each[id].numbers]
    places = range(len(report.verdicts[id].numbers))
    ends = [spread(each[place] for each in members) or NO_RANGE for place in places]
    return np.reshape(ends, (-1, 2))


def once(text: str) -> str:
    """A list of results, reduced to one if all are equal: ``0.2, 0.2`` to ``0.2``."""
    parts = text.split(", ")
    return parts[0] if len(set(parts)) == 1 else text


def _agreeing(report: Report, sets: Iterable[Verdicts], id: str) -> int:
    """Number of sets of verdicts that agree with the default on a statement."""
    same = report.verdicts[id].tested, report.verdicts[id].holds
    return sum((other[id].tested, other[id].holds) == same for other in sets)


def claims_markdown(report: Report) -> str:
    """The page ``claims.md``: a summary, then every statement."""
    table = report.table
    numbers = headline_table(report)
    failing = table[table["verdict"] == FAILS]
    names = failing["cluster"].replace("", None).fillna(failing["id"])
    return ENVIRONMENT.get_template("claims.md.j2").render(
        report=report,
        score=score_sentence(report),
        reached=numbers["reached"].sum(),
        headline=numbers.drop(columns="id").replace({"reached": {True: "yes", False: "no"}}),
        misfits=[rows.to_dict("records") for _, rows in failing.groupby(names, sort=False)],
        words=dict(zip(table["id"], table["verdict"], strict=True)),
        counts=counts_by_figure(report),
        comparison=report.comparison.drop(columns="predicted_fraction", errors="ignore"),
        statements=table.to_dict("records"),
        failing=failing.to_dict("records"),
    )


def claims_html(report: Report) -> str:
    """The statements and their verdicts as an HTML table, by figure, of which a verdict can be chosen."""
    score = score_sentence(report).replace("**", "")
    parts = report.table.groupby(report.table["place"].map(part_of_paper), sort=False)
    groups = [(part, rows.to_dict("records")) for part, rows in parts]
    reasons = {claim.id: claim.reason for claim in report.claims}
    template = ENVIRONMENT.get_template("claims.html.j2")
    given = {"score": score, "counts": counts_sentence(report), "groups": groups}
    return template.render(reasons=reasons, **given)


def claims_json(report: Report) -> str:
    """The same data for programs, as JSON: statements have the columns of the table ``claims``, lists and
    objects instead of texts, and the ensemble range of each number."""
    held, of = count_once(report.claims, report.verdicts)
    predicted, predicted_of = count_once(report.claims, report.predicted)
    rows = report.table.drop(columns=["range_low", "range_high"]).to_dict("records")
    content = {
        "score": score_sentence(report).replace("**", ""),
        "counts": counts_sentence(report),
        "held": held,
        "judged": of,
        "predicted": predicted,
        "predicted_of": predicted_of,
        "interpretation": report.default["interpretation"],
        "inputs": report.default["inputs"],
        "identification": report.default["identification"],
        "headline": headline_table(report).to_dict("records"),
        "interpretations": report.comparison.to_dict("records"),
        "statements": [
            row
            | {
                "curves": [condition._asdict() for condition in claim.curves],
                "references": [condition._asdict() for condition in claim.references],
                "loads": claim.limits,
                "published": claim.published,
                "numbers": report.verdicts[claim.id].numbers,
                "range": number_ranges(report, claim.id).tolist(),
                "contradicts": list(claim.contradicts),
            }
            for row, claim in zip(rows, report.claims, strict=True)
        ],
    }
    # null for every number that is nan
    content = json.loads(json.dumps(content), parse_constant=lambda name: None)
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def score_sentence(report: Report) -> str:
    """Numbers of statements that hold: predicted, fitted, with fainter turning points, and on a fine axis."""
    sets = {"fitted": report.verdicts, "predicted": report.predicted}
    sets |= {"faint": report.faint, "fine": report.fine}
    counts = {name: count_once(report.claims, verdicts) for name, verdicts in sets.items()}
    texts = ENVIRONMENT.get_template("claims.macros.j2").module
    return texts.score(**counts, prominence=PROMINENCE, faint_prominence=FAINT)


def counts_sentence(report: Report) -> str:
    """Numbers of statements by verdict, repeats included."""
    counts = report.table["verdict"].value_counts()
    texts = [f"{counts[verdict]} {text}" for verdict, text in COUNTED.items() if verdict in counts]
    return f"With repeats the paper makes {counts.sum()} statements: {', '.join(texts)}."


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
ENVIRONMENT.filters |= {"markdown": _as_markdown, "once": once, "cell": _cell, "typeset": html}
