"""One of the paper's own tables with each derived entry recomputed."""

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.files import atomic_write
from thirdbody.data.paper_tables import paper_table
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters

with logged(snakemake.log[0]):
    judged = paper_table(
        read_yaml(snakemake.input.printed)[snakemake.wildcards.table],
        Parameters(**snakemake.params.parameters),
    )
    with atomic_write(snakemake.output.rows) as part:
        write_csv(part, judged, TABLES["paper_table"])
