"""The index page of all products, and the captions with the failing statements of each figure."""

import json
import struct
from pathlib import Path

import jinja2
from markupsafe import Markup

from thirdbody.paper.figures.captions import read_caption
from thirdbody.paper.job_log import job
from thirdbody.paper.places import part_of_paper
from thirdbody.paper.typeset import html

# a line on each table
TABLES = {
    "table1": "Mechanical properties, as printed and recomputed",
    "table2": "Operating conditions, as printed and recomputed",
    "tpca_loads": "Loads of the turning points of the contact area on every curve",
    "tpca_windows": "Ranges of x_a/σ in which dry contact has a turning point",
    "transitions": "Loads at which lubrication regime or contact mode change",
    "sensitivity": "How much each unprinted input changes each result",
}


def figure_entry(caption, picture, statements, scenes):
    """Content of the page for one figure: its title, what it shows, its caption, and its statements."""
    stem, written = Path(caption).stem, read_caption(caption)
    number = int(stem.removeprefix("fig")) if stem.startswith("fig") else None
    here = [each for each in statements if part_of_paper(each["place"]) == f"Figure {number}"]
    failed = [each for each in here if each["verdict"] == "fails"]
    return {
        "stem": stem,
        "size": struct.unpack(">2I", Path(picture).read_bytes()[16:24]),  # of a PNG, in dots
        "title": written.title,
        "shows": written.message,
        "text": written.text,
        "alternative": written.alternative,
        "held": sum(each["verdict"] == "holds" for each in here),
        "wide": stem in scenes,
        "failed": [f"{each['place']}: {each['statement']}" for each in failed],
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
    statements, titles = judged["statements"], snakemake.params.titles
    content = {
        "figures": [
            figure_entry(*files, statements, titles)
            for files in zip(snakemake.input.captions, snakemake.input.thumbnails, strict=True)
        ],
        "tables": {
            name: TABLES.get(name, name)
            for name in (Path(table).stem for table in snakemake.input.tables)
        },
        "datasets": {Path(path).name: titles[Path(path).stem] for path in snakemake.input.datasets},
        "score": f"{judged['score']} {judged['counts']}",
        "held": judged["held"],
        "judged": judged["judged"],
        "version": snakemake.params.version,
    }
    for path, template in zip((output.page, output.captions), templates, strict=True):
        text = environment.get_template(template.name).render(content)
        path.write_text(text, encoding="utf-8")
