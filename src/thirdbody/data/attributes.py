"""Attributes of datasets and variables required by CF-1.11 and ACDD-1.3, and the inputs of the
model as text."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from thirdbody.data.conditions import Axis
from thirdbody.data.quantities import FILL_FLAG, FILL_FLOAT, NUMBERS, STATUS, Quantity
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import NO_FLAG

# Attributes of a dataset in their order; null if they depend on its content.  The dates are those
# of the software version, so that the same inputs give the same bytes.
EVERYWHERE = json.loads(Path(__file__).with_suffix(".json").read_text(encoding="utf-8"))
# Keys of the attribute model_parameters by the names of inputs and of fields of a surface.
KEYS = EVERYWHERE["model_parameters"]


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


def model_attribute(parameters: Parameters, roughness: Iterable[float]) -> str:
    """The attribute ``model_parameters`` of a dataset with the coordinates ``roughness`` [m]: a
    flat JSON object, in SI, with lists for values that depend on the roughness."""
    surfaces = [parameters.surface(float(sigma)) for sigma in roughness]
    model = {key: getattr(parameters, name) for name, key in KEYS["body"].items()}
    for name, key in KEYS["surface"].items():
        model[key] = [getattr(surface, name) for surface in surfaces]
    model |= {key: getattr(parameters, name) for name, key in KEYS["particles"].items()}
    return json.dumps(model)
