"""Fill the folder of a release with products, sources and their descriptions."""

from thirdbody.run.job import logged

from pathlib import Path

from thirdbody.release.citation import Release
from thirdbody.release.crate import Job, Run
from thirdbody.release.staging import stage, whole_folder
from thirdbody.run.custody import require_recorded


def fill(place, products, sources, run, is_changed):
    """Write the folder ``place`` of the release that the ``sources`` describe.

    A product is to be as it was made: one without a record of that may be damaged.  ``is_changed``
    says that the configuration is not the paper's.
    """
    require_recorded(products)
    release = Release.of("pyproject.toml", "CITATION.cff")
    release = release.of_other_configuration() if is_changed else release
    with whole_folder(place) as folder:
        stage(folder, products, sources, run, release)
    print(f"{place}: {len(products)} products, {len(sources)} sources")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        fill(
            Path(snakemake.output.sealed).parent,
            [*snakemake.input.products, *snakemake.input.bands],
            snakemake.input.sources,
            Run(
                snakemake.params.settings,
                [Job(**job) for job in snakemake.params.jobs],
                snakemake.params.software,
            ),
            snakemake.params.is_changed,
        )
