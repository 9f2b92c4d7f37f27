"""Checksums of all products."""

from thirdbody.data.files import sums_text
from thirdbody.job_log import job

with job(snakemake) as output:
    text = sums_text(snakemake.input, snakemake.params.folder)
    output.sums.write_text(text, encoding="utf-8")
    print(f"{len(snakemake.input)} products")
