"""The dataset of a figure, which has the curves of a scene."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.curves import Condition
from thirdbody.grids import Axes, crossed
from thirdbody.netcdf import FILL_FLAG, FILL_FLOAT, PlainDataset, curves_of, described_grid
from thirdbody.variables import CONDITION_AXES, DIMENSIONS, FLAGS, NUMBERS, decimal

RELATIVE_DIAMETER = "particle_diameter_per_roughness"  # this key may replace the diameter


def scene_groups(scene: Mapping, newtons_per_load: float) -> list[Axes]:
    """The groups of curves in a valid entry of ``config/scenes.yaml``.

    A group has every combination of its five axes.  All groups have the same loads: logarithmically
    spaced loads, and the loads between their ends that the text names.  Diameters relative to the
    roughness make a group for each roughness.
    """
    axis = scene["load_axis"]
    first, last = decimal(np.array(axis["load_N"]) / newtons_per_load, digits=12)
    named = [load for load in scene.get("named_loads", []) if first <= load <= last]
    load = np.unique([*np.geomspace(first, last, axis["count"]), *named])
    entries = []
    for entry in scene["curves"]:
        if RELATIVE_DIAMETER not in entry:
            entries.append(entry)
            continue
        for sigma in entry["roughness_nm"]:
            diameters = [ratio * sigma for ratio in entry[RELATIVE_DIAMETER]]
            entries.append(entry | {"roughness_nm": [sigma], "particle_diameter_nm": diameters})
    return [
        {"load": load} | {axis.name: axis.values(entry[axis.alias]) for axis in CONDITION_AXES}
        for entry in entries
    ]


def scene_dataset(
    scene: Mapping,
    parameters: Parameters,
    rtol: float = DEFAULT_RTOL,
) -> PlainDataset:
    """The dataset of a figure, from its entry in ``config/scenes.yaml``: all variables over the
    five axes.  Combinations that the figure does not show have ``FILL_FLOAT`` or ``FILL_FLAG``.
    """
    groups = scene_groups(scene, parameters.newtons_per_load)
    axes = {
        name: np.unique(np.concatenate([group[name] for group in groups])) for name in DIMENSIONS
    }
    shape = tuple(axis.size for axis in axes.values())
    values = {name: np.full(shape, FILL_FLOAT) for name in NUMBERS}
    values |= {name: np.full(shape, FILL_FLAG) for name in FLAGS}
    for group in groups:
        indices = np.ix_(*(np.searchsorted(axes[name], group[name]) for name in DIMENSIONS))
        solved = solve_points(crossed(group), parameters, rtol, values)
        for name in values:
            values[name][indices] = solved[name]
    request = {
        "load": axes["load"].tolist(),
        "groups": [{name: group[name].tolist() for name in Condition._fields} for group in groups],
    }
    dataset = described_grid(axes, values, parameters, rtol, scene["title"], request)
    summary = f"{how_to_select(dataset)}{dataset.attrs['summary']}"
    return replace(dataset, attrs={**dataset.attrs, "summary": summary})


def how_to_select(dataset: PlainDataset) -> str:
    """Sentences on the curves among all combinations of their conditions; empty if all are shown.

    A mean over all combinations, or a plot of them, would meet fill values.
    """
    conditions, shown = curves_of(dataset)
    if shown.all():
        return ""
    names = Condition._fields
    first = ", ".join(f"{name}={value:.10g}" for name, value in zip(names, conditions.T[-1]))
    return (
        f"Select a curve before you take a mean or plot: the figure shows {shown.sum()} of "
        f"{shown.size} combinations of {', '.join(names)}, and the others are fill, nan in xarray. "
        f"The last curve is dataset.sel({first}, method='nearest'). "
    )
