"""What the workflow takes from the configuration, judged as a whole before anything is computed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
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
from thirdbody.configuration.schema import read_valid, validate
from thirdbody.messages import shown

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


def read_settings(config: Mapping, folder: str | Path, *given: str | Path) -> dict:
    """All settings of a run of the workflow, checked before anything is computed.

    Parameters
    ----------
    config : Mapping
        What Snakemake has read: keys that are missing are those of the paper, and ``changes`` is the
        path of a file that is laid over all of them.
    folder : str or Path
        The folder of the configuration.
    *given : str or Path
        Files of the command line, which Snakemake has merged into ``config``.

    Returns
    -------
    dict
        What ``workflow_settings`` returns, and

        - ``run``, the name of the run or None;
        - ``config``, the merged configuration, and ``is_paper``, whether it is the paper's.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    paper = read_plain(Path(folder, "config.yaml"), Path(folder, "scenes.yaml"))
    read_plain(*given)
    changes = {key: value for key, value in config.items() if key != "changes"}
    merged = _merged(_merged(paper, changes), read_changes(config.get("changes")))
    settings = workflow_settings(merged, folder)
    require_surfaces(settings)
    run = merged.pop("run", None)
    paper.pop("run", None)
    return settings | {"run": run, "config": merged, "is_paper": merged == paper}


def _merged(base: Mapping, changes: Mapping) -> dict:
    """``base`` with ``changes`` laid over it, key by key, as Snakemake merges configurations."""
    merged = dict(base)
    for key, value in changes.items():
        both = isinstance(value, Mapping) and isinstance(merged.get(key), Mapping)
        merged[key] = _merged(merged[key], value) if both else value
    return merged


def workflow_settings(config: Mapping, folder: str | Path | None = None) -> dict:
    """The configuration that the rules take their parameters from.

    Parameters
    ----------
    config : Mapping
        ``config.yaml`` and ``scenes.yaml`` with all changes, as Snakemake merges them.
    folder : str or Path, optional
        Where the other files of the configuration lie; the project's own folder without it.

    Returns
    -------
    dict
        ``config`` with

        - ``scenes``, each with its own load axis and ``rtol``, so that it depends on nothing else;
        - ``calibration`` and ``sensitivity``, the settings of both studies;
        - ``parameters`` and ``uncalibrated``, the inputs of the model as ``config`` chooses them, and
          without calibrated file and what is laid over it, SI;
        - ``calibrated``, the path of that file, ``inputs``, the values laid over it, and
          ``ensemble``, the members of its ensemble with these values;
        - ``accuracy`` and ``atlas``, the settings of these runs;
        - ``software``, the versions of what computes.

    Raises
    ------
    ValueError
        In one line: the file, the key at fault, its value and what is allowed.
    """
    directory = Path(folder or schema.config_directory())
    entries = read_entries(directory)
    values = values_schema(entries)
    validate(config, schema.read_schema("config"), "configuration", input_values=values)
    read_valid(directory / "paper_tables.yaml", "paper_tables")
    given = config["inputs"]
    laid_over = _found(given, directory) if isinstance(given, str) else given
    chosen = choose_inputs(entries, _found(config["calibrated"], directory), laid_over)
    calibration = read_valid(directory / "calibration.yaml", "calibration", input_values=values)
    if chosen.interpretation not in calibration["interpretations"]:
        allowed = ", ".join(calibration["interpretations"])
        raise ValueError(
            f"{chosen.calibrated}: interpretation is {shown(chosen.interpretation)}; allowed: {allowed}"
        )
    shared = {"load_axis": config["load_axis"], "rtol": config["rtol"]}
    return {
        **config,
        "scenes": {name: shared | scene for name, scene in config["scenes"].items()},
        "calibration": calibration,
        "sensitivity": read_valid(directory / "sensitivity.yaml", "sensitivity"),
        "parameters": chosen.values,
        "calibrated": chosen.calibrated,
        "inputs": chosen.laid_over,
        "ensemble": chosen.ensemble,
        "uncalibrated": uncalibrated(entries),
        "accuracy": read_valid(_found(config["accuracy"], directory), "accuracy"),
        "atlas": read_valid(_found(config["atlas"], directory), "atlas"),
        "software": {name: version(name) for name in SOFTWARE},
    }


def _found(path: str, folder: Path) -> str:
    """A file named as ``config/...``: in the current folder, else in the ``folder`` of the configuration."""
    return path if Path(path).exists() else str(folder.parent / path)


def require_surfaces(settings: Mapping) -> None:
    """Require that every configured surface can have the inputs that are laid over the calibrated ones.

    Parameters
    ----------
    settings : Mapping
        What ``workflow_settings`` returns.

    Raises
    ------
    ValueError
        In one line: for inputs that leave no variance to the summits of a surface, and those of which
        a member of the ensemble does.
    """
    if not settings["inputs"]:
        return
    import numpy as np  # the workflow is read without, unless there are inputs of one's own

    from thirdbody.model.parameters import Parameters

    roughness = 1e-9 * np.unique(list(_roughnesses(settings)))
    best = settings["parameters"]
    sets = {"inputs": best}
    for number, member in enumerate(settings["ensemble"], 1):
        sets[f"inputs in member {number} of {settings['calibrated']}"] = best | member
    for name, values in sets.items():
        try:
            Parameters(**values).surface(roughness)
        except ValueError as error:
            raise ValueError(f"configuration: {name}: {error}") from None


def _roughnesses(settings: Mapping) -> Iterator[float]:
    """sigma [nm] of all that is configured, some of it twice."""
    yield from settings["windows"]["roughness_nm"]
    for scene in settings["scenes"].values():
        for group in scene["curves"]:
            yield from group["roughness_nm"]
    for panels in settings["schematics"].values():
        for panel in panels:
            yield panel["roughness_nm"]


def with_one_interpretation(calibration: Mapping, name: str) -> dict:
    """The settings of the calibration for one interpretation, which depends on nothing of the others."""
    interpretation = dict(calibration["interpretations"][name])
    budget = calibration["budget"] | interpretation.pop("budget", {})
    return {**calibration, "budget": budget, "interpretations": {name: interpretation}}


def number_of_unknowns(calibration: Mapping, name: str) -> int:
    """How many inputs an interpretation searches."""
    interpretation = calibration["interpretations"][name]
    return len(
        {*calibration["always"], *interpretation.get("unknowns", ())} - set(interpretation["fixed"])
    )
