"""Writes ``measured.csv``: no measurement, but the model with other p and R, and with errors of a
laboratory.

Friction and contact resistance come from the estimates of ``docs/recipes.md``.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import thirdbody as tb

SCATTER = 0.03  # relative
loads = np.geomspace(1.0, 50.0, 9)
truth = tb.load_parameters().changed(participation=0.55, summit_radius=1e-4)
points = tb.solve(
    load_N=loads,
    viscosity_cSt=90,
    particle_diameter_nm=500,
    roughness_nm=300,
    particle_density_per_m2=1e11,
    parameters=truth,
)
scatter = 1.0 + SCATTER * np.random.default_rng(1).standard_normal((2, loads.size))
friction = 0.11 * points.solid_load_fraction + 0.035 * points.fluid_load_fraction
area = points.total_contact_area * truth.apparent_area
resistance = 2.2e-7 / (2.0 * np.sqrt(area / np.pi))
table = pd.DataFrame(
    {
        "load [N]": loads.round(2),
        "friction coefficient": friction * scatter[0],
        "contact resistance [mohm]": 1e3 * resistance * scatter[1],
    }
)
table.to_csv(Path(__file__).with_name("measured.csv"), index=False, float_format="%.4g")
