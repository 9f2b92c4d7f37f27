"""Inputs of the model: the sources of their values, and which source takes precedence.

Later values override earlier ones: those in ``config/inputs.yaml``, which describes each input; in
a calibrated file, named by ``calibrated`` in ``config/config.yaml`` or given in its place; and
overrides: ``inputs`` in ``config/config.yaml`` and its changes, a file with some inputs, plain or
in the layout of ``config/inputs.yaml``, and arguments of ``load_parameters``.
"""

import math
import warnings
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

from thirdbody.conditions import numbers_in
from thirdbody.configuration import config_directory, schema
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.core.parameters import BOUNDS, Parameters
from thirdbody.messages import format_path

Entries = Mapping[str, Mapping]
Values = dict[str, float | bool | str]
CLOSED = {"type": "object", "additionalProperties": False}  # in a JSON Schema


def load_parameters(path: str | Path | None = None, **inputs: float | bool | str) -> Parameters:
    """The calibrated inputs of the model, overridden by the given ones.

    Parameters
    ----------
    path : str or Path, optional
        A YAML file with some inputs, plain or in the layout of ``config/inputs.yaml``, that
        overrides the calibrated ones; or a calibrated file of your own, which replaces them.
    **inputs : float, bool or str
        Inputs by the field names of ``Parameters``, SI or quantities; they override the file.

    Returns
    -------
    Parameters
        All inputs, SI.

    Raises
    ------
    ValueError
        One line with the file or argument, the wrong key, its value and what is allowed.

    Warns
    -----
    UserWarning
        For a modulus, hardness or radius without G, V or U/nu, which depend on it;
        ``thirdbody.bearing`` changes them together.

    Examples
    --------
    >>> parameters = load_parameters()
    >>> parameters.ball_radius  # [m]
    0.00635
    >>> sparse = load_parameters(participation=0.5)
    >>> sparse.participation, sparse.truncation == parameters.truncation
    (0.5, True)
    """
    directory = config_directory()
    settings = read_yaml(directory / "config.yaml")
    entries = read_entries()
    calibrated = directory.parent / settings["calibrated"]
    chosen = choose_inputs(entries, calibrated, settings["inputs"] if path is None else path)
    inputs = {
        name: numbers_in(name, value, entries[name]["unit"]).tolist()
        if "unit" in entries.get(name, {})
        else value
        for name, value in inputs.items()
    }
    schema.validate(inputs, values_schema(entries), "load_parameters")
    values = chosen["parameters"] | plain_values(inputs)
    check_ball(values, "load_parameters")
    changed = chosen["inputs"] | inputs
    if HELD_IN.keys() & changed.keys():
        _warn_of_what_stays(changed, choose_inputs(entries, chosen["calibrated"], {})["parameters"])
    return Parameters(**values)


def or_calibrated(parameters: Parameters | None) -> Parameters:
    """``parameters``, or the calibrated ones if it is None."""
    return _calibrated() if parameters is None else parameters


@cache
def _calibrated():
    """Cached: reading the files takes longer than solving one point."""
    return load_parameters()


# film parameters that depend on a modulus, a hardness or the radius (below Eq. 8)
HELD_IN = {
    "elastic_modulus_surfaces": ("material_parameter", "hardness_parameter", "speed_per_viscosity"),
    "hardness_surface_1": ("hardness_parameter",),
    "hardness_surface_2": ("hardness_parameter",),
    "ball_radius": ("speed_per_viscosity",),
}


def _warn_of_what_stays(given, before):
    """Warn of inputs that differ from ``before`` without the film parameters that depend on them."""
    for name in HELD_IN.keys() & given.keys():
        stay = ", ".join(other for other in HELD_IN[name] if other not in given)
        if stay and not math.isclose(given[name], before[name]):
            message = f"{name} is changed without {stay}; thirdbody.bearing changes them together"
            warnings.warn(message, UserWarning, stacklevel=3)


def read_entries(directory: Path | None = None) -> Entries:
    """Entries of the file ``inputs.yaml`` in a folder, by default ``config/``."""
    path = (directory or config_directory()) / "inputs.yaml"
    entries = schema.read_valid(path, "inputs")
    schema.validate(entries, values_schema(entries), str(path))
    return entries


def plain_values(given: Mapping) -> Values:
    """The values of entries that have one, and plain values; numbers as ``float``."""
    values = {}
    for name, each in given.items():
        value = each.get("value") if isinstance(each, Mapping) else each
        if value is not None:
            values[name] = value if isinstance(value, bool | str) else float(value)
    return values


def choose_inputs(
    entries: Entries, calibrated: str | Path, given: str | Path | Mapping
) -> dict[str, Any]:
    """Values of all inputs, by the precedence in the docstring of this module.

    ``given``, values or a file of them, overrides the inputs of the file ``calibrated``, or is a
    calibrated file that replaces it.  Returns ``parameters``, the value of each input, SI;
    ``calibrated``, the path of the calibrated file; ``ensemble``, its members with the overrides;
    and ``inputs``, the overrides.
    """
    content, place = given, "inputs"
    if not isinstance(given, Mapping):
        content, place = read_yaml(given), format_path(given)
        if "inputs" in content:
            calibrated, content = given, {}
    schema.validate(content, values_schema(entries), place)
    laid_over = plain_values(content)
    found = read_calibrated(calibrated, entries)
    values = plain_values(entries) | plain_values(found["inputs"]) | laid_over
    schema.validate(values, {"required": [*entries]}, f"{format_path(calibrated)}: inputs")
    check_ball(values, place)
    return {
        "parameters": values,
        "calibrated": str(calibrated),
        "ensemble": ensemble_of(found, laid_over),
        "inputs": laid_over,
    }


def ensemble_of(calibrated: Mapping, laid_over: Values) -> list[Values]:
    """The ensemble members of a calibrated file, all with the same overrides; none if they do not
    differ."""
    members = [plain_values(member) | laid_over for member in calibrated["ensemble"]]
    return members if any(member != members[0] for member in members) else []


def calibrated_ensemble(parameters: Parameters) -> tuple[Parameters, ...]:
    """The sets of inputs that explain the paper about equally well: those in the calibrated file of
    ``config/config.yaml``, each with the changes of ``parameters`` from the best set.

    Empty if they then do not differ.
    """
    directory = config_directory()
    content = read_calibrated(directory.parent / read_yaml(directory / "config.yaml")["calibrated"])
    best, given = content["inputs"], parameters.as_dict()
    changed = {name: value for name, value in given.items() if best.get(name) != value}
    return tuple(replace(parameters, **member) for member in ensemble_of(content, changed))


def check_ball(values: Values, place: str) -> None:
    """Raise ``ValueError`` if the cross-section of the ball is smaller than A_n."""
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
    """JSON Schema of some inputs: plain values, or entries as in ``config/inputs.yaml`` in the same
    unit; its ``$defs/name`` is the schema of their names."""
    given = {}
    for name, entry in entries.items():
        if "allowed" in entry:
            value, unit = {"enum": entry["allowed"]}, {}
        else:
            bounds, unit = BOUNDS[name], {"unit": {"const": entry["unit"]}}
            allowed = f"{bounds}" if entry["unit"] == "1" else f"{bounds} {entry['unit']}"
            limits = {"minimum": bounds.least, "maximum": bounds.most, "allowed": allowed}
            value = {"type": "number", **limits}
        whole = CLOSED | {"properties": dict.fromkeys(entry, True) | unit | {"value": value}}
        given[name] = {"if": {"type": "object"}, "then": whole, "else": value}
    return CLOSED | {"properties": given, "$defs": {"name": {"enum": list(entries)}}}
