"""How near limits and windows that are read off the atlas are to those that the library finds.

python -m benchmarks.measure_atlas_errors [--catalogue results/atlas/catalogue.json]
"""

from __future__ import annotations

import argparse

import numpy as np
import xarray as xr

import thirdbody as tb
from thirdbody.atlas.surfaces import LIMITED
from thirdbody.model.parameters import Parameters

DRAWN = 2000  # limits of each kind, at random
DENSITY = 1e11  # m-2, of the windows


def limit_errors(atlas: xr.Dataset, name: str, parameters: Parameters) -> np.ndarray:
    """Relative errors [1] of limits that are drawn at random and lie within the atlas."""
    along, variable, level, _ = LIMITED[name]
    limits = atlas[name].load()
    points = limits.stack(point=limits.dims)
    chosen = np.random.default_rng(0).choice(points.size, DRAWN, replace=False)
    points = points.isel(point=chosen)
    points = points.isel(point=np.isfinite(points.values) & (points.values > 0.0))
    ends = atlas[along].values[atlas[along].values > 0.0][[0, -1]]
    found = tb.find(
        variable,
        level,
        along,
        between=tuple(ends),
        parameters=parameters,
        progress=False,
        **{each: points[each].values for each in limits.dims},
    )
    return np.abs(points.values / found.first - 1.0)


def window_errors(atlas: xr.Dataset, parameters: Parameters) -> np.ndarray:
    """Relative errors [1] of both ends of the windows of dry contact, a row a surface."""
    errors = []
    for roughness in atlas["roughness"].values:
        exact = tb.turning_window(
            parameters=parameters, roughness=roughness, particle_density_per_m2=DENSITY
        )
        read = atlas.sel(viscosity=0, particle_density=DENSITY, roughness=roughness)
        ends = (float(read[f"turning_point_window_{end}"]) for end in ("low", "high"))
        errors.append([one / other - 1.0 for one, other in zip(ends, (exact.low, exact.high))])
    return np.abs(errors)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--catalogue", default="results/atlas/catalogue.json")
    parameters = tb.load_parameters()
    with tb.open_atlas(parser.parse_args().catalogue) as atlas:
        for name in LIMITED:
            errors = limit_errors(atlas, name, parameters)
            told = f"median {np.median(errors):.2%}, 99 % below {np.quantile(errors, 0.99):.2%}"
            print(f"{name}: {errors.size} limits, {told}, largest {errors.max():.2%}")
        errors = window_errors(atlas, parameters)
        print(f"windows: {errors.size} ends, largest error {errors.max():.2%}")
