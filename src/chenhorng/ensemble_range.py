"""The range of the ensemble around the curves of a dataset."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chenhorng.scenes import how_to_select
from thirdbody.core.names import TOTAL_CONTACT_AREA
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import solve_points
from thirdbody.curves import Condition
from thirdbody.ensembles import ENDS, RANGE, range_over_members
from thirdbody.netcdf import FILL_FLOAT, PlainDataset, PlainVariable, curves_of, identity
from thirdbody.variables import DERIVED, DIMENSIONS, QUANTITIES, RELATIVE_AREA

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
    ``<quantity>_low`` and ``<quantity>_high`` are the ends of the range.  Where ``dataset`` has dry
    two-body contact, the area over that of it has a range too: of the ratios of each member.
    """
    conditions, shown = curves_of(dataset)
    load = dataset["load"].values[:, None]
    points = {"load": load, **Condition(*conditions)._asdict()}
    solved = [
        solve_points(points, replace(base, **member), MEMBER_RTOL, tuple(QUANTITIES))
        for member in ensemble
    ]
    attributes_of = {name: dataset[name].attrs for name in QUANTITIES}
    reference = _two_body(conditions)
    if (reference >= 0).any():
        relative = DERIVED[RELATIVE_AREA]
        attributes_of[RELATIVE_AREA] = {
            "units": relative.unit,
            "symbol": relative.symbol,
            "long_name": relative.label,
        }
        for member in solved:
            area = member[TOTAL_CONTACT_AREA]
            member[RELATIVE_AREA] = np.where(reference < 0, np.nan, area / area[:, reference])
    variables = {}
    for name, own in attributes_of.items():
        ends = range_over_members([member[name] for member in solved])
        for suffix, fraction, values in zip(SUFFIXES, ENDS, ends, strict=True):
            whole = np.full((len(load), *shown.shape), FILL_FLOAT)
            whole[:, shown] = values
            described = {key: own[key] for key in ("units", "symbol", "equation") if key in own}
            described["long_name"] = f"{own['long_name']}, {fraction:g} quantile of the ensemble"
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


def _two_body(conditions: NDArray) -> NDArray:
    """The curve of dry two-body contact on the surface of each curve, -1 where there is none."""
    curves = [Condition(*each) for each in conditions.T.tolist()]
    found = {
        one.roughness: place for place, one in enumerate(curves) if one.is_dry and one.is_two_body
    }
    return np.array([found.get(one.roughness, -1) for one in curves])
