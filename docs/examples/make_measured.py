"""Writes ``measured.csv``: no measurement, but a member of the ensemble with errors of a laboratory.

Friction and contact resistance come from the same estimates as in ``thirdbody.lab.compare``.
"""

from pathlib import Path

import numpy as np
import pandas as pd

import thirdbody as tb

SCATTER = 0.03  # relative
loads = np.geomspace(1.0, 50.0, 9)
truth = tb.ensemble()[4]
points = tb.solve(
    load_N=loads,
    viscosity_cSt=90,
    particle_diameter_nm=500,
    roughness_nm=300,
    particle_density_per_m2=1e11,
    parameters=truth,
)
scatter = 1.0 + SCATTER * np.random.default_rng(1).standard_normal((2, loads.size))
friction = tb.lab.friction(points, boundary_friction=0.11, film_friction=0.035)
table = pd.DataFrame(
    {
        "load [N]": loads.round(2),
        "friction coefficient": friction * scatter[0],
        "contact resistance [mohm]": 1e3 * tb.lab.contact_resistance(points) * scatter[1],
    }
)
table.to_csv(Path(__file__).with_name("measured.csv"), index=False, float_format="%.4g")
