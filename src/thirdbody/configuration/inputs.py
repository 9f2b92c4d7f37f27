"""Inputs of the model: ``config/inputs.yaml`` and the files whose keys replace some of its values.

``config/inputs.yaml`` has an entry for each input: its value with symbol, unit, source, and the bounds
or words that are allowed.  What it allows is the schema of every other file of inputs.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from thirdbody.configuration import schema
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import read_valid, validate

if TYPE_CHECKING:
    from thirdbody.model.parameters import Parameters

Entries = Mapping[str, Mapping]
Values = dict[str, float | bool | str]


def load_parameters(path: str | Path | None = None) -> Parameters:
    """Inputs of the model from a YAML file, by default the calibrated ones of ``config/``.

    Parameters
    ----------
    path : str or Path, optional
        A file with the layout of ``config/inputs.yaml``, one that gives plain values of some of its keys,
        or a calibrated one of ``config/calibrated/``.  Inputs that it does not name keep their value of
        ``config/inputs.yaml``.

    Returns
    -------
    Parameters
        All inputs, SI.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.

    Examples
    --------
    >>> parameters = load_parameters()
    >>> parameters.ball_radius  # [m]
    0.00635
    >>> parameters.size_distribution
    'uncentred'
    """
    from thirdbody.model.parameters import Parameters  # needs numpy; the workflow is read without

    directory = schema.config_directory()
    if path is None:
        path = directory.parent / read_yaml(directory / "config.yaml")["inputs"]
    return Parameters(**read_inputs(read_entries(), path))


def read_entries() -> Entries:
    """Entries of ``config/inputs.yaml`` by the name of the input, each value among those allowed."""
    path = schema.config_directory() / "inputs.yaml"
    entries = read_valid(path, "inputs")
    validate(entries, _overlay_schema(entries), str(path))
    return entries


def uncalibrated(entries: Entries) -> Values:
    """The value of each entry, numbers as ``float``."""
    return {name: _plain(entry) for name, entry in entries.items()}


def read_inputs(entries: Entries, *overlays: str | Path) -> Values:
    """Values of all inputs: those of ``entries``, with each key of ``overlays`` in its place.

    Parameters
    ----------
    entries : Mapping
        What ``read_entries`` gives.
    *overlays : str or Path
        Files that give some of the inputs, plain or as entries, or calibrated files; later ones win.

    Returns
    -------
    dict
        A value of each input, SI, numbers as ``float``.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    values = uncalibrated(entries)
    for path in overlays:
        given = read_yaml(path)
        if "inputs" in given:
            _validate_calibrated(given, path, entries)
            given = given["inputs"]
        else:
            validate(given, _overlay_schema(entries), str(path))
        values |= {name: _plain(value) for name, value in given.items()}
    return values


def read_calibrated(path: str | Path) -> dict:
    """Read a file that ``snakemake calibrate`` writes: a reading, its best inputs, their ensemble.

    Parameters
    ----------
    path : str or Path
        A file of ``config/calibrated/``.

    Returns
    -------
    dict
        Its content; every key is described in ``config/calibrated.schema.yaml``.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    content = read_yaml(path)
    _validate_calibrated(content, path, read_entries())
    return content


def values_schema(entries: Entries) -> dict:
    """JSON Schema of plain values of some of the inputs; in it, ``$defs/name`` is that of their names."""
    values = _closed({name: _value_schema(entry) for name, entry in entries.items()})
    return values | {"$defs": {"name": {"enum": list(entries)}}}


def _validate_calibrated(content: dict, path: str | Path, entries: Entries) -> None:
    known = schema.read_schema("calibrated")
    validate(content, known, str(path), input_values=values_schema(entries))


def _value_schema(entry: Mapping) -> dict:
    """JSON Schema of the value of one input: a number within bounds, or one of some words."""
    if "allowed" in entry:
        return {"enum": entry["allowed"]}
    low, high = entry["bounds"]
    unit = "" if entry["unit"] == "1" else f" {entry['unit']}"
    allowed = f"a number from {low:g} to {high:g}{unit}"
    return {"type": "number", "minimum": low, "maximum": high, "allowed": allowed}


def _overlay_schema(entries: Entries) -> dict:
    """JSON Schema of a file that gives some of the inputs, plain or in the layout of ``entries``."""
    return _closed({name: _given_schema(entry) for name, entry in entries.items()})


def _given_schema(entry: Mapping) -> dict:
    """JSON Schema of one input in such a file: a value, or an entry with it and in the same unit."""
    value = _value_schema(entry)
    same_unit = {"unit": {"const": entry["unit"]}} if "unit" in entry else {}
    keys = dict.fromkeys(entry, True) | same_unit | {"value": value}
    return {
        "if": {"type": "object"},
        "then": _closed(keys) | {"required": ["value"]},
        "else": value,
    }


def _closed(properties: dict) -> dict:
    return {"type": "object", "additionalProperties": False, "properties": properties}


def _plain(given) -> float | bool | str:
    """The value of an entry, or the plain value itself; numbers as ``float``."""
    value = given["value"] if isinstance(given, Mapping) else given
    return value if isinstance(value, (bool, str)) else float(value)
