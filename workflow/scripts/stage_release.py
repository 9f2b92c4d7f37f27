"""Fill the folder of a release with products, sources and their descriptions."""

import json
from pathlib import Path

from thirdbody.data.sums import require_sums
from thirdbody.job_log import logged
from thirdbody.release.citation import Release
from thirdbody.release.crate import Run
from thirdbody.release.staging import stage, whole_folder


def fill(place, products, sums, sources, run, is_changed):
    """Write the folder ``place`` of the release that the ``sources`` describe.

    Products must be what ``sums`` says.  ``is_changed``: the configuration is not the paper's.
    """
    require_sums(sums)
    release = Release.of("pyproject.toml", "CITATION.cff")
    release = release.of_other_configuration() if is_changed else release
    with whole_folder(place) as folder:
        stage(folder, products, sources, run, release)
    print(f"{place}: {len(products)} products, {len(sources)} sources")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        jobs = json.loads(Path(snakemake.input.jobs).read_text(encoding="utf-8"))
        fill(
            Path(snakemake.output.sealed).parent,
            snakemake.input.products,
            snakemake.input.sums,
            snakemake.input.sources,
            Run(snakemake.params.settings, jobs, snakemake.params.software),
            snakemake.params.is_changed,
        )
