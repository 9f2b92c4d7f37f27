"""Gather the parts of a table and write it as CSV with its Table Schema, Markdown and LaTeX."""

from pathlib import Path

from thirdbody.data.files import logged, whole
from thirdbody.data.readable import READABLE, markdown, readable
from thirdbody.data.tables import TABLES, read_csv, write_csv, write_schema, write_text
from thirdbody.model.parameters import Parameters


def write(table, parts, printed, parameters, csv, schema, text, latex):
    """Write ``table`` from the rows of all ``parts``, in their order.

    Where it can be read more easily another way, its Markdown is, with the numbers that the paper
    prints beside: ``printed`` is their file, empty for none.
    """
    columns = TABLES.get(table) or TABLES["paper_table"]
    rows = [row for part in parts for row in read_csv(part, columns)]
    with whole(csv, schema, text, latex) as (csv_part, schema_part, md_part, tex_part):
        write_csv(csv_part, rows, columns)
        write_schema(schema_part, columns)
        if table in READABLE:
            numbers = read_csv(printed, TABLES["printed"]) if printed else ()
            newtons_per_load = Parameters(**parameters).newtons_per_load
            sheets = readable(table, rows, numbers, newtons_per_load)
            Path(md_part).write_text(markdown(sheets), encoding="utf-8")
        else:
            write_text(md_part, rows, columns, "github")
        write_text(tex_part, rows, columns, "latex_booktabs")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        write(
            snakemake.wildcards.table,
            snakemake.input.parts,
            snakemake.input.printed,
            snakemake.params.parameters,
            snakemake.output.csv,
            snakemake.output.json,
            snakemake.output.md,
            snakemake.output.tex,
        )
