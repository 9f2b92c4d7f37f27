"""Every dataset, table and figure of Chen & Horng (2024), from the printed equations."""

import logging
import sys
from pathlib import Path
from runpy import run_path

from snakemake.utils import update_config

# on a full disk every line that does not fit into a log would be a traceback
logging.raiseExceptions = False
if workflow.is_main_process:
    run_path("src/thirdbody/bytecode.py")["prepare_bytecode"]("src/thirdbody", "verification")

from thirdbody.closure import import_closure
from thirdbody.configuration import (
    read_changes,
    read_plain,
    with_one_reading,
    workflow_settings,
)
from thirdbody.custody import hold_alone, remove_damaged, require_writable

try:
    read_plain("config/config.yaml", "config/scenes.yaml", *workflow.overwrite_configfiles)
except ValueError as error:
    sys.exit(f"{error}")


configfile: "config/config.yaml"
configfile: "config/scenes.yaml"


try:
    update_config(config, read_changes(config.pop("changes", None)))
    settings = workflow_settings(config)
except ValueError as error:
    sys.exit(f"{error}")


wildcard_constraints:
    figure="[a-z][a-z0-9_]*",
    table="[a-z0-9_]+",


include: "workflow/rules/datasets.smk"
include: "workflow/rules/extract.smk"
include: "workflow/rules/render.smk"
include: "workflow/rules/calibrate.smk"
include: "workflow/rules/judge.smk"
include: "workflow/rules/claims.smk"
include: "workflow/rules/sensitivity.smk"
include: "workflow/rules/band.smk"
include: "workflow/rules/accuracy.smk"


# jobs read this file too, while the run that started them holds the folder
if workflow.is_main_process and not workflow.output_settings.dryrun:
    try:
        held = hold_alone(".snakemake/thirdbody.lock")
        require_writable("results")
        for product in remove_damaged("logs"):
            print(f"{product} is not as it was made: removed", file=sys.stderr)
    except OSError as error:
        sys.exit(f"{error}")


rule all:
    default_target: True
    input:
        "results/datasets/fig03.nc",
        "results/datasets/fig04.nc",
        "results/datasets/fig05.nc",
        "results/datasets/fig06.nc",
        "results/datasets/fig07.nc",
        "results/datasets/fig08.nc",
        "results/datasets/fig09.nc",
        "results/datasets/fig10.nc",
        "results/datasets/fig11.nc",
        "results/datasets/fig12.nc",
        "results/datasets/fig13.nc",
        "results/tables/table1.csv",
        "results/tables/table1.json",
        "results/tables/table1.md",
        "results/tables/table1.tex",
        "results/tables/table2.csv",
        "results/tables/table2.json",
        "results/tables/table2.md",
        "results/tables/table2.tex",
        "results/tables/tpca_loads.csv",
        "results/tables/tpca_loads.json",
        "results/tables/tpca_loads.md",
        "results/tables/tpca_loads.tex",
        "results/tables/tpca_windows.csv",
        "results/tables/tpca_windows.json",
        "results/tables/tpca_windows.md",
        "results/tables/tpca_windows.tex",
        "results/tables/transitions.csv",
        "results/tables/transitions.json",
        "results/tables/transitions.md",
        "results/tables/transitions.tex",
        "results/tables/sensitivity.csv",
        "results/tables/sensitivity.json",
        "results/tables/sensitivity.md",
        "results/tables/sensitivity.tex",
        "results/figures/fig01.svg",
        "results/figures/fig01.pdf",
        "results/figures/fig01.png",
        "results/figures/fig01.csv",
        "results/figures/fig02.svg",
        "results/figures/fig02.pdf",
        "results/figures/fig02.png",
        "results/figures/fig02.csv",
        "results/figures/fig03.svg",
        "results/figures/fig03.pdf",
        "results/figures/fig03.png",
        "results/figures/fig03.csv",
        "results/figures/fig04.svg",
        "results/figures/fig04.pdf",
        "results/figures/fig04.png",
        "results/figures/fig04.csv",
        "results/figures/fig05.svg",
        "results/figures/fig05.pdf",
        "results/figures/fig05.png",
        "results/figures/fig05.csv",
        "results/figures/fig06.svg",
        "results/figures/fig06.pdf",
        "results/figures/fig06.png",
        "results/figures/fig06.csv",
        "results/figures/fig07.svg",
        "results/figures/fig07.pdf",
        "results/figures/fig07.png",
        "results/figures/fig07.csv",
        "results/figures/fig08.svg",
        "results/figures/fig08.pdf",
        "results/figures/fig08.png",
        "results/figures/fig08.csv",
        "results/figures/fig09.svg",
        "results/figures/fig09.pdf",
        "results/figures/fig09.png",
        "results/figures/fig09.csv",
        "results/figures/fig10.svg",
        "results/figures/fig10.pdf",
        "results/figures/fig10.png",
        "results/figures/fig10.csv",
        "results/figures/fig11.svg",
        "results/figures/fig11.pdf",
        "results/figures/fig11.png",
        "results/figures/fig11.csv",
        "results/figures/fig12.svg",
        "results/figures/fig12.pdf",
        "results/figures/fig12.png",
        "results/figures/fig12.csv",
        "results/figures/fig13.svg",
        "results/figures/fig13.pdf",
        "results/figures/fig13.png",
        "results/figures/fig13.csv",
        "results/figures/claims.svg",
        "results/figures/claims.pdf",
        "results/figures/claims.png",
        "results/figures/claims.csv",
        "results/figures/conflict.svg",
        "results/figures/conflict.pdf",
        "results/figures/conflict.png",
        "results/figures/conflict.csv",
        "results/figures/sensitivity.svg",
        "results/figures/sensitivity.pdf",
        "results/figures/sensitivity.png",
        "results/figures/sensitivity.csv",
        "results/claims/claims.csv",
        "results/claims/claims.md",
        "results/claims/conflict.csv",
        "results/accuracy/solver_cost.csv",


include: "workflow/rules/archive.smk"
