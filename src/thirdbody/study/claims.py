"""Statements of the paper as data: what they say, where, of what, and to which tolerance.

A claim names a quantity, the conditions under which the paper speaks of it, and what it says.  The
fields of each kind are explained at the head of ``config/claims.yaml`` and kept to by
``config/claims.schema.yaml``, whose words for quantities and states are those of this module.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from thirdbody.configuration.schema import read_valid
from thirdbody.data.conditions import CONDITION_AXES, Condition
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

# states of sections 3.1 and 3.2: the quantity that decides, and the interval it must lie in
STATES = {
    "boundary": ("solid_load_fraction", BOUNDARY_LIMIT, np.inf),
    "mixed": ("solid_load_fraction", FULL_FILM_LIMIT, BOUNDARY_LIMIT),
    "full_film": ("solid_load_fraction", -np.inf, FULL_FILM_LIMIT),
    "particle_surface": ("particle_contact_area_ratio", PARTICLE_LIMIT, np.inf),
    "hybrid": ("particle_contact_area_ratio", SURFACE_LIMIT, PARTICLE_LIMIT),
    "surface_surface": ("particle_contact_area_ratio", -np.inf, SURFACE_LIMIT),
}

VALUE_KINDS = ("value", "range", "window")


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


def load_claims(path: str | Path) -> tuple[Claim, ...]:
    """Read the statements of the paper.

    Parameters
    ----------
    path : str or Path
        A file that keeps to ``config/claims.schema.yaml``.

    Returns
    -------
    tuple of Claim
        In the order of the file, from which the roles follow.

    Raises
    ------
    ValueError
        In one line: the file, the id and the key at fault, its value and what is allowed.

    Examples
    --------
    >>> from thirdbody.configuration.schema import config_directory
    >>> claim = load_claims(config_directory() / "claims.yaml")[0]
    >>> claim.kind, claim.published
    ('mode_sequence', ['particle_surface', 'hybrid', 'surface_surface'])
    """
    return tuple(map(_claim, read_valid(path, "claims")))


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


def _claim(entry: Mapping) -> Claim:
    """The statement that an entry of ``config/claims.yaml`` makes."""
    tolerance = entry["tolerance"]
    relative = "relative" in tolerance
    size = tolerance["relative" if relative else "absolute"]
    given = {"tolerance": size, "relative": relative, "reason": tolerance["reason"]}
    return Claim(**entry | given)
