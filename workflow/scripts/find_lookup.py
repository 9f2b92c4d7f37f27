"""Find the smallest table from which L_s and A_sa,t* are interpolated in real time."""

from thirdbody.atlas.smallest import search_lookup
from thirdbody.data.files import whole
from thirdbody.data.netcdf import write_netcdf
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters


def find(axes, settings, parameters, table):
    """Write the table of the inputs ``parameters``, with its errors as attributes."""
    found = search_lookup(Parameters(**parameters), axes, settings).tables
    with whole(table) as part:
        write_netcdf(found, part, {})
    for name in ("numbers", "error_kept_in_share", "largest_error"):
        print(f"{name}: {found.attrs[name]}")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        find(
            snakemake.params.axes,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.output.table,
        )
