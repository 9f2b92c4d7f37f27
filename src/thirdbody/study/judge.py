"""The verdicts on the statements of the paper for any inputs of the model."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from thirdbody.core.parameters import Parameters
from thirdbody.core.turning_points import PROMINENCE
from thirdbody.study.claim import Claim, Verdict
from thirdbody.study.claims import referenced_conditions
from thirdbody.study.evidence import FULL_EFFORT, Effort, Evidence, solve_evidence


@dataclass(frozen=True)
class Judge:
    """Evaluates the same statements for any inputs: ``base`` has inputs missing in a set, fields of
    ``Parameters`` in SI; ``newtons`` are the first and last normal load of every curve [N]."""

    claims: Sequence[Claim]
    base: Mapping[str, Any]
    newtons: tuple[float, float]

    def __call__(
        self,
        inputs: Mapping[str, Any],
        effort: Effort = FULL_EFFORT,
        claims: Sequence[Claim] | None = None,
    ) -> dict[str, Verdict]:
        """Evaluate all statements, or some ``claims``, for ``inputs``, fields of ``Parameters`` in SI:
        verdicts by the ids of the statements, in order.  Unphysical inputs raise ``ValueError``."""
        some = self.claims if claims is None else claims
        prominence = effort.window.prominence
        if prominence != PROMINENCE:  # it is also the tolerance of statements on maxima
            some = [claim.visible_from(prominence) for claim in some]
        evidence = self.evidence(inputs, effort, some)
        return {claim.id: claim.verdict(evidence) for claim in some}

    def evidence(
        self, inputs: Mapping[str, Any], effort: Effort, claims: Sequence[Claim]
    ) -> Evidence:
        """The curves, turning points and windows of the model that ``claims`` need."""
        parameters = Parameters(**{**self.base, **inputs})
        return solve_evidence(parameters, referenced_conditions(claims), self.newtons, effort)
