"""Combine the parts of a table; write it as CSV, and its sheet as HTML and LaTeX."""

from chenhorng.job_log import job
from chenhorng.sheets import sheet_of
from chenhorng.tables import TABLES, read_csv, write_csv
from thirdbody.core.parameters import Parameters

# tables that have the columns of another one
COLUMNS = {"table1": "paper_table", "table2": "paper_table", "held_out": "own_claims"}

with job(snakemake) as output:
    table = snakemake.wildcards.table
    printed = snakemake.input.printed
    columns = TABLES[COLUMNS.get(table, table)]
    rows = [row for part in snakemake.input.parts for row in read_csv(part, columns)]
    numbers = read_csv(printed, TABLES["printed"]) if printed else ()
    unit = Parameters(**snakemake.params.parameters).newtons_per_load
    sheet = sheet_of(table, rows, numbers, unit)
    write_csv(output.csv, rows, columns)
    output.html.write_text(sheet.html(), encoding="utf-8")
    output.tex.write_text(sheet.latex(table), encoding="utf-8")
