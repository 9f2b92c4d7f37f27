"""Inputs of the model: where their values come from, and what is laid over what.

``config/inputs.yaml`` has an entry for each input: its value, unless it is calibrated, with symbol, unit,
source, and the words that are allowed; ``thirdbody.model.bounds`` says what numbers may be.  Of the values
of an input the last that is given counts:

1. that of ``config/inputs.yaml``;
2. that of a calibrated file, as ``snakemake calibrate`` writes it: the one that ``calibrated`` in
   ``config/config.yaml`` names, or one that is given in its place;
3. that which is laid over: by ``inputs`` in ``config/config.yaml`` and its changes, by a file that gives
   some inputs, plain or in the layout of ``config/inputs.yaml``, and by arguments of ``load_parameters``.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from thirdbody.configuration import schema
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.messages import shown_file
from thirdbody.model.bounds import BOUNDS

if TYPE_CHECKING:
    from thirdbody.model.parameters import Parameters

Entries = Mapping[str, Mapping]
Values = dict[str, float | bool | str]


def load_parameters(path: str | Path | None = None, **inputs: float | bool | str) -> Parameters:
    """Inputs of the model: the calibrated ones, with what is given laid over them.

    Parameters
    ----------
    path : str or Path, optional
        A YAML file that gives some inputs, plain or in the layout of ``config/inputs.yaml``, which is
        laid over the calibrated ones; or a calibrated file of your own, which takes their place.
    **inputs : float, bool or str
        Inputs by the names that the fields of ``Parameters`` have, SI; they win over the file.

    Returns
    -------
    Parameters
        All inputs, SI.

    Raises
    ------
    ValueError
        In one line: the file or argument, the key at fault, its value and what is allowed.

    Warns
    -----
    UserWarning
        For a modulus, hardness or radius without G, V or U/nu, which hold it: ``thirdbody.bearing`` changes
        them together.

    Examples
    --------
    >>> parameters = load_parameters()
    >>> parameters.ball_radius  # [m]
    0.00635
    >>> sparse = load_parameters(participation=0.5)
    >>> sparse.participation, sparse.truncation == parameters.truncation
    (0.5, True)
    """
    import numpy as np  # which the workflow is read without

    from thirdbody.model.parameters import Parameters

    directory = schema.config_directory()
    settings = read_yaml(directory / "config.yaml")
    entries = read_entries()
    calibrated = directory.parent / settings["calibrated"]
    chosen = choose_inputs(entries, calibrated, settings["inputs"] if path is None else path)
    given = {
        name: value.item() if isinstance(value, np.generic) else value
        for name, value in inputs.items()
    }
    schema.validate(given, values_schema(entries), "load_parameters")
    values = chosen["parameters"] | plain_values(given)
    check_ball(values, "load_parameters")
    _warn_of_what_stays(chosen["inputs"] | given)
    return Parameters(**values)


# parameters of the film that hold a modulus, a hardness or the radius (below Eq. 8)
HELD_IN = {
    "elastic_modulus_surfaces": ("material_parameter", "hardness_parameter", "speed_per_viscosity"),
    "hardness_surface_1": ("hardness_parameter",),
    "hardness_surface_2": ("hardness_parameter",),
    "ball_radius": ("speed_per_viscosity",),
}


def _warn_of_what_stays(given):
    """Warn of inputs that are changed without the parameters of the film that hold them."""
    for name in HELD_IN.keys() & given.keys():
        stay = ", ".join(other for other in HELD_IN[name] if other not in given)
        if stay:
            message = f"{name} is changed alone, not with it {stay}; thirdbody.bearing changes them together"
            warnings.warn(message, UserWarning, stacklevel=3)


def read_entries(directory: Path | None = None) -> Entries:
    """Entries of the file ``inputs.yaml`` in a folder, the project's ``config/`` unless another is given."""
    path = (directory or schema.config_directory()) / "inputs.yaml"
    entries = schema.read_valid(path, "inputs")
    schema.validate(entries, _overlay_schema(entries), str(path))
    return entries


def plain_values(given: Mapping) -> Values:
    """The value of each entry that has one, or the plain value itself; numbers as ``float``."""
    values = {}
    for name, each in given.items():
        value = each.get("value") if isinstance(each, Mapping) else each
        if value is not None:
            values[name] = value if isinstance(value, bool | str) else float(value)
    return values


def choose_inputs(
    entries: Entries, calibrated: str | Path, given: str | Path | Mapping
) -> dict[str, Any]:
    """Values of all inputs, as the head of this module says.

    ``given``, values or a file of them, is laid over the inputs of the file ``calibrated``, or is a calibrated
    file that takes its place.  Raises ``ValueError`` in one line.  Returned are ``parameters``, a value of each
    input, SI; ``calibrated``, the path of the calibrated file, and ``interpretation``, the one that it is of;
    ``ensemble``, its members with what is laid over them; ``inputs``, the values that are laid over.
    """
    content, place = given, "inputs"
    if not isinstance(given, Mapping):
        content, place = read_yaml(given), shown_file(given)
        if "inputs" in content:
            calibrated, content = given, {}
    schema.validate(content, _overlay_schema(entries), place)
    laid_over = plain_values(content)
    found = read_calibrated(calibrated, entries)
    values = plain_values(entries) | plain_values(found["inputs"]) | laid_over
    check_complete(values, entries, f"{shown_file(calibrated)}: inputs")
    check_ball(values, place)
    return {
        "parameters": values,
        "calibrated": str(calibrated),
        "interpretation": found["interpretation"],
        "ensemble": ensemble_of(found, laid_over),
        "inputs": laid_over,
    }


def ensemble_of(calibrated: Mapping, laid_over: Values) -> list[Values]:
    """The members of the ensemble of a calibrated file, with the same values laid over all of them.

    There are none where they do not differ: one alone is no ensemble.
    """
    members = [plain_values(member) | laid_over for member in calibrated["ensemble"]]
    return members if any(member != members[0] for member in members) else []


def check_complete(given: Collection[str], entries: Entries, place: str) -> None:
    """Raises ``ValueError`` unless every input that has no value of its own is ``given``."""
    for name, entry in entries.items():
        if "value" not in entry and name not in given:
            allowed = "a value of each calibrated input"
            raise ValueError(f"{place}: {name} is missing; allowed: {allowed}")


def check_ball(values: Values, place: str) -> None:
    """Raises ``ValueError`` if the ball is smaller than the interface A_n, to which loads refer."""
    section = math.pi * values["ball_radius"] ** 2
    if values["apparent_area"] > section:
        raise ValueError(
            f"{place}: apparent_area is {values['apparent_area']:g}; allowed: at most {section:.3g} m2, "
            f"the cross-section of a ball of ball_radius {values['ball_radius']:g} m"
        )


def read_calibrated(path: str | Path, entries: Entries | None = None) -> dict:
    """The content of a file of ``config/calibrated/``; ``ValueError`` in one line."""
    values = values_schema(entries or read_entries())
    return schema.read_valid(path, "calibrated", input_values=values)


def values_schema(entries: Entries) -> dict:
    """JSON Schema of plain values of some of the inputs; in it, ``$defs/name`` is that of their names."""
    values = _closed({name: _value_schema(name, entry) for name, entry in entries.items()})
    return values | {"$defs": {"name": {"enum": list(entries)}}}


def _value_schema(name: str, entry: Mapping) -> dict:
    """JSON Schema of the value of one input: a number within bounds, or one of some words."""
    if "allowed" in entry:
        return {"enum": entry["allowed"]}
    bounds = BOUNDS[name]
    allowed = f"{bounds}" if entry["unit"] == "1" else f"{bounds} {entry['unit']}"
    limits = {"minimum": bounds.least, "maximum": bounds.most}
    return {"type": "number", **limits, "allowed": allowed}


def _overlay_schema(entries: Entries) -> dict:
    """JSON Schema of some inputs: each a value, or an entry as in ``config/inputs.yaml``, in the same unit."""
    given = {}
    for name, entry in entries.items():
        value = _value_schema(name, entry)
        unit = {"unit": {"const": entry["unit"]}} if "unit" in entry else {}
        whole = _closed(dict.fromkeys(entry, True) | unit | {"value": value})
        given[name] = {"if": {"type": "object"}, "then": whole, "else": value}
    return _closed(given)


def _closed(properties: dict) -> dict:
    return {"type": "object", "additionalProperties": False, "properties": properties}
