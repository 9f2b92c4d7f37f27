"""Every dataset, table and figure of Chen & Horng (2024), from the printed equations."""

import sys
from pathlib import Path

from thirdbody.closure import import_closure
from thirdbody.configuration import (
    read_plain,
    read_yaml,
    with_one_reading,
    workflow_settings,
)

try:
    read_plain("config/config.yaml", "config/scenes.yaml", *workflow.overwrite_configfiles)
except ValueError as error:
    sys.exit(f"{error}")


configfile: "config/config.yaml"
configfile: "config/scenes.yaml"


try:
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
        "results/tables/table2.csv",
        "results/tables/tpca_loads.csv",
        "results/tables/tpca_windows.csv",
        "results/tables/transitions.csv",
        "results/tables/sensitivity.csv",
        "results/figures/fig01.png",
        "results/figures/fig02.png",
        "results/figures/fig03.png",
        "results/figures/fig04.png",
        "results/figures/fig05.png",
        "results/figures/fig06.png",
        "results/figures/fig07.png",
        "results/figures/fig08.png",
        "results/figures/fig09.png",
        "results/figures/fig10.png",
        "results/figures/fig11.png",
        "results/figures/fig12.png",
        "results/figures/fig13.png",
        "results/figures/claims.png",
        "results/figures/conflict.png",
        "results/figures/sensitivity.png",
        "results/claims/claims.csv",
        "results/claims/claims.md",
        "results/claims/conflict.csv",
        "results/accuracy/solver_cost.csv",
