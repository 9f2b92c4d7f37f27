"""Printed numbers beside computed ones, and the verdicts with departures from the print taken back."""

from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.study.choice import printed_numbers
from thirdbody.study.claims import load_claims
from thirdbody.study.departures import departure_rows
from thirdbody.study.judge import Judge

with logged(snakemake.log[0]):
    settings, parameters = snakemake.params.settings, snakemake.params.parameters
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, parameters, settings["newtons"])
    deviations = printed_numbers(claims, judge({}), settings["headline"])
    tables = {
        "deviations": deviations.to_dict("records"),
        "departures": departure_rows(judge, settings),
    }
    with atomic_write(*snakemake.output) as parts:
        for part, (name, rows) in zip(parts, tables.items(), strict=True):
            write_csv(part, rows, TABLES[name])
    sizes = deviations["deviation"].abs()
    print(
        f"deviation of {len(sizes)} printed numbers: median {sizes.median():.2%}, mean {sizes.mean():.2%}"
    )
