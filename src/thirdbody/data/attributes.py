"""Attributes of the files: what CF-1.11 and ACDD-1.3 ask of a dataset and of each variable in it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version

import numpy as np
from numpy.typing import NDArray

from thirdbody.data.conditions import Axis
from thirdbody.data.model_attribute import model_attribute
from thirdbody.data.quantities import FILL_FLAG, FILL_FLOAT, NUMBERS, STATUS, Quantity
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import NO_FLAG

SCHEMA_VERSION = "1.2"
PAPER_DOI = "10.3389/fmech.2024.1390335"
# What ACDD-1.3 asks of every file beside the attributes that depend on its content; the dates are
# that of this version of the software, so that the same inputs give the same bytes.
RELEASE_DATE = "2026-11-21"
DISCOVERY = {
    "naming_authority": "thirdbody",
    "history": "computed by thirdbody from the equations of the paper",
    "comment": (
        "nan: the point has no values, and solution_status says why; a value beside another status "
        "than converged is to be taken as the comment of solution_status says"
    ),
    "acknowledgement": "Chen & Horng (2024) for the model",
    "project": "thirdbody",
    "program": "reproduction of published models",
    "processing_level": "model result",
    "institution": "The thirdbody developers",
    "creator_type": "group",
    "creator_institution": "The thirdbody developers",
    "creator_url": f"https://doi.org/{PAPER_DOI}",
    "creator_email": "not given",
    "contributor_name": "Chen Y-Y, Horng J-H",
    "contributor_role": "authors of the model",
    "publisher_name": "The thirdbody developers",
    "publisher_type": "group",
    "publisher_institution": "The thirdbody developers",
    "publisher_url": f"https://doi.org/{PAPER_DOI}",
    "publisher_email": "not given",
    "metadata_link": f"https://doi.org/{PAPER_DOI}",
    "platform": "model",
    "platform_vocabulary": "none",
    "instrument": "none",
    "instrument_vocabulary": "none",
    "keywords_vocabulary": "none",
    "date_created": RELEASE_DATE,
    "date_issued": RELEASE_DATE,
    "date_modified": RELEASE_DATE,
    "date_metadata_modified": RELEASE_DATE,
}


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
    canonical = json.dumps(configuration, sort_keys=True)
    own = identity(canonical)
    conventions = "CF-1.11, ACDD-1.3"
    return {
        "Conventions": conventions,
        "conventions": conventions,
        "title": title,
        "summary": (
            "Load and real contact area shared by summits, third particles and a lubricant film "
            "between two rough surfaces, computed from the equations printed by Chen & Horng "
            "(2024) with the parameters in model_parameters."
        ),
        "keywords": "tribology, three-body contact, mixed lubrication, real contact area",
        "source": f"doi:{PAPER_DOI}",
        "references": f"Chen & Horng (2024), Front. Mech. Eng. 10:1390335, doi:{PAPER_DOI}",
        "license": "CC-BY-4.0",
        "creator_name": "The thirdbody developers",
        "standard_name_vocabulary": "CF Standard Name Table v93",
        "schema_version": SCHEMA_VERSION,
        "software_version": software_version(),
        "configuration_sha256": own["configuration_sha256"],
        "rtol": rtol,
        **DISCOVERY,
        "id": own["id"],
        "product_version": software_version(),
        "model_parameters": model_attribute(parameters, roughness),
    }
