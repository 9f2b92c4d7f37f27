"""Check the folder of a release against its sums and pack it into one archive file."""

from pathlib import Path

from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged
from thirdbody.release.bag import pack


def write(folder, archive, date):
    """Write the file ``archive`` of ``folder``, its members dated ``date``."""
    with atomic_write(archive) as part:
        pack(folder, part, date)


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        write(
            Path(snakemake.input.sealed).parent,
            snakemake.output.archive,
            snakemake.params.date,
        )
