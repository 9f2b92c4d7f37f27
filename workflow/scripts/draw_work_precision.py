"""Draw the time over the true error of the library and of plain solvers."""

from benchmarks.work_precision import draw
from chenhorng.job_log import job
from chenhorng.tables import TABLES, read_csv
from thirdbody.plotting.drawing import save_figure

with job(snakemake) as output:
    rows = (read_csv(snakemake.input[name], TABLES[name]) for name in ("errors", "times"))
    save_figure(draw(*rows), output.figure)
