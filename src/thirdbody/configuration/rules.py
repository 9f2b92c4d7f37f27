"""What JSON Schema cannot say: rules between several values, each named where it holds.

A schema asks for a rule by its name, ``rules: [first_below_last]``, beside the type, the bounds and the
keys of the same value.  A rule is a function of that value, which has already been found to keep to
the rest of its schema; it yields a ``Breach`` for each fault.  To add one, write the function and
list it in ``RULES``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple


class Breach(NamedTuple):
    """A fault found by a rule.

    Attributes
    ----------
    allowed : str
        What would have been right.
    path : tuple
        Keys and positions from the value that the rule judges to the one at fault.
    fault : str
        What is wrong; empty where it is enough to show the value at fault.
    """

    allowed: str
    path: tuple[str | int, ...] = ()
    fault: str = ""


def first_below_last(ends: list) -> Iterator[Breach]:
    """A range goes upwards."""
    if not ends[0] < ends[-1]:
        yield Breach("a first value below the last")


def particles_fit(conditions: dict) -> Iterator[Breach]:
    """Particles lie side by side: pi/4 x_a^2 eta_a, the area they cover, cannot exceed 1."""
    diameters = _listed(conditions.get("particle_diameter_nm", [])) or [
        ratio * roughness
        for ratio in _listed(conditions["particle_diameter_per_roughness"])
        for roughness in _listed(conditions["roughness_nm"])
    ]
    diameter = max(diameters)
    density = max(_listed(conditions["particle_density_per_m2"]))
    coverage = 0.25 * math.pi * (1e-9 * diameter) ** 2 * density
    if coverage > 1.0:
        fault = (
            f"particles of {diameter:g} nm at {density:g} m-2 cover {coverage:.3g} of the interface"
        )
        yield Breach("at most 1", fault=fault)


def lists_of_equal_length(conditions: dict) -> Iterator[Breach]:
    """Lists of conditions run together, so that each position is one curve."""
    lengths = {key: len(value) for key, value in conditions.items() if isinstance(value, list)}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{key} has {length} values" for key, length in lengths.items())
        yield Breach("lists of equal length", fault=told)


def ids_are_unique(statements: list) -> Iterator[Breach]:
    """No two statements go by one id."""
    seen = set()
    for index, statement in enumerate(statements):
        if statement["id"] in seen:
            yield Breach("an id given once", (index, "id"))
        seen.add(statement["id"])


def contradictions_are_mutual(statements: list) -> Iterator[Breach]:
    """Of two statements that contradict each other, both say so."""
    contradicted = {entry["id"]: entry.get("contradicts", []) for entry in statements}
    for index, statement in enumerate(statements):
        for place, other in enumerate(statement.get("contradicts", [])):
            if statement["id"] not in contradicted.get(other, []):
                yield Breach(
                    "the id of a statement that contradicts this one too",
                    (index, "contradicts", place),
                )


def contradictions_are_settled(statements: list) -> Iterator[Breach]:
    """Of two statements that contradict each other, at least one stands aside."""
    aside = {entry["id"] for entry in statements if "aside" in entry}
    for index, statement in enumerate(statements):
        for place, other in enumerate(statement.get("contradicts", [])):
            if not aside & {statement["id"], other}:
                yield Breach(
                    "a statement that stands aside, or this one does",
                    (index, "contradicts", place),
                )


def unknowns_are_listed(calibration: dict) -> Iterator[Breach]:
    """What a reading searches has its bounds and scale under ``unknowns``."""
    unknowns = calibration["unknowns"]
    allowed = ", ".join(unknowns)
    for index, name in enumerate(calibration["always"]):
        if name not in unknowns:
            yield Breach(allowed, ("always", index))
    for reading, settings in calibration["readings"].items():
        for index, name in enumerate(settings.get("unknowns", [])):
            if name not in unknowns:
                yield Breach(allowed, ("readings", reading, "unknowns", index))


RULES = {
    rule.__name__: rule
    for rule in (
        first_below_last,
        particles_fit,
        lists_of_equal_length,
        ids_are_unique,
        contradictions_are_mutual,
        contradictions_are_settled,
        unknowns_are_listed,
    )
}


def _listed(value) -> list:
    """``value`` as a list: a panel gives single numbers where a group of curves gives lists."""
    return value if isinstance(value, list) else [value]
