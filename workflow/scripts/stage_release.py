"""Fill the folder of a release with products, sources and their descriptions."""

import json
from pathlib import Path

from thirdbody.data.sums import require_sums
from thirdbody.job_log import logged
from thirdbody.release.citation import Release
from thirdbody.release.staging import stage


def fill(place, products, sums, sources, settings, jobs, software, is_paper):
    """Write the folder ``place`` of the release that the ``sources`` describe.

    Products must be what ``sums`` says.  ``is_paper``: the configuration is the paper's.
    """
    require_sums(sums)
    release = Release.of("pyproject.toml", "CITATION.cff", is_paper)
    stage(place, products, sources, settings, jobs, software, release)
    print(f"{place}: {len(products)} products, {len(sources)} sources")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        fill(
            Path(snakemake.output.sealed).parent,
            snakemake.input.products,
            snakemake.input.sums,
            snakemake.input.sources,
            snakemake.params.settings,
            json.loads(Path(snakemake.input.jobs).read_text(encoding="utf-8")),
            snakemake.params.software,
            snakemake.params.is_paper,
        )
