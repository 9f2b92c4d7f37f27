"""The verdict on every statement of the paper, and what would change those that fail."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from thirdbody.calibration import Reading
from thirdbody.claims import Claim, Verdict, assign_roles, judge, referenced_conditions
from thirdbody.evidence import FULL_EFFORT, QUICK_EFFORT, SolvedEvidence
from thirdbody.parameters import Parameters

HOLDS, FAILS = "holds", "fails"
CONTRADICTED, WITHHELD = "contradicted by the paper itself", "value withheld"
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


def verdict_rows(court: Court, default: Mapping, readings: Sequence[Mapping]) -> list[dict]:
    """One row a claim: what is published and measured, the verdict, and how many agree.

    ``default`` and ``readings`` are contents of calibrated files (``thirdbody.posterior``).
    """
    main = court.judge("default", default["inputs"], FULL_EFFORT)
    ensemble = [
        court.judge(f"member {index}", {**default["inputs"], **member}).held()
        for index, member in enumerate(default["ensemble"])
    ]
    others = [court.judge(each["reading"], each["inputs"]).held() for each in readings]
    held = dict(zip((claim.id for claim in court.claims), main.held(), strict=True))
    roles = assign_roles(court.claims)
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
            "ensemble_agree": int(sum(member[index] == verdict.holds for member in ensemble)),
            "ensemble_size": len(ensemble),
            "readings_agree": int(sum(other[index] == verdict.holds for other in others)),
            "readings_size": len(others),
            "contradicts": " ".join(claim.contradicts),
        }
        for index, (claim, verdict) in enumerate(zip(court.claims, main.verdicts, strict=True))
    ]


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


def explanations(
    court: Court, default: Mapping, reading: Reading, readings: Sequence[Mapping]
) -> dict[str, str]:
    """For each claim that fails, a paragraph: what the model gives, what would change it, and
    which statements forbid that.  By claim id."""
    main = court.judge("default", default["inputs"])
    nudged = [
        court.judge(f"{name} {direction}", inputs)
        for name, direction, inputs in _nudges(reading, default["inputs"])
    ]
    others = [court.judge(each["reading"], each["inputs"]) for each in readings]
    failed = [
        index
        for index, (claim, verdict) in enumerate(zip(court.claims, main.verdicts, strict=True))
        if not verdict.holds and not claim.is_withheld
    ]
    return {
        court.claims[index].id: _paragraph(court, index, main, nudged, others) for index in failed
    }


def _nudges(reading: Reading, inputs: Mapping):
    """Each unknown alone, moved down and up by a part of its bounds."""
    for unknown in reading.unknowns:
        for direction, step in (("lower", -NUDGE), ("higher", NUDGE)):
            position = np.clip(unknown.position(inputs[unknown.name]) + step, 0.0, 1.0)
            yield unknown.name, direction, {**inputs, unknown.name: unknown.value(position)}


def _paragraph(court: Court, index: int, main: Judgement, nudged, others) -> str:
    claim, verdict = court.claims[index], main.verdicts[index]
    sentences = [f"The model gives {verdict.measured}, {verdict.score:.2g} tolerances off."]
    best = min(nudged, key=lambda each: _order(each.verdicts[index].score))
    gain = verdict.score - best.verdicts[index].score
    if gain > 0.01:
        result = "would hold" if best.verdicts[index].holds else "would come nearest, by "
        if not best.verdicts[index].holds:
            result += f"{gain:.2g} tolerances"
        sentences.append(f"Of the inputs, a {_words(best.name)} {result}; {_price(court, main, best)}.")
    else:
        sentences.append("No single input, moved by itself, brings it nearer.")
    better = [other for other in others if other.verdicts[index].holds]
    if better:
        kindest = max(better, key=lambda other: int(other.held().sum()))
        names = ", ".join(other.name for other in better)
        sentences.append(
            f"It holds under {len(better)} of {len(others)} readings ({names}); under the best of "
            f"them, {kindest.name}, {_price(court, main, kindest)}."
        )
    else:
        sentences.append(f"It holds under none of the {len(others)} readings at their best inputs.")
    return " ".join(sentences)


def _words(name: str) -> str:
    """``summit_radius higher`` as ``higher summit radius``."""
    unknown, direction = name.split()
    return f"{direction} {unknown.replace('_', ' ')}"


def _order(score: float) -> float:
    return score if np.isfinite(score) else np.inf


def _price(court: Court, main: Judgement, other: Judgement) -> str:
    """Which statements that hold now forbid a change to ``other``."""
    lost = [
        claim.id
        for claim, before, after in zip(court.claims, main.held(), other.held(), strict=True)
        if before and not after
    ]
    if not lost:
        return "no statement that holds now forbids it"
    shown = ", ".join(lost[:4]) + (f" and {len(lost) - 4} more" if len(lost) > 4 else "")
    return f"{len(lost)} that hold now forbid it: {shown}"


def counts(rows: Sequence[Mapping], by: str) -> list[dict]:
    """Numbers of each verdict among ``rows``, by ``role`` or by ``figure``."""
    groups: dict[str, Counter] = {}
    for row in rows:
        key = row["role"] if by == "role" else row["where"].split(",")[0].rstrip("ABCD")
        groups.setdefault(key, Counter())[row["verdict"]] += 1
    order = (HOLDS, FAILS, CONTRADICTED, WITHHELD)
    return [{by: key, **{name: count[name] for name in order}} for key, count in groups.items()]
