# The release: a folder, its archive file, and their provenance.
from chenhorng.archive.citation import Release, software_versions
from chenhorng.archive.files import source_files

# only the configuration of the paper is archived under the name and version of the project
RELEASE = Release.of("pyproject.toml", "CITATION.cff", settings["is_paper"])
RECORD = f"<results>/release/{RELEASE.full_name}-provenance.json"

# these serve the workflow; the archive has its own sums
NOT_RELEASED = {"extracted", "SHA256SUMS"}


rule release:
    input:
        archive=f"<results>/release/{RELEASE.full_name}.zip",
        provenance=RECORD,
    message:
        "The release {input.archive}"


rule stage_release:
    input:
        products=[file for file in rules.all.input if NOT_RELEASED.isdisjoint(Path(file).parts)],
        sources=lambda wildcards: source_files(),
    output:
        sealed=f"<results>/release/{RELEASE.full_name}/tagmanifest-sha256.txt",
    log:
        "<logs>/stage_release.log",
    localrule: True
    params:
        *sources_of("stage_release.py"),
        settings={"config": settings["config"], "parameters": settings["parameters"]},
        software=software_versions("pyproject.toml"),
        is_paper=settings["is_paper"],
    message:
        "Gather the release"
    script:
        "../scripts/stage_release.py"


rule pack_release:
    input:
        sealed=rules.stage_release.output.sealed,
    output:
        archive=f"<results>/release/{RELEASE.full_name}.zip",
        provenance=RECORD,
    log:
        "<logs>/pack_release.log",
    localrule: True
    params:
        *sources_of("pack_release.py"),
    message:
        "Pack the release"
    script:
        "../scripts/pack_release.py"
