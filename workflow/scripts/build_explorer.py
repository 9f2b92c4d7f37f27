"""Build the explorer, a web page, from figures, statements and inputs of the run."""

import json
from itertools import product
from pathlib import Path

from chenhorng.job_log import job
from chenhorng.page.build import page_content, page_text
from chenhorng.page.oils import OILS, TEMPERATURES, VISCOSITIES
from thirdbody.bearings import MATERIALS, USUAL_BEARING, bearing
from thirdbody.conditions import OIL_DENSITY
from thirdbody.core.parameters import Parameters
from thirdbody.ensembles import BODIES, PAPER_SETUP, Ensemble
from thirdbody.files import read_yaml


def rig_content(parameters):
    """The inputs of each combination of materials, and the oils, that the library accepts."""
    materials = []
    in_setup = Ensemble((parameters,), PAPER_SETUP)
    first, *_ = MATERIALS  # the material of the paper
    for names in product(MATERIALS, repeat=len(BODIES)):
        bodies = dict(zip(BODIES, names, strict=True))
        others = {body: name for body, name in bodies.items() if name != first}
        try:
            inputs = bearing(in_setup, **others).best.as_dict()
        except ValueError:  # particles softer than a surface
            continue
        changed = {name: n for name, n in inputs.items() if n != getattr(parameters, name)}
        materials.append(bodies | {"inputs": changed})
    numbers = "speed_m_per_s", "oil_density_kg_per_m3"
    return {
        "materials": materials,
        "oils": OILS,
        "usual_density": OIL_DENSITY,
        **{name: USUAL_BEARING[name][:2] for name in numbers},
        "temperature_C": TEMPERATURES,
        "oil_viscosity_cSt": VISCOSITIES,
    }


with job(snakemake) as output:
    parameters = snakemake.params.parameters
    unknowns = snakemake.params.unknowns
    entries = read_yaml(snakemake.params.entries)
    inputs = {
        name: entry | unknowns.get(name, {}) | {"value": parameters[name]}
        for name, entry in entries.items()
    }
    judged, departures, *figures = (
        json.loads(Path(path).read_text(encoding="utf-8"))
        for path in (
            snakemake.input.verdicts,
            snakemake.input.departures,
            *snakemake.input.figures,
        )
    )
    content = page_content(
        {Path(path).stem: each for path, each in zip(snakemake.input.figures, figures)},
        judged,
        departures,
        inputs,
        snakemake.params.ensemble,
        {row["symbol"]: row["printed"] for row in read_yaml(snakemake.params.tables)["table2"]},
        rig_content(Parameters(**parameters)),
    )
    output.page.write_text(page_text(content), encoding="utf-8")
    print(f"{output.page.stat().st_size} bytes")
