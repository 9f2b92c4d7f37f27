"""Checksums of all products."""

from thirdbody.files import sums_text
from thirdbody.paper.job_log import job

with job(snakemake) as output:
    text = sums_text(snakemake.input, snakemake.params.folder)
    output.sums.write_text(text, encoding="utf-8")
    print(f"{len(snakemake.input)} products")
