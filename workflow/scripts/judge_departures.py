"""Printed numbers beside computed ones, and the verdicts with departures from the print taken back."""

from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import job
from thirdbody.study.choice import printed_numbers
from thirdbody.study.claims import load_claims
from thirdbody.study.departures import departure_rows
from thirdbody.study.judge import Judge

with job(snakemake) as output:
    settings, parameters = snakemake.params.settings, snakemake.params.parameters
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, parameters, settings["newtons"])
    deviations = printed_numbers(claims, judge({}), settings["headline"])
    write_csv(output.deviations, deviations.to_dict("records"), TABLES["deviations"])
    write_csv(output.departures, departure_rows(judge, settings), TABLES["departures"])
    sizes = deviations["deviation"].abs()
    print(
        f"deviation of {len(sizes)} printed numbers: median {sizes.median():.2%}, mean {sizes.mean():.2%}"
    )
