"""Write the index page of all products, and the captions with the failing statements of figures."""

import base64
import json
import struct
from pathlib import Path

import jinja2
from markupsafe import Markup

from chenhorng.claims.words import COLOURS, FAILS, HOLDS
from chenhorng.figures.captions import inputs_sentence, labels_sentences
from chenhorng.findings import RULE, in_no_finding, judged_findings, worth_of_inputs
from chenhorng.job_log import job
from chenhorng.markdown import markdown_text
from chenhorng.tables import TABLES as COLUMNS
from chenhorng.tables import read_csv
from thirdbody.netcdf import read_plain
from thirdbody.symbols import html
from thirdbody.version import current

# a description of each table
TABLES = {
    "table1": "Table 1: mechanical properties, as printed and recomputed",
    "table2": "Table 2: operating conditions, as printed and recomputed",
    "tpca_loads": "Loads of the turning points of the contact area on every curve",
    "tpca_windows": "Ranges of x_a/σ in which dry contact has a turning point",
    "transitions": "Loads at which lubrication regime or contact mode change",
    "sensitivity": "How much each unprinted input changes each result",
    "deviations": "Numbers of the headline statements beside computed ones; those of all others "
    "are on the page of statements",
    "departures": "What each departure from the words of the paper is worth",
    "coverage": "Printed numbers, and ranges of the inputs that have not seen them",
    "coverage_of_sets": "Other sets of inputs within the ranges",
    "profiles": "What the statements determine: profiles of the objective",
    "apparent_area": "The apparent area A_n that the digits of the printed loads leave",
    "limits": "What cannot be: the inputs beside what surfaces and digits allow",
    "held_out": "What other papers say of the model, which no search for inputs has seen",
}


def figure_entry(path, picture, statements, scenes):
    """Content of the page for one figure: its record, its picture, and the statements about it."""
    stem, record = Path(path).stem, json.loads(Path(path).read_text(encoding="utf-8"))
    here = [row for row in statements if row["part"] == record["place"]]
    return record | {
        "stem": stem,
        "size": struct.unpack(">2I", Path(picture).read_bytes()[16:24]),  # of a PNG, in dots
        "wide": stem in scenes,
        "held": sum(row["verdict"] == HOLDS for row in here),
        "failed": [row for row in here if row["verdict"] == FAILS],
    }


with job(snakemake) as output:
    judged = json.loads(Path(snakemake.input.verdicts).read_text(encoding="utf-8"))
    templates = Path(snakemake.input.page_template), Path(snakemake.input.captions_template)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates[0].parent),
        autoescape=jinja2.select_autoescape(),
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    environment.filters["typeset"] = lambda text: Markup(html(text))
    environment.filters["markdown"] = markdown_text
    statements = judged["statements"]
    figures = [
        figure_entry(*files, statements, snakemake.params.scenes)
        for files in zip(snakemake.input.figures, snakemake.input.pictures, strict=True)
    ]
    data = read_plain(snakemake.input.datasets[0])
    content = {
        "figures": figures,
        "findings": judged_findings(snakemake.params.findings, statements),
        "rule": RULE,
        "others": in_no_finding(snakemake.params.findings, statements),
        "worth": worth_of_inputs(
            *(read_csv(snakemake.input[name], COLUMNS[name]) for name in ("departures", "limits"))
        ),
        "colours": {verdict.split()[0]: colour for verdict, colour in COLOURS.items()},
        "judged": judged,
        "tables": {
            name: TABLES.get(name, name)
            for name in (Path(table).stem for table in snakemake.input.tables)
        },
        "precision": [
            base64.b64encode(Path(path).read_bytes()).decode() for path in snakemake.input.precision
        ],
        "inputs": f"{inputs_sentence(data)} {labels_sentences(data)}",
        "version": current().text,
    }
    for path, template in zip((output.page, output.captions), templates, strict=True):
        text = environment.get_template(template.name).render(content)
        path.write_text(text, encoding="utf-8")
