"""What solving each dataset cost, and all of them together."""

from thirdbody.run.job import logged

from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, read_csv, write_csv


def write(parts, table):
    """Write the rows of ``parts`` and their sum."""
    columns = TABLES["solver_cost"]
    rows = [row for part in parts for row in read_csv(part, columns)]
    points = sum(row["points"] for row in rows)
    seconds = sum(row["seconds"] for row in rows)
    total = {
        "figure": "all",
        "points": points,
        "rtol": min(row["rtol"] for row in rows),
        "seconds": seconds,
        "microseconds_per_point": 1e6 * seconds / points,
    }
    with whole(table) as part:
        write_csv(part, [*rows, total], columns)


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        write(snakemake.input.parts, snakemake.output.table)
