"""Attributes of datasets and variables required by CF-1.11 and ACDD-1.3, and the inputs of the
model as text."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Axis
from thirdbody.data.quantities import FILL_FLAG, FILL_FLOAT, NUMBERS, STATUS, Quantity
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import NO_FLAG

# Attributes of a dataset in their order; null if they depend on its content.  The dates are those
# of the software version, so that the same inputs give the same bytes.
EVERYWHERE = json.loads(Path(__file__).with_name("attributes.json").read_text(encoding="utf-8"))
# keys of inputs and of fields of a surface, in the order of the attribute
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


def software_version() -> str:
    """Installed version of this package."""
    try:
        return version("thirdbody")
    except PackageNotFoundError:
        return "not installed"


def coordinate_attributes(described: Axis | Quantity) -> dict[str, str]:
    """Attributes of a coordinate: an axis, or the normal load along the load axis."""
    return {"units": described.units, "long_name": described.long_name, "symbol": described.symbol}


def variable_attributes(quantity: Quantity) -> dict:
    """Attributes of a variable, including the fill value of points that a figure does not show."""
    attributes = coordinate_attributes(quantity) | {"equation": quantity.equation}
    if quantity.meanings:
        named = dict(enumerate(quantity.meanings))
        named |= {} if quantity.name == STATUS else {NO_FLAG: "without_values"}
        named |= {FILL_FLAG: "not_shown"}
        attributes["flag_values"] = np.array([*named], dtype=np.int8)
        attributes["flag_meanings"] = " ".join(named.values())
        attributes["coverage_content_type"] = "qualityInformation"
    else:
        attributes["ancillary_variables"] = STATUS
        attributes["coverage_content_type"] = "modelResult"
    if quantity.name in NUMBERS:
        attributes["_FillValue"] = FILL_FLOAT
    if quantity.comment:
        attributes["comment"] = quantity.comment
    return attributes


def identity(origin: str) -> dict[str, str]:
    """The SHA-256 of an ``origin`` text, and the dataset id derived from it."""
    digest = hashlib.sha256(origin.encode()).hexdigest()
    return {"configuration_sha256": digest, "id": f"thirdbody-{digest[:16]}"}


def global_attributes(
    title: str,
    parameters: Parameters,
    roughness: NDArray[np.float64],
    rtol: float,
    request: Mapping,
) -> dict:
    """Attributes of a whole dataset.

    ``model_parameters`` lists the summits of ``parameters`` along ``roughness`` [m], shape (n,);
    ``configuration_sha256`` depends on the parameters, ``rtol`` and the ``request``.
    """
    configuration = {"parameters": parameters.as_dict(), "rtol": rtol, "request": request}
    return {
        **EVERYWHERE,
        **identity(json.dumps(configuration, sort_keys=True)),
        "title": title,
        "software_version": software_version(),
        "product_version": software_version(),
        "rtol": rtol,
        "model_parameters": model_attribute(parameters, roughness),
    }


def model_attribute(parameters: Parameters, roughness: Iterable[float]) -> str:
    """The attribute ``model_parameters`` of a dataset with the coordinates ``roughness`` [m]: a
    flat JSON object, in SI, with lists for values that depend on the roughness."""
    surfaces = [parameters.surface(float(sigma)) for sigma in roughness]
    model = {key: getattr(parameters, name) for name, key in BODY_KEYS.items()}
    for name, key in SURFACE_KEYS.items():
        model[key] = [getattr(surface, name) for surface in surfaces]
    model |= {key: getattr(parameters, name) for name, key in PARTICLE_KEYS.items()}
    return json.dumps(model)
