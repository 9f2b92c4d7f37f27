"""Scores of the statements of Figures 4, 6 and 11 under calibrated readings."""

from thirdbody.configuration.inputs import read_calibrated
from thirdbody.data.files import logged, whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.model.parameters import Parameters
from thirdbody.study.claims import load_claims
from thirdbody.study.conflict import conflict_rows


def judge_conflict(claims, calibrated, newtons, parameters, table):
    """Write a row for each reading of the files ``calibrated``, member and statement."""
    readings = [read_calibrated(path) for path in calibrated]
    base = Parameters(**parameters)
    with whole(table) as part:
        rows = conflict_rows(load_claims(claims), readings, base, newtons)
        write_csv(part, rows, TABLES["conflict"])


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        judge_conflict(
            snakemake.input.claims,
            snakemake.input.calibrated,
            snakemake.params.newtons,
            snakemake.params.parameters,
            snakemake.output.table,
        )
