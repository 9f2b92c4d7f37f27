"""Fill the folder of a release with products, sources and their descriptions."""

from pathlib import Path

from thirdbody.files import require_sums
from thirdbody.paper.archive.citation import Release
from thirdbody.paper.archive.staging import stage
from thirdbody.paper.job_log import logged

with logged(snakemake.log[0]):
    place = Path(snakemake.output.sealed).parent
    products = snakemake.input.products
    sources = snakemake.input.sources
    require_sums(snakemake.input.sums)
    release = Release.of("pyproject.toml", "CITATION.cff", snakemake.params.is_paper)
    stage(
        place,
        products,
        sources,
        snakemake.params.settings,
        snakemake.params.software,
        release,
    )
    print(f"{place}: {len(products)} products, {len(sources)} sources")
