"""Catalogue the chunks of the atlas."""

from thirdbody.atlas.catalogue import write_catalogue
from thirdbody.data.files import atomic_write
from thirdbody.job_log import logged

with logged(snakemake.log[0]), atomic_write(snakemake.output.catalogue) as part:
    write_catalogue(part, snakemake.input.chunks)
