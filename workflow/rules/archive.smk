# The release: one folder, one archive file of it, and beside them the record of their making.
import sys

from thirdbody.release.citation import Release, software_versions
from thirdbody.run.jobs import jobs_behind
from thirdbody.release.sources import source_files

try:
    RELEASE = Release.of("pyproject.toml", "CITATION.cff")
except ValueError as error:
    sys.exit(f"{error}")

# nothing but the paper's configuration is sealed under the name and version of the project
IS_CHANGED = config != {key: value for key, value in PAPER.items() if key != "run"}
if IS_CHANGED:
    RELEASE = RELEASE.of_other_configuration()

# what is measured on a machine differs from run to run: it goes to the record
MEASURED = f"{PLACES.products}/accuracy/"


rule release:
    input:
        archive=f"<results>/release/{RELEASE.full_name}.zip",
        provenance="<results>/release/provenance.json",
    message:
        "The release is made"


rule stage_release:
    input:
        products=[path for path in rules.all.input if not path.startswith(MEASURED)],
        bands=branch(
            settings["bands"],
            then=expand("<results>/bands/{figure}.nc", figure=CURVE_FIGURES),
            otherwise=[],
        ),
        sources=source_files(),
        modules=import_closure("workflow/scripts/stage_release.py"),
    output:
        sealed=f"<results>/release/{RELEASE.full_name}/tagmanifest-sha512.txt",
    log:
        "<logs>/stage_release.log",
    benchmark:
        "<logs>/stage_release.tsv"
    localrule: True
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        settings={"config": config, "parameters": settings["parameters"]},
        jobs=lambda wildcards, input: jobs_behind(
            [*input.products, *input.bands], workflow.rules, PLACES
        ),
        software=software_versions("pyproject.toml"),
        is_changed=IS_CHANGED,
    message:
        "Filling the folder of the release"
    script:
        "../scripts/stage_release.py"


rule pack_release:
    input:
        sealed=rules.stage_release.output.sealed,
        modules=import_closure("workflow/scripts/pack_release.py"),
    output:
        archive=f"<results>/release/{RELEASE.full_name}.zip",
    log:
        "<logs>/pack_release.log",
    benchmark:
        "<logs>/pack_release.tsv"
    localrule: True
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    params:
        date=RELEASE.date,
    message:
        "Packing the release"
    script:
        "../scripts/pack_release.py"


rule record_provenance:
    input:
        archive=rules.pack_release.output.archive,
        cost="<results>/accuracy/solver_cost.csv",
        modules=import_closure("workflow/scripts/record_provenance.py"),
    output:
        provenance="<results>/release/provenance.json",
    log:
        "<logs>/record_provenance.log",
    benchmark:
        "<logs>/record_provenance.tsv"
    localrule: True
    conda:
        "../envs/thirdbody.yaml"
    threads: 1
    message:
        "Recording when and where the release was made"
    script:
        "../scripts/record_provenance.py"
