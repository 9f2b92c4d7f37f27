"""The inputs of a run: the inputs of a calibrated file, and the overrides of the configuration."""

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from chenhorng.home import config_directory
from thirdbody.ensembles import Ensemble, checked_inputs
from thirdbody.files import read_yaml
from thirdbody.inputs import ensemble_of

Values = dict[str, float | str]


def uncalibrated_values(folder: Path | None = None) -> Values:
    """The values of the inputs that no search varies, SI, from ``inputs.yaml`` in ``folder``, by
    default ``config/``.
    """
    entries = read_yaml((folder or config_directory()) / "inputs.yaml")
    return {name: entry["value"] for name, entry in entries.items() if "value" in entry}


def choose_inputs(
    folder: Path, calibrated: str | Path, laid_over: str | Path | Mapping
) -> dict[str, Any]:
    """The inputs of a run, checked.

    ``laid_over`` has inputs, or is a file of inputs, that override those of the file
    ``calibrated``.  It may also be a calibrated file, which replaces ``calibrated``.  Returns
    ``parameters``, the value of each input, SI; ``calibrated``, the path of the calibrated file;
    ``ensemble``, the inputs of each member that differ from ``parameters``; and ``inputs``, the
    overrides.
    """
    if isinstance(laid_over, Mapping):
        changes, place = laid_over, "inputs"
    else:
        changes, place = read_yaml(laid_over), str(laid_over)
        if "inputs" in changes:
            calibrated, changes = laid_over, {}
    try:
        ensemble = ensemble_of(read_yaml(calibrated))
        # a file of inputs may have a setup; the workflow needs none, as scenes have no speed
        changes = checked_inputs({key: value for key, value in changes.items() if key != "setup"})
        chosen = ensemble.changed(**changes)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{place}: {error}") from None
    _check_printed(uncalibrated_values(folder), ensemble, calibrated)
    values = chosen.best.as_dict()
    return {
        "parameters": values,
        "calibrated": str(calibrated),
        "ensemble": [_differing(member.as_dict(), values) for member in chosen.members]
        if len(chosen.members) > 1
        else [],
        "inputs": changes,
    }


def _differing(inputs: Values, base: Values) -> Values:
    """The ``inputs`` that differ from ``base``."""
    return {name: value for name, value in inputs.items() if value != base[name]}


def _check_printed(values: Values, ensemble: Ensemble, calibrated: str | Path) -> None:
    """Raise ``ValueError`` for a value of ``inputs.yaml`` that differs from the value in the search
    for the ``calibrated`` inputs.
    """
    for name, value in values.items():
        used = getattr(ensemble.best, name)
        if not math.isclose(float(value), used, rel_tol=1e-12):
            raise ValueError(
                f"inputs.yaml: {name} is {value:g}; allowed: {used:g}, with which {calibrated} was "
                "found (inputs in config.yaml override it)"
            )
