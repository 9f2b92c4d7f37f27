"""Rules between several values, which JSON Schema cannot express.

A schema names a rule, ``rules: [first_below_last]``, beside the type and keys of a value.  A rule
is a function of this value, which already satisfies its schema, and yields each fault.
"""

import math
from collections.abc import Iterator

import numpy as np
from jsonschema import ValidationError


def first_below_last(ends: list) -> Iterator[ValidationError]:
    """The ends of a range increase."""
    if not ends[0] < ends[-1]:
        yield ValidationError(f"{ends} does not increase")


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
        yield ValidationError(
            f"particles of {diameter:g} nm at {density:g} m-2 cover {coverage:.3g} of the interface; allowed: at most 1"
        )
