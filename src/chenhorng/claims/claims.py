"""The statements of the paper in ``config/claims.yaml``: read, with the curves that they need, and their
printed numbers as a table."""

from collections.abc import Iterable, Sequence
from itertools import product
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from chenhorng.claims.claim import Claim
from chenhorng.claims.kinds import KINDS
from chenhorng.configuration.model import first_fault
from chenhorng.places import FIGURE
from chenhorng.sampling import CURVE_QUANTITIES
from thirdbody.plain_yaml import read_yaml


def load_claims(path: str | Path) -> tuple[Claim, ...]:
    """Read the statements of the paper, in order; ``ValueError`` for one without a field of its kind, with
    another, or with too few curves."""
    claims = []
    for entry in read_yaml(path, list):
        given = dict(entry["tolerance"])
        reason = given.pop("reason")
        ((kind, size),) = given.items()
        fields = {"tolerance": size, "tolerance_kind": kind, "reason": reason}
        try:
            claims.append(KINDS[entry["kind"]](**entry | fields))
        except ValidationError as error:
            raise ValueError(f"{path}: {entry['id']}: {first_fault(error)}") from None
    return tuple(claims)


def referenced_conditions(claims: Sequence[Claim]) -> dict[str, set]:
    """The conditions needed to evaluate ``claims``, for ``solve_evidence``: a set of ``Condition``
    for ``curve`` and ``turning_point``, of sigma [m] for ``window``."""
    asked: dict[str, set] = {"curve": set(), "turning_point": set(), "window": set()}
    for claim in claims:
        for condition in claim.curves + claim.references:
            asked[claim.source].add(condition.roughness if claim.source == "window" else condition)
    return asked


def printed_rows(claims: Iterable[Claim]) -> list[dict]:
    """Rows of the table ``printed``: a printed number with its tolerance for each of its curves; none for a
    change from a reference, which is not a point of a figure."""
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
