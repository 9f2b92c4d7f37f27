"""Write the checksums of all products; each product must be as its job made it."""

from pathlib import Path

from chenhorng.job_log import job, require_as_made

with job(snakemake) as output:
    folder = Path(snakemake.output.sums).parent
    sums = require_as_made(sorted(snakemake.input))
    lines = [f"{digits}  {Path(path).relative_to(folder)}\n" for path, digits in sums.items()]
    output.sums.write_text("".join(lines), encoding="utf-8")
    print(f"{len(lines)} products")
