# The index page, the checksums of all products, and the last line of a run.
import json
import logging
import os
import time
from importlib.metadata import version

# on a full disk, lines that do not fit into Snakemake's log are dropped
logging.raiseExceptions = False

# before the run starts, where Snakemake would end with a traceback
for folder in [RESULTS, LOGS]:
    if Path(folder).is_dir() and not os.access(folder, os.W_OK):
        sys.exit(f"{folder} is read-only; allowed: a writable folder")

AHEAD = 300.0  # [s] by which clocks of a cluster may differ
INPUTS = (path for path in PACKAGE.rglob("*") if path.suffix != ".py")
for path in [*Path(RESULTS).rglob("*"), *INPUTS]:
    # Snakemake fails each job that reads such a file, and removes its products
    if path.is_file() and path.stat().st_mtime > time.time() + AHEAD:
        date = time.ctime(path.stat().st_mtime)
        sys.exit(f"{path} is dated {date}; allowed: no date in the future (touch gives it today's)")


# intermediate files
INTERMEDIATE = [
    *expand("<results>/schematics/{figure}.nc", figure=SCHEMATICS),
    *expand(
        "<results>/extracted/{kind}/{figure}.csv", kind=["tpca_loads", "transitions"], figure=SCENES
    ),
    *expand(
        "<results>/extracted/{kind}/all.csv", kind=["tpca_windows", "printed", "table1", "table2"]
    ),
    *expand("<results>/extracted/sensitivity/{kind}.csv", kind=["elasticities", "sobol_indices"]),
]


rule write_index:
    input:
        captions=expand("<results>/figures/{figure}.md", figure=FIGURES),
        thumbnails=expand("<results>/figures/{figure}.png", figure=FIGURES),
        tables=expand("<results>/tables/{table}.html", table=TABLES),
        verdicts="<results>/claims/claims.json",
        explorer="<results>/explorer/index.html",
        datasets=expand("<results>/datasets/{figure}.nc", figure=SCENES),
        page_template=project_file("workflow/templates/index.html"),
        captions_template=project_file("workflow/templates/captions.md"),
    output:
        page="<results>/index.html",
        captions="<results>/captions.md",
    log:
        "<logs>/write_index.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        titles={figure: settings["scenes"][figure]["title"] for figure in SCENES},
        version=version("thirdbody"),
        sources=sources_of("write_index.py"),
    message:
        "Writing the index page"
    script:
        "../scripts/write_index.py"


rule write_sums:
    input:
        INTERMEDIATE,
        PRODUCTS,
        rules.write_index.output,
    output:
        sums="<results>/SHA256SUMS",
    log:
        "<logs>/write_sums.log",
    conda:
        "../envs/thirdbody.yaml"
    params:
        folder=lambda wildcards, output: Path(output.sums).parent,
    message:
        "Writing the checksums of all products"
    script:
        "../scripts/write_sums.py"


onstart:
    # before any work, but not whenever rules are read: it takes longer than all other settings
    from thirdbody.study.claims import load_claims

    try:
        load_claims(configured("claims"))
    except ValueError as error:
        sys.exit(str(error))


onsuccess:
    if Path(RESULTS, "index.html").is_file():
        with open(f"{RESULTS}/claims/claims.json", encoding="utf-8") as judged:
            print(json.load(judged)["score"].replace("**", ""))
        print(f"Open {RESULTS}/index.html in a browser")


onerror:
    print("Finished products are kept: the same command continues from there")
