"""The verdicts on the statements of the paper for any inputs of the model."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from chenhorng.claims.claim import Claim, Verdict
from chenhorng.claims.claims import referenced_conditions
from chenhorng.claims.evidence import FULL_EFFORT, Effort, solve_evidence
from chenhorng.claims.words import CONTRADICTED, FAILS, HOLDS, NOT_TESTED, counted_once
from thirdbody.core.parameters import Parameters

Verdicts = dict[str, Verdict]  # by the id of the statement


@dataclass(frozen=True)
class Judge:
    """A function that evaluates the same statements for any inputs.

    ``base`` has the inputs that a set lacks: fields of ``Parameters`` in SI.  ``newtons`` are the
    first and the last normal load of every curve [N].
    """

    claims: Sequence[Claim]
    base: Mapping[str, Any]
    newtons: tuple[float, float]

    def __call__(
        self,
        inputs: Mapping[str, Any],
        effort: Effort = FULL_EFFORT,
        claims: Sequence[Claim] | None = None,
    ) -> dict[str, Verdict]:
        """Verdicts on all statements, or on some ``claims``, by the ids of the statements, in
        order.  ``inputs`` are fields of ``Parameters`` in SI.  Unphysical inputs raise
        ``ValueError``."""
        claims = self.claims if claims is None else claims
        parameters = Parameters(**{**self.base, **inputs})
        evidence = solve_evidence(parameters, referenced_conditions(claims), self.newtons, effort)
        return {claim.id: claim.verdict(evidence) for claim in claims}


def claim_columns(claim: Claim, verdict: Verdict) -> dict[str, Any]:
    """The columns of the tables ``claims`` and ``own_claims`` that follow from a statement and its
    verdict alone, and all fields of both.
    """
    return {
        **vars(claim),
        **verdict._asdict(),
        "curves": claim.curves_text,
        "published": claim.published_text,
        "score": verdict.score,
        "value": verdict.value,
        "verdict": outcome(claim, verdict),
        "contradicts": " ".join(claim.contradicts),
        "figures": ", ".join(map(str, claim.figures)),
    }


def outcome(claim: Claim, verdict: Verdict) -> str:
    """The word for a verdict; a claim that is set aside neither holds nor fails."""
    if claim.aside:
        return CONTRADICTED
    if not verdict.tested:
        return NOT_TESTED
    return HOLDS if verdict.holds else FAILS


def count_once(
    claims: Iterable[Claim], verdicts: Verdicts, tolerances: float = 1.0
) -> tuple[int, int]:
    """Numbers of statements that hold, at so many ``tolerances`` of each, and that are tested.

    A cluster counts once, and holds if all its tested statements hold.
    """
    known = [(claim, verdicts[claim.id]) for claim in claims if claim.id in verdicts]
    return counted_once(
        (
            claim.counted_as,
            outcome(claim, verdict._replace(distance=verdict.distance / tolerances)),
        )
        for claim, verdict in known
    )
