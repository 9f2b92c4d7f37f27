"""Compare printed with computed numbers, and judge the statements with each departure from the
print taken back."""

import json

from chenhorng.calibration.choice import printed_numbers
from chenhorng.claims.claims import load_claims
from chenhorng.claims.departures import departure_rows, departure_words, read_departures
from chenhorng.claims.judge import Judge
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    settings, parameters = snakemake.params.settings, snakemake.params.parameters
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, parameters, settings["newtons"])
    default = judge({})
    departures = read_departures(settings, parameters)
    taken_back = [judge(departure["inputs"]) for departure in departures]
    deviations = printed_numbers(claims, default, settings["headline"])
    rows = departure_rows(judge, settings, default, departures, taken_back)
    write_csv(output.deviations, deviations.to_dict("records"), TABLES["deviations"])
    write_csv(output.departures, rows, TABLES["departures"])
    words = departure_words(judge, departures, taken_back)
    output.verdicts.write_text(json.dumps(words, indent=1) + "\n", encoding="utf-8")
    sizes = deviations["deviation"].abs()
    print(
        f"deviation of {len(sizes)} printed numbers: "
        f"median {sizes.median():.2%}, mean {sizes.mean():.2%}"
    )
