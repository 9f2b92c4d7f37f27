"""The tables of the paper with derived entries recomputed."""

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.core.parameters import Parameters
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import job
from thirdbody.study.paper_tables import paper_table

with job(snakemake) as output:
    inputs = Parameters(**snakemake.params.parameters)
    printed = read_yaml(snakemake.params.printed)
    for table, path in vars(output).items():
        write_csv(path, paper_table(printed[table], inputs), TABLES["paper_table"])
