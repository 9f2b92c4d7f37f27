"""Checksums of all products."""

from thirdbody.data.files import atomic_write, sums_text
from thirdbody.job_log import logged

with logged(snakemake.log[0]):
    text = sums_text(snakemake.input, snakemake.params.folder)
    with atomic_write(snakemake.output.sums) as part:
        part.write_text(text, encoding="utf-8")
    print(f"{len(snakemake.input)} products")
