"""The apparent area that the digits of printed loads leave, and what surfaces cannot be."""

from chenhorng.claims.apparent_area import area_rows, free_areas
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
    found = free_areas([read_yaml(path) for path in snakemake.params.calibrated])
    areas = area_rows(
        digits,
        1e-5 * rows["W"]["printed"][0],
        inputs,
        steel_modulus(poisson_ratio),
        found,
    )
    speed = 1e-10 * rows["U"]["printed"][1], rows["U"]["digits"]
    limits = limit_rows(inputs, digits, speed, rows["sigma"]["printed"])
    write_csv(output.apparent_area, areas, TABLES["apparent_area"])
    write_csv(output.limits, limits, TABLES["limits"])
