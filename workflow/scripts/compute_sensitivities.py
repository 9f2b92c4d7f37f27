"""Elasticities and total Sobol indices of results with respect to the unprinted inputs."""

from dataclasses import replace

from thirdbody.core.parameters import Parameters
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.study.evidence import FULL_EFFORT
from thirdbody.study.sensitivity import (
    Subject,
    default_indices,
    elasticities,
    sensitivity_rows,
    varied_inputs,
)

with logged(snakemake.log[0]):
    settings = snakemake.params.settings
    subject, defaults = Subject.of(settings), Parameters(**snakemake.params.parameters)
    inputs = varied_inputs(defaults, snakemake.params.unpublished)
    base = subject.values(defaults, FULL_EFFORT)
    effort = subject.effort_near(base)

    def values(changes):
        return subject.values(replace(defaults, **changes), effort)

    found = (
        elasticities(values, base, inputs),
        default_indices(subject, defaults, inputs, base, settings["sobol"]),
    )
    with atomic_write(snakemake.output.elasticities, snakemake.output.indices) as parts:
        for part, measured in zip(parts, found, strict=True):
            rows = sensitivity_rows(subject, base, inputs, measured)
            write_csv(part, rows, TABLES["sensitivity"])
    print(f"{len(subject.outputs)} results, {len(inputs)} inputs: {', '.join(inputs)}")
