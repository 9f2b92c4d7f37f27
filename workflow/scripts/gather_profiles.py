"""The profiles of the calibration as a table."""

import pandas as pd

from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    columns = [column.name for column in TABLES["profiles"]]
    profiles = pd.read_csv(snakemake.input.profiles).reindex(columns=columns)
    rows = profiles.astype(object).where(profiles.notna(), None).to_dict("records")
    write_csv(output.table, rows, TABLES["profiles"])
