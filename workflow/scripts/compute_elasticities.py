"""Elasticities of results with respect to the inputs that the paper does not print."""

from thirdbody.run.job import logged

from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.model.parameters import Parameters
from thirdbody.study.sensitivity import (
    Subject,
    default_elasticities,
    sensitivity_rows,
    varied_inputs,
)


def compute(settings, unpublished, parameters, rows):
    """Write the elasticities of what ``settings`` ask about; inputs of value 0 are left out."""
    subject, defaults = Subject.of(settings), Parameters(**parameters)
    inputs = varied_inputs(defaults, unpublished)
    base, found = default_elasticities(subject, defaults, inputs)
    with whole(rows) as part:
        write_csv(part, sensitivity_rows(subject, base, inputs, found), TABLES["sensitivity"])
    print(f"{len(subject.outputs)} results, {len(inputs)} inputs: {', '.join(inputs)}")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        compute(
            snakemake.params.settings,
            snakemake.params.unpublished,
            snakemake.params.parameters,
            snakemake.output.rows,
        )
