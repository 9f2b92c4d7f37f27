"""Settings of the workflow, checked as a whole before anything is computed."""

from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any

from thirdbody.configuration.inputs import choose_inputs, plain_values, read_entries, values_schema
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import read_schema, read_valid, validate
from thirdbody.core.parameters import Parameters
from thirdbody.messages import format_value

SOFTWARE = ("numpy", "scipy", "netCDF4", "xarray")  # packages whose versions can change a number


def read_settings(config: Mapping, folder: str | Path, *given: str | Path) -> dict[str, Any]:
    """All settings of a run of the workflow, checked before anything is computed.

    ``config`` is the configuration read by Snakemake from, among others, the files ``given`` on the
    command line: missing keys have the values of the paper, the files in ``folder``, and ``changes``
    is the path of a file that overrides all of them.  Returns the result of ``workflow_settings``,
    with ``run``, the name of the run or None; ``config``, the merged configuration; and
    ``is_paper``, whether it is that of the paper.  ``ValueError`` in one line for any fault.
    """
    paper = read_yaml(Path(folder, "config.yaml")) | read_yaml(Path(folder, "scenes.yaml"))
    for path in given:
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
    """``base`` updated by ``changes``, key by key, as Snakemake merges configurations."""
    merged = dict(base)
    for key, value in changes.items():
        both = isinstance(value, Mapping) and isinstance(merged.get(key), Mapping)
        merged[key] = _merged(merged[key], value) if both else value
    return merged


def workflow_settings(config: Mapping, folder: str | Path) -> dict[str, Any]:
    """The settings of the rules, from ``config`` and the files in ``folder``.

    Each scene has its load axis and ``rtol``, so that it depends on nothing else; ``uncalibrated``
    are the values of the inputs that no search finds, SI, ``software`` the versions of what
    computes; see ``choose_inputs`` for the other inputs.
    """
    folder = Path(folder)
    entries = read_entries(folder)
    values = values_schema(entries)
    validate(config, read_schema("config"), "configuration", input_values=values)
    read_valid(folder / "paper_tables.yaml", "paper_tables")

    def found(path):
        """A file ``config/...``: in the current folder, otherwise beside the configuration."""
        return path if Path(path).exists() else str(folder.parent / path)

    given = config["inputs"]
    laid_over = found(given) if isinstance(given, str) else given
    chosen = choose_inputs(entries, found(config["calibrated"]), laid_over)
    try:
        Parameters(**chosen["parameters"]).check_particles()
    except ValueError as error:
        place = laid_over if isinstance(laid_over, str) else "inputs"
        raise ValueError(f"{place}: {error}") from None
    shared = {"load_axis": config["load_axis"], "rtol": config["rtol"]}
    return {
        **config,
        **chosen,
        "scenes": {name: shared | scene for name, scene in config["scenes"].items()},
        "calibration": read_valid(folder / "calibration.yaml", "calibration", input_values=values),
        "sensitivity": read_valid(folder / "sensitivity.yaml", "sensitivity"),
        "uncalibrated": plain_values(entries),
        "accuracy": read_valid(found(config["accuracy"]), "accuracy"),
        "atlas": read_valid(found(config["atlas"]), "atlas"),
        "software": {name: version(name) for name in SOFTWARE},
    }
