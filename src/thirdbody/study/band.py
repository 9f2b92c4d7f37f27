"""The range of the ensemble around the curves of a dataset."""

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import solve_points
from thirdbody.data.conditions import Condition
from thirdbody.data.netcdf import PlainDataset, Variable
from thirdbody.data.quantities import FILL_FLOAT, curves_of
from thirdbody.toml_tables import toml_beside
from thirdbody.variables import DIMENSIONS, QUANTITIES

BAND_RTOL = 1e-4  # for each member: an error far below a line width
# Suffix of a variable: the word in its long name, and the function, which ignores nan.
ENDS = {"low": ("lowest", np.fmin), "high": ("highest", np.fmax)}
ATTRIBUTES = toml_beside(__file__)


def band(
    dataset: PlainDataset, base: Parameters, ensemble: Sequence[Mapping[str, Any]]
) -> PlainDataset:
    """Lowest and highest value of each quantity, ``<quantity>_low`` and ``_high``, over ``dataset``, solved
    with ``base``, and the ``ensemble``, whose members have the inputs that differ from it, SI."""
    conditions, shown = curves_of(dataset)
    load = dataset["load"].values[:, None]
    start = {name: dataset[name].values[:, shown] for name in QUANTITIES}
    envelope = {end: dict(start) for end in ENDS}
    for member in ensemble:
        points = {"load": load, **Condition(*conditions)._asdict()}
        solved = solve_points(points, replace(base, **member), BAND_RTOL, tuple(QUANTITIES))
        for end, (_, widest) in ENDS.items():
            for name, values in envelope[end].items():
                envelope[end][name] = widest(values, solved[name])
    variables = {}
    for end, (extreme, _) in ENDS.items():
        for name in QUANTITIES:
            whole = np.full((len(load), *shown.shape), FILL_FLOAT)
            whole[:, shown] = envelope[end][name]
            given = dataset[name].attrs
            described = {key: given[key] for key in ("units", "symbol", "equation")}
            described["long_name"] = f"{extreme} {given['long_name']} of the ensemble"
            described["coverage_content_type"] = "modelResult"
            filled = {"_FillValue": FILL_FLOAT}
            variables[f"{name}_{end}"] = Variable(DIMENSIONS, whole, described, filled)
    members = json.dumps([dict(member) for member in ensemble])
    origin = f"{dataset.attrs['configuration_sha256']} {BAND_RTOL} {members}"
    attributes = dataset.attrs | {
        "title": f"{dataset.attrs['title']}: envelope of the ensemble",
        **ATTRIBUTES,
        "configuration_sha256": hashlib.sha256(origin.encode()).hexdigest(),
        "rtol": BAND_RTOL,
        "ensemble": members,
    }
    return PlainDataset(variables, dataset.coords, attributes)
