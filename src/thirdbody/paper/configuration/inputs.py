"""Inputs of the model: the sources of their values, and which source takes precedence.

Later values override earlier ones: those in ``config/inputs.yaml``, which describes each input; in
a calibrated file, named by ``calibrated`` in ``config/config.yaml`` or given in its place; and
overrides: ``inputs`` in ``config/config.yaml`` and its changes, a file with some inputs, plain or
in the layout of ``config/inputs.yaml``, and arguments of ``load_parameters``.
"""

import math
import warnings
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from thirdbody.conditions import numbers_in
from thirdbody.core.parameters import BOUNDS, Parameters
from thirdbody.messages import format_path
from thirdbody.paper.configuration import schema
from thirdbody.plain_yaml import config_directory, read_yaml

Entries = Mapping[str, Mapping]
Values = dict[str, float | bool | str]
CLOSED = {"type": "object", "additionalProperties": False}  # in a JSON Schema
CALIBRATED_FILE = {
    "required": ["interpretation", "inputs", "ensemble"],
    "properties": {
        "inputs": {"$ref": "input_values"},
        "ensemble": {"type": "array", "minItems": 1, "items": {"$ref": "input_values"}},
    },
}


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
        For a modulus, hardness or radius without G, V or U/nu, which depend on it:
        ``thirdbody.bearing`` changes them together; and for another mean of the sizes, plane of the particles
        or load of the film without the inputs that were calibrated for it.

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
    inputs = plain_values(inputs)
    check_ball(chosen["parameters"] | inputs, "load_parameters")
    changed = chosen["inputs"] | inputs
    if BELONGS_TO.keys() & changed.keys():
        _warn_of_what_stays(changed, choose_inputs(entries, chosen["calibrated"], {})["parameters"])
    members = [Parameters(**chosen["parameters"] | member) for member in chosen["ensemble"]]
    return Parameters(**chosen["parameters"]).with_members(members).changed(**inputs)


def or_calibrated(parameters: Parameters | None) -> Parameters:
    """``parameters``, or the calibrated ones if it is None."""
    return _calibrated() if parameters is None else parameters


@cache
def _calibrated():
    """Cached: reading the files takes longer than solving one point."""
    return load_parameters()


def ensemble(parameters: Parameters | None = None) -> tuple[Parameters, ...]:
    """The sets of inputs that explain the paper about equally well, from which ranges are computed.

    They are the members of the calibrated file of ``parameters``, by default that of the project, with as many
    members from each interpretation that explains the paper as well as the best.  What was given to
    ``load_parameters``, ``bearing`` or ``Parameters.changed`` is known: all members have it.  The range of a
    result is 5 to 95 % of its values over them.

    Parameters
    ----------
    parameters : Parameters, optional
        Inputs of the model, by default the calibrated ones.

    Returns
    -------
    tuple of Parameters
        The members; none for inputs that were built without them.

    Examples
    --------
    >>> import numpy as np
    >>> import thirdbody as tb
    >>> particles = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    >>> interface = dict(load_N=10, viscosity_cSt=120, roughness_nm=300, **particles)
    >>> shares = [
    ...     float(tb.solve(**interface, parameters=member).solid_load_fraction)
    ...     for member in tb.ensemble()
    ... ]
    >>> low, high = np.quantile(shares, (0.05, 0.95))
    >>> bool(low < tb.solve(**interface).solid_load_fraction < high)
    True
    """
    return or_calibrated(parameters).members


# inputs that were found for one value of another, or are derived from it (below Eq. 8), and what changes them together
BEARING = "thirdbody.bearing changes them together"
CALIBRATED = "they were found for the value of the calibrated file"
BELONGS_TO = {
    "elastic_modulus_surfaces": (
        ("material_parameter", "hardness_parameter", "speed_per_viscosity"),
        BEARING,
    ),
    "hardness_surface_1": (("hardness_parameter",), BEARING),
    "hardness_surface_2": (("hardness_parameter",), BEARING),
    "ball_radius": (("speed_per_viscosity",), BEARING),
    "mean_ratio": (("spread_ratio", "elastic_depth_ratio"), CALIBRATED),
    "particle_plane": (("elastic_depth_ratio", "summit_offset_ratio"), CALIBRATED),
    "film_load": (("summit_parameter", "summit_radius", "apparent_area"), CALIBRATED),
}


def _warn_of_what_stays(changed, before):
    """Warn of inputs that differ from ``before`` without those that belong to their value."""
    for name in BELONGS_TO.keys() & changed.keys():
        dependents, reason = BELONGS_TO[name]
        stay = ", ".join(other for other in dependents if other not in changed)
        value, old = changed[name], before[name]
        same = value == old if isinstance(value, str) else math.isclose(value, old)
        if stay and not same:
            message = f"{name} is changed without {stay}; {reason}"
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
    content = read_yaml(path)
    values = values_schema(entries or read_entries())
    schema.validate(content, CALIBRATED_FILE, format_path(path), input_values=values)
    return content


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
