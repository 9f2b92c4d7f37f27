"""What the workflow takes from the configuration, checked as a whole."""

from __future__ import annotations

import math
from importlib.metadata import version
from pathlib import Path

from thirdbody.configuration import schema
from thirdbody.configuration.inputs import checked_input, read_inputs
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import read_valid, shown, validate
from thirdbody.model.parameters import Parameters


def read_plain(*paths) -> None:
    """Refuse configuration files that hold anything but plain data, before Snakemake reads them."""
    for path in paths:
        if "__use_yte__" in read_yaml(path):
            raise ValueError(f"{path}: key '__use_yte__' runs code; allowed: plain values")


def read_changes(path) -> dict:
    """Keys of the file given with ``--config changes=``, none without one.

    Nothing but ``read_yaml`` reads it, where Snakemake has read a ``--configfile`` before it reads
    the workflow, templates that run code included.
    """
    if path is None:
        return {}
    if not isinstance(path, str):
        raise ValueError(f"changes is {shown(path)}; allowed: the path of a YAML file")
    return read_yaml(path)


def workflow_settings(config: dict) -> dict:
    """The configuration that the rules take their parameters from, checked as a whole.

    Every scene carries its own load axis and ``rtol``, so that it depends on nothing else;
    ``parameters`` are the inputs of the model and ``software`` the versions that compute.
    Raises ``ValueError`` with one line that names the key, its value and what is allowed.
    """
    directory = schema.config_directory()
    validate(config, read_yaml(directory / "schema.yaml"))
    shared = {"load_axis": config["load_axis"], "rtol": config["rtol"]}
    _check_increasing(config["load_axis"]["load_N"], "load_axis.load_N")
    windows = config["windows"]
    ratios = windows["particle_diameter_per_roughness"]
    _check_increasing(ratios, "windows.particle_diameter_per_roughness")
    for name, scene in config["scenes"].items():
        _check_increasing(scene.get("load_axis", shared["load_axis"])["load_N"], f"scenes.{name}")
        for index, group in enumerate(scene["curves"]):
            _check_room(group, f"scenes.{name}.curves[{index}]")
    for name, panels in config["schematics"].items():
        for index, panel in enumerate(panels):
            lists = {key: [value] for key, value in panel.items()}
            _check_room(lists, f"schematics.{name}[{index}]")
    read_valid(directory / "paper_tables.yaml", directory / "paper_tables.schema.yaml")
    base = directory / "inputs.yaml"
    inputs = read_inputs(base, config["inputs"])
    calibration = read_valid(directory / "calibration.yaml", directory / "calibration.schema.yaml")
    sensitivity = read_valid(directory / "sensitivity.yaml", directory / "sensitivity.schema.yaml")
    _check_increasing(sensitivity["load_N"], f"{directory / 'sensitivity.yaml'}: load_N")
    _check_readings(directory / "calibration.yaml", calibration, read_yaml(base))
    return {
        **config,
        "scenes": {name: shared | scene for name, scene in config["scenes"].items()},
        "calibration": calibration,
        "sensitivity": sensitivity,
        "parameters": Parameters(**inputs).as_dict(),
        "uncalibrated": Parameters(**read_inputs(base)).as_dict(),
        "software": {name: version(name) for name in ("numpy", "scipy", "netCDF4", "xarray")},
    }


def _check_readings(path: Path, calibration: dict, entries: dict) -> None:
    """What a reading fixes is within bounds; all that it searches is an input with a range."""
    unknowns = calibration["unknowns"]
    places = {"unknowns": unknowns, "always": calibration["always"]}
    for name, reading in calibration["readings"].items():
        places[f"readings.{name}.unknowns"] = reading.get("unknowns", [])
        places[f"readings.{name}.start"] = reading["start"]
    try:
        _check_increasing(calibration["newtons"], "newtons")
        for place, names in places.items():
            for name in names:
                if name not in unknowns or name not in entries:
                    text = shown(name)
                    raise ValueError(
                        f"{place}: {text} is no unknown; allowed: {', '.join(unknowns)}"
                    )
        for name, unknown in unknowns.items():
            _check_increasing(unknown["bounds"], f"unknowns.{name}.bounds")
            _check_increasing(unknown["usual"], f"unknowns.{name}.usual")
            if (
                unknown["scale"] == "logarithmic"
                and min(*unknown["bounds"], *unknown["usual"]) <= 0
            ):
                raise ValueError(
                    f"unknowns.{name} is logarithmic; allowed: bounds and usual above 0"
                )
        for name, reading in calibration["readings"].items():
            for key, value in reading["fixed"].items():
                try:
                    checked_input(key, value, entries)
                except ValueError as error:
                    raise ValueError(f"readings.{name}.fixed: {error}") from None
            for key in (*calibration["always"], *reading.get("unknowns", [])):
                if key not in reading["start"]:
                    raise ValueError(
                        f"readings.{name}.start: key {key!r} is missing; allowed: a number"
                    )
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from None


def _check_increasing(ends, key) -> None:
    if not ends[0] < ends[1]:
        raise ValueError(f"{key} is {ends}; allowed: a first value below the last")


def _check_room(group: dict, key) -> None:
    """Particles lie side by side: pi/4 x_a^2 eta_a cannot exceed 1."""
    diameters = group.get("particle_diameter_nm") or [
        ratio * sigma
        for ratio in group["particle_diameter_per_roughness"]
        for sigma in group["roughness_nm"]
    ]
    coverage = 0.25 * math.pi * (1e-9 * max(diameters)) ** 2 * max(group["particle_density_per_m2"])
    if coverage > 1.0:
        raise ValueError(
            f"{key}: particles of {max(diameters):g} nm at {max(group['particle_density_per_m2']):g}"
            f" m-2 cover {coverage:.3g} of the interface; allowed: at most 1"
        )


def with_one_reading(calibration: dict, name: str) -> dict:
    """The calibration settings without the other readings: a reading depends on its own alone."""
    return {**calibration, "readings": {name: calibration["readings"][name]}}
