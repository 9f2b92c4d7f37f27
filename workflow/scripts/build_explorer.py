"""Build the explorer: one page for a browser, from figures, statements and inputs of the run."""

import json
from pathlib import Path

from thirdbody.configuration.inputs import read_entries
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.files import atomic_write
from thirdbody.explorer.content import page_content
from thirdbody.explorer.page import page_text
from thirdbody.job_log import logged
from thirdbody.study.claims import load_claims


def build(
    points, captions, claims, verdicts, calibrated, parameters, calibration, ensemble, tables, page
):
    """Write the ``page`` from the ``points`` and ``captions`` of all figures of curves, the
    ``claims`` with their ``verdicts``, and the inputs of the run beside the ``calibrated`` ones.

    ``calibration`` are the settings of the search for inputs, ``ensemble`` the members of the
    ensemble, ``tables`` the paper's as printed.
    """
    entries = read_entries()
    interpretations = [read_yaml(path) for path in calibrated]
    inputs = {
        name: entry | calibration["unknowns"].get(name, {}) | {"value": parameters[name]}
        for name, entry in entries.items()
    }
    content = page_content(
        zip(points, captions, strict=True),
        load_claims(claims),
        json.loads(Path(verdicts).read_text(encoding="utf-8")),
        inputs,
        {each["interpretation"]: each["inputs"] for each in interpretations},
        ensemble,
        {row["symbol"]: row["printed"] for row in read_yaml(tables)["table2"]},
    )
    with atomic_write(page) as part:
        part.write_text(page_text(content), encoding="utf-8")
    print(f"{page}: {Path(page).stat().st_size} bytes")


if __name__ == "__main__":
    with logged(snakemake.log[0]):
        build(
            snakemake.input.points,
            snakemake.input.captions,
            snakemake.input.claims,
            snakemake.input.verdicts,
            snakemake.input.calibrated,
            snakemake.params.parameters,
            snakemake.params.calibration,
            snakemake.params.ensemble,
            snakemake.input.tables,
            snakemake.output.page,
        )
