"""Compare printed with computed numbers, and judge the statements with each departure from the
print taken back."""

import json

from chenhorng.calibration.choice import printed_numbers
from chenhorng.claims.claims import load_claims
from chenhorng.claims.departures import departure_rows, departure_words
from chenhorng.claims.judge import Judge
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv

with job(snakemake) as output:
    settings, parameters = snakemake.params.settings, snakemake.params.parameters
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, parameters, settings["newtons"])
    default = judge({})
    taken_back = [judge(departure["inputs"]) for departure in settings["departures"]]
    deviations = printed_numbers(claims, default, settings["headline"])
    departures = departure_rows(judge, settings, default, taken_back)
    write_csv(output.deviations, deviations.to_dict("records"), TABLES["deviations"])
    write_csv(output.departures, departures, TABLES["departures"])
    words = departure_words(judge, settings, taken_back)
    output.verdicts.write_text(json.dumps(words, indent=1) + "\n", encoding="utf-8")
    sizes = deviations["deviation"].abs()
    print(
        f"deviation of {len(sizes)} printed numbers: "
        f"median {sizes.median():.2%}, mean {sizes.mean():.2%}"
    )
