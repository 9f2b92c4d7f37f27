"""The verdict on every statement of the paper, and what would change those that fail."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from thirdbody.data.places import part_of_paper
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Reading
from thirdbody.study.checks import Verdict, judge
from thirdbody.study.claims import Claim, assign_roles, referenced_conditions
from thirdbody.study.evidence import FULL_EFFORT, QUICK_EFFORT, SolvedEvidence

HOLDS, FAILS = "holds", "fails"
CONTRADICTED, WITHHELD = "contradicted by the paper itself", "value withheld"
LEAST_GAIN = 0.01  # of a score that is worth telling
NUDGE = 0.08  # of an input's bounds: how far one input alone is moved to see what it would change


@dataclass(frozen=True)
class Judgement:
    """Verdicts on all claims, in their order, under one set of inputs."""

    name: str
    verdicts: tuple[Verdict, ...]

    def held(self) -> np.ndarray:
        """Which claims hold."""
        return np.array([verdict.holds for verdict in self.verdicts], dtype=bool)


class Court:
    """Judges the same claims under many sets of inputs."""

    def __init__(self, claims: Sequence[Claim], base: Parameters, newtons):
        self.claims = tuple(claims)
        self.base = base
        self.newtons = newtons
        self.asked = referenced_conditions(claims)

    def judge(self, name: str, inputs: Mapping, effort=QUICK_EFFORT) -> Judgement:
        """Verdicts with ``inputs`` in the place of those of ``base``."""
        parameters = replace(self.base, **inputs)
        evidence = SolvedEvidence(parameters, self.asked, self.newtons, effort)
        return Judgement(name, tuple(judge(claim, evidence) for claim in self.claims))


@dataclass(frozen=True)
class Trial:
    """The claims judged under the default inputs, their ensemble, single changes of theirs, and
    the best inputs of every reading."""

    claims: tuple[Claim, ...]
    main: Judgement
    ensemble: tuple[Judgement, ...]
    nudged: tuple[Judgement, ...]
    readings: tuple[Judgement, ...]

    @classmethod
    def of(cls, court: Court, default: Mapping, reading: Reading, readings: Sequence[Mapping]):
        """``default`` and ``readings`` are contents of calibrated files; ``reading`` is default's."""
        inputs = default["inputs"]
        return cls(
            court.claims,
            court.judge("default", inputs, FULL_EFFORT),
            tuple(court.judge("member", {**inputs, **member}) for member in default["ensemble"]),
            tuple(court.judge(name, changed) for name, changed in _nudges(reading, inputs)),
            tuple(court.judge(each["reading"], each["inputs"]) for each in readings),
        )


def verdict_rows(trial: Trial) -> list[dict]:
    """One row a claim: what is published and measured, the verdict, and how many agree."""
    held = dict(zip((claim.id for claim in trial.claims), trial.main.held(), strict=True))
    roles = assign_roles(trial.claims)
    return [
        {
            "id": claim.id,
            "where": claim.where,
            "statement": claim.statement,
            "kind": claim.kind,
            "role": roles[claim.id],
            "published": _published(claim),
            "measured": verdict.measured,
            "value": verdict.value,
            "deviation": verdict.deviation,
            "tolerance": claim.tolerance,
            "score": verdict.score,
            "verdict": _verdict(claim, verdict, held),
            "ensemble_agree": _agreeing(trial.ensemble, index, verdict),
            "ensemble_size": len(trial.ensemble),
            "readings_agree": _agreeing(trial.readings, index, verdict),
            "readings_size": len(trial.readings),
            "contradicts": " ".join(claim.contradicts),
        }
        for index, (claim, verdict) in enumerate(
            zip(trial.claims, trial.main.verdicts, strict=True)
        )
    ]


def _agreeing(judgements: Sequence[Judgement], index: int, verdict: Verdict) -> int:
    """How many judgements of the claim at ``index`` come to the same as ``verdict``."""
    return sum(bool(each.verdicts[index].holds) == bool(verdict.holds) for each in judgements)


def reading_rows(trial: Trial, readings: Sequence[Mapping], headline: Sequence[str]) -> list[dict]:
    """One row a reading: its objective, the shares that hold, and what it gives for the claims
    whose ids ``headline`` names."""
    roles = assign_roles(trial.claims)
    rows = []
    for judgement, content in zip(trial.readings, readings, strict=True):
        row = {"reading": judgement.name, "objective": content["objective"]}
        for role in ("calibration", "validation"):
            chosen = np.array([roles[claim.id] == role for claim in trial.claims])
            row[role] = f"{judgement.held()[chosen].sum()}/{chosen.sum()}"
        for claim, verdict in zip(trial.claims, judgement.verdicts, strict=True):
            if claim.id in headline:
                row[claim.id] = verdict.measured + (" ✓" if verdict.holds else "")
        rows.append(row)
    return sorted(rows, key=lambda row: row["objective"])


def _published(claim: Claim) -> str:
    """What the paper says, as text; empty where the statement is not a number or a sequence."""
    if claim.published is None:
        return ""
    separator = " > " if claim.kind.endswith("_sequence") else ", "
    return separator.join(str(each) for each in np.atleast_1d(claim.published))


def _verdict(claim: Claim, verdict: Verdict, held: Mapping) -> str:
    """A failed statement whose opposite the paper states as well, and which holds, is no miss."""
    if claim.is_withheld:
        return WITHHELD
    if verdict.holds:
        return HOLDS
    return CONTRADICTED if any(held[other] for other in claim.contradicts) else FAILS


def explanations(trial: Trial) -> dict[str, str]:
    """For each claim that fails, a paragraph: what the model gives, what would change it, and
    which statements forbid that.  By claim id."""
    return {
        claim.id: _paragraph(trial, index)
        for index, (claim, verdict) in enumerate(
            zip(trial.claims, trial.main.verdicts, strict=True)
        )
        if not verdict.holds and not claim.is_withheld
    }


def _nudges(reading: Reading, inputs: Mapping):
    """Each unknown alone, moved down and up by a part of its bounds."""
    for unknown in reading.unknowns:
        for direction, step in (("lower", -NUDGE), ("higher", NUDGE)):
            position = np.clip(unknown.position(inputs[unknown.name]) + step, 0.0, 1.0)
            name = f"{direction} {unknown.name.replace('_', ' ')}"
            yield name, {**inputs, unknown.name: unknown.value(position)}


def _paragraph(trial: Trial, index: int) -> str:
    """What the model gives for the claim at ``index``, and what an input or a reading changes."""
    verdict = trial.main.verdicts[index]
    return " ".join(
        [
            f"The model gives {verdict.measured}, a score of {verdict.score:.2g}.",
            _by_input(trial, index, verdict),
            _by_reading(trial, index),
        ]
    )


def _by_input(trial: Trial, index: int, verdict: Verdict) -> str:
    best = min(trial.nudged, key=lambda each: each.verdicts[index].score)
    found = best.verdicts[index]
    if verdict.score - found.score <= LEAST_GAIN:
        return "No single input, moved by itself, brings it nearer."
    effect = "it would hold" if found.holds else f"its score would fall to {found.score:.2g}"
    return f"With a {best.name} {effect}; {_price(trial, best)}."


def _by_reading(trial: Trial, index: int) -> str:
    better = [other for other in trial.readings if other.verdicts[index].holds]
    if not better:
        return f"It holds under none of the {len(trial.readings)} readings at their best inputs."
    kindest = max(better, key=lambda other: int(other.held().sum()))
    return (
        f"It holds under {len(better)} of {len(trial.readings)} readings "
        f"({', '.join(other.name for other in better)}); under the best of them, {kindest.name}, "
        f"{_price(trial, kindest)}."
    )


def _price(trial: Trial, other: Judgement) -> str:
    """Which statements that hold now forbid a change to ``other``."""
    lost = [
        claim.id
        for claim, before, after in zip(trial.claims, trial.main.held(), other.held(), strict=True)
        if before and not after
    ]
    if not lost:
        return "no statement that holds now forbids it"
    shown = ", ".join(lost[:4]) + (f" and {len(lost) - 4} more" if len(lost) > 4 else "")
    return f"{len(lost)} that hold now forbid it: {shown}"


def counts(rows: Sequence[Mapping], by: str) -> list[dict]:
    """How many statements fare how, in each group of them.

    Parameters
    ----------
    rows : sequence of Mapping
        Rows of the table ``claims``.
    by : str
        ``role``, or ``figure``: the part of the paper that a statement stands in.

    Returns
    -------
    list of dict
        A row a group, in the order of the first statement of each: its name under ``by``, and
        the number of statements under each verdict.
    """
    groups: dict[str, Counter] = {}
    for row in rows:
        group = row["role"] if by == "role" else part_of_paper(row["where"])
        groups.setdefault(group, Counter())[row["verdict"]] += 1
    order = (HOLDS, FAILS, CONTRADICTED, WITHHELD)
    return [{by: name, **{each: count[each] for each in order}} for name, count in groups.items()]
