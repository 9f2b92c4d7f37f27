"""Statements of the paper as data, each called a *claim*.

A claim has a quantity, conditions, the statement of the paper on it, and a tolerance.  The head of
``config/claims.yaml`` explains the kinds of claims and their fields.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from thirdbody.configuration.schema import read_valid
from thirdbody.data.conditions import CONDITION_AXES, Condition
from thirdbody.data.places import FIGURE
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT

CURVE_QUANTITIES = (
    *("load", "solid_load", "solid_load_fraction", "particle_contact_area_ratio"),
    *("total_contact_area", "total_contact_area_slope", "film_thickness"),
)
TURNING_POINT_QUANTITIES = {
    "turning_point_load": lambda point: point.load,
    "turning_point_ratio": lambda point: point.peak_ratio,
    "turning_point_solid_load_fraction": lambda point: point.solid_load_fraction,
    "turning_point_solid_load": lambda point: point.solid_load_fraction * point.load,
}
WINDOW_QUANTITIES = {"window_low": 0, "window_high": 1}
# loads where two curves part or cross
BETWEEN_CURVES = ("total_contact_area_reversal_load", "bend_load", "bend_load_over_mixed_load")
# Keys of conditions that bound a range of loads: the quantity, and the sign for which sign * (bound
# - value) is positive outside the bound.
BOUNDS = {f"{name}_min": (name, 1.0) for name in CURVE_QUANTITIES} | {
    f"{name}_max": (name, -1.0) for name in CURVE_QUANTITIES
}
KEYS = tuple(axis.key for axis in CONDITION_AXES)  # conditions that distinguish curves

# "Figure 4B", "Figures 4B and 4C", "Figures 4 to 7": first number and, of a range, the last
FIGURES = re.compile(r"(?:Figures? |and (?=\d))(\d+)[A-D]?(?: to (\d+))?")

# Regimes and modes of sections 3.1 and 3.2: the decisive quantity and its interval.
STATES = {
    "boundary": ("solid_load_fraction", BOUNDARY_LIMIT, np.inf),
    "mixed": ("solid_load_fraction", FULL_FILM_LIMIT, BOUNDARY_LIMIT),
    "full_film": ("solid_load_fraction", -np.inf, FULL_FILM_LIMIT),
    "particle_surface": ("particle_contact_area_ratio", PARTICLE_LIMIT, np.inf),
    "hybrid": ("particle_contact_area_ratio", SURFACE_LIMIT, PARTICLE_LIMIT),
    "surface_surface": ("particle_contact_area_ratio", -np.inf, SURFACE_LIMIT),
}


@dataclass(frozen=True)
class Claim:
    """One statement: an entry of ``config/claims.yaml``, whose head explains the fields.  ``tolerance`` is in
    the unit of the quantity if ``tolerance_kind`` is "absolute", a fraction of it [1] if "relative", and a
    factor on both sides [1] if "factor"."""

    id: str
    place: str
    statement: str
    kind: str
    conditions: Mapping[str, Any]
    tolerance: float
    tolerance_kind: str
    reason: str
    fine_tolerance: float = 0.0  # relative, if loads were read on a fine axis; 0 if it is the same
    quantity: str = ""
    published: float | Sequence | None = None
    direction: str = ""
    along: str = ""
    extreme: str = ""
    against: str = "load"
    open_end: bool = False
    any_curve: bool = False
    must_be_reached: bool = False
    figures: Sequence[int] = ()
    reference: Mapping[str, float] = field(default_factory=dict)
    contradicts: Sequence[str] = ()
    quote: str = ""
    aside: str = ""
    cluster: str = ""

    @cached_property
    def curves(self) -> tuple[Condition, ...]:
        """Conditions of the compared curves, SI: lists are combined element by element."""
        given = [np.atleast_1d(self.conditions.get(key, np.nan)) for key in KEYS]
        rows = zip(*np.broadcast_arrays(*given), strict=True)
        return tuple(Condition.of(dict(zip(KEYS, row, strict=True))) for row in rows)

    @cached_property
    def references(self) -> tuple[Condition, ...]:
        """Conditions of the reference of each curve, SI; empty without reference."""
        changes = {
            axis.name: axis.to_si(self.reference[axis.key])
            for axis in CONDITION_AXES
            if axis.key in self.reference
        }
        return tuple(condition._replace(**changes) for condition in self.curves if changes)

    @cached_property
    def all_figures(self) -> frozenset[int]:
        """Numbers of the figures in its place, and of those it repeats."""
        return figures_named(self.place).union(self.figures)

    @cached_property
    def limits(self) -> dict[str, float]:
        """The conditions that bound or give the loads, by key."""
        return {key: value for key, value in self.conditions.items() if key not in KEYS}

    @property
    def curves_text(self) -> str:
        """The curves, the bounds of the loads, and the reference as text."""
        loads = [f"{key} = {value:g}" for key, value in self.limits.items()]
        text = "; ".join([*_condition_texts(self.conditions), *loads])
        against = ", ".join(_condition_texts(self.reference))
        return f"{text}; held against {against}" if against else text

    @property
    def counted_as(self) -> str:
        """The name under which it is counted: its cluster, or its id."""
        return self.cluster or self.id

    @property
    def source(self) -> str:
        """The part of ``thirdbody.study.evidence.Evidence`` that the claim uses."""
        if self.kind == "window" or self.quantity in WINDOW_QUANTITIES:
            return "window"
        return "turning_point" if self.quantity in TURNING_POINT_QUANTITIES else "curve"

    @property
    def relative(self) -> bool:
        """Whether logarithms are compared."""
        return self.tolerance_kind != "absolute"

    @property
    def step(self) -> float:
        """The tolerance [unit of the quantity]; the logarithm of its upper end [1] if logarithms are compared."""
        return float(np.log(self.interval(1.0)[1])) if self.relative else self.tolerance

    def on_a_fine_axis(self) -> "Claim":
        """The same statement, if loads were read on a fine axis."""
        if not self.fine_tolerance:
            return self
        return replace(self, tolerance=self.fine_tolerance, tolerance_kind="relative")

    def interval(self, value: float) -> tuple[float, float]:
        """Both ends of the tolerance about a published ``value`` [unit of the quantity]."""
        if self.tolerance_kind == "factor":
            return value / self.tolerance, value * self.tolerance
        margin = abs(value) * self.tolerance if self.relative else self.tolerance
        return value - margin, value + margin


def figures_named(place: str) -> frozenset[int]:
    """Numbers of the figures in a place, such as "Figures 4B and 5C" or "Figures 4 to 7"."""
    ends = FIGURES.findall(place)
    return frozenset().union(*(range(int(one), int(last or one) + 1) for one, last in ends))


def load_claims(path: str | Path) -> tuple[Claim, ...]:
    """Read the statements of the paper, in order; ``ValueError`` in one line for an invalid file."""
    claims = []
    for entry in read_valid(path, "claims"):
        given = dict(entry["tolerance"])
        reason, fine = given.pop("reason"), given.pop("on_a_fine_axis", 0.0)
        ((kind, size),) = given.items()
        fields = {"tolerance": size, "tolerance_kind": kind, "reason": reason}
        claims.append(Claim(**entry | fields, fine_tolerance=fine))
    return tuple(claims)


def referenced_conditions(claims: Sequence[Claim]) -> dict[str, set]:
    """The conditions needed to evaluate ``claims``, for ``solve_evidence``: a set of ``Condition``
    for ``curve`` and ``turning_point``, of sigma [m] for ``window``."""
    asked = {"curve": set(), "turning_point": set(), "window": set()}
    for claim in claims:
        for condition in claim.curves + claim.references:
            asked[claim.source].add(condition.roughness if claim.source == "window" else condition)
    return asked


def _condition_texts(conditions: Mapping[str, Any]) -> list[str]:
    """The ``conditions`` that distinguish curves, as text: ``nu = 0, 90 cSt``."""
    return [
        f"{axis.symbol} = {', '.join(f'{value:g}' for value in np.atleast_1d(given))} {axis.unit}"
        for axis in CONDITION_AXES
        if (given := conditions.get(axis.key)) is not None
    ]


def printed_rows(claims: Iterable[Claim]) -> list[dict]:
    """Rows of the table ``printed``: a printed number with its tolerance for each of its curves; none for a
    change from a reference, which is not a point of a figure."""
    rows = []
    for claim in claims:
        is_change = claim.reference and claim.quantity not in BETWEEN_CURVES
        if claim.kind not in ("value", "span", "window") or is_change:
            continue
        number = FIGURE.match(claim.place)
        levels = [(name, value) for name, value in claim.limits.items() if name in CURVE_QUANTITIES]
        at_quantity, at_level = levels[0] if levels else ("", None)
        curves = claim.curves
        # one number: that of the middle curve
        if claim.quantity == "total_contact_area_reversal_load":
            curves = curves[len(curves) // 2 :][:1]
        for condition, (extreme, quantity, value) in product(curves, _numbers(claim)):
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


def _numbers(claim):
    """Extreme, quantity and value of each number of a claim."""
    if claim.kind == "window":
        return zip(("", ""), ("window_low", "window_high"), claim.published, strict=True)
    if claim.kind == "span":
        return zip(("minimum", "maximum"), [claim.quantity] * 2, claim.published, strict=True)
    return [(claim.extreme, claim.quantity, claim.published)]
