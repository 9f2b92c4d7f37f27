"""Time of a look-up in the table for real time, beside solving; and what a table over the five
conditions themselves would be worth.

    python -m benchmarks.measure_lookup [--table results/atlas/lookup.nc] [--conditions 20000]
"""

from __future__ import annotations

import argparse
import time

import numpy as np
from scipy.interpolate import RegularGridInterpolator
from scipy.special import expit, logit

import thirdbody as tb
from thirdbody.atlas.lookup import Lookup
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.schema import config_directory

SHARES = "solid_load_fraction", "particle_contact_area_ratio"
LEAST = 1e-4  # share that is told from none
CALLS = 200
GRIDS = (8, 8, 12, 6, 6), (16, 12, 32, 12, 12), (24, 16, 48, 16, 16)


def solved(conditions, parameters) -> np.ndarray:
    """L_s and A_sa,t* [1] of conditions in engineering units, which broadcast; shape (2, ...)."""
    load, viscosity, diameter, roughness, density = conditions
    found = tb.solve(
        load=load / parameters.newtons_per_load,
        viscosity=viscosity * 1e-6,
        particle_diameter=diameter * 1e-9,
        roughness=roughness * 1e-9,
        particle_density=density,
        parameters=parameters,
        rtol=1e-3,
        variables=SHARES,
        progress=False,
    )
    return np.array([getattr(found, name) for name in SHARES])


def microseconds(function, conditions) -> float:
    """Least time on the clock of a call for one set of conditions [us]."""
    times = []
    for each in conditions.T[:CALLS]:
        start = time.perf_counter()
        function(each)
        times.append(time.perf_counter() - start)
    return 1e6 * float(np.median(times))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--table", default="results/atlas/lookup.nc")
    parser.add_argument("--conditions", type=int, default=20_000)
    given = parser.parse_args()
    lookup, parameters = Lookup.read(given.table), tb.load_parameters()
    told = lookup.tables.attrs
    axes = read_yaml(config_directory() / "atlas.yaml")["axes"].values()
    first, last = np.log([[float(axis["from"]), float(axis["to"])] for axis in axes]).T
    drawn = np.random.default_rng(5).random((given.conditions, 5)) * (last - first) + first
    conditions = np.exp(drawn.T)
    known = solved(conditions, parameters)

    start = time.perf_counter()
    errors = np.abs(np.array(lookup(*conditions)) - known).max(axis=0)
    seconds = time.perf_counter() - start
    for name in ("numbers", "error_kept_in_share", "error_quantile_0.999", "largest_error"):
        print(f"table: {name} {told[name]:.6g}")
    print(f"table: within 0.01 at {(errors <= 0.01).mean():.4%} of {given.conditions} conditions")
    print(f"table: {microseconds(lambda each: lookup(*each), conditions):.0f} us a call")
    print(f"table: {1e6 * seconds / given.conditions:.1f} us a condition of {given.conditions}")
    one = microseconds(lambda each: solved(each, parameters), conditions)
    print(f"solve: {one:.0f} us a call")
    for counts in GRIDS:
        nodes = [np.linspace(*ends, count) for ends, count in zip(zip(first, last), counts)]
        grid = solved(np.ix_(*map(np.exp, nodes)), parameters)
        odds = np.moveaxis(logit(np.clip(grid, LEAST, 1.0 - LEAST)), 0, -1)
        found = expit(RegularGridInterpolator(nodes, odds)(drawn)).T
        within = (np.abs(found - known).max(axis=0) <= 0.01).mean()
        print(f"five axes, linear in the odds: {odds.size} numbers, within 0.01 at {within:.2%}")
