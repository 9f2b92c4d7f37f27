"""The tables of the paper with derived entries recomputed."""

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.core.parameters import Parameters
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.study.paper_tables import paper_table

with logged(snakemake.log[0]):
    inputs = Parameters(**snakemake.params.parameters)
    printed = read_yaml(snakemake.params.printed)
    with atomic_write(*snakemake.output) as parts:
        for part, table in zip(parts, snakemake.output.keys(), strict=True):
            write_csv(part, paper_table(printed[table], inputs), TABLES["paper_table"])
