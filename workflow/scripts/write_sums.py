"""Write the checksums of all products."""

from pathlib import Path

from chenhorng.job_log import job
from thirdbody.files import digest

with job(snakemake) as output:
    folder = Path(snakemake.output.sums).parent
    products = sorted(snakemake.input)
    lines = [f"{digest(path)}  {Path(path).relative_to(folder)}\n" for path in products]
    output.sums.write_text("".join(lines), encoding="utf-8")
    print(f"{len(lines)} products")
