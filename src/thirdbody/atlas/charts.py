"""Design charts: limits over the load, one curve per roughness, with ensemble ranges.

Nothing is solved for a chart: its limits were found with the points of the atlas.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import xarray as xr

from thirdbody.data.conditions import AXES, CONDITION_AXES, DIMENSIONS
from thirdbody.data.quantities import STATUS
from thirdbody.model.regimes import SOLUTION_STATUSES

CHARTS = {  # the variable of the atlas in each
    "largest_particle": "largest_particle_diameter",
    "least_viscosity": "least_viscosity",
}


def chart_panels(atlas: xr.Dataset, name: str, charts: Mapping) -> list[xr.Dataset]:
    """Datasets of the panels of a chart, one of ``CHARTS``, by ``charts`` of ``config/atlas.yaml``.

    Each has ``limit`` over ``load`` and ``roughness`` [SI], ``range`` also over ``quantile``, and
    the ``solution_status`` of the point of the atlas nearest to the limit; the conditions of the
    panel are coordinates, and the attribute ``ends`` is the range of the limit in the atlas.
    """
    variable = CHARTS[name]
    curves = [AXES["roughness"].to_si(value) for value in charts["roughness_nm"]]
    (along,) = (each for each in DIMENSIONS if each not in atlas[variable].dims)
    ends = atlas[along].values[atlas[along].values > 0.0][[0, -1]]
    panels = []
    for given in charts[name]:
        held = {
            axis.name: axis.to_si(given[axis.key]) for axis in CONDITION_AXES if axis.key in given
        }
        found = {"limit": variable, "range": f"{variable}_range", STATUS: STATUS}
        shown = xr.Dataset({name: atlas[of] for name, of in found.items()})
        shown = shown.sel(held, method="nearest").sel(roughness=curves, method="nearest").load()
        # an unknown limit is put at the last value
        nearest = shown["limit"].fillna(ends[1]).clip(*ends)
        status = shown[STATUS].sel({along: nearest}, method="nearest").drop_vars(along)
        panels.append(shown.drop_dims(along).assign({STATUS: status}).assign_attrs(ends=ends))
    return panels


def chart_rows(panels: Sequence[xr.Dataset], newtons: Sequence[float]) -> Iterator[dict]:
    """Rows of the table of a chart: one for each panel, roughness and load of ``newtons`` [N]."""
    for panel in panels:
        held = [axis for axis in CONDITION_AXES if axis.name in panel.coords]
        for surface in panel["roughness"].values:
            for load in newtons:
                place = int(np.abs(panel["normal_load"].values - load).argmin())
                point = panel.isel(load=place).sel(roughness=surface)
                low, median, high = point["range"].values.tolist()
                yield {
                    **{axis.column: float(point[axis.name]) for axis in held},
                    "load_N": load,
                    "load": float(point["load"]),
                    "limit": float(point["limit"]),
                    "low": low,
                    "median": median,
                    "high": high,
                    STATUS: SOLUTION_STATUSES[int(point[STATUS])],
                }
