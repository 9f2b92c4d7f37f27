"""``bearing``: inputs derived from ball, speed, oil and the materials in contact.

The film parameters, defined below Eq. 8 of the paper, are those of Masjedi & Khonsari (2015):
U = mu_0 u/(E_ss R_x), G = alpha E_ss and V = v_h/E_ss.  As mu_0 = rho nu, the model uses U over the
kinematic viscosity, rho u/(E_ss R_x).  The moduli follow Hertz,
1/E = (1 - v_1^2)/E_1 + (1 - v_2^2)/E_2, which gives Table 1 for two steel bodies.
"""

from __future__ import annotations

from dataclasses import dataclass

from thirdbody.answers.answer import Answer, Row
from thirdbody.conditions import checked_number, checked_numbers
from thirdbody.core.parameters import Parameters
from thirdbody.inputs import check_ball, or_calibrated
from thirdbody.printed import POISSON_RATIO, STEEL_MODULUS
from thirdbody.toml_tables import toml_beside
from thirdbody.variables import AXES

TABLES = toml_beside(__file__)
USUAL_BEARING, USUAL_MATERIAL = TABLES["usual"], TABLES["usual_material"]
BODIES = "ball", "flat", "particle"
GIGA = 1e9
USUAL_DENSITY = 850.0  # of mineral oils [kg m-3]
LUBRICANT_DENSITIES = 700.0, 1100.0  # [kg m-3]


@dataclass(frozen=True)
class Material:
    """Young's modulus [GPa], Poisson's ratio [1] and hardness [GPa] of a body; numbers or quantities."""

    modulus_GPa: float
    poisson_ratio: float
    hardness_GPa: float

    def __post_init__(self):
        given = {name: getattr(self, name) for name in USUAL_MATERIAL}
        ratio = checked_number("poisson_ratio", self.poisson_ratio, positive=False)
        for name, number in (
            checked_numbers(given, USUAL_MATERIAL) | {"poisson_ratio": ratio}
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


def _material(name: str, given: Material | str) -> Material:
    """A material, or the one of this name."""
    if isinstance(given, Material):
        return given
    word = str(given).replace("-", " ").lower()
    if word not in MATERIALS:
        raise ValueError(f"{name} is {given!r}; allowed: a Material, {', '.join(MATERIALS)}")
    return MATERIALS[word]


def implied_speed(parameters: Parameters, oil_density_kg_per_m3: float = USUAL_DENSITY) -> float:
    """The rolling speed u [m/s] that U over the viscosity stands for, with an oil of this density."""
    stiffness = parameters.elastic_modulus_surfaces * parameters.ball_radius
    return parameters.speed_per_viscosity * stiffness / oil_density_kg_per_m3


def speed_note(parameters: Parameters, oil_density_kg_per_m3: float = USUAL_DENSITY) -> str:
    """The speed of the inputs with an oil of this density, in words."""
    speed = implied_speed(parameters, oil_density_kg_per_m3)
    oil = f"an oil of {oil_density_kg_per_m3:.4g} kg/m3"
    return f"with {oil}, U/nu is for a speed of {speed:.3g} m/s"


def _hertz_modulus(one: Material, other: Material) -> float:
    return 1.0 / (one.compliance + other.compliance)


def bearing(
    parameters: Parameters | None = None,
    *,
    ball_radius_mm: float | None = None,
    speed_m_per_s: float | None = None,
    oil_density_kg_per_m3: float | None = None,
    dynamic_viscosity_mPa_s: float | None = None,
    viscosity_cSt: float | None = None,
    pressure_viscosity_per_GPa: float | None = None,
    ball: Material | str | None = None,
    flat: Material | str | None = None,
    particle: Material | str | None = None,
    apparent_area_mm2: float | None = None,
) -> Parameters:
    """Derive the inputs of the model for another ball, speed, oil or material.

    Inputs that are not given are kept from ``parameters``, including the product of density and
    speed and the pressure-viscosity coefficient implied by U and G.  Raises ``ValueError`` for a
    number that is not positive, a speed without a density or the reverse, a body that is not a
    ``Material``, a particle softer than a surface, an A_n larger than the ball, and inputs out of
    bounds.  Unusual numbers cause an ``OutOfRangeWarning``.

    Parameters
    ----------
    parameters : Parameters, optional
        Inputs to start from, by default the calibrated ones.
    ball_radius_mm, speed_m_per_s : float, optional
        R_x [mm], with 1/R_x = 1/R_1 + 1/R_2 for two balls; and the rolling speed u [m/s].
    oil_density_kg_per_m3, dynamic_viscosity_mPa_s, viscosity_cSt : float, optional
        For the speed: rho of the oil [kg m-3], or mu_0 [mPa s] and nu [cSt], with rho = mu_0/nu.
    pressure_viscosity_per_GPa : float, optional
        alpha [GPa-1].
    ball, flat, particle : Material or str, optional
        Materials of both bodies and of the particles, or their names: "steel", "silicon nitride",
        "alumina"; if one is given, the others are steel.
    apparent_area_mm2 : float, optional
        A_n [mm2], the reference area of loads: at most the cross-section of the ball.

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
    bodies = {name: _material(name, arguments[name]) for name in BODIES if name in arguments}
    changes = _of_bodies(bodies) if bodies else {}
    modulus = changes.get("elastic_modulus_surfaces", parameters.elastic_modulus_surfaces)
    radius = 1e-3 * numbers.get("ball_radius_mm", 1e3 * parameters.ball_radius)
    stiffer, larger = modulus / parameters.elastic_modulus_surfaces, radius / parameters.ball_radius
    changes |= {
        "ball_radius": radius,
        "speed_per_viscosity": parameters.speed_per_viscosity / (stiffer * larger),
        "material_parameter": parameters.material_parameter * stiffer,
    }
    flow = _density_times_speed(numbers)
    if flow is not None:
        changes["speed_per_viscosity"] = flow / (modulus * radius)
    if "pressure_viscosity_per_GPa" in numbers:
        changes["material_parameter"] = numbers["pressure_viscosity_per_GPa"] * modulus / GIGA
    if "apparent_area_mm2" in numbers:
        changes["apparent_area"] = 1e-6 * numbers["apparent_area_mm2"]
    try:
        found = parameters.changed(**changes)
        if {"ball_radius_mm", "apparent_area_mm2"} & numbers.keys():
            check_ball(found.as_dict(), "bearing")
        return found
    except ValueError as error:
        raise ValueError(f"derived from {', '.join([*numbers, *bodies])}: {error}") from None


def _of_bodies(given):
    """The inputs that follow from the materials by body; those that are not ``given`` are steel."""
    ball, flat, particle = (given.get(name, MATERIALS["steel"]) for name in BODIES)
    softer, harder = sorted((ball.hardness, flat.hardness))
    if "particle" in given and particle.hardness < harder:
        raise ValueError(
            f"particle has a hardness of {1e-9 * particle.hardness:g} GPa; allowed: at least "
            f"{1e-9 * harder:g} GPa, the harder surface, as particles keep their shape"
        )
    modulus = _hertz_modulus(ball, flat)
    surface = max(ball, flat, key=lambda body: body.compliance)
    return {
        "elastic_modulus_surfaces": modulus,
        "elastic_modulus_particle": _hertz_modulus(particle, surface),
        "hardness_surface_1": ball.hardness,
        "hardness_surface_2": flat.hardness,
        "hardness_parameter": softer / modulus,
    }


def _density_times_speed(numbers):
    """rho u [kg m-2 s-1]; None if neither is among the ``numbers``."""
    speed, density = numbers.get("speed_m_per_s"), numbers.get("oil_density_kg_per_m3")
    if {"dynamic_viscosity_mPa_s", "viscosity_cSt"} <= numbers.keys():
        density = 1e3 * numbers["dynamic_viscosity_mPa_s"] / numbers["viscosity_cSt"]
    if (speed is None) != (density is None):
        texts = ("None" if each is None else f"{each:g}" for each in (speed, density))
        raise ValueError(
            "speed_m_per_s is {} and the oil's density {}; allowed: both, or neither (a density, "
            "or dynamic_viscosity_mPa_s with viscosity_cSt)".format(*texts)
        )
    return None if speed is None else density * speed


def derived(parameters: Parameters, viscosity_cSt: float | None = None) -> Answer:
    """Answer to question 8: the inputs derived by ``bearing``, each with its formula, and U for an
    oil of ``viscosity_cSt`` if given.
    """
    parameters = or_calibrated(parameters)
    rows = [
        Row(name, formula, getattr(parameters, name), unit)
        for name, (unit, formula) in TABLES["formulas"].items()
    ]
    if viscosity_cSt is not None:
        viscosity_cSt = checked_number("viscosity_cSt", viscosity_cSt, positive=False)
        speed = parameters.speed_per_viscosity * float(AXES["viscosity"].to_si(viscosity_cSt))
        rows.append(Row("speed_parameter", f"U at {viscosity_cSt:g} cSt", speed, "1"))
    notes = (
        speed_note(parameters),
        f"A_n = {parameters.apparent_area:.4g} m2 is an input of its own and stays",
    )
    return Answer("Inputs derived from ball, speed, oil and materials", tuple(rows), notes)
