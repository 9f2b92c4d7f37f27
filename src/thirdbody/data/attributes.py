"""Attributes of the files: what CF-1.11 and ACDD-1.3 ask of a dataset and of each variable in it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Axis
from thirdbody.data.model_attribute import model_attribute
from thirdbody.data.quantities import FILL_FLAG, FILL_FLOAT, NUMBERS, STATUS, Quantity
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import NO_FLAG

# Attributes of a whole dataset in their order, null where they depend on its content.  The dates are that of
# this version of the software, so that the same inputs give the same bytes.
EVERYWHERE = json.loads(Path(__file__).with_name("attributes.json").read_text(encoding="utf-8"))


def software_version() -> str:
    """Version of this package, as installed."""
    try:
        return version("thirdbody")
    except PackageNotFoundError:
        return "not installed"


def coordinate_attributes(described: Axis | Quantity) -> dict[str, str]:
    """Attributes of a coordinate: an axis, or the normal load beside the first."""
    return {
        "units": described.units,
        "long_name": described.long_name,
        "symbol": described.symbol,
    }


def variable_attributes(quantity: Quantity) -> dict:
    """Attributes of a variable, with what stands for points that a figure does not show."""
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
    """The sum of an ``origin`` text, and the name of a dataset that it makes."""
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
    ``configuration_sha256`` depends on the parameters, ``rtol`` and what was asked for, ``request``.
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
