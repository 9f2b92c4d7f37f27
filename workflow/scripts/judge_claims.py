"""The verdict on every statement of the paper, as a table, as pages and as data."""

from thirdbody.configuration.inputs import read_calibrated, read_entries
from thirdbody.configuration.schema import read_valid
from thirdbody.data.files import atomic_write
from thirdbody.data.tables import TABLES, write_csv
from thirdbody.job_log import logged
from thirdbody.model.parameters import Parameters
from thirdbody.study.checks import Judge
from thirdbody.study.claims import load_claims
from thirdbody.study.page import claims_html, claims_json, claims_markdown
from thirdbody.study.verdicts import judge_everything


def judge_claims(
    claims, default, calibrated, earlier, settings, parameters, laid_over, table, text, page, data
):
    """Judge ``claims`` under the inputs of the file ``default``, with what is ``laid_over`` them, and
    under those of all ``calibrated`` interpretations that ``settings`` have."""
    judge_all = Judge(load_claims(claims), Parameters(**parameters), settings["newtons"])
    entries = read_entries()
    found = {path: read_calibrated(path, entries) for path in dict.fromkeys([default, *calibrated])}
    main = found[default]
    main = main | {
        "inputs": main["inputs"] | laid_over,
        "ensemble": [member | laid_over for member in main["ensemble"]],
    }
    compared = [
        found[path]
        for path in calibrated
        if found[path]["interpretation"] in settings["interpretations"]
    ]
    judged = judge_everything(judge_all, main, compared, settings)
    contents = (
        claims_markdown(judged, read_valid(earlier, "earlier_predictions")),
        claims_html(judged),
        claims_json(judged),
    )
    with atomic_write(table, text, page, data) as (table_part, *parts):
        write_csv(table_part, judged.table.to_dict("records"), TABLES["claims"])
        for part, content in zip(parts, contents, strict=True):
            part.write_text(content, encoding="utf-8")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        judge_claims(
            snakemake.input.claims,
            snakemake.input.default,
            snakemake.input.calibrated,
            snakemake.input.earlier,
            snakemake.params.settings,
            snakemake.params.parameters,
            snakemake.params.laid_over,
            snakemake.output.table,
            snakemake.output.text,
            snakemake.output.page,
            snakemake.output.data,
        )
