"""The apparent area that the digits of printed loads leave, and what surfaces cannot be."""

import pandas as pd

from chenhorng.claims.apparent_area import area_rows, losses_of_areas
from chenhorng.claims.limits import limit_rows
from chenhorng.claims.paper_tables import steel_modulus
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.core.parameters import Parameters
from thirdbody.files import read_yaml

with job(snakemake) as output:
    inputs = Parameters(**snakemake.params.parameters)
    digits = read_yaml(snakemake.params.digits)
    tables = read_yaml(snakemake.params.tables)
    rows = {row["symbol"]: row for table in tables.values() for row in table}
    (poisson_ratio,) = rows["v_s1, v_s2, v_a"]["printed"]
    ranking = pd.read_csv(snakemake.input.ranking, index_col="interpretation")
    losses = losses_of_areas(
        snakemake.params.interpretations, ranking["left_out_loss"], inputs.apparent_area
    )
    areas = area_rows(
        digits, 1e-5 * rows["W"]["printed"][0], inputs, steel_modulus(poisson_ratio), losses
    )
    speed = 1e-10 * rows["U"]["printed"][1], rows["U"]["digits"]
    limits = limit_rows(inputs, digits, speed, rows["sigma"]["printed"])
    write_csv(output.apparent_area, areas, TABLES["apparent_area"])
    write_csv(output.limits, limits, TABLES["limits"])
