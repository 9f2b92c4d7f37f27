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

from thirdbody.configuration.axes import axis_values


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
    """What an interpretation searches has its bounds and scale under ``unknowns``."""
    unknowns = calibration["unknowns"]
    allowed = ", ".join(unknowns)
    for index, name in enumerate(calibration["always"]):
        if name not in unknowns:
            yield Breach(allowed, ("always", index))
    for interpretation, settings in calibration["interpretations"].items():
        for index, name in enumerate(settings.get("unknowns", [])):
            if name not in unknowns:
                yield Breach(allowed, ("interpretations", interpretation, "unknowns", index))


def axis_goes_up(axis: dict) -> Iterator[Breach]:
    """An axis has a first value below the last, which its scale can hold, and all others between."""
    first, last = axis["from"], axis["to"]
    if not first < last:
        yield Breach(f"less than {last:g}, the last value", ("from",))
    elif axis["scale"] == "logarithmic" and first == 0:
        yield Breach("above 0 on a logarithmic axis; 0 can stand in also", ("from",))
    for place, value in enumerate(axis["also"]):
        if value and not first <= value <= last:
            yield Breach(f"0, or from {first:g} to {last:g}", ("also", place))


def chunks_have_surfaces(atlas: dict) -> Iterator[Breach]:
    """Each job of the atlas has one roughness or more."""
    surfaces = len(axis_values(atlas["axes"]["roughness_nm"]))
    if atlas["chunks"] > surfaces:
        yield Breach(f"at most {surfaces}, the number of roughnesses", ("chunks",))


def charts_lie_on_axes(atlas: dict) -> Iterator[Breach]:
    """What charts show has been solved."""
    axes = {name: axis_values(axis) for name, axis in atlas["axes"].items()}
    for chart, content in atlas["charts"].items():
        for place, shown in enumerate(content):
            panel = shown if isinstance(shown, dict) else {chart: shown}
            for key, value in panel.items():
                if float(f"{value:.12g}") not in axes[key]:
                    path = ("charts", chart, place, *((key,) if shown is panel else ()))
                    yield Breach(f"a value of axes.{key}, to which also can add it", path)


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
        axis_goes_up,
        chunks_have_surfaces,
        charts_lie_on_axes,
    )
}


def _listed(value) -> list:
    """``value`` as a list: a panel gives single numbers where a group of curves gives lists."""
    return value if isinstance(value, list) else [value]
