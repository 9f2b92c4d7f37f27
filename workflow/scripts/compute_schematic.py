"""Solve the interfaces of one schematic and draw lots for the sections through them."""

from thirdbody.run.job import logged

from thirdbody.data.files import whole
from thirdbody.figures.section_file import write_sections
from thirdbody.figures.sections import sections
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
