"""The statements of the paper, read from ``config/claims.yaml``; the conditions that they need; and
the table of their printed numbers."""

from collections.abc import Iterable, Sequence
from itertools import product
from pathlib import Path
from typing import Annotated

import numpy as np
from pydantic import BaseModel, ConfigDict, ValidationError

from chenhorng.claims.claim import Claim
from chenhorng.claims.fields import Tolerance
from chenhorng.claims.kinds import KINDS
from chenhorng.configuration.model import first_fault, one_of
from chenhorng.places import FIGURE
from chenhorng.sampling import CURVE_QUANTITIES
from thirdbody.files import read_yaml


class Head(BaseModel):
    """The fields of an entry of ``config/claims.yaml`` that are read before its kind is known."""

    model_config = ConfigDict(extra="allow", strict=True, allow_inf_nan=False)

    id: str
    kind: Annotated[str, one_of(*KINDS)]
    tolerance: Tolerance


def load_claims(path: str | Path) -> tuple[Claim, ...]:
    """Read the statements of the paper, in order.  ``ValueError``, in one line, names a statement
    that lacks a field of its kind, or has a field of another kind, a value that is not allowed, or
    the id of another statement."""
    claims: dict[str, Claim] = {}
    for number, entry in enumerate(read_yaml(path, list), 1):
        name = entry.get("id", number) if isinstance(entry, dict) else number
        try:
            head = Head.model_validate(entry)
            ((kind, size),) = head.tolerance.kinds.items()
            fields = {"tolerance": size, "tolerance_kind": kind, "reason": head.tolerance.reason}
            claim = KINDS[head.kind](**entry | fields)
        except ValidationError as error:
            raise ValueError(f"{path}: {name!r:.100}: {first_fault(error)}") from None
        if claims.setdefault(claim.id, claim) is not claim:
            raise ValueError(f"{path}: {name!r:.100}: another statement has this id")
    return tuple(claims.values())


def referenced_conditions(claims: Sequence[Claim]) -> dict[str, set]:
    """The conditions that ``solve_evidence`` must solve for ``claims``: a set of ``Condition`` for
    ``curve`` and ``turning_point``, and a set of sigma [m] for ``window``."""
    asked: dict[str, set] = {"curve": set(), "turning_point": set(), "window": set()}
    for claim in claims:
        for condition in claim.curves + claim.references:
            asked[claim.source].add(condition.roughness if claim.source == "window" else condition)
    return asked


def printed_rows(claims: Iterable[Claim]) -> list[dict]:
    """Rows of the table ``printed``: a printed number with its tolerance, for each of its curves.
    A change from a reference has no row, as it is not a point in a figure."""
    rows = []
    for claim in claims:
        number = FIGURE.match(claim.place)
        levels = [(name, value) for name, value in claim.limits.items() if name in CURVE_QUANTITIES]
        at_quantity, at_level = levels[0] if levels else ("", None)
        for condition, (extreme, quantity, value) in product(claim.curves, claim.printed_numbers):
            low, high = claim.interval(value)
            known = {n: None if np.isnan(v) else v for n, v in condition.columns.items()}
            rows.append(
                {
                    "id": claim.id,
                    "figure": f"fig{int(number[1]):02d}" if number else "",
                    "at_quantity": at_quantity,
                    "at_level": at_level,
                    "load_max": claim.limits.get("load_max"),
                    "load_max_N": claim.limits.get("load_max_N"),
                    **known,
                    "quantity": quantity,
                    "extreme": extreme,
                    "value": value,
                    "low": low,
                    "high": high,
                }
            )
    return rows
