"""Write the tables of the paper with their derived entries recomputed."""

from chenhorng.claims.paper_tables import paper_table
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.core.parameters import Parameters
from thirdbody.files import read_yaml

with job(snakemake) as output:
    inputs = Parameters(**snakemake.params.parameters)
    printed = read_yaml(snakemake.params.printed)
    for table, path in vars(output).items():
        write_csv(path, paper_table(printed[table], inputs), TABLES["paper_table"])
