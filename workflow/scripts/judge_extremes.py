"""The verdict on each extreme at which models of this kind break."""

from collections import Counter

from benchmarks.extremes import judge_extremes
from benchmarks.points import read_rows
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged


def judge(extremes, rtols, verdicts):
    """Write the verdict on each row of ``extremes`` for each of ``rtols``."""
    golden = read_rows(extremes)
    rows = [row for rtol in rtols for row in judge_extremes(golden, rtol)]
    with whole(verdicts) as part:
        write_csv(part, rows, TABLES["extremes"])
    print(dict(Counter(row["verdict"].partition(":")[0] for row in rows)))


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        judge(snakemake.input.extremes, snakemake.params.rtol, snakemake.output.verdicts)
