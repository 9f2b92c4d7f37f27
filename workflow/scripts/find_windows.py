"""Find the windows of x_a/sigma in which dry contact has a turning point."""

import numpy as np

from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.core.parameters import Parameters
from thirdbody.core.windows import WindowSearch, turning_point_windows
from thirdbody.variables import AXES

with job(snakemake) as output:
    search = snakemake.params.windows
    inputs = Parameters(**snakemake.params.parameters)
    ratios = np.linspace(*search["particle_diameter_per_roughness"], search["count"])
    sweep = WindowSearch(ratios)
    loads = [newtons / inputs.newtons_per_load for newtons in snakemake.params.load_axis["load_N"]]
    density = search["particle_density_per_m2"]
    rows = []
    for roughness in map(AXES["roughness"].to_si, search["roughness_nm"]):
        (window,) = turning_point_windows(sweep, [roughness], density, loads, inputs)
        same = {"roughness_m": roughness, "particle_density_per_m2": density}
        for end, value, error in (
            ("low", window.low, window.low_error),
            ("high", window.high, window.high_error),
        ):
            rows.append(same | {"end": end, "diameter_over_roughness": value, "error": error})
    write_csv(output.windows, rows, TABLES["tpca_windows"])
