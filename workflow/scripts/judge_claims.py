"""Judge every statement of the paper; write the verdicts as a table, as pages and as data."""

from chenhorng.calibration.choice import printed_numbers
from chenhorng.claims.claims import load_claims
from chenhorng.claims.judge import Judge
from chenhorng.claims.verdicts import Report, claims_html, claims_json, claims_markdown
from chenhorng.coverage import printed_and_ranges
from chenhorng.job_log import job
from chenhorng.tables import TABLES, write_csv
from thirdbody.files import read_yaml

with job(snakemake) as output:
    calibrated = snakemake.params.calibrated
    settings = snakemake.params.settings
    claims = load_claims(snakemake.params.claims)
    judge = Judge(claims, snakemake.params.base, settings["newtons"])
    contents = [read_yaml(path) for path in calibrated]
    default = read_yaml(snakemake.params.default)
    names = settings["interpretations"]
    compared = [content for content in contents if content["interpretation"] in names]
    report = Report.of(
        judge,
        default,
        compared,
        settings,
        inputs=snakemake.params.parameters,
        ensemble=snakemake.params.ensemble,
    )
    # the ensemble of a run with other inputs is not the one that has not seen some figures
    unseen = default["unseen"] if report.has_calibrated_inputs else []
    numbers = printed_numbers(claims, report.verdicts, settings["headline"])
    covered = printed_and_ranges(claims, numbers, report.members, unseen) if unseen else []
    write_csv(output.coverage, covered, TABLES["coverage"])
    write_csv(output.table, report.table.to_dict("records"), TABLES["claims"])
    output.text.write_text(claims_markdown(report), encoding="utf-8")
    output.page.write_text(claims_html(report), encoding="utf-8")
    output.data.write_text(claims_json(report), encoding="utf-8")
