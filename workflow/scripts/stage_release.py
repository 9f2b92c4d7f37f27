"""Fill the folder of a release with products, sources and their descriptions."""

from pathlib import Path

from thirdbody.job_log import logged
from thirdbody.release.citation import Release, software_versions
from thirdbody.release.crate import Run
from thirdbody.release.files import source_files
from thirdbody.release.staging import stage, whole_folder


def fill(place, products, settings, jobs, is_changed):
    """Write the folder ``place``; ``is_changed``: the configuration is not the paper's."""
    release = Release.of("pyproject.toml", "CITATION.cff")
    release = release.of_other_configuration() if is_changed else release
    sources = source_files()
    run = Run(settings, jobs, software_versions("pyproject.toml"))
    with whole_folder(place) as folder:
        stage(folder, products, sources, run, release)
    print(f"{place}: {len(products)} products, {len(sources)} sources")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        fill(
            Path(snakemake.output.sealed).parent,
            snakemake.input.products,
            snakemake.params.settings,
            snakemake.params.jobs,
            snakemake.params.is_changed,
        )
