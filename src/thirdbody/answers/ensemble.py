"""The calibrated ensemble: sets of inputs that explain the paper about equally well.

The paper does not print some inputs.  Every number is computed with each set; the range beside it
covers nine in ten of the results.
"""

from __future__ import annotations

from dataclasses import replace

from thirdbody.conditions import checked_parameters
from thirdbody.configuration.inputs import ensemble_of, read_calibrated
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import config_directory
from thirdbody.model.parameters import Parameters

NO_ENSEMBLE = "no ensemble: these inputs leave nothing in which the calibrated sets differ"


def calibrated_ensemble(parameters: Parameters) -> tuple[Parameters, ...]:
    """The sets of inputs in the calibrated file of ``config/config.yaml``, each with the changes of
    ``parameters`` from the best set; empty if they then do not differ.
    """
    parameters = checked_parameters(parameters)
    directory = config_directory()
    path = directory.parent / read_yaml(directory / "config.yaml")["calibrated"]
    content = read_calibrated(path)
    best, given = content["inputs"], parameters.as_dict()
    changed = {name: value for name, value in given.items() if best.get(name) != value}
    return tuple(replace(parameters, **member) for member in ensemble_of(content, changed))
