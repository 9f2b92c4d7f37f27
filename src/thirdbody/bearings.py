"""``bearing``: inputs derived from ball, speed, oil and the materials in contact.

The film parameters, defined below Eq. 8 of the paper, are those of Masjedi & Khonsari (2015):
U = mu_0 u/(E_ss R_x), G = alpha E_ss and V = v_h/E_ss.  As mu_0 = rho nu, the model uses U over the
kinematic viscosity, rho u/(E_ss R_x).  The moduli follow Hertz,
1/E = (1 - v_1^2)/E_1 + (1 - v_2^2)/E_2, which gives Table 1 for two steel bodies.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions import (
    OIL_DENSITY,
    checked_number,
    checked_numbers,
)
from thirdbody.core.parameters import Parameters
from thirdbody.inputs import or_calibrated
from thirdbody.notes import speed_note

if TYPE_CHECKING:
    import pandas as pd


STEEL_MODULUS = 205e9  # [Pa], not printed: E_ss of Table 1 follows from it
POISSON_RATIO = 0.29  # of all bodies, Table 1
GIGA = 1e9
# least and most usual value of the numbers of ``bearing``, and their unit
USUAL_BEARING = {
    "ball_radius_mm": (0.1, 1000.0, "mm"),
    "speed_m_per_s": (1e-6, 200.0, "m s-1"),
    "oil_density_kg_per_m3": (500.0, 3000.0, "kg m-3"),
    "pressure_viscosity_per_GPa": (1.0, 100.0, "GPa-1"),
    "apparent_area_mm2": (1e-4, 1e6, "mm2"),
    "ellipticity": (0.1, 10.0, "1"),
}
USUAL_MATERIAL = {"modulus_GPa": (0.1, 2000.0, "GPa"), "hardness_GPa": (0.01, 200.0, "GPa")}
# unit of each derived input, and its formula
FORMULAS = {
    "elastic_modulus_surfaces": ("Pa", "1/E_ss = (1-v_1^2)/E_1 + (1-v_2^2)/E_2 (Hertz)"),
    "elastic_modulus_particle": ("Pa", "1/E_sa = (1-v_a^2)/E_a + (1-v^2)/E, more compliant body"),
    "hardness_surface_1": ("Pa", "H_s1, hardness of the ball"),
    "hardness_surface_2": ("Pa", "H_s2, hardness of the flat"),
    "ball_radius": ("m", "R_x, radius of the ball"),
    "material_parameter": ("1", "G = alpha E_ss (below Eq. 8)"),
    "hardness_parameter": ("1", "V = v_h/E_ss, softer body (below Eq. 8)"),
    "speed_per_viscosity": ("s m-2", "U/nu = rho u/(E_ss R_x) (below Eq. 8)"),
    "ellipticity": ("1", "kappa of the contact, 1 for a ball on a flat (Eq. 7)"),
    "apparent_area": ("m2", "A_n, the nominal area, an input of its own"),
}


@dataclass(frozen=True)
class Material:
    """A body: its modulus, Poisson's ratio and hardness, as numbers or quantities.

    Parameters
    ----------
    modulus_GPa : float
        Young's modulus E [GPa].
    poisson_ratio : float
        Poisson's ratio v [1], 0 to 0.5.
    hardness_GPa : float
        Hardness H [GPa].

    Examples
    --------
    >>> import thirdbody as tb
    >>> bronze = tb.Material(modulus_GPa=110, poisson_ratio=0.34, hardness_GPa=1.5)
    >>> inputs = tb.bearing(flat=bronze)
    >>> inputs.hardness_surface_2
    1500000000.0
    """

    modulus_GPa: float
    poisson_ratio: float
    hardness_GPa: float

    def __post_init__(self):
        numbers = {name: getattr(self, name) for name in USUAL_MATERIAL}
        ratio = checked_number("poisson_ratio", self.poisson_ratio, positive=False)
        for name, number in (
            checked_numbers(numbers, USUAL_MATERIAL) | {"poisson_ratio": ratio}
        ).items():
            object.__setattr__(self, name, number)
        if self.poisson_ratio > 0.5:
            raise ValueError(f"poisson_ratio is {self.poisson_ratio}; allowed: 0 to 0.5")

    @property
    def compliance(self) -> float:
        """(1 - v^2)/E [Pa-1]."""
        return (1.0 - self.poisson_ratio**2) / (GIGA * self.modulus_GPa)

    @property
    def hardness(self) -> float:
        """Hardness [Pa]."""
        return GIGA * self.hardness_GPa


MATERIALS = {
    # Table 1; the modulus of steel that gives E_ss = 112 GPa
    "steel": Material(STEEL_MODULUS / GIGA, POISSON_RATIO, 5.0),
    # common values of hot-pressed bearing balls, within the limits of ASTM F2094
    "silicon nitride": Material(310.0, 0.27, 15.0),
    # common values of dense alumina
    "alumina": Material(380.0, 0.22, 16.0),
}
STEEL = MATERIALS["steel"]


@dataclass(frozen=True, kw_only=True)
class Rig:
    """The materials and the density of the oil from which inputs were derived."""

    ball: Material = STEEL
    flat: Material = STEEL
    particle: Material = STEEL
    oil_density_kg_per_m3: float = OIL_DENSITY

    @property
    def moduli(self) -> tuple[float, float]:
        """E_ss and E_sa [Pa]; a particle is in contact with the more compliant of ball and flat."""
        surface = max(self.ball, self.flat, key=lambda body: body.compliance)
        return _hertz_modulus(self.ball, self.flat), _hertz_modulus(self.particle, surface)


BODIES = "ball", "flat", "particle"


def _hertz_modulus(one: Material, other: Material) -> float:
    return 1.0 / (one.compliance + other.compliance)


def _material(name: str, material: Material | str) -> Material:
    """A material, or the one of this name."""
    if isinstance(material, Material):
        return material
    word = str(material).replace("-", " ").lower()
    if word not in MATERIALS:
        raise ValueError(f"{name} is {material!r}; allowed: a Material, {', '.join(MATERIALS)}")
    return MATERIALS[word]


def bearing(
    parameters: Parameters | None = None,
    *,
    ball_radius_mm: float | None = None,
    speed_m_per_s: float | None = None,
    oil_density_kg_per_m3: float | None = None,
    pressure_viscosity_per_GPa: float | None = None,
    ball: Material | str | None = None,
    flat: Material | str | None = None,
    particle: Material | str | None = None,
    apparent_area_mm2: float | None = None,
    ellipticity: float | None = None,
) -> Parameters:
    """Derive the inputs of the model for another ball, speed, oil or material.

    What is not given stays as it is in ``parameters``, also the product of density and speed and the
    pressure-viscosity coefficient that U and G stand for, the materials of the other bodies, and A_n.

    Parameters
    ----------
    parameters : Parameters, optional
        Inputs to start from, by default the calibrated ones.
    ball_radius_mm : float, optional
        R_x [mm], with 1/R_x = 1/R_1 + 1/R_2 for two balls.
    speed_m_per_s, oil_density_kg_per_m3 : float, optional
        Entrainment speed u = (u_1 + u_2)/2 [m/s] and density rho of the oil [kg m-3], both or neither.  Where a
        disc turns under a ball that does not, its speed is twice u.
    pressure_viscosity_per_GPa : float, optional
        alpha of the oil [GPa-1].
    ball, flat, particle : Material or str, optional
        Materials or their names: "steel", "silicon nitride", "alumina".  The ball is surface 1, on which Eq. 5
        counts the contact area of particles, so that ball and flat cannot be exchanged.
    apparent_area_mm2 : float, optional
        A_n [mm2], the nominal area of loads and areas: at most the cross-section of the ball.
    ellipticity : float, optional
        kappa of the contact in Eq. 7 [1], 1 for a ball on a flat; a roller or a gear has up to 10.

    Returns
    -------
    Parameters
        All inputs, SI; its members have the same changes.

    Raises
    ------
    ValueError
        For a number that is not positive, a speed without a density or the reverse, a particle softer than a
        surface, an A_n larger than the ball, inputs out of bounds, and some of the bodies where those of
        ``parameters`` are not known.

    Warns
    -----
    OutOfRangeWarning
        For unusual numbers.

    Examples
    --------
    A silicon nitride ball on steel, at 2 m/s in an oil of 850 kg/m3:

    >>> import thirdbody as tb
    >>> oil = dict(speed_m_per_s=2.0, oil_density_kg_per_m3=850.0)
    >>> inputs = tb.bearing(ball="silicon nitride", **oil)
    >>> round(inputs.elastic_modulus_surfaces / 1e9, 1)
    134.1
    """
    arguments = {name: value for name, value in locals().items() if value is not None}
    parameters = or_calibrated(parameters)
    numbers = checked_numbers(
        {name: arguments[name] for name in USUAL_BEARING if name in arguments}, USUAL_BEARING
    )
    materials = {name: _material(name, arguments[name]) for name in BODIES if name in arguments}
    rig, changes = _of_materials(parameters, materials)
    modulus = changes.get("elastic_modulus_surfaces", parameters.elastic_modulus_surfaces)
    radius = (
        1e-3 * numbers["ball_radius_mm"] if "ball_radius_mm" in numbers else parameters.ball_radius
    )
    stiffer, larger = modulus / parameters.elastic_modulus_surfaces, radius / parameters.ball_radius
    changes |= {
        "ball_radius": radius,
        "speed_per_viscosity": parameters.speed_per_viscosity / (stiffer * larger),
        "material_parameter": parameters.material_parameter * stiffer,
    }
    speed, density = numbers.get("speed_m_per_s"), numbers.get("oil_density_kg_per_m3")
    if (speed is None) != (density is None):
        texts = ("None" if each is None else f"{each:g}" for each in (speed, density))
        message = "speed_m_per_s is {} and oil_density_kg_per_m3 {}; allowed: both, or neither"
        raise ValueError(message.format(*texts))
    if speed is not None and density is not None:
        changes["speed_per_viscosity"] = density * speed / (modulus * radius)
    if "pressure_viscosity_per_GPa" in numbers:
        changes["material_parameter"] = numbers["pressure_viscosity_per_GPa"] * modulus / GIGA
    if "apparent_area_mm2" in numbers:
        changes["apparent_area"] = 1e-6 * numbers["apparent_area_mm2"]
    if "ellipticity" in numbers:
        changes["ellipticity"] = numbers["ellipticity"]
    inputs = parameters.changed(**changes).with_rig(rig)
    if density is not None:
        inputs = with_oil_density(inputs, density)
    if {"ball_radius_mm", "apparent_area_mm2"} & numbers.keys():
        inputs.check_ball()
    return inputs


def with_oil_density(parameters: Parameters, density: float) -> Parameters:
    """The same inputs, of which a speed is that in an oil of this ``density`` [kg m-3]."""
    return parameters.with_rig(replace(parameters.rig or Rig(), oil_density_kg_per_m3=density))


def _of_materials(parameters, materials):
    """The rig of ``parameters`` with other ``materials`` by name, and the inputs that follow from these."""
    rig = parameters.rig
    if rig is None and _are_of(Rig(), parameters):
        rig = Rig()
    if not materials:
        return rig, {}
    if (rig is None or not _are_of(rig, parameters)) and len(materials) < len(BODIES):
        missing = ", ".join(name for name in BODIES if name not in materials)
        raise ValueError(
            f"{missing}: not given, and not known from the moduli of the inputs; "
            f"allowed: {', '.join(BODIES)} together"
        )
    rig = replace(rig or Rig(), **materials)
    one = materials["ball"].hardness if "ball" in materials else parameters.hardness_surface_1
    two = materials["flat"].hardness if "flat" in materials else parameters.hardness_surface_2
    if "particle" in materials and rig.particle.hardness < max(one, two):
        raise ValueError(
            f"particle has a hardness of {1e-9 * rig.particle.hardness:g} GPa; allowed: at least "
            f"{1e-9 * max(one, two):g} GPa, the harder surface, as particles keep their shape"
        )
    surfaces, particle = rig.moduli
    changes = {"elastic_modulus_particle": particle}
    if materials.keys() - {"particle"}:
        changes |= {
            "elastic_modulus_surfaces": surfaces,
            "hardness_surface_1": one,
            "hardness_surface_2": two,
            "hardness_parameter": min(one, two) / surfaces,
        }
    return rig, changes


def _are_of(rig, parameters):
    """Whether the moduli of ``parameters`` are those of a rig, to the digits of Table 1."""
    moduli = parameters.elastic_modulus_surfaces, parameters.elastic_modulus_particle
    return bool(np.allclose(rig.moduli, moduli, rtol=2e-3, atol=0.0))


def hertz_contact(load_N: ArrayLike, parameters: Parameters) -> tuple[NDArray, NDArray]:
    """Area [m2] and mean pressure [Pa] of the smooth ball on a flat under a load [N] (Hertz)."""
    load = np.asarray(load_N, float)
    cube = 0.75 * load * parameters.ball_radius
    area = math.pi * (cube / parameters.elastic_modulus_surfaces) ** (2.0 / 3.0)
    return area, load / area


def derived_inputs(parameters: Parameters | None = None) -> pd.DataFrame:
    """The inputs that ``bearing`` derives: a row for each, with its value, unit and formula, and notes in
    ``attrs``."""
    import pandas as pd  # slow to import, for inputs alone

    parameters = or_calibrated(parameters)
    table = pd.DataFrame.from_dict(FORMULAS, "index", columns=["unit", "formula"])
    table.insert(0, "value", [getattr(parameters, name) for name in FORMULAS])
    table = table.rename_axis("input")
    table.attrs["notes"] = [speed_note(parameters)]
    return table
