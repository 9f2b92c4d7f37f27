"""Solve the interfaces of one schematic and draw lots for the sections through them."""

from thirdbody.data.files import whole
from thirdbody.data.schematic import write_sections
from thirdbody.data.section import sections
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def compute(figure, panels, parameters, path):
    """Write the sections of ``figure``, one at the conditions of each of its ``panels``."""
    computed = sections(figure, panels, Parameters(**parameters))
    with whole(path) as part:
        write_sections(part, computed)
    print(f"{figure}: {len(computed)} sections")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        compute(
            snakemake.wildcards.figure,
            snakemake.params.panels,
            snakemake.params.parameters,
            snakemake.output.sections,
        )
