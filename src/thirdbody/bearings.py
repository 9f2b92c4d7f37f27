"""``bearing``: inputs derived from ball, speed, oil and the materials in contact.

The paper defines the film parameters below Eq. 8.  They are those of Masjedi & Khonsari (2015):
U = mu_0 u/(E_ss R_x), G = alpha E_ss and V = v_h/E_ss.  As mu_0 = rho nu, the input of the model is
U over the kinematic viscosity, rho u/(E_ss R_x).  The moduli follow Hertz,
1/E = (1 - v_1^2)/E_1 + (1 - v_2^2)/E_2; two steel bodies then have the modulus of Table 1.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.conditions import checked_numbers
from thirdbody.core.parameters import BOUNDS, Parameters
from thirdbody.ensembles import (
    BODIES,
    GIGA,
    STEEL,
    Ensemble,
    Material,
    Setup,
)
from thirdbody.inputs import or_calibrated
from thirdbody.notes import speed_notes
from thirdbody.variables import SPEED

if TYPE_CHECKING:
    import pandas as pd


# by argument of ``bearing``: its least and its most usual value, and their unit
USUAL_BEARING = {
    "ball_radius_mm": (0.1, 1000.0, "mm"),
    SPEED.alias: (*SPEED.usual, SPEED.unit),
    "oil_density_kg_per_m3": (500.0, 3000.0, "kg m-3"),
    "pressure_viscosity_per_GPa": (1.0, 100.0, "GPa-1"),
    "apparent_area_mm2": (1e-4, 1e6, "mm2"),
    "ellipticity": (0.1, 10.0, "1"),
}
# by derived input: its formula
FORMULAS = {
    "elastic_modulus_surfaces": "1/E_ss = (1-v_1^2)/E_1 + (1-v_2^2)/E_2 (Hertz)",
    "elastic_modulus_particle": "1/E_sa = (1-v_a^2)/E_a + (1-v^2)/E, more compliant body",
    "hardness_surface_1": "H_s1, hardness of the ball",
    "hardness_surface_2": "H_s2, hardness of the flat",
    "ball_radius": "R_x, radius of the ball",
    "material_parameter": "G = alpha E_ss (below Eq. 8)",
    "hardness_parameter": "V = v_h/E_ss, softer body (below Eq. 8)",
    "speed_per_viscosity": "U/nu = rho u/(E_ss R_x) (below Eq. 8)",
    "ellipticity": "kappa of the contact, 1 for a ball on a flat (Eq. 7)",
    "apparent_area": "A_n, the nominal area, an input of its own",
}


MATERIALS = {
    "steel": STEEL,
    # common values of hot-pressed bearing balls, within the limits of ASTM F2094
    "silicon nitride": Material(310.0, 0.27, 15.0),
    # common values of dense alumina
    "alumina": Material(380.0, 0.22, 16.0),
}


def _moduli(setup: Setup) -> tuple[float, float]:
    """E_ss and E_sa [Pa].  E_sa is that of a particle and the more compliant of ball and flat."""
    ball, flat, particle = (getattr(setup, name) for name in BODIES)
    surface = max(ball, flat, key=lambda body: body.compliance)
    return _hertz_modulus(ball, flat), _hertz_modulus(particle, surface)


def _hertz_modulus(one: Material, other: Material) -> float:
    return 1.0 / (one.compliance + other.compliance)


def _material(name: str, material: Material | str) -> Material:
    """The ``material``, also from its name; ``name`` is the body, for the error."""
    if isinstance(material, Material):
        return material
    word = str(material).replace("-", " ").lower()
    if word not in MATERIALS:
        raise ValueError(f"{name} is {material!r}; allowed: a Material, {', '.join(MATERIALS)}")
    return MATERIALS[word]


def bearing(
    parameters: Parameters | Ensemble | None = None,
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
) -> Ensemble:
    """Derive the inputs of the model for another ball, speed, oil or material.

    All else stays as it is in ``parameters``: A_n, the materials of the other bodies, the product
    of density and speed that U contains, and the pressure-viscosity coefficient that G contains.
    If members differ in A_n, a new A_n moves their calibrated inputs, as in ``Ensemble.changed``.

    Parameters
    ----------
    parameters : Parameters or Ensemble, optional
        Inputs to start from, by default the calibrated inputs.  For ``Parameters`` the materials
        and the density of the oil are unknown.
    ball_radius_mm : float, optional
        R_x [mm], with 1/R_x = 1/R_1 + 1/R_2 for two balls.
    speed_m_per_s, oil_density_kg_per_m3 : float, optional
        Entrainment speed u = (u_1 + u_2)/2 [m/s] and density rho of the oil [kg m-3], both or
        neither.  The speed of a disc under a ball that does not turn is 2 u.
    pressure_viscosity_per_GPa : float, optional
        alpha of the oil [GPa-1].
    ball, flat, particle : Material or str, optional
        Materials or their names: "steel", "silicon nitride", "alumina".  The ball is surface 1, on
        which Eq. 5 counts the contact area of particles: to exchange ball and flat changes results.
    apparent_area_mm2 : float, optional
        A_n [mm2], the nominal area to which loads and areas refer: at most the cross-section of the
        ball.
    ellipticity : float, optional
        kappa of the contact in Eq. 7 [1]: 1 for a ball on a flat, up to 10 for a roller or a gear.

    Returns
    -------
    Ensemble
        All inputs, SI, with the same changes in all members.  The ``setup`` has the materials and
        the density of the oil.

    Raises
    ------
    ValueError
        For a number that is not positive, a speed without a density or the reverse, a particle
        softer than a surface, an A_n larger than the ball, and inputs out of bounds.  Also for a
        material of one or two bodies, if those of ``parameters`` are unknown.

    Warns
    -----
    OutOfRangeWarning
        For unusual numbers.
    UserWarning
        For an A_n that is far from those of all members, or another than they all share.

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
    ensemble = or_calibrated(parameters)
    before = ensemble.best
    numbers = checked_numbers(
        {name: arguments[name] for name in USUAL_BEARING if name in arguments},
        USUAL_BEARING,
        stacklevel=4,
    )
    materials = {name: _material(name, arguments[name]) for name in BODIES if name in arguments}
    setup, changes = _of_materials(ensemble, materials)
    modulus = changes.get("elastic_modulus_surfaces", before.elastic_modulus_surfaces)
    radius = 1e-3 * numbers["ball_radius_mm"] if "ball_radius_mm" in numbers else before.ball_radius
    stiffer, larger = modulus / before.elastic_modulus_surfaces, radius / before.ball_radius
    changes |= {
        "speed_per_viscosity": before.speed_per_viscosity / (stiffer * larger),
        "material_parameter": before.material_parameter * stiffer,
    }
    if "ball_radius_mm" in numbers:
        changes["ball_radius"] = radius
    speed, density = numbers.get("speed_m_per_s"), numbers.get("oil_density_kg_per_m3")
    if (speed is None) != (density is None):
        texts = ("None" if each is None else f"{each:g}" for each in (speed, density))
        message = "speed_m_per_s is {} and oil_density_kg_per_m3 {}; allowed: both, or neither"
        raise ValueError(message.format(*texts))
    if speed is not None and density is not None:
        changes["speed_per_viscosity"] = density * speed / (modulus * radius)
        setup = replace(setup, oil_density_kg_per_m3=density)
    if "pressure_viscosity_per_GPa" in numbers:
        changes["material_parameter"] = numbers["pressure_viscosity_per_GPa"] * modulus / GIGA
    if "apparent_area_mm2" in numbers:
        changes["apparent_area"] = 1e-6 * numbers["apparent_area_mm2"]
    if "ellipticity" in numbers:
        changes["ellipticity"] = numbers["ellipticity"]
    return replace(ensemble._with(changes, stacklevel=3), setup=setup)


def _of_materials(ensemble: Ensemble, materials: dict[str, Any]) -> tuple[Setup, dict[str, float]]:
    """The setup of an ensemble with other ``materials`` by body, and the inputs that change."""
    setup, before = ensemble.setup, ensemble.best
    if not materials:
        return setup, {}
    if not _are_of(setup, before) and len(materials) < len(BODIES):
        missing = ", ".join(name for name in BODIES if name not in materials)
        raise ValueError(
            f"{missing}: missing, and the inputs do not say the material; "
            f"allowed: {', '.join(BODIES)} together"
        )
    setup = replace(setup, **materials)
    one = materials["ball"].hardness if "ball" in materials else before.hardness_surface_1
    two = materials["flat"].hardness if "flat" in materials else before.hardness_surface_2
    if "particle" in materials and materials["particle"].hardness < max(one, two):
        raise ValueError(
            f"particle has a hardness of {1e-9 * materials['particle'].hardness:g} GPa; "
            f"allowed: at least {1e-9 * max(one, two):g} GPa, the harder surface, "
            "as particles keep their shape"
        )
    surfaces, particle = _moduli(setup)
    changes = {"elastic_modulus_particle": particle}
    if materials.keys() - {"particle"}:
        changes |= {
            "elastic_modulus_surfaces": surfaces,
            "hardness_surface_1": one,
            "hardness_surface_2": two,
            "hardness_parameter": min(one, two) / surfaces,
        }
    return setup, changes


def _are_of(setup: Setup, parameters: Parameters) -> bool:
    """Whether the materials of a setup give the moduli of ``parameters``, to the digits of Table
    1."""
    if None in (setup.ball, setup.flat, setup.particle):
        return False
    moduli = parameters.elastic_modulus_surfaces, parameters.elastic_modulus_particle
    return bool(np.allclose(_moduli(setup), moduli, rtol=2e-3, atol=0.0))


def hertz_contact(load_N: ArrayLike, parameters: Parameters | Ensemble) -> tuple[NDArray, NDArray]:
    """Contact area [m2] and mean pressure [Pa] of a smooth ball on a flat under a load (Hertz)."""
    load = np.asarray(load_N, float)
    cube = 0.75 * load * parameters.ball_radius
    area = math.pi * (cube / parameters.elastic_modulus_surfaces) ** (2.0 / 3.0)
    return area, load / area


def hardness_notes(load_N: ArrayLike, parameters: Parameters | Ensemble) -> list[str]:
    """A note if the largest load presses the smooth ball harder than the softer surface is."""
    loads = np.asarray(load_N, float)
    if not loads.size:
        return []
    load = float(loads.max())
    hardness = min(parameters.hardness_surface_1, parameters.hardness_surface_2)
    _, pressure = hertz_contact(load, parameters)
    note = f"load {load:g} N: the mean Hertz pressure is {1e-9 * pressure:.3g} GPa, above the "
    note += f"hardness of the softer surface, {1e-9 * hardness:g} GPa"
    return [note] if pressure > hardness else []


def derived_inputs(parameters: Parameters | Ensemble | None = None) -> pd.DataFrame:
    """A table of the inputs that ``bearing`` derives, with value, unit and formula.

    ``attrs`` has notes.
    """
    import pandas as pd  # slow to import; other functions here do not need it

    inputs = or_calibrated(parameters)
    columns = {
        "value": [getattr(inputs.best, name) for name in FORMULAS],
        "unit": [BOUNDS[name].unit for name in FORMULAS],
        "formula": [*FORMULAS.values()],
    }
    table = pd.DataFrame(columns, index=pd.Index(FORMULAS, name="input"))
    table.attrs["notes"] = speed_notes(inputs)
    return table
