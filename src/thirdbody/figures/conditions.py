"""The conditions of an interface, and how figures name them."""

from __future__ import annotations

from dataclasses import dataclass

from thirdbody.data.scene import CENTISTOKES, NANOMETRE
from thirdbody.figures.panel import power_text

# a parameter in which curves may differ: title of their key, unit of its values
PARAMETERS = {
    "viscosity": ("Viscosity ν (cSt)", CENTISTOKES),
    "particle_diameter": ("Particle diameter xₐ (nm)", NANOMETRE),
    "roughness": ("Roughness σ (nm)", NANOMETRE),
    "diameter_ratio": ("Diameter over roughness xₐ/σ", 1.0),
    "particle_density": ("Particle density ηₐ (m⁻²)", 1.0),
}


@dataclass(frozen=True)
class Conditions:
    """What is held while the load varies (SI); 0 means no lubricant, no particles."""

    viscosity: float
    particle_diameter: float
    roughness: float
    particle_density: float

    @property
    def diameter_ratio(self) -> float:
        """x_a/sigma, free of rounding."""
        return round(self.particle_diameter / self.roughness, 9)

    @property
    def is_dry(self) -> bool:
        """Whether there is no lubricant."""
        return self.viscosity == 0.0

    @property
    def is_two_body(self) -> bool:
        """Whether there are no particles."""
        return self.particle_diameter == 0.0 or self.particle_density == 0.0

    @property
    def label(self) -> str:
        """All conditions, as the file of the drawn data names them."""
        return (
            f"nu = {self.viscosity / CENTISTOKES:.10g} cSt; "
            f"x_a = {self.particle_diameter / NANOMETRE:.10g} nm; "
            f"sigma = {self.roughness / NANOMETRE:.10g} nm; "
            f"eta_a = {self.particle_density:.10g} m-2"
        )

    def texts(self) -> list[str]:
        """Each condition by itself, as figures name it."""
        viscosity, diameter = self.viscosity / CENTISTOKES, self.particle_diameter / NANOMETRE
        return [
            "dry" if self.is_dry else f"ν = {viscosity:.10g} cSt",
            f"σ = {self.roughness / NANOMETRE:.10g} nm",
            f"xₐ = {diameter:.10g} nm",
            f"ηₐ = {power_text(self.particle_density)} m⁻²",
        ]


def shared_texts(several) -> list[str]:
    """The conditions that all of ``several`` with particles share, as figures name them."""
    columns = zip(*(one.texts() for one in several if not one.is_two_body), strict=True)
    return [column[0] for column in columns if len(set(column)) == 1]
