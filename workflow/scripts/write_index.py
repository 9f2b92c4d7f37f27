"""The index page of all products, and the captions with the failing statements of each figure."""

import json
from pathlib import Path

import jinja2

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.study.claims import figures_named


def figure_entry(caption, statements, scenes):
    """Content of the page for one figure: title, text, and the statements that fail."""
    stem = Path(caption).stem
    first, _, _ = Path(caption).read_text(encoding="utf-8").partition("\n\n")
    title, _, text = first.removeprefix("**").partition(".**")
    number = int(stem.removeprefix("fig")) if stem.startswith("fig") else None
    here = [each for each in statements if number in figures_named(each["place"])]
    return {
        "stem": stem,
        "title": title,
        "text": text.strip(),
        "held": sum(each["verdict"] == "holds" for each in here),
        "wide": stem in scenes,
        "failed": [
            f"{each['place']}: {each['statement']}" for each in here if each["verdict"] == "fails"
        ],
    }


with logged(snakemake.log[0]):
    judged = json.loads(Path(snakemake.input.verdicts).read_text(encoding="utf-8"))
    templates = Path(snakemake.input.page_template), Path(snakemake.input.captions_template)
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates[0].parent),
        autoescape=jinja2.select_autoescape(),
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    statements = judged["statements"]
    scenes = {Path(dataset).stem for dataset in snakemake.input.datasets}
    content = {
        "figures": [figure_entry(each, statements, scenes) for each in snakemake.input.captions],
        "tables": [Path(table).stem for table in snakemake.input.tables],
        "datasets": [Path(dataset).name for dataset in snakemake.input.datasets],
        "score": judged["score"],
    }
    with atomic_write(snakemake.output.page, snakemake.output.captions) as parts:
        for part, template in zip(parts, templates, strict=True):
            text = environment.get_template(template.name).render(content)
            part.write_text(text, encoding="utf-8")
