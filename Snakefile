# Every dataset, table and figure of Chen & Horng (2024), from the printed equations: snakemake -c2

import re
import sys
from snakemake.utils import min_version
from thirdbody.paper.configuration.settings import read_settings

min_version("9.12")


include: "rules/common.smk"


# Snakemake does not quote the interpreter of a script
if not re.fullmatch(r"[\w/.,:@%+~-]+", sys.executable):
    sys.exit(
        f"the path {sys.executable} has a blank or a sign of the shell; allowed: a folder whose path has none"
    )

# before Snakemake reads the files: its errors do not give the location
try:
    settings = read_settings(config, CONFIG, *workflow.overwrite_configfiles)
except ValueError as error:
    sys.exit(str(error))


configfile: f"{CONFIG}/config.yaml"
configfile: f"{CONFIG}/scenes.yaml"


# a named run keeps all its files in results/NAME
RESULTS = f"results/{settings['run']}" if settings["run"] else "results"
LOGS = f"{RESULTS}/logs" if settings["run"] else "logs"

SCHEMATICS = ["fig01", "fig02"]
SCENES = [name for name in settings["scenes"] if name.startswith("fig")]
FIGURES = [*SCHEMATICS, *SCENES, "claims", "sensitivity"]
TABLES = [
    *["table1", "table2", "tpca_loads", "tpca_windows", "transitions"],
    *["sensitivity", "deviations", "departures"],
]
CHARTS = ["largest_particle", "least_viscosity"]  # of the atlas
FIGURE_KINDS = ["svg", "pdf", "png", "csv", "md", "json"]
TABLE_KINDS = ["csv", "html", "tex"]
SOFTWARE = settings["software"]


pathvars:
    results=RESULTS,
    logs=LOGS,


report: "report/workflow.rst"


wildcard_constraints:
    scene="|".join(settings["scenes"]),
    schematic="|".join(SCHEMATICS),


rule all:
    default_target: True
    input:
        expand("<results>/datasets/{figure}.nc", figure=SCENES),
        expand("<results>/bands/{figure}.nc", figure=SCENES if settings["bands"] else []),
        expand("<results>/schematics/{figure}.nc", figure=SCHEMATICS),
        expand("<results>/extracted/tpca_loads/{figure}.csv", figure=SCENES),
        expand("<results>/extracted/transitions/{figure}.csv", figure=SCENES),
        "<results>/extracted/tpca_windows/all.csv",
        "<results>/extracted/sensitivity/all.csv",
        "<results>/extracted/printed/all.csv",
        "<results>/extracted/table1/all.csv",
        "<results>/extracted/table2/all.csv",
        expand("<results>/figures/{figure}.{kind}", figure=FIGURES, kind=FIGURE_KINDS),
        expand("<results>/figures/{figure}_wide.csv", figure=SCENES),
        expand("<results>/tables/{table}.{kind}", table=TABLES, kind=TABLE_KINDS),
        expand("<results>/claims/claims.{kind}", kind=["csv", "json", "md", "html"]),
        "<results>/explorer/index.html",
        "<results>/index.html",
        "<results>/captions.md",
        "<results>/SHA256SUMS",


include: "rules/datasets.smk"
include: "rules/extract.smk"
include: "rules/render.smk"
include: "rules/claims.smk"
include: "rules/explorer.smk"
include: "rules/publish.smk"
# on demand: snakemake -c2 calibrate, atlas, accuracy, release
include: "rules/shortlist.smk"
include: "rules/search.smk"
include: "rules/calibrate.smk"
include: "rules/atlas.smk"


# the repository alone has benchmarks, and the sources that go into a release
if (HOME / "benchmarks").is_dir():

    include: "rules/accuracy.smk"


if Path.cwd() == HOME:

    include: "rules/archive.smk"
