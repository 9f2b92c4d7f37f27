"""One of the paper's own tables with each derived entry recomputed."""

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.files import atomic_write
from thirdbody.data.paper_tables import paper_table
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def recompute(printed, table, parameters, rows):
    """Write the rows of ``table`` from the file ``printed``."""
    judged = paper_table(read_yaml(printed)[table], Parameters(**parameters))
    with atomic_write(rows) as part:
        write_csv(part, judged, TABLES["paper_table"])


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        recompute(
            snakemake.input.printed,
            snakemake.wildcards.table,
            snakemake.params.parameters,
            snakemake.output.rows,
        )
