"""The verdict on every statement of the paper, as a table, as pages and as data."""

from thirdbody.inputs import ensemble_of, read_calibrated, read_entries
from thirdbody.paper.claims.claims import load_claims
from thirdbody.paper.claims.judge import Judge
from thirdbody.paper.claims.verdicts import Report, claims_html, claims_json, claims_markdown
from thirdbody.paper.job_log import job
from thirdbody.paper.tables import TABLES, write_csv

with job(snakemake) as output:
    default = snakemake.params.default
    calibrated = snakemake.params.calibrated
    settings = snakemake.params.settings
    laid_over = snakemake.params.laid_over
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.parameters, settings["newtons"])
    entries = read_entries()
    found = {path: read_calibrated(path, entries) for path in dict.fromkeys([default, *calibrated])}
    main = found[default] | {
        "inputs": found[default]["inputs"] | laid_over,
        "ensemble": ensemble_of(found[default], laid_over),
    }
    compared = [
        found[path]
        for path in calibrated
        if found[path]["interpretation"] in settings["interpretations"]
    ]
    report = Report.of(judge, main, compared, settings)
    write_csv(output.table, report.table.to_dict("records"), TABLES["claims"])
    output.text.write_text(claims_markdown(report), encoding="utf-8")
    output.page.write_text(claims_html(report), encoding="utf-8")
    output.data.write_text(claims_json(report), encoding="utf-8")
