"""Fill the folder of a release with products, sources and their descriptions."""

from pathlib import Path

from chenhorng.archive.citation import Release
from chenhorng.archive.staging import stage
from chenhorng.job_log import logged, require_as_made

with logged(snakemake.log[0]):
    folder = Path(snakemake.output.sealed).parent
    products = snakemake.input.products
    sources = snakemake.input.sources
    require_as_made(products)
    release = Release.of("pyproject.toml", "CITATION.cff", snakemake.params.is_paper)
    stage(
        folder,
        products,
        sources,
        snakemake.params.settings,
        snakemake.params.software,
        release,
    )
    print(f"{folder}: {len(products)} products, {len(sources)} sources")
