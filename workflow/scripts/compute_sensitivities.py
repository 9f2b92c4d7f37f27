"""Compute the elasticities of results with respect to the unprinted inputs."""

from dataclasses import replace

from chenhorng.claims.evidence import FULL_EFFORT
from chenhorng.job_log import job
from chenhorng.sensitivity import Subject, elasticities, sensitivity_rows, varied_inputs
from chenhorng.tables import TABLES, write_csv
from thirdbody.core.parameters import Parameters

with job(snakemake) as output:
    subject = Subject.of(snakemake.params.settings)
    defaults = Parameters(**snakemake.params.parameters)
    inputs = varied_inputs(defaults, snakemake.params.unpublished)
    base = subject.values(defaults, FULL_EFFORT)
    effort = subject.effort_near(base)

    def values(changes):
        return subject.values(replace(defaults, **changes), effort)

    measured = elasticities(values, base, inputs)
    rows = sensitivity_rows(subject, base, inputs, *measured)
    write_csv(output.elasticities, rows, TABLES["sensitivity"])
    print(f"{len(subject.outputs)} results, {len(inputs)} inputs: {', '.join(inputs)}")
