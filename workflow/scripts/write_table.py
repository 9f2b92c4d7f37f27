"""Combine the parts of a table and write it as CSV with Table Schema, Markdown, HTML and LaTeX."""

from thirdbody.core.parameters import Parameters
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, read_csv, write_csv, write_schema
from thirdbody.job_log import logged
from thirdbody.readable import markdown, page, readable, write_latex

with logged(snakemake.log[0]):
    table = snakemake.wildcards.table
    printed = snakemake.input.printed
    columns = TABLES.get(table) or TABLES["paper_table"]
    rows = [row for part in snakemake.input.parts for row in read_csv(part, columns)]
    numbers = read_csv(printed, TABLES["printed"]) if printed else ()
    unit = Parameters(**snakemake.params.parameters).newtons_per_load
    sheets = readable(table, rows, numbers, unit)
    places = [snakemake.output[kind] for kind in ("csv", "json", "md", "html", "tex")]
    with atomic_write(*places) as (as_csv, as_json, as_md, as_html, as_tex):
        write_csv(as_csv, rows, columns)
        write_schema(as_json, columns)
        as_md.write_text(markdown(sheets), encoding="utf-8")
        as_html.write_text(page(sheets), encoding="utf-8")
        write_latex(as_tex, rows, columns)
