"""Datasets of solved values with the attributes required by CF-1.11 and ACDD-1.3."""

import hashlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from thirdbody.core.parameters import Parameters
from thirdbody.core.regimes import NO_FLAG
from thirdbody.netcdf import FILL_FLAG, FILL_FLOAT, PlainDataset, Variable
from thirdbody.variables import AXES, DIMENSIONS, NORMAL_LOAD, NUMBERS, STATUS, VARIABLES
from thirdbody.variables import Variable as Described

# Attributes of a dataset in their order; null if they depend on its content.
EVERYWHERE = json.loads(Path(__file__).with_suffix(".json").read_text(encoding="utf-8"))
# Keys of the attribute model_parameters by the names of inputs and of fields of a surface.
KEYS = EVERYWHERE["model_parameters"]
GIVEN_AS = (
    "given_as"  # attribute of a load that was given in newtons: its name in ``thirdbody.solve``
)


def coordinate_attributes(described: Described, key: str = "") -> dict[str, str]:
    """Attributes of a coordinate: an axis, which was given by the name ``key``, or the normal
    load."""
    attributes = {
        "units": described.unit,
        "long_name": described.label,
        "symbol": described.symbol,
    }
    return attributes | ({GIVEN_AS: key} if key == "load_N" else {})


def variable_attributes(quantity: Described) -> dict:
    """Attributes of a variable."""
    attributes: dict[str, Any] = coordinate_attributes(quantity)
    attributes |= {"equation": quantity.equation}
    if quantity.meanings:
        named = dict(enumerate(quantity.meanings))
        named |= {} if quantity.name == STATUS else {int(NO_FLAG): "without_values"}
        named |= {int(FILL_FLAG): "not_shown"}
        attributes["flag_values"] = np.array([*named], dtype=np.int8)
        attributes["flag_meanings"] = " ".join(named.values())
        attributes["coverage_content_type"] = "qualityInformation"
    else:
        attributes["ancillary_variables"] = STATUS
        attributes["coverage_content_type"] = "modelResult"
    if quantity.comment:
        attributes["comment"] = quantity.comment
    return attributes


def variable_encoding(quantity: Described) -> dict:
    """How files store a variable: with the fill value of points that a figure does not show."""
    return {"_FillValue": FILL_FLOAT} if quantity.name in NUMBERS else {}


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
    model["phi_a"] = "centred" if parameters.mean_ratio > 0.0 else "uncentred"
    model |= {key: getattr(parameters, name) for name, key in KEYS["particles"].items()}
    return json.dumps(model)


def described_grid(
    axes: Mapping[str, NDArray],
    values: Mapping[str, NDArray],
    parameters: Parameters,
    rtol: float,
    title: str = "Three-body contact on a grid",
    request: Mapping | None = None,
    load_key: str = "load",
) -> PlainDataset:
    """The dataset of ``values``, an array over all ``axes`` for each variable, with coordinates and
    attributes; the load was given by the name ``load_key``.  Its SHA-256 depends on the parameters,
    ``rtol`` and ``request``, by default the axes."""
    variables = {
        name: Variable(
            DIMENSIONS, values[name], variable_attributes(quantity), variable_encoding(quantity)
        )
        for name, quantity in VARIABLES.items()
        if name in values
    }
    coordinates = {
        name: Variable(
            (name,), axis, coordinate_attributes(AXES[name], load_key if name == "load" else name)
        )
        for name, axis in axes.items()
    }
    newtons = axes["load"] * parameters.newtons_per_load
    coordinates["normal_load"] = Variable(("load",), newtons, coordinate_attributes(NORMAL_LOAD))
    configuration = {"parameters": parameters.as_dict(), "rtol": rtol}
    configuration["request"] = request or {name: axis.tolist() for name, axis in axes.items()}
    attributes = {
        **EVERYWHERE,
        **identity(json.dumps(configuration, sort_keys=True)),
        "title": title,
        "rtol": rtol,
        "model_parameters": model_attribute(parameters, axes["roughness"]),
    }
    known = {name: value for name, value in attributes.items() if value is not None}
    return PlainDataset(variables, coordinates, known)
