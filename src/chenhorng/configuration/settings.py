"""Settings of the workflow, all checked before anything is computed."""

from collections.abc import Mapping
from importlib.metadata import version
from itertools import chain, product
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from chenhorng.configuration.inputs import choose_inputs, uncalibrated_values
from chenhorng.configuration.model import check
from chenhorng.scenes import RELATIVE_DIAMETER, scene_groups
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import DEFAULT_RTOL
from thirdbody.curves import (
    MOST_PANELS,
    Condition,
    colours_and_panels,
    variables_over_load,
)
from thirdbody.files import format_value, read_yaml

MOST_POINTS = 3_000_000  # of a scene: solving more needs more memory than a job has
SOFTWARE = ("numpy", "scipy", "netCDF4", "xarray")  # packages whose versions can change a number


def read_settings(config: Mapping, folder: str | Path, *files: str | Path) -> dict[str, Any]:
    """All settings of a run of the workflow, checked before anything is computed.

    ``config`` is the configuration that Snakemake has read, also from the ``files`` named on the
    command line.  A missing key has the value of the paper, from the files in ``folder``; ``rtol``,
    which they may leave out, the default of the library.  The key
    ``changes`` is the path of a file that overrides all others.  Returns the result of
    ``workflow_settings``, with ``run``, the name of the run or None; ``config``, the merged
    configuration; and ``is_paper``, whether this is the configuration of the paper.  Any fault
    raises ``ValueError`` in one line.
    """
    paper = {"rtol": DEFAULT_RTOL}
    paper |= read_yaml(Path(folder, "config.yaml")) | read_yaml(Path(folder, "scenes.yaml"))
    for path in files:
        read_yaml(path)
    changed = dict(config)
    changes = changed.pop("changes", None)
    if not isinstance(changes, str | None):
        raise ValueError(f"changes is {format_value(changes)}; allowed: the path of a YAML file")
    merged = _merged(_merged(paper, changed), {} if changes is None else read_yaml(changes))
    settings = workflow_settings(merged, folder)
    run = merged.pop("run", None)
    paper.pop("run", None)
    return settings | {"run": run, "config": merged, "is_paper": merged == paper}


def _merged(base: Mapping, changes: Mapping) -> dict:
    """``base`` with the ``changes``, merged key by key, as Snakemake merges configurations."""
    merged = dict(base)
    for key, value in changes.items():
        both = isinstance(value, Mapping) and isinstance(merged.get(key), Mapping)
        merged[key] = _merged(merged[key], value) if both else value
    return merged


def workflow_settings(config: Mapping, folder: str | Path) -> dict[str, Any]:
    """The settings of the rules, from ``config`` and the files in ``folder``.

    Each scene has its load axis and ``rtol``, so that it depends on nothing else.
    ``uncalibrated`` has the values of the inputs that no search varies, SI.  ``software`` has the
    versions of the packages that can change a number.  ``choose_inputs`` describes the other
    inputs.
    """
    folder = Path(folder)
    check(config, "configuration")

    def located(path):
        """The path of a file ``config/...``: in the current folder, or else in the parent of the
        configuration."""
        return path if Path(path).exists() else str(folder.parent / path)

    inputs = config["inputs"]
    laid_over = located(inputs) if isinstance(inputs, str) else inputs
    chosen = choose_inputs(folder, located(config["calibrated"]), laid_over)
    shared = {"load_axis": config["load_axis"], "rtol": config["rtol"]}
    scenes = {name: shared | scene for name, scene in config["scenes"].items()}
    for name, scene in scenes.items():
        _check_size(name, scene)
        if not name.startswith("fig"):  # figures of the paper have their own layout
            _check_figure(name, scene)
    try:
        _check_surfaces(config, chosen)
    except ValueError as error:
        place = laid_over if isinstance(laid_over, str) else "inputs"
        raise ValueError(f"{place}: {error}") from None
    return {
        **config,
        **chosen,
        "scenes": scenes,
        "calibration": read_yaml(folder / "calibration.yaml"),
        "findings": read_yaml(folder / "findings.yaml", list),
        "sensitivity": read_yaml(folder / "sensitivity.yaml"),
        "uncalibrated": uncalibrated_values(folder),
        "accuracy": read_yaml(located(config["accuracy"])),
        "software": [f"{name} {version(name)}" for name in SOFTWARE],
    }


def _check_size(name: str, scene: Mapping) -> None:
    """Raise ``ValueError`` for a scene that is too large.  Its dataset has every combination of the
    values of its curves."""
    curves = scene["curves"]
    relative = [group for group in curves if RELATIVE_DIAMETER in group]
    diameters = sum(
        len(group[RELATIVE_DIAMETER]) * len(group["roughness_nm"]) for group in relative
    )
    diameters += len({value for group in curves for value in group.get("particle_diameter_nm", [])})
    others = (
        len({value for group in curves for value in group[key]})
        for key in ("viscosity_cSt", "roughness_nm", "particle_density_per_m2")
    )
    points = scene["load_axis"]["count"] * diameters * prod(others)
    if points > MOST_POINTS:
        raise ValueError(
            f"scenes.{name}: the curves and loads have {points:.3g} combinations; "
            f"allowed: at most {MOST_POINTS:.3g}"
        )


def _check_figure(name: str, scene: Mapping) -> None:
    """Raise ``ValueError`` for a scene whose figure would have more panels than letters."""
    groups = scene_groups(scene, 1.0)
    levels = {axis: {*chain(*(group[axis] for group in groups))} for axis in Condition._fields}
    _, varied = colours_and_panels(levels)
    combinations = {
        values
        for group in groups
        for values in product(*(group[axis] for axis in varied))
        if all(values)
    }
    panels = len(combinations) * len(variables_over_load(levels))
    if panels > MOST_PANELS:
        raise ValueError(
            f"scenes.{name}: the figure has {panels} panels, for each combination of "
            f"{', '.join(varied)}; allowed: at most {MOST_PANELS}"
        )


def _check_surfaces(config: Mapping, chosen: Mapping) -> None:
    """Raise ``ValueError`` for inputs whose particles are not hard, or that have no surface with a
    roughness of the configuration."""
    groups = [group for scene in config["scenes"].values() for group in scene["curves"]]
    solved = [
        *groups,
        config["windows"],
        config["atlas"],
        *chain.from_iterable(config["schematics"].values()),
    ]
    roughness = np.unique(np.hstack([group["roughness_nm"] for group in solved]))
    for member in [{}, *(chosen["ensemble"] if config["bands"] else [])]:
        parameters = Parameters(**chosen["parameters"] | member)
        parameters.check_particles()
        parameters.surface(1e-9 * roughness)
