"""The verdict on every statement of the paper, as a table and as text."""

from thirdbody.configuration.inputs import read_calibrated, read_entries
from thirdbody.data.files import whole
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.calibration import Reading
from thirdbody.study.claims import load_claims
from thirdbody.study.verdict_text import claims_html, claims_json, claims_markdown
from thirdbody.study.verdicts import Court, Trial, verdict_rows


def judge_claims(
    claims, default, calibrated, settings, parameters, laid_over, table, text, page, data
):
    """Judge ``claims`` under the inputs of the file ``default``, with what is ``laid_over`` them, and
    under those of all ``calibrated``."""
    court = Court(load_claims(claims), Parameters(**parameters), tuple(settings["newtons"]))
    entries = read_entries()
    found = {path: read_calibrated(path, entries) for path in dict.fromkeys([default, *calibrated])}
    main, readings = found[default], [found[path] for path in calibrated]
    main = main | {
        "inputs": main["inputs"] | laid_over,
        "ensemble": [member | laid_over for member in main["ensemble"]],
    }
    trial = Trial.of(court, main, Reading.of(main["reading"], settings), readings)
    given = trial, main, readings, settings["headline"]
    contents = claims_markdown(*given), claims_html(trial), claims_json(*given)
    with whole(table, text, page, data) as (table_part, *parts):
        write_csv(table_part, verdict_rows(trial), TABLES["claims"])
        for part, content in zip(parts, contents, strict=True):
            part.write_text(content, encoding="utf-8")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        judge_claims(
            snakemake.input.claims,
            snakemake.input.default,
            snakemake.input.calibrated,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.params.laid_over,
            snakemake.output.table,
            snakemake.output.text,
            snakemake.output.page,
            snakemake.output.data,
        )
