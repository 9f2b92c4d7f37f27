"""The range of the ensemble around the curves of a dataset."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from chenhorng.scenes import how_to_select
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import solve_points
from thirdbody.curves import Condition
from thirdbody.ensembles import ENDS, RANGE, range_over_members
from thirdbody.netcdf import FILL_FLOAT, PlainDataset, PlainVariable, curves_of, identity
from thirdbody.variables import DIMENSIONS, QUANTITIES

MEMBER_RTOL = 1e-4  # of each member: an error far below the width of a line
SUFFIXES = "low", "high"
ATTRIBUTES = {
    "summary": f"For each quantity, at the points of the dataset of this figure, the {RANGE}.",
    "comment": (
        "load is F_t* of the default inputs, those of model_parameters, and normal_load belongs to "
        "it. Each member is solved at the same F_t*, which is another normal load where its "
        "apparent area differs. A member that has no solution at a point does not count there. "
        "ensemble gives what differs from the default in each member, by the names of "
        "config/inputs.yaml, SI."
    ),
}


def ensemble_range(
    dataset: PlainDataset,
    base: Parameters,
    ensemble: Sequence[Mapping[str, Any]],
) -> PlainDataset:
    """The range of each quantity over the ``ensemble``, at the points of ``dataset``.

    A member of the ensemble has the inputs that differ from ``base``, SI.  The variables
    ``<quantity>_low`` and ``<quantity>_high`` are the ends of the range.
    """
    conditions, shown = curves_of(dataset)
    load = dataset["load"].values[:, None]
    points = {"load": load, **Condition(*conditions)._asdict()}
    solved = [
        solve_points(points, replace(base, **member), MEMBER_RTOL, tuple(QUANTITIES))
        for member in ensemble
    ]
    variables = {}
    for name in QUANTITIES:
        ends = range_over_members([member[name] for member in solved])
        for suffix, fraction, values in zip(SUFFIXES, ENDS, ends, strict=True):
            whole = np.full((len(load), *shown.shape), FILL_FLOAT)
            whole[:, shown] = values
            variable = dataset[name].attrs
            described = {key: variable[key] for key in ("units", "symbol", "equation")}
            described["long_name"] = (
                f"{variable['long_name']}, {fraction:g} quantile of the ensemble"
            )
            described["coverage_content_type"] = "modelResult"
            filled = {"_FillValue": FILL_FLOAT}
            variables[f"{name}_{suffix}"] = PlainVariable(DIMENSIONS, whole, described, filled)
    members = json.dumps([dict(member) for member in ensemble])
    origin = f"{dataset.attrs['configuration_sha256']} {MEMBER_RTOL} {members}"
    attributes = {
        **dataset.attrs,
        "title": f"{dataset.attrs['title']}: range of the ensemble",
        **ATTRIBUTES,
        "summary": f"{how_to_select(dataset)}{ATTRIBUTES['summary']}",
        **identity(origin),
        "rtol": MEMBER_RTOL,
        "ensemble": members,
    }
    return PlainDataset(variables, dataset.coords, attributes)
