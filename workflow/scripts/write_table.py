"""Gather the parts of a table and write it as CSV with its Table Schema, Markdown and LaTeX."""

from thirdbody.data.files import logged, whole
from thirdbody.data.tables import TABLES, read_csv, write_csv, write_schema, write_text


def write(table, parts, csv, schema, markdown, latex):
    """Write ``table`` from the rows of all ``parts``, in their order."""
    columns = TABLES.get(table) or TABLES["paper_table"]
    rows = [row for part in parts for row in read_csv(part, columns)]
    with whole(csv, schema, markdown, latex) as (csv_part, schema_part, md_part, tex_part):
        write_csv(csv_part, rows, columns)
        write_schema(schema_part, columns)
        write_text(md_part, rows, columns, "github")
        write_text(tex_part, rows, columns, "latex_booktabs")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        write(
            snakemake.wildcards.table,
            snakemake.input.parts,
            snakemake.output.csv,
            snakemake.output.json,
            snakemake.output.md,
            snakemake.output.tex,
        )
