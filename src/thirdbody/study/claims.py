"""Statements of the paper as data: what they say, where, of what, and to which tolerance.

A claim names a quantity, the conditions under which the paper speaks of it, and what it says.  The
fields of each kind are explained at the head of ``config/claims.yaml``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.conditions import AXES, CONDITION_AXES, Condition
from thirdbody.model.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT

VALIDATION_STRIDE = 3  # every third published value is kept from the calibration

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
REVERSAL_LOAD = "total_contact_area_reversal_load"
QUANTITIES = (*CURVE_QUANTITIES, *TURNING_POINT_QUANTITIES, *WINDOW_QUANTITIES, REVERSAL_LOAD)
BOUNDS = {f"{name}_min": (name, 1.0) for name in CURVE_QUANTITIES} | {
    f"{name}_max": (name, -1.0) for name in CURVE_QUANTITIES
}
KEYS = tuple(axis.key for axis in CONDITION_AXES)  # of the conditions of a curve
CONDITIONS = (*KEYS, *CURVE_QUANTITIES, *BOUNDS, "load_max_N")

# states of sections 3.1 and 3.2: the quantity that decides, and the interval it must lie in
STATES = {
    "boundary": ("solid_load_fraction", BOUNDARY_LIMIT, np.inf),
    "mixed": ("solid_load_fraction", FULL_FILM_LIMIT, BOUNDARY_LIMIT),
    "full_film": ("solid_load_fraction", -np.inf, FULL_FILM_LIMIT),
    "particle_surface": ("particle_contact_area_ratio", PARTICLE_LIMIT, np.inf),
    "hybrid": ("particle_contact_area_ratio", SURFACE_LIMIT, PARTICLE_LIMIT),
    "surface_surface": ("particle_contact_area_ratio", -np.inf, SURFACE_LIMIT),
}

# directions that an ordering or a trend can take
DIRECTIONS = ("increasing", "decreasing", "constant", "rising_then_falling", "falling_then_rising")
VALUE_KINDS = ("value", "range", "window")
COMMON_FIELDS = {"id", "where", "statement", "kind", "conditions", "tolerance"}
# fields of each kind beyond those of every claim: required, optional
FIELDS = {
    "value": ({"quantity", "published"}, {"extreme", "reference"}),
    "range": ({"quantity", "published"}, set()),
    "window": ({"published"}, set()),
    "ordering": ({"quantity", "direction"}, {"reference"}),
    "coincidence": ({"quantity", "reference"}, {"against"}),
    "trend": ({"quantity", "direction", "along"}, {"extreme", "reference"}),
    "absence": ({"quantity"}, set()),
    "regime_sequence": ({"published"}, {"open_end"}),
    "mode_sequence": ({"published"}, {"open_end"}),
}


@dataclass(frozen=True)
class Claim:
    """One statement of the paper; the keys of ``conditions`` and ``reference`` carry units.

    ``tolerance`` is a fraction of the quantity if ``relative``, else in its unit.
    """

    id: str
    where: str
    statement: str
    kind: str
    conditions: Mapping
    tolerance: float
    relative: bool
    reason: str
    quantity: str = ""
    published: float | Sequence | None = None
    direction: str = ""
    along: str = ""
    extreme: str = ""
    against: str = "load"
    open_end: bool = False
    reference: Mapping | None = None
    contradicts: Sequence[str] = ()

    @cached_property
    def curves(self) -> tuple[Condition, ...]:
        """The conditions compared, SI: lists run together, single values hold for all."""
        given = [np.atleast_1d(self.conditions.get(key, np.nan)) for key in KEYS]
        rows = zip(*np.broadcast_arrays(*given), strict=True)
        return tuple(Condition.of(dict(zip(KEYS, row, strict=True))) for row in rows)

    @cached_property
    def references(self) -> tuple[Condition, ...]:
        """For each curve, the one that the paper holds it against."""
        if not self.reference:
            return ()
        changes = {
            axis.name: axis.to_si(self.reference[axis.key])
            for axis in CONDITION_AXES
            if axis.key in self.reference
        }
        return tuple(condition._replace(**changes) for condition in self.curves)

    @property
    def source(self) -> str:
        """The method of ``Evidence`` that the claim rests on."""
        if self.kind == "window" or self.quantity in WINDOW_QUANTITIES:
            return "window"
        return "turning_point" if self.quantity in TURNING_POINT_QUANTITIES else "curve"

    @property
    def step(self) -> float:
        """The tolerance on the scale on which values are compared: logarithmic if relative."""
        return np.log1p(self.tolerance) if self.relative else self.tolerance

    @property
    def is_withheld(self) -> bool:
        """Whether this is the slot of a number that the text keeps back."""
        return self.kind in VALUE_KINDS and self.published is None


def load_claims(path) -> tuple[Claim, ...]:
    """Claims of a YAML file, in its order; a ``ValueError`` names file, id and key at fault."""
    claims = []
    for entry in read_yaml(path, list):
        if not isinstance(entry, dict):
            raise ValueError(
                f"{path}: {str(entry)[:60]!r} is no statement; allowed: keys with values"
            )
        try:
            claims.append(_parsed(entry))
        except ValueError as error:
            raise ValueError(f"{path}: {entry.get('id', '?')}: {error}") from None
    links = {claim.id: claim.contradicts for claim in claims}
    for claim in claims:
        if sum(claim.id == other.id for other in claims) > 1:
            raise ValueError(f"{path}: {claim.id}: id is given more than once")
        for other in claim.contradicts:
            if claim.id not in links.get(other, ()):
                raise ValueError(f"{path}: {claim.id}: contradicts {other}, but not the reverse")
    return tuple(claims)


def assign_roles(claims: Sequence[Claim]) -> dict[str, str]:
    """Role of each claim by id, by the rule at the head of ``config/claims.yaml``."""
    roles = {c.id: "withheld" if c.is_withheld else "calibration" for c in claims}
    values = [c.id for c in claims if c.kind in VALUE_KINDS and not c.is_withheld]
    return roles | dict.fromkeys(values[VALIDATION_STRIDE - 1 :: VALIDATION_STRIDE], "validation")


def state_names(published):
    """Names of all states that the steps ``published`` speak of."""
    return [name for step in published for name in step.replace(" or ", " ").split()]


def referenced_conditions(claims: Sequence[Claim]) -> dict[str, set]:
    """All that judging ``claims`` asks for: per method of ``Evidence``, its arguments in SI."""
    asked = {"curve": set(), "turning_point": set(), "window": set()}
    for claim in claims:
        for condition in claim.curves + claim.references:
            asked[claim.source].add(condition.roughness if claim.source == "window" else condition)
    return asked


CHOICES = {
    "quantity": QUANTITIES,
    "direction": DIRECTIONS,
    "along": ("load", "curves"),
    "extreme": ("minimum", "maximum"),
    "against": CURVE_QUANTITIES,
}


def _parsed(entry: dict) -> Claim:
    for key in ("id", "where", "statement", "kind", *CHOICES):
        _require(isinstance(entry.get(key, ""), str), key, "a word")
    for key in ("conditions", "reference", "tolerance"):
        _require(isinstance(entry.get(key, {}), dict), key, "keys with values")
    _require(isinstance(entry.get("contradicts", []), list), "contradicts", "a list")
    kind, tolerance = entry.get("kind"), entry.get("tolerance", {})
    _require(kind in FIELDS, "kind", f"one of {', '.join(FIELDS)}")
    required, optional = FIELDS[kind]
    _check_keys(entry, COMMON_FIELDS | required, optional | {"contradicts"})
    for key in CHOICES.keys() & entry.keys():
        _require(entry[key] in CHOICES[key], key, f"one of {', '.join(CHOICES[key])}")
    _check_conditions(entry, entry["conditions"], entry.get("reference", {}))
    _require(_is_published(entry), "published", "what a claim of this kind can state")
    scale = "relative" if "relative" in tolerance else "absolute"
    _check_keys(tolerance, {scale, "reason"}, ())
    limit = 1.0 if scale == "relative" else np.inf
    good = _are_numbers(tolerance[scale]) and 0.0 < tolerance[scale] < limit
    _require(good, scale, f"a number between 0 and {limit:g}")
    given = {"tolerance": tolerance[scale], "relative": scale == "relative"}
    return Claim(**entry | given, reason=tolerance["reason"])


def _check_conditions(entry, conditions, reference):
    of_window = entry["kind"] == "window" or entry.get("quantity") in WINDOW_QUANTITIES
    _check_keys(conditions, [AXES["roughness"].key] if of_window else KEYS, CONDITIONS)
    _check_keys(reference, (), KEYS)
    for key, value in [*conditions.items(), *reference.items()]:
        _require(_are_numbers(value), key, "a number or a list of numbers")
    lengths = {len(value) for value in conditions.values() if isinstance(value, list)}
    _require(len(lengths) < 2, "conditions", "lists of equal length")
    one_number = entry["kind"] == "value" or entry.get("along") == "curves"
    if one_number and entry["quantity"] in CURVE_QUANTITIES:
        located = "extreme" in entry or conditions.keys() & set(CURVE_QUANTITIES)
        _require(located, "extreme", "given where no condition names one load")


def _is_published(entry):
    published = entry.get("published")
    if entry["kind"].endswith("_sequence"):
        steps = published if isinstance(published, list) else [None]
        words = all(isinstance(step, str) for step in steps)
        return words and all(name in STATES for name in state_names(steps))
    return published is None or _are_numbers(published)


def _are_numbers(value):
    values = value if isinstance(value, list) else [value]
    return all(isinstance(v, int | float) and not isinstance(v, bool) for v in values)


def _check_keys(given, required, optional):
    for key in required:
        _require(key in given, key, "given")
    for key in given:
        _require(key in required or key in optional, key, "left out: unknown here")


def _require(good, key, what):
    if not good:
        raise ValueError(f"{key} must be {what}")
