"""Bounds of the numeric inputs, within which the model is known to be computed correctly.

Each interval is closed, in SI, and much wider than the range of real materials and surfaces.
``Parameters`` and input files are checked against the same bounds.
"""

from numbers import Real
from typing import NamedTuple


class Bounds(NamedTuple):
    """A closed interval of numbers, in SI."""

    least: float
    most: float

    def hold(self, value: object) -> bool:
        """Whether ``value`` is a number in the interval."""
        is_number = isinstance(value, Real) and not isinstance(value, bool)
        return is_number and self.least <= value <= self.most

    def __str__(self) -> str:
        return f"a number from {self.least:g} to {self.most:g}"


BOUNDS = {
    "elastic_modulus_surfaces": Bounds(1e8, 1e13),
    "elastic_modulus_particle": Bounds(1e8, 1e13),
    "hardness_surface_1": Bounds(1e6, 1e14),
    "hardness_surface_2": Bounds(1e6, 1e14),
    "yield_pressure_ratio": Bounds(0.1, 1.0),
    "plastic_interference_ratio": Bounds(1.0, 1e5),
    "ball_radius": Bounds(1e-6, 1.0),
    "material_parameter": Bounds(1.0, 1e5),
    "hardness_parameter": Bounds(1e-4, 1.0),
    "speed_per_viscosity": Bounds(1e-10, 1.0),
    "ellipticity": Bounds(0.1, 10.0),
    "apparent_area": Bounds(1e-12, 1e-2),
    "reference_roughness": Bounds(1e-12, 1e-2),
    "summit_parameter": Bounds(0.0193, 100.0),
    "summit_parameter_exponent": Bounds(-2.0, 2.0),
    "summit_radius": Bounds(1e-7, 1e-2),
    "summit_radius_exponent": Bounds(-2.0, 2.0),
    "summit_deviation_ratio": Bounds(0.05, 5.0),
    "summit_offset_ratio": Bounds(0.0, 5.0),
    "mean_ratio": Bounds(0.0, 2.0),
    # narrower sizes make a step in the load that float64 cannot resolve to 1e-9
    "spread_ratio": Bounds(1e-6, 10.0),
    "truncation": Bounds(0.5, 10.0),
    "participation": Bounds(1e-6, 1.0),
    "elastic_depth_ratio": Bounds(0.0, 5.0),
}
