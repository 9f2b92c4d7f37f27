"""What the workflow takes from the configuration, judged as a whole before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path

from thirdbody.configuration import schema
from thirdbody.configuration.inputs import (
    choose_inputs,
    read_entries,
    uncalibrated,
    values_schema,
)
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import read_valid, shown, validate

SOFTWARE = ("numpy", "scipy", "netCDF4", "xarray")  # whose versions can change a number


def read_plain(*paths: str | Path) -> dict:
    """The keys of configuration files, each of which must hold plain data; before Snakemake reads them.

    Raises
    ------
    ValueError
        In one line, for a file that holds anything else.
    """
    found = {}
    for path in paths:
        content = read_yaml(path)
        if "__use_yte__" in content:
            raise ValueError(f"{path}: key '__use_yte__' runs code; allowed: plain values")
        found |= content
    return found


def read_changes(path: str | None) -> dict:
    """Keys of the file given with ``--config changes=``, none without one.

    Nothing but the strict reader reads this file.  One given with ``--configfile`` has been read by
    Snakemake before it comes to the workflow, templates that run code included.

    Raises
    ------
    ValueError
        In one line, where ``path`` is no path or the file no plain data.
    """
    if path is None:
        return {}
    if not isinstance(path, str):
        raise ValueError(f"changes is {shown(path)}; allowed: the path of a YAML file")
    return read_yaml(path)


def workflow_settings(config: Mapping) -> dict:
    """The configuration that the rules take their parameters from.

    Parameters
    ----------
    config : Mapping
        ``config/config.yaml`` and ``config/scenes.yaml`` with all changes, as Snakemake merges them.

    Returns
    -------
    dict
        ``config`` with

        - ``scenes``, each with its own load axis and ``rtol``, so that it depends on nothing else;
        - ``calibration`` and ``sensitivity``, the settings of both studies;
        - ``parameters`` and ``uncalibrated``, the inputs of the model as ``config`` chooses them, and
          without calibrated file and what is laid over it, SI;
        - ``calibrated``, the path of that file, and ``inputs``, the values laid over it;
        - ``software``, the versions of what computes.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    directory = schema.config_directory()
    entries = read_entries()
    values = values_schema(entries)
    validate(config, schema.read_schema("config"), "configuration", input_values=values)
    read_valid(directory / "paper_tables.yaml", "paper_tables")
    chosen = choose_inputs(entries, config["calibrated"], config["inputs"])
    shared = {"load_axis": config["load_axis"], "rtol": config["rtol"]}
    return {
        **config,
        "scenes": {name: shared | scene for name, scene in config["scenes"].items()},
        "calibration": read_valid(
            directory / "calibration.yaml", "calibration", input_values=values
        ),
        "sensitivity": read_valid(directory / "sensitivity.yaml", "sensitivity"),
        "parameters": chosen.values,
        "calibrated": chosen.calibrated,
        "inputs": chosen.laid_over,
        "uncalibrated": uncalibrated(entries),
        "software": {name: version(name) for name in SOFTWARE},
    }


def with_one_reading(calibration: Mapping, name: str) -> dict:
    """The settings of the calibration without the other readings: one depends on its own alone."""
    return {**calibration, "readings": {name: calibration["readings"][name]}}
