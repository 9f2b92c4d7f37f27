"""Catalogue the chunks of the atlas, and gather what they cost."""

from thirdbody.atlas.catalogue import write_catalogue
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, read_csv, write_csv
from thirdbody.job_log import logged


def write(chunks, costs, catalogue, cost):
    """Write the catalogue of the files ``chunks``, and the rows of all ``costs``."""
    rows = [row for part in costs for row in read_csv(part, TABLES["atlas_cost"])]
    with atomic_write(catalogue, cost) as (catalogue_part, cost_part):
        write_catalogue(catalogue_part, chunks)
        write_csv(cost_part, rows, TABLES["atlas_cost"])
    points = sum(row["points"] for row in rows)
    print(f"{len(chunks)} chunks, {points:.3g} points")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        write(
            snakemake.input.chunks,
            snakemake.input.cost,
            snakemake.output.catalogue,
            snakemake.output.cost,
        )
