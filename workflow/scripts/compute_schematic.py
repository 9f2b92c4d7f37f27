"""Solve the interfaces of one schematic and generate random sections through them."""

from dataclasses import replace

from thirdbody.attributes import version_attributes
from thirdbody.core.parameters import Parameters
from thirdbody.core.solve import DEFAULT_RTOL, solve_points
from thirdbody.curves import Condition
from thirdbody.netcdf import write_dataset
from chenhorng.figures.sections import sections, state_of
from chenhorng.job_log import job
from thirdbody.variables import VARIABLES
from thirdbody.version import Version


def solved_state(conditions, parameters):
    """The state of the interface at the configured ``conditions``."""
    condition = Condition.of(conditions)
    load = conditions["load_N"] / parameters.newtons_per_load
    point = {"load": load, **condition._asdict()}
    solved = solve_points(point, parameters, DEFAULT_RTOL, VARIABLES)
    return state_of(condition, conditions["load_N"], solved)


with job(snakemake) as output:
    figure = snakemake.wildcards.schematic
    inputs = Parameters(**snakemake.params.parameters)
    states = [solved_state(conditions, inputs) for conditions in snakemake.params.panels]
    computed = sections(figure, states, inputs)
    attributes = computed.attrs | version_attributes(Version(*snakemake.params.version))
    write_dataset(replace(computed, attrs=attributes), output.sections)
    print(f"{figure}: {len(states)} sections")
