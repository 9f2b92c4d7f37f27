"""The page that leads to all products: results/index.html."""

import json
import re
from pathlib import Path

import jinja2

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged

NUMBERS = re.compile(r"\d+")


def figures_named(place):
    """Numbers of the figures that the place of a statement names, such as "Figures 4 to 7"."""
    figures = place.partition(",")[0]
    if "Figure" not in figures:
        return set()
    numbers = [int(number) for number in NUMBERS.findall(figures)]
    return set(range(numbers[0], numbers[-1] + 1)) if " to " in figures else set(numbers)


def figure_entry(caption, statements, scenes):
    """What the page says of one figure: title, text, and the statements that fail there."""
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
        "failed": [each["statement"] for each in here if each["verdict"] == "fails"],
    }


def write(captions, tables, verdicts, datasets, template, page):
    """Write the ``page`` from the ``template``."""
    scenes = {Path(dataset).stem for dataset in datasets}
    judged = json.loads(Path(verdicts).read_text(encoding="utf-8"))
    environment = jinja2.Environment(
        autoescape=True, trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined
    )
    text = environment.from_string(Path(template).read_text(encoding="utf-8")).render(
        figures=[figure_entry(each, judged["statements"], scenes) for each in captions],
        tables=[Path(table).stem for table in tables],
        datasets=[Path(dataset).name for dataset in datasets],
        score=judged["score"],
    )
    with atomic_write(page) as part:
        part.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        write(
            snakemake.input.captions,
            snakemake.input.tables,
            snakemake.input.verdicts,
            snakemake.input.datasets,
            snakemake.input.template,
            snakemake.output.page,
        )
