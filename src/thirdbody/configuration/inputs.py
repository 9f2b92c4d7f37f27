"""Inputs of the model, from ``config/inputs.yaml`` and the files that replace some of them."""

from __future__ import annotations

import math
from dataclasses import fields

from thirdbody.configuration import schema
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import shown
from thirdbody.model.parameters import Parameters


def read_inputs(base, *overlays) -> dict:
    """Values of the inputs: those of the file ``base`` with each key of ``overlays`` in its place.

    Raises ``ValueError`` for an unknown key, or a value out of the bounds that ``base`` states.
    """
    entries = read_yaml(base)
    _check_entries(base, entries)
    values = {name: entry["value"] for name, entry in entries.items()}
    for path in (base, *overlays):
        for name, given in _input_values(path, entries).items():
            try:
                values[name] = checked_input(name, given, entries)
            except ValueError as error:
                raise ValueError(f"{path}: {error}") from None
    return values


def _check_entries(path, entries: dict) -> None:
    """Every input has an entry, with a value and with what is allowed; nothing else has one."""
    names = [field.name for field in fields(Parameters)]
    for name in names:
        entry = entries.get(name)
        if not isinstance(entry, dict) or "value" not in entry:
            text = shown(entry)
            raise ValueError(f"{path}: {name} is {text}; allowed: an entry with a value")
        if "allowed" not in entry and "bounds" not in entry:
            raise ValueError(f"{path}: {name} has no bounds; allowed: bounds or allowed values")
        _check_allowed(path, name, entry)
    for name in entries:
        if name not in names:
            raise ValueError(f"{path}: unknown key {name!r}; allowed: {', '.join(names)}")


def _check_allowed(path, name, entry: dict) -> None:
    """An entry allows two finite numbers and all between them, or what it lists."""
    bounds = entry.get("bounds", [0, 1])
    two = isinstance(bounds, list) and len(bounds) == 2
    if not two or not all(_is_number(end) and math.isfinite(end) for end in bounds):
        text = shown(bounds)
        raise ValueError(f"{path}: {name}.bounds is {text}; allowed: two finite numbers")
    listed = entry.get("allowed", [True])
    if (
        not isinstance(listed, list)
        or not listed
        or not all(type(x) in (bool, str) for x in listed)
    ):
        text = shown(listed)
        raise ValueError(f"{path}: {name}.allowed is {text}; allowed: a list of words or truths")


def _is_number(value) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _input_values(path, entries) -> dict:
    """Values that the file ``path`` gives: plain, or entries in the layout of ``entries``."""
    content = read_yaml(path)
    content = content.get("inputs", content)  # a calibrated file says more than its inputs
    if not isinstance(content, dict):
        raise ValueError(f"{path}: inputs is {shown(content)}; allowed: keys with values")
    return {name: _plain_value(path, name, given, entries) for name, given in content.items()}


def _plain_value(path, name, given, entries):
    """The value in an entry, which must not differ from that of ``entries`` in anything else."""
    if not isinstance(given, dict):
        return given
    known = entries.get(name, given)
    for key in given:
        if key not in (*known, "value"):
            allowed = ", ".join(known)
            raise ValueError(f"{path}: {name}: unknown key {key!r}; allowed: {allowed}")
    if given.get("unit") != known.get("unit") and "unit" in given:
        unit = shown(given["unit"])
        raise ValueError(f"{path}: {name}.unit is {unit}; allowed: {known.get('unit')}")
    if "value" not in given:
        raise ValueError(f"{path}: {name}: key 'value' is missing; allowed: it must be given")
    return given["value"]


def checked_input(name, value, entries):
    """``value`` of the input ``name`` in the type and bounds of its entry."""
    if name not in entries:
        raise ValueError(f"unknown key {name!r}; allowed: {', '.join(entries)}")
    entry = entries[name]
    if "allowed" in entry:
        if value not in entry["allowed"] or type(value) is not type(entry["allowed"][0]):
            allowed = ", ".join(map(str, entry["allowed"]))
            raise ValueError(f"{name} is {shown(value)}; allowed: {allowed}")
        return value
    low, high = entry["bounds"]
    if not _is_number(value) or not low <= value <= high:
        raise ValueError(
            f"{name} is {shown(value)}; allowed: a number from {low:g} to {high:g} {entry.get('unit', '')}"
        )
    return float(value)


CALIBRATED = {"reading": str, "objective": float, "inputs": dict, "ensemble": list}


def read_calibrated(path) -> dict:
    """A file that `snakemake calibrate` writes: a reading, its best inputs and their ensemble.

    Raises ``ValueError`` with one line for a key that is missing or no input of the model.
    """
    content = read_yaml(path)
    for key, kind in CALIBRATED.items():
        if not isinstance(content.get(key), kind):
            text = shown(content.get(key))
            raise ValueError(f"{path}: {key} is {text}; allowed: what `snakemake calibrate` writes")
    names = {field.name for field in fields(Parameters)}
    for values in (content["inputs"], *content["ensemble"]):
        unknown = sorted(set(values) - names) if isinstance(values, dict) else [values]
        if unknown:
            raise ValueError(
                f"{path}: unknown input {shown(unknown[0])}; allowed: those of the model"
            )
    return content


def load_parameters(path=None) -> Parameters:
    """Inputs of the model from a YAML file, by default the calibrated ones of ``config/``.

    ``path`` names a file with the layout of ``config/inputs.yaml``, or one that gives only some
    of its keys (the others keep their value there).  Raises ``ValueError`` with one line that
    names the file, the key, its value and what is allowed.
    """
    directory = schema.config_directory()
    if path is None:
        path = directory.parent / read_yaml(directory / "config.yaml")["inputs"]
    return Parameters(**read_inputs(directory / "inputs.yaml", path))
