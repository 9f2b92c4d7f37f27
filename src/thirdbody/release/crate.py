"""ro-crate-metadata.json: description and provenance of each file of an archive.

RO-Crate 1.1 (https://w3id.org/ro/crate/1.1) with the profile Workflow Run Crate 0.5
(https://w3id.org/ro/wfrun/workflow/0.5): the run and each of its jobs are a ``CreateAction``.
"""

from pathlib import Path, PurePosixPath
from typing import Any

from rocrate.model.entity import Entity
from rocrate.rocrate import ROCrate

from thirdbody.release.citation import Release
from thirdbody.release.files import files_in, media_type, render_json

METADATA = "ro-crate-metadata.json"
SCRIPTS = "source/workflow/scripts/"
WORKFLOW = "source/workflow/Snakefile"
CONFIGURATION = {"@id": "configuration/config.json"}
COMPLETED = {  # of each action
    "actionStatus": "http://schema.org/CompletedActionStatus",
    "agent": {"@id": "#developers"},
}
# folders of products, named as in results/, and their titles
KINDS = {
    "datasets": "solved points, one file a figure",
    "bands": "range of each quantity, 5 to 95 % (_low, _high), over the calibrated ensemble",
    "tables": "tables of the paper and what was extracted from the datasets",
    "figures": "figures, with the points drawn as CSV",
    "claims": "statements of the paper and their verdicts",
    "explorer": "a page for any browser: figures, statements and the model itself",
}
FOLDERS = {
    "configuration": "configuration of the run and the inputs of the model that follow from it",
    "source": "source code of the library, the workflow and the tests",
}


def crate(
    data: Path,
    kinds: dict[str, str],
    jobs: list[dict[str, Any]],
    software: dict[str, str],
    release: Release,
) -> dict[str, Any]:
    """Content of ``ro-crate-metadata.json`` for the folder ``data`` of an archive; ``kinds`` has the
    titles of its folders of products, ``jobs`` and ``software`` are as in ``stage``."""
    known = render_json("crate.json", kinds=kinds, software=software, release=release)
    described = ROCrate(version="1.1")  # extended by Workflow Run Crate 0.5
    for entity in known["entities"]:
        described.add_jsonld(entity)
    workflow = described.add_workflow(
        dest_path=WORKFLOW,
        main=True,
        lang="snakemake",
        lang_version=software["snakemake"],
        properties=_file_properties(WORKFLOW, release) | known["workflow"],
    )
    files = {WORKFLOW: workflow}
    for path in files_in(data, data):
        if path not in (METADATA, WORKFLOW):
            properties = _file_properties(path, release)
            files[path] = described.add_file(dest_path=path, properties=properties)
    for folder, title in (FOLDERS | kinds).items():
        properties = {"name": folder, "description": title}
        if folder in kinds:
            properties["exampleOfWork"] = {"@id": "#products"}
        entity = described.add_dataset(dest_path=f"{folder}/", properties=properties)
        entity["hasPart"] = [part for path, part in files.items() if path.startswith(f"{folder}/")]
    _add_actions(described, jobs, files, kinds, release)
    for name, value in known["root"].items():
        described.root_dataset[name] = value
    described.root_dataset["mentions"] = described.get_by_type("CreateAction")
    return described.metadata.generate()


def _file_properties(path: str, release: Release) -> dict[str, Any]:
    """Properties of a file, with its licence if it differs from that of the archive."""
    properties = {"name": PurePosixPath(path).name, "encodingFormat": media_type(path)}
    if path.startswith(SCRIPTS):
        properties["@type"] = ["File", "SoftwareSourceCode"]
        properties["programmingLanguage"] = "Python"
    if path == CONFIGURATION["@id"]:
        properties["exampleOfWork"] = {"@id": "#configuration"}
    if path.startswith("source/") and not path.startswith("source/config/"):
        properties["license"] = {"@id": f"https://spdx.org/licenses/{release.citation['license']}"}
    return properties


def _add_actions(described, jobs, files: dict[str, Entity], kinds, release: Release) -> None:
    """Add the run of the workflow and its jobs, including files that are not in the archive."""
    products = {path: file for path, file in files.items() if path.partition("/")[0] in kinds}
    described.add_action(
        files[WORKFLOW],
        "#run",
        object=[CONFIGURATION],
        result=list(products.values()),
        properties={"name": f"run of the workflow of {release.full_name}", **COMPLETED},
    )
    known = {f"results/{path}": file for path, file in products.items()}
    known |= {path.removeprefix("source/"): file for path, file in files.items()}
    about = "written by one job and read by another; not in the archive"
    for job in jobs:
        for path in (*job["inputs"], *job["outputs"]):
            if path not in known:
                written = {"@id": f"#{path}", "@type": "CreativeWork", "name": path}
                known[path] = described.add_jsonld(written | {"description": about})
        first = PurePosixPath(job["outputs"][0]).with_suffix("").as_posix()
        name = first.removeprefix("results/")
        described.add_action(
            files.get(f"{SCRIPTS}{job['rule']}.py", files[WORKFLOW]),
            f"#{job['rule']}/{name}",
            object=[known[path] for path in job["inputs"]] or [CONFIGURATION],
            result=[known[path] for path in job["outputs"]],
            properties={"name": f"{job['rule']} ({name})", **COMPLETED},
        )
