"""Every public name as a user uses it, for a type checker; it is not run."""

from typing import assert_type

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

import thirdbody as tb

print(tb.__version__)
inputs = tb.load_parameters(participation=0.5)
assert_type(inputs, tb.Ensemble)
assert_type(tb.load_parameters("inputs.yaml").changed(ball_radius=0.01), tb.Ensemble)
assert_type(inputs.best, tb.Parameters)
assert_type(inputs.best.ball_radius, float)
assert_type(inputs.setup, tb.Setup)
for alone in inputs:
    assert_type(alone, tb.Ensemble)
for member in tb.ensemble(inputs):
    assert_type(member, tb.Parameters)
bronze = tb.Material(modulus_GPa=110, poisson_ratio=0.34, hardness_GPa=1.5)
rig = tb.bearing(inputs, ball="silicon nitride", flat=bronze, speed_m_per_s=2.0)
assert_type(rig, tb.Ensemble)

try:
    points = tb.solve(
        load=np.geomspace(1e-6, 1e-4, 5)[:, np.newaxis],
        viscosity_cSt=[0, 120],
        particle_diameter=3e-7,
        roughness_nm=300,
        particle_density=1e11,
        variables=["solid_load_fraction"],
        parameters=rig,
    )
except tb.OutOfRangeWarning as warning:
    raise SystemExit(str(warning)) from warning
assert_type(points, tb.Solution)
assert_type(points.to_dataset(), xr.Dataset)
points.to_dataframe().to_csv("points.csv")
print(points.solid_load_fraction.max(), points.contact_mode == "hybrid")
print(points.nonsense)  # type: ignore[attr-defined]
tb.solve(load=3, nonsense=4)  # type: ignore[call-arg]
tb.solve(load=None, load_N="heavy", viscosity=object())  # type: ignore[arg-type]
tb.grid(load=[1e-6, 1e-5], nonsense=4)  # type: ignore[call-arg]
labelled = xr.DataArray([0.0, 90.0], dims="oil")
every = tb.solve(load_N=10, viscosity_cSt=labelled, members=True, parameters=inputs)
assert_type(every, tb.Solution)

grid = tb.grid(load_N=[1, 10], viscosity_cSt=[0, 90], roughness_nm=300, progress=False)
assert_type(grid, xr.Dataset)
tb.stream("grid.nc", load_N=[1, 10], viscosity_cSt=[0, 90], roughness_nm=300, compression=1)
figure = tb.plot(grid, over="load_N")
assert_type(figure, Figure)
figure.savefig("figure.png")

found = tb.find("solid_load_fraction", [0.9, 0.5], "viscosity_cSt", load_N=10, roughness_nm=300)
changes = tb.transitions("load_N", between=(0.1, 100.0), viscosity_cSt=90, roughness_nm=300)
turning = tb.turning_point(viscosity_cSt=0, roughness_nm=300, count=60)
window = tb.turning_window(roughness_nm=[100, 300], particle_density_per_m2=1e11)
print(found, changes, turning["exists"], window["low"])
