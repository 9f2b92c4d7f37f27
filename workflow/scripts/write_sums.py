"""Checksums of all products, as their jobs recorded them."""

from pathlib import Path

from chenhorng.job_log import job, require_as_made

with job(snakemake) as output:
    place, logs = Path(snakemake.output.sums).parent, Path(snakemake.log[0]).parent
    sums = require_as_made(snakemake.input, logs)
    products = sorted(snakemake.input)
    lines = [f"{sums[path]}  {Path(path).relative_to(place)}\n" for path in products]
    output.sums.write_text("".join(lines), encoding="utf-8")
    print(f"{len(products)} products")
