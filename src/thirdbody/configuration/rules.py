"""Rules between several values, which JSON Schema cannot express.

A schema names a rule, ``rules: [first_below_last]``, beside the type and keys of a value.  A rule
is a function of this value, which already satisfies its schema, and yields each fault.
"""

import math
from collections.abc import Iterator, Mapping

import numpy as np
from jsonschema import ValidationError


def fault(allowed: str, *path: str | int, problem: str = "") -> ValidationError:
    """What is allowed at the ``path`` below the value; with a ``problem``, if the value there does
    not show it."""
    return ValidationError(problem, path=path, schema={"allowed": allowed})


def axis_values(axis: Mapping) -> list[float]:
    """The values [unit of the key] of an axis of ``config/atlas.yaml``, increasing, to twelve digits."""
    space = np.geomspace if axis["scale"] == "logarithmic" else np.linspace
    spaced = space(axis["from"], axis["to"], axis["count"])
    return sorted({float(f"{value:.12g}") for value in (*spaced, *axis["also"])})


def first_below_last(ends: list) -> Iterator[ValidationError]:
    """The ends of a range increase."""
    if not ends[0] < ends[-1]:
        yield fault("a first value below the last")


def particles_fit(conditions: dict) -> Iterator[ValidationError]:
    """Particles lie side by side: the area fraction pi/4 x_a^2 eta_a cannot exceed 1."""
    largest = {key: np.max(each) for key, each in conditions.items()}
    if "particle_diameter_nm" in largest:
        diameter = largest["particle_diameter_nm"]
    else:
        diameter = largest["particle_diameter_per_roughness"] * largest["roughness_nm"]
    density = largest["particle_density_per_m2"]
    coverage = 0.25 * math.pi * (1e-9 * diameter) ** 2 * density
    if coverage > 1.0:
        problem = (
            f"particles of {diameter:g} nm at {density:g} m-2 cover {coverage:.3g} of the interface"
        )
        yield fault("at most 1", problem=problem)


def lists_of_equal_length(conditions: dict) -> Iterator[ValidationError]:
    """Lists of conditions are combined element by element: each position is one curve."""
    lengths = {key: len(value) for key, value in conditions.items() if isinstance(value, list)}
    if len(set(lengths.values())) > 1:
        problem = ", ".join(f"{key} has {length} values" for key, length in lengths.items())
        yield fault("lists of equal length", problem=problem)


def ids_are_unique(statements: list) -> Iterator[ValidationError]:
    """No two statements have the same id."""
    ids = [statement["id"] for statement in statements]
    for index, name in enumerate(ids):
        if name in ids[:index]:
            yield fault("an id given once", index, "id")


def contradictions_are_settled(statements: list) -> Iterator[ValidationError]:
    """Contradicting statements name each other, and at least one of them is set aside."""
    known = {statement["id"]: statement for statement in statements}
    for index, statement in enumerate(statements):
        for place, name in enumerate(statement.get("contradicts", [])):
            path, other = (index, "contradicts", place), known.get(name, {})
            if statement["id"] not in other.get("contradicts", []):
                yield fault("the id of a statement that contradicts this one too", *path)
            elif "aside" not in statement and "aside" not in other:
                yield fault("a statement that is set aside, unless this one is", *path)


def unknowns_have_bounds(calibration: dict) -> Iterator[ValidationError]:
    """Each input that is searched has bounds under ``unknowns``."""
    searched = {"always": calibration["always"]}
    for name, interpretation in calibration["interpretations"].items():
        searched[name] = interpretation.get("unknowns", [])
    for place, names in searched.items():
        for name in names:
            if name not in calibration["unknowns"]:
                problem = f"unknowns of {place} have {name!r}"
                yield fault(", ".join(calibration["unknowns"]), problem=problem)


def axis_goes_up(axis: dict) -> Iterator[ValidationError]:
    """The first value of an axis is below the last, and all others are between."""
    first, last = axis["from"], axis["to"]
    if not first < last:
        yield fault(f"less than {last:g}, the last value", "from")
    for place, value in enumerate(axis["also"]):
        if value and not first <= value <= last:
            yield fault(f"0, or from {first:g} to {last:g}", "also", place)


def chunks_have_surfaces(atlas: dict) -> Iterator[ValidationError]:
    """Each job of the atlas has at least one roughness."""
    surfaces = len(axis_values(atlas["axes"]["roughness_nm"]))
    if atlas["chunks"] > surfaces:
        yield fault(f"at most {surfaces}, the number of roughnesses", "chunks")


def charts_lie_on_axes(atlas: dict) -> Iterator[ValidationError]:
    """Charts show only values on the axes."""
    axes = {name: axis_values(axis) for name, axis in atlas["axes"].items()}
    for chart, shown in atlas["charts"].items():
        for place, panel in enumerate(shown):
            conditions = panel if isinstance(panel, dict) else {chart: panel}
            for key, value in conditions.items():
                if float(f"{value:.12g}") not in axes[key]:
                    below = [key] if panel is conditions else []
                    allowed = f"a value of axes.{key}; its key also can add it"
                    yield fault(allowed, "charts", chart, place, *below)
