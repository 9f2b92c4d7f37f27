"""The verdict on every statement of the paper: as tables, pages for readers and data for programs.

``Report.of`` evaluates all statements for many sets of inputs: the default, its ensemble,
the inputs of every interpretation, and those of every fold of the cross-validation.
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import numpy as np
import pandas as pd
from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from chenhorng.calibration.choice import Candidate, printed_numbers, rank_interpretations
from chenhorng.claims.claim import Claim, Verdict
from chenhorng.claims.evidence import QUICK_EFFORT
from chenhorng.claims.judge import (
    FAILS,
    HOLDS,
    Judge,
    Verdicts,
    claim_columns,
    count_once,
    outcome,
)
from chenhorng.claims.words import COLOURS, counts_sentence, number
from chenhorng.places import part_of_paper
from chenhorng.tables import TABLES
from thirdbody.core.turning_points import PROMINENCE
from thirdbody.ensembles import RANGE, range_over_members
from thirdbody.symbols import html

NO_RANGE = (np.nan, np.nan)
# of a bullet graph, in its units: the middle, the length of a tolerance, and the last place
MIDDLE, TOLERANCE, LAST = 50.0, 20.0, 46.0


@dataclass(frozen=True, kw_only=True)
class Report:
    """All statements, evaluated for all sets of inputs.

    ``settings`` is the content of ``config/calibration.yaml``.  ``default`` is the content of the
    calibrated file, with the ``inputs`` of the run; ``verdicts`` are for these inputs.
    ``predicted`` has the verdicts on statements for inputs that were found without their figure; it
    is empty if no search found the inputs of the run.  ``comparison`` is the table from
    ``rank_interpretations``.  ``has_calibrated_inputs`` says whether the inputs of the run are
    those of the calibrated file.
    """

    claims: Sequence[Claim]
    settings: Mapping[str, Any]
    default: Mapping[str, Any]
    verdicts: Verdicts
    members: tuple[Verdicts, ...]
    interpretations: dict[str, Verdicts]
    predicted: Verdicts
    comparison: pd.DataFrame
    has_calibrated_inputs: bool = False

    @classmethod
    def of(
        cls,
        judge: Judge,
        default: Mapping[str, Any],
        contents: Sequence[Mapping[str, Any]],
        settings: Mapping[str, Any],
        *,
        inputs: Mapping[str, Any],
        ensemble: Sequence[Mapping[str, Any]],
    ) -> Self:
        """Evaluate all statements for all sets of inputs.

        ``default`` and ``contents`` are the calibrated files of the default and of all
        interpretations.  ``inputs`` and ``ensemble`` belong to the run.
        """
        every = {**judge.base, **inputs}

        def is_of_the_run(content):
            return judge.base | content["inputs"] == every

        verdicts = judge(every)
        candidates = [
            Candidate.of(judge, content, verdicts if is_of_the_run(content) else None)
            for content in contents
        ]
        predicted = {
            candidate.name: candidate.predicted
            for candidate in candidates
            if is_of_the_run(candidate.content)
        }
        return cls(
            claims=judge.claims,
            settings=settings,
            default={**default, "inputs": inputs},
            verdicts=verdicts,
            members=tuple(judge({**every, **member}, QUICK_EFFORT) for member in ensemble),
            interpretations={candidate.name: candidate.verdicts for candidate in candidates},
            predicted=predicted.get(default["interpretation"], {}),
            comparison=rank_interpretations(judge, candidates, settings),
            has_calibrated_inputs=is_of_the_run(default),
        )

    @cached_property
    def table(self) -> pd.DataFrame:
        """The table ``claims`` of ``chenhorng.tables``: a row for each statement, in the order of
        the paper.
        """
        rows, others = [], self.interpretations.values()
        for claim in self.claims:
            verdict, predicted = self.verdicts[claim.id], self.predicted.get(claim.id)
            ranges = number_ranges(self, claim.id)
            low, high = ranges[verdict.worst] if verdict.numbers else NO_RANGE
            rows.append(
                {
                    **claim_columns(claim, verdict),
                    "range_low": low,
                    "range_high": high,
                    "predicted": outcome(claim, predicted) if predicted else "",
                    "ensemble_agree": _agreeing(self, self.members, claim.id),
                    "ensemble_size": len(self.members),
                    "interpretations_agree": _agreeing(self, others, claim.id),
                    "interpretations_size": len(others),
                }
            )
        return pd.DataFrame(rows)[[column.name for column in TABLES["claims"]]]


def headline_table(report: Report) -> pd.DataFrame:
    """The headline numbers in the paper, in the model and in the ensemble."""
    table = report.table[report.table["id"].isin(report.settings["headline"])]
    return pd.DataFrame(
        {
            "statement": table["statement"],
            "id": table["id"],
            "paper": table["published"],
            "model": table["computed"].map(once),
            "range of the ensemble": [once(_range_text(report, id)) for id in table["id"]],
            "verdict": table["verdict"],
        }
    )


def _range_text(report: Report, id: str) -> str:
    """The range of each number as text; without numbers, how many members of the ensemble agree."""
    ends = number_ranges(report, id)
    if not report.members:
        return "no ensemble"
    if np.isfinite(ends).any():
        return ", ".join(f"{low:.3g} to {high:.3g}" for low, high in ends)
    same = _agreeing(report, report.members, id)
    return f"{same} of {len(report.members)} agree"


def number_ranges(report: Report, id: str) -> np.ndarray:
    """The range of the ensemble for each number of a statement: shape (numbers, 2), nan
    without an ensemble.
    """
    members = [verdicts[id].numbers for verdicts in report.members if verdicts[id].numbers]
    if not members:
        return np.full((len(report.verdicts[id].numbers), 2), np.nan)
    return range_over_members(members).T


def once(text: str) -> str:
    """A list of results, or a single result if all are equal: ``0.2`` for ``0.2, 0.2``."""
    parts = text.split(", ")
    return parts[0] if len(set(parts)) == 1 else text


def _agreeing(report: Report, sets: Iterable[Verdicts], id: str) -> int:
    """The number of sets of verdicts that agree with the default on a statement."""
    same = report.verdicts[id].tested, report.verdicts[id].holds
    return sum((other[id].tested, other[id].holds) == same for other in sets)


def claims_markdown(report: Report) -> str:
    """The page ``claims.md``: a summary, then all statements."""
    table = report.table
    numbers = headline_table(report)
    failing = table[table["verdict"] == FAILS]
    names = failing["cluster"].replace("", None).fillna(failing["id"])
    return ENVIRONMENT.get_template("claims.md.j2").render(
        report=report,
        score=score_sentence(report),
        range=RANGE,
        reached=numbers["verdict"].eq(HOLDS).sum(),
        headline=numbers.drop(columns="id"),
        numbers=len(printed_numbers(report.claims, report.verdicts, report.settings["headline"])),
        misfits=[rows.to_dict("records") for _, rows in failing.groupby(names, sort=False)],
        words=dict(zip(table["id"], table["verdict"], strict=True)),
        comparison=report.comparison,
        claims={claim.id: claim for claim in report.claims},
        statements=table.to_dict("records"),
        failing=failing.to_dict("records"),
    )


def claims_html(report: Report) -> str:
    """The statements and their verdicts as an HTML table, by figure; readers can show one verdict
    alone.
    """
    score = score_sentence(report).replace("**", "")
    parts = report.table.groupby(report.table["place"].map(part_of_paper), sort=False)
    groups = [(part, rows.to_dict("records")) for part, rows in parts]
    return ENVIRONMENT.get_template("claims.html.j2").render(
        score=score,
        counts=counts_sentence(report.table.to_dict("records")),
        groups=groups,
        verdicts=report.verdicts,
        claims={claim.id: claim for claim in report.claims},
        bullets={claim.id: bullets(claim, report.verdicts[claim.id]) for claim in report.claims},
        colours={verdict.split()[0]: colour for verdict, colour in COLOURS.items()},
        ends=(MIDDLE - TOLERANCE, MIDDLE, 2.0 * TOLERANCE, LAST),
    )


def bullets(claim: Claim, verdict: Verdict) -> list[dict[str, Any]]:
    """A bullet graph of each number that the paper prints in a statement: the number as text, and
    how far the computed numbers lie from it, in tolerances [1]; none for words without a number,
    and none for a number that a curve reaches or passes."""
    published = np.atleast_1d(claim.published)
    is_printed = not claim.stands_for or any(map(str.isdigit, claim.stands_for))
    if claim.kind == "reach" or not is_printed or published.dtype.kind != "f":
        return []
    if not np.isfinite(verdict.numbers).all():
        return []
    found = np.reshape(verdict.numbers, (-1, published.size))
    offsets = np.reshape(claim.offsets(found), found.shape)
    return [
        {"printed": number(value, 4), "offsets": dict.fromkeys(np.round(own, 3).tolist())}
        for value, own in zip(published.tolist(), offsets.T, strict=True)
        if own.size
    ]


def claims_json(report: Report) -> str:
    """The statements and their verdicts for programs, as JSON.

    A statement has the columns of the table ``claims``, with lists and objects instead of texts.
    It also has the part of the paper, the finding as a sentence, the range of each number
    over the ensemble, the reason for the tolerance, and ``verdicts_of``: its verdict with the
    inputs of each interpretation.
    """
    held, of = count_once(report.claims, report.verdicts)
    predicted, predicted_of = count_once(report.claims, report.predicted)
    rows = report.table.drop(columns=["range_low", "range_high"]).to_dict("records")
    content = {
        "score": score_sentence(report).replace("**", ""),
        "counts": counts_sentence(report.table.to_dict("records")),
        "held": held,
        "judged": of,
        "predicted": predicted,
        "predicted_of": predicted_of,
        "interpretation": report.default["interpretation"],
        "inputs": report.default["inputs"],
        "headline": headline_table(report).to_dict("records"),
        "interpretations": report.comparison.to_dict("records"),
        "statements": [
            row
            | {
                "part": part_of_paper(claim.place),
                "finding": report.verdicts[claim.id].finding,
                "curves": [condition._asdict() for condition in claim.curves],
                "references": [condition._asdict() for condition in claim.references],
                "loads": claim.limits,
                "published": claim.published,
                "numbers": report.verdicts[claim.id].numbers,
                "range": number_ranges(report, claim.id).tolist(),
                "contradicts": list(claim.contradicts),
                "reason": claim.reason,
                "verdicts_of": {
                    name: outcome(claim, verdicts[claim.id])
                    for name, verdicts in report.interpretations.items()
                },
            }
            for row, claim in zip(rows, report.claims, strict=True)
        ],
    }
    # JSON has no nan: the page has null
    content = json.loads(json.dumps(content), parse_constant=lambda name: None)
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def score_sentence(report: Report) -> str:
    """The sentence on how many statements hold, fitted and predicted."""
    fitted = count_once(report.claims, report.verdicts)
    predicted = count_once(report.claims, report.predicted)
    texts: Any = ENVIRONMENT.get_template("claims.macros.j2").module  # its macros are attributes
    compared = len(report.settings["interpretations"])
    half, twice = (count_once(report.claims, report.verdicts, each)[0] for each in (0.5, 2.0))
    return texts.score(
        fitted=fitted,
        predicted=predicted,
        compared=compared,
        half=half,
        twice=twice,
        by_definition=sum(bool(claim.by_definition) for claim in report.claims),
        impossible=sum(bool(claim.impossible) for claim in report.claims),
        prominence=PROMINENCE,
    ).replace("\n", " ")


def _cell(value: Any) -> str:
    """A value as a cell of a table in Markdown."""
    return str(value).replace("|", "\\|")


def _as_markdown(table: pd.DataFrame) -> str:
    return table.map(_cell).to_markdown(index=False, disable_numparse=True)


ENVIRONMENT = Environment(
    loader=PackageLoader("chenhorng.claims", "."),
    autoescape=select_autoescape(["html.j2"]),
    undefined=StrictUndefined,
    keep_trailing_newline=True,
)
ENVIRONMENT.filters |= {"markdown": _as_markdown, "once": once, "cell": _cell, "typeset": html}
