"""The inputs of the model: one frozen record of every number and reading it depends on."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass

# McCool (1986): distance of the summit plane and loss of summit variance, over 1/(eta_s R)
SUMMIT_PLANE = 0.045944
SUMMIT_VARIANCE = 3.717e-4
# A narrower size distribution is a step of the load that float64 cannot resolve to 1e-9.
LEAST_SPREAD = 1e-6


@dataclass(frozen=True)
class Surface:
    """Summits of the equivalent rough surface at one roughness.

    ``roughness`` sigma [m], ``summit_density`` eta_s [m-2], ``summit_radius`` R [m],
    ``summit_deviation`` sigma_s [m], ``summit_offset`` y_s [m].
    """

    roughness: float
    summit_density: float
    summit_radius: float
    summit_deviation: float
    summit_offset: float


@dataclass(frozen=True)
class Parameters:
    """All inputs, SI; the meaning of each key stands in ``config/inputs.yaml``."""

    elastic_modulus_surfaces: float
    elastic_modulus_particle: float
    hardness_surface_1: float
    hardness_surface_2: float
    yield_pressure_ratio: float
    plastic_interference_ratio: float
    ball_radius: float
    material_parameter: float
    hardness_parameter: float
    speed_per_viscosity: float
    ellipticity: float
    apparent_area: float
    reference_roughness: float
    summit_parameter: float
    summit_parameter_exponent: float
    summit_radius: float
    summit_radius_exponent: float
    summit_offset: bool
    size_distribution: str
    mean_ratio: float
    spread_ratio: float
    gap_ratio: float
    truncation: float
    participation: float
    elastic_depth_ratio: float
    elastic_limits: str
    coverage_limits: str
    film_load: str

    def __post_init__(self):
        if self.spread_ratio < LEAST_SPREAD and not self.convolves_sizes:
            raise ValueError(
                f"spread_ratio is {self.spread_ratio!r}; allowed: at least {LEAST_SPREAD:g}, "
                "below which equal particles would bear any load at one separation"
            )

    @property
    def convolves_sizes(self) -> bool:
        """Whether the spread of the gap joins that of the sizes, which may then be equal."""
        return self.size_distribution == "gap_convolved" and self.gap_ratio >= LEAST_SPREAD

    @property
    def elastic_factor(self) -> float:
        """(9 pi^2/4)(H_s1^2/E_sa^2 + H_s2^2/E_ss^2), the weight of elastic particles in Eqs. 4-5 [1]."""
        return (
            2.25
            * math.pi**2
            * (
                (self.hardness_surface_1 / self.elastic_modulus_particle) ** 2
                + (self.hardness_surface_2 / self.elastic_modulus_surfaces) ** 2
            )
        )

    @property
    def newtons_per_load(self) -> float:
        """F_t/F_t* = A_n E_ss [N]."""
        return self.apparent_area * self.elastic_modulus_surfaces

    def surface(self, roughness: float) -> Surface:
        """Summits at ``roughness`` sigma [m] (scalar).

        Raises ``ValueError`` where the summit parameter leaves no variance to the summits.
        Source: McCool (1986) for the offset; the power laws are assumptions.
        """
        scale = roughness / self.reference_roughness
        summit_parameter = self.summit_parameter * scale**self.summit_parameter_exponent
        radius = self.summit_radius * scale**self.summit_radius_exponent
        density = summit_parameter / (radius * roughness)
        if not self.summit_offset:
            return Surface(roughness, density, radius, roughness, 0.0)
        curvature_length = 1.0 / (density * radius)
        variance = roughness**2 - SUMMIT_VARIANCE * curvature_length**2
        if not variance > 0.0:
            raise ValueError(
                f"summit_parameter is {summit_parameter:.4g} at roughness {roughness:g} m; "
                f"allowed: above {math.sqrt(SUMMIT_VARIANCE):.5f}, where summits keep a variance"
            )
        return Surface(
            roughness, density, radius, math.sqrt(variance), SUMMIT_PLANE * curvature_length
        )

    def as_attribute(self, roughness) -> str:
        """The JSON text of ``model_parameters``: flat, SI, lists along ``roughness`` [m], 1-D."""
        surfaces = [self.surface(float(sigma)) for sigma in roughness]
        numbers = {
            "E_ss": self.elastic_modulus_surfaces,
            "E_sa": self.elastic_modulus_particle,
            "H_s1": self.hardness_surface_1,
            "H_s2": self.hardness_surface_2,
            "k": self.yield_pressure_ratio,
            "omega_ratio": self.plastic_interference_ratio,
            "R_x": self.ball_radius,
            "G": self.material_parameter,
            "V": self.hardness_parameter,
            "kappa": self.ellipticity,
            "U_per_viscosity": self.speed_per_viscosity,
            "A_n": self.apparent_area,
            "eta_s": [surface.summit_density for surface in surfaces],
            "R": [surface.summit_radius for surface in surfaces],
            "sigma_s": [surface.summit_deviation for surface in surfaces],
            "y_s": [surface.summit_offset for surface in surfaces],
            "phi_a": self.size_distribution,
            "mean_ratio": self.mean_ratio,
            "sigma_a_ratio": self.spread_ratio,
            "gap_ratio": self.gap_ratio,
            "truncation": self.truncation,
            "participation": self.participation,
            "h_e_ratio": self.elastic_depth_ratio,
            "elastic_limits": self.elastic_limits,
            "coverage_limits": self.coverage_limits,
            "film_load": self.film_load,
        }
        return json.dumps(numbers)

    def as_dict(self) -> dict:
        """Plain mapping of all inputs."""
        return asdict(self)
