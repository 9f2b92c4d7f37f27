"""The inputs of the model as text: the attribute ``model_parameters`` of datasets."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping

from thirdbody.model.parameters import Parameters

# keys of inputs, and of fields of a surface, in the order in which they stand in the attribute
BODY_KEYS = {
    "elastic_modulus_surfaces": "E_ss",
    "elastic_modulus_particle": "E_sa",
    "hardness_surface_1": "H_s1",
    "hardness_surface_2": "H_s2",
    "yield_pressure_ratio": "k",
    "plastic_interference_ratio": "omega_ratio",
    "ball_radius": "R_x",
    "material_parameter": "G",
    "hardness_parameter": "V",
    "ellipticity": "kappa",
    "speed_per_viscosity": "U_per_viscosity",
    "apparent_area": "A_n",
}
SURFACE_KEYS = {
    "summit_density": "eta_s",
    "summit_radius": "R",
    "summit_deviation": "sigma_s",
    "summit_offset": "y_s",
}
PARTICLE_KEYS = {
    "size_distribution": "phi_a",
    "mean_ratio": "mean_ratio",
    "spread_ratio": "sigma_a_ratio",
    "gap_ratio": "gap_ratio",
    "truncation": "truncation",
    "participation": "participation",
    "elastic_depth_ratio": "h_e_ratio",
    "particle_plane": "particle_plane",
    "elastic_limits": "elastic_limits",
    "coverage_limits": "coverage_limits",
    "film_load": "film_load",
}


def model_attribute(parameters: Parameters, roughness: Iterable[float]) -> str:
    """The attribute ``model_parameters`` of a dataset with these coordinates ``roughness`` [m]: a
    flat JSON object, in SI; what depends on the roughness is a list along it."""
    surfaces = [parameters.surface(float(sigma)) for sigma in roughness]
    model = {key: getattr(parameters, name) for name, key in BODY_KEYS.items()}
    for name, key in SURFACE_KEYS.items():
        model[key] = [getattr(surface, name) for surface in surfaces]
    model |= {key: getattr(parameters, name) for name, key in PARTICLE_KEYS.items()}
    return json.dumps(model)


def parameters_on_one_surface(model: Mapping, roughness: float) -> Parameters:
    """The inputs that ``model`` describes, with the summits of one surface at ``roughness`` [m] alone.

    ``model`` has values by the keys of ``model_parameters``, numbers or their texts, and no lists.
    Older datasets have no ``particle_plane``, which was that of the surface.
    """
    model = {"particle_plane": "surface", **model}
    kinds = Parameters.__annotations__
    given = {
        name: float(model[key]) if kinds[name] == "float" else model[key]
        for name, key in (BODY_KEYS | PARTICLE_KEYS).items()
    }
    density, radius, deviation, offset = (float(model[key]) for key in SURFACE_KEYS.values())
    raised = "as_rough" if deviation == roughness else True
    return Parameters(
        **given,
        reference_roughness=roughness,
        summit_parameter=density * radius * roughness,
        summit_parameter_exponent=0.0,
        summit_radius=radius,
        summit_radius_exponent=0.0,
        summit_offset=raised if offset != 0.0 else False,
    )
