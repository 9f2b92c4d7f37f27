"""Inputs of the model: where their values come from, and what is laid over what.

``config/inputs.yaml`` has an entry for each input: its value with symbol, unit, source, and the words
that are allowed; ``thirdbody.model.bounds`` says what numbers may be.  Of the values of an input the
last that is given counts:

1. that of ``config/inputs.yaml``;
2. that of a calibrated file, as ``snakemake calibrate`` writes it: the one that ``calibrated`` in
   ``config/config.yaml`` names, or one that is given in its place;
3. that which is laid over: by ``inputs`` in ``config/config.yaml`` and its changes, by a file that gives
   some inputs, plain or in the layout of ``config/inputs.yaml``, and by arguments of ``load_parameters``.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from thirdbody.configuration import schema
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import read_valid, validate
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
        laid over the calibrated ones; or a calibrated file of one's own, which takes their place.
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

    Examples
    --------
    >>> parameters = load_parameters()
    >>> parameters.ball_radius  # [m]
    0.00635
    >>> softer = load_parameters(hardness_surface_1=3e9)
    >>> softer.hardness_surface_1, softer.truncation == parameters.truncation
    (3000000000.0, True)
    """
    from thirdbody.model.parameters import Parameters  # needs numpy; the workflow is read without

    directory = schema.config_directory()
    settings = read_yaml(directory / "config.yaml")
    entries = read_entries()
    calibrated = directory.parent / settings["calibrated"]
    chosen = choose_inputs(entries, calibrated, settings["inputs"] if path is None else path)
    given = {name: _of_python(value) for name, value in inputs.items()}
    validate(given, values_schema(entries), "load_parameters")
    return Parameters(**chosen.values | _plain_values(given))


def read_entries(directory: Path | None = None) -> Entries:
    """Entries of ``inputs.yaml`` by the name of the input, each value among those allowed.

    It is the one in ``directory``, a folder such as ``config/``; without one, that of the project.
    """
    path = (directory or schema.config_directory()) / "inputs.yaml"
    entries = read_valid(path, "inputs")
    validate(entries, _overlay_schema(entries), str(path))
    return entries


def uncalibrated(entries: Entries) -> Values:
    """The value of each entry, numbers as ``float``."""
    return _plain_values(entries)


class ChosenInputs(NamedTuple):
    """Values of all inputs, and what they are made of.

    Attributes
    ----------
    values : dict
        A value of each input, SI, numbers as ``float``.
    calibrated : str
        Path of the calibrated file.
    interpretation : str
        The interpretation that it is of.
    ensemble : list of dict
        The members of its ensemble, each with what is laid over it.
    laid_over : dict
        The values that are laid over those of this file.
    """

    values: Values
    calibrated: str
    interpretation: str
    ensemble: list[Values]
    laid_over: Values


def choose_inputs(
    entries: Entries, calibrated: str | Path, given: str | Path | Mapping
) -> ChosenInputs:
    """Values of all inputs, as the head of this module says.

    Parameters
    ----------
    entries : Mapping
        What ``read_entries`` gives.
    calibrated : str or Path
        A calibrated file.
    given : str, Path or Mapping
        What is laid over its inputs: values, or a file of them.  A calibrated file takes its place.

    Returns
    -------
    ChosenInputs

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    is_file = not isinstance(given, Mapping)
    content = read_yaml(given) if is_file else given
    if is_file and "inputs" in content:
        calibrated, content = given, {}
    place = shown_file(given) if is_file else "inputs"
    validate(content, _overlay_schema(entries), place)
    laid_over = _plain_values(content)
    found = read_calibrated(calibrated, entries)
    values = uncalibrated(entries) | _plain_values(found["inputs"]) | laid_over
    _check_ball(values, place)
    ensemble = [_plain_values(member) | laid_over for member in found["ensemble"]]
    return ChosenInputs(values, str(calibrated), found["interpretation"], ensemble, laid_over)


def _check_ball(values: Values, place: str) -> None:
    """Raises ``ValueError`` if the ball is smaller than the interface A_n, to which loads refer."""
    section = math.pi * values["ball_radius"] ** 2
    if values["apparent_area"] > section:
        raise ValueError(
            f"{place}: apparent_area is {values['apparent_area']:g}; allowed: at most {section:.3g} m2, "
            f"the cross-section of a ball of ball_radius {values['ball_radius']:g} m"
        )


def read_calibrated(path: str | Path, entries: Entries | None = None) -> dict:
    """Read a file that ``snakemake calibrate`` writes: an interpretation, its best inputs, their ensemble.

    Parameters
    ----------
    path : str or Path
        A file of ``config/calibrated/``.
    entries : Mapping, optional
        Those of ``read_entries``, by whoever has them.

    Returns
    -------
    dict
        Its content; every key is described in ``config/calibrated.schema.yaml``.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    return read_valid(path, "calibrated", input_values=values_schema(entries or read_entries()))


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
    return {
        "type": "number",
        "minimum": bounds.least,
        "maximum": bounds.most,
        "allowed": allowed,
    }


def _overlay_schema(entries: Entries) -> dict:
    """JSON Schema of a file that gives some of the inputs, plain or in the layout of ``entries``."""
    return _closed({name: _given_schema(name, entry) for name, entry in entries.items()})


def _given_schema(name: str, entry: Mapping) -> dict:
    """JSON Schema of one input in such a file: a value, or an entry with it and in the same unit."""
    value = _value_schema(name, entry)
    same_unit = {"unit": {"const": entry["unit"]}} if "unit" in entry else {}
    keys = dict.fromkeys(entry, True) | same_unit | {"value": value}
    return {
        "if": {"type": "object"},
        "then": _closed(keys) | {"required": ["value"]},
        "else": value,
    }


def _closed(properties: dict) -> dict:
    return {"type": "object", "additionalProperties": False, "properties": properties}


def _of_python(value: object) -> object:
    """A number of numpy as one of Python, and anything else as it is."""
    return value.item() if isinstance(value, Real) and hasattr(value, "item") else value


def _plain_values(given: Mapping) -> Values:
    """The value of each entry, or the plain value itself; numbers as ``float``."""
    values = {
        name: each["value"] if isinstance(each, Mapping) else each for name, each in given.items()
    }
    return {
        name: value if isinstance(value, (bool, str)) else float(value)
        for name, value in values.items()
    }
