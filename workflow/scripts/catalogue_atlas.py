"""Catalogue the chunks of the atlas."""

from thirdbody.atlas.catalogue import write_catalogue
from thirdbody.job_log import job

with job(snakemake) as output:
    write_catalogue(output.catalogue, snakemake.input.chunks)
