# Every dataset, table and figure of Chen & Horng (2024): snakemake -c2

import atexit
import os
import platform
import time

import numpy
from snakemake.utils import min_version

min_version("9.12")
STARTED = time.time()

# Optional instructions of numpy, and the kernels of linear algebra, differ in the last bits. Without them
# x86-64 processors should make the same files, and it takes no longer: python -m benchmarks.processors
if platform.machine() in ("x86_64", "AMD64"):
    OPTIONAL = numpy.show_config(mode="dicts")["SIMD Extensions"].get("found", [])
    os.environ.setdefault("NPY_DISABLE_CPU_FEATURES", " ".join(OPTIONAL))
    os.environ.setdefault("OPENBLAS_CORETYPE", "Prescott")


# the library; the settings, checked; where files are; what a job depends on
include: "workflow/rules/common.smk"


# <results> and <logs> in the paths of all rules
pathvars:
    results=RESULTS,
    logs=LOGS,


report: "workflow/report/workflow.rst"


SCHEMATICS = ["fig01", "fig02"]
SCENES = [f"fig{number:02d}" for number in range(3, 14)]
FIGURES = [*SCHEMATICS, *SCENES, "claims", "sensitivity", "profiles"]
TABLES = [
    "table1",
    "table2",
    "tpca_loads",
    "tpca_windows",
    "transitions",
    "sensitivity",
    "deviations",
    "departures",
    "coverage",
    "coverage_of_sets",
    "profiles",
    "apparent_area",
    "limits",
    "held_out",
]
# the panel that shows a finding of the paper: its figure and letter
PANELS = {finding["panel"]: finding["of"] for finding in settings["findings"]}
PICTURES = ["svg", "pdf", "png"]
FIGURE_FORMATS = [*PICTURES, "csv", "md", "json"]
TABLE_FORMATS = ["csv", "html", "tex"]


wildcard_constraints:
    scene="|".join(settings["scenes"]),
    schematic="|".join(SCHEMATICS),


rule all:
    default_target: True
    input:
        expand("<results>/datasets/{figure}.nc", figure=SCENES),
        expand("<results>/bands/{figure}.nc", figure=SCENES if settings["bands"] else []),
        expand("<results>/extracted/tpca_loads/{figure}.csv", figure=SCENES),
        expand("<results>/extracted/transitions/{figure}.csv", figure=SCENES),
        "<results>/extracted/tpca_windows/all.csv",
        "<results>/extracted/sensitivity/all.csv",
        "<results>/extracted/printed/all.csv",
        "<results>/extracted/table1/all.csv",
        "<results>/extracted/table2/all.csv",
        expand("<results>/figures/{figure}.{format}", figure=FIGURES, format=FIGURE_FORMATS),
        expand("<results>/figures/{panel}.{format}", panel=PANELS, format=PICTURES),
        "<results>/extracted/apparent_area/all.csv",
        "<results>/extracted/limits/all.csv",
        expand("<results>/figures/{figure}_wide.csv", figure=SCENES),
        expand("<results>/tables/{table}.{format}", table=TABLES, format=TABLE_FORMATS),
        expand("<results>/claims/claims.{format}", format=["csv", "json", "md", "html"]),
        "<results>/explorer/index.html",
        "<results>/index.html",
        "<results>/captions.md",
        "<results>/SHA256SUMS",
    message:
        "All products of the paper"


onsuccess:
    page, judged = Path(RESULTS, "index.html"), Path(RESULTS, "claims/claims.json")
    if page.is_file() and page.stat().st_mtime >= STARTED:
        score = json.loads(judged.read_text(encoding="utf-8"))
        hold = f"{score['held']} of {score['judged']} statements hold"
        # at the end of the process, below what Snakemake says of its log
        atexit.register(print, f"{hold}; open {RESULTS}/index.html in a browser")


onerror:
    print("Finished products are kept: the same command continues from there")


include: "workflow/rules/solve.smk"
include: "workflow/rules/judge.smk"
include: "workflow/rules/draw.smk"
# on demand: snakemake -c2 atlas (in solve.smk), calibrate, accuracy, release
include: "workflow/rules/calibrate.smk"
include: "workflow/rules/measure.smk"


# a release has the sources, which only the repository has
if Path.cwd() == HOME:

    include: "workflow/rules/archive.smk"
