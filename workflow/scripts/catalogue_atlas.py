"""Catalogue the chunks of the atlas."""

from thirdbody.paper.atlas.catalogue import write_catalogue
from thirdbody.paper.job_log import job

with job(snakemake) as output:
    write_catalogue(output.catalogue, snakemake.input.chunks)
