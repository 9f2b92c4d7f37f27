"""Time and memory of streaming a grid to a file, which is removed."""

from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.streams import stream_rows
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def measure(settings, parameters, table, directory):
    """Write the times that ``settings`` ask for; the file stands in ``directory`` meanwhile."""
    with TemporaryDirectory(dir=directory) as place:
        rows = stream_rows(Parameters(**parameters), settings, Path(place))
    with whole(table) as part:
        write_csv(part, rows, TABLES["streaming"])
    print(f"{rows[0]['points']} points")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        measure(
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.table,
            snakemake.resources.tmpdir,
        )
