"""ro-crate-metadata.json: what each file of an archive is, and which was made from which.

RO-Crate 1.1 with the profile Workflow Run Crate 0.5: the run of the workflow is one
``CreateAction``, and each of its jobs is another.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from rocrate.model.entity import Entity
from rocrate.rocrate import ROCrate

from thirdbody.release.citation import DATA_LICENCE, SPDX, Release
from thirdbody.release.files import files_in, media_type

METADATA = "ro-crate-metadata.json"
SCRIPTS = "source/workflow/scripts/"
WORKFLOW = "source/workflow/Snakefile"
CONFIGURATION = "configuration/config.json"
DEVELOPERS = {"@id": "#developers"}
RO_CRATE = "1.1"  # the version that Workflow Run Crate 0.5 extends
PROFILES = {
    "https://w3id.org/ro/wfrun/process/0.5": ("Process Run Crate", "0.5"),
    "https://w3id.org/ro/wfrun/workflow/0.5": ("Workflow Run Crate", "0.5"),
    "https://w3id.org/workflowhub/workflow-ro-crate/1.0": ("Workflow RO-Crate", "1.0"),
}
BIOSCHEMAS_WORKFLOW = "https://bioschemas.org/profiles/ComputationalWorkflow/1.0-RELEASE"
# folders of products, called as in results/, and their titles
KINDS = {
    "datasets": "solved points, one file a figure",
    "bands": "lowest and highest value (_low, _high) of each quantity over calibrated inputs",
    "tables": "tables of the paper and what was extracted from the datasets",
    "figures": "figures, with the points drawn as CSV",
    "claims": "statements of the paper and their verdicts",
    "explorer": "a page for any browser: figures, statements and the model itself",
}
FOLDERS = {
    "configuration": "configuration of the run and the inputs of the model that follow from it",
    "source": "source code of the library, the workflow and the tests",
}


@dataclass(frozen=True)
class Run:
    """How the products were made.

    Attributes
    ----------
    settings : dict
        Configuration of the run; each entry becomes a file of its name in ``configuration/``.
    jobs : list of dict
        Jobs of the workflow: ``rule``, the name of its rule and script; ``inputs`` and ``outputs``,
        lists of paths relative to the root of the repository, products in ``results/``.  Other keys
        are ignored.
    software : dict
        Versions of the packages that the workflow ran on, by name.
    """

    settings: dict[str, dict[str, Any]]
    jobs: list[dict[str, Any]]
    software: dict[str, str]


def crate(data: Path, kinds: dict[str, str], run: Run, release: Release) -> dict[str, Any]:
    """Content of ``ro-crate-metadata.json``.

    Parameters
    ----------
    data : Path
        Folder of the archive that holds products, sources and configuration.
    kinds : dict
        Title of each folder of products in ``data``, by name.
    run, release
        The run that made the products, and the release that they are part of.

    References
    ----------
    https://w3id.org/ro/crate/1.1, https://w3id.org/ro/wfrun/workflow/0.5
    """
    described = ROCrate(version=RO_CRATE)
    _describe_context(described, run.software, release)
    files = {WORKFLOW: _describe_workflow(described, kinds, run.software, release)}
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
    _describe_run(described, run.jobs, files, kinds, release)
    _describe_root(described, release)
    return described.metadata.generate()


def _describe_root(described: ROCrate, release: Release) -> None:
    cited, root = release.citation, described.root_dataset
    described.name = cited["title"]
    described.description = cited["abstract"]
    described.datePublished = release.date
    described.license = {"@id": f"{SPDX}{DATA_LICENCE}"}
    described.publisher = DEVELOPERS
    described.keywords = ", ".join(cited["keywords"])
    described.isBasedOn = {"@id": release.paper_url}
    root["version"] = release.version
    root["author"] = DEVELOPERS
    root["conformsTo"] = [{"@id": profile} for profile in PROFILES]
    root["mentions"] = described.get_by_type("CreateAction")


def _describe_context(described: ROCrate, software: dict[str, str], release: Release) -> None:
    """Add what files refer to: profiles, licences, the software, people and the paper."""

    def add(identifier, kind, **properties):
        described.add_jsonld({"@id": identifier, "@type": kind, **properties})

    for profile, (name, number) in PROFILES.items():
        add(profile, "CreativeWork", name=name, version=number)
    for licence in (DATA_LICENCE, release.citation["license"]):
        add(f"{SPDX}{licence}", "CreativeWork", name=licence)
    for name, number in software.items():
        add(_package_url(name, number), "SoftwareApplication", name=name, version=number)
    add(DEVELOPERS["@id"], "Organization", name=", ".join(release.authors))
    paper = {"name": release.paper["title"], "creditText": release.paper_text}
    add(release.paper_url, "ScholarlyArticle", **paper)


def _package_url(name: str, number: str) -> str:
    return f"pkg:pypi/{name.lower()}@{number}"


def _describe_workflow(described, kinds, software, release: Release) -> Entity:
    """Add the workflow: its configuration goes in, the products come out."""
    configuration = described.add_formal_parameter(
        "configuration",
        "File",
        identifier="#configuration",
        description="what is computed, and the inputs of the model",
        valueRequired=True,
        properties={"workExample": {"@id": CONFIGURATION}},
    )
    products = described.add_formal_parameter(
        "products",
        "Dataset",
        identifier="#products",
        description=", ".join(kinds),
        properties={"workExample": [{"@id": f"{kind}/"} for kind in kinds]},
    )
    properties = {
        "name": f"workflow of {release.full_name}",
        "version": release.version,
        "creator": DEVELOPERS,
        "conformsTo": {"@id": BIOSCHEMAS_WORKFLOW},
        "input": configuration,
        "output": products,
        "softwareRequirements": [{"@id": _package_url(*pair)} for pair in software.items()],
    }
    return described.add_workflow(
        dest_path=WORKFLOW,
        main=True,
        lang="snakemake",
        lang_version=software["snakemake"],
        properties=_file_properties(WORKFLOW, release) | properties,
    )


def _file_properties(path: str, release: Release) -> dict[str, Any]:
    """Properties of a file, with its licence if that is not the one of the archive."""
    properties = {"name": PurePosixPath(path).name, "encodingFormat": media_type(path)}
    if path.startswith(SCRIPTS):
        properties["@type"] = ["File", "SoftwareSourceCode"]
        properties["programmingLanguage"] = "Python"
    if path == CONFIGURATION:
        properties["exampleOfWork"] = {"@id": "#configuration"}
    if path.startswith("source/") and not path.startswith("source/config/"):
        properties["license"] = {"@id": f"{SPDX}{release.citation['license']}"}
    return properties


def _describe_run(described, jobs, files: dict[str, Entity], kinds, release: Release) -> None:
    """Add the run of the whole workflow and its jobs, with the files that are not in the archive."""
    products = {path: file for path, file in files.items() if path.partition("/")[0] in kinds}
    known = {f"results/{path}": file for path, file in products.items()}
    known |= {path.removeprefix("source/"): file for path, file in files.items()}
    configuration = {"@id": CONFIGURATION}
    name = f"run of the workflow of {release.full_name}"
    results = list(products.values())
    _add_action(described, "#run", files[WORKFLOW], name, [configuration], results)
    for job in jobs:
        for path in (*job["inputs"], *job["outputs"]):
            if path not in known:
                known[path] = _add_intermediate(described, path)
        first = PurePosixPath(job["outputs"][0]).with_suffix("").as_posix()
        name = first.removeprefix("results/")
        _add_action(
            described,
            f"#{job['rule']}/{name}",
            files.get(f"{SCRIPTS}{job['rule']}.py", files[WORKFLOW]),
            f"{job['rule']} ({name})",
            [known[path] for path in job["inputs"]] or [configuration],
            [known[path] for path in job["outputs"]],
        )


def _add_action(described, identifier, instrument, name, inputs, outputs) -> None:
    described.add_action(
        instrument,
        identifier=identifier,
        object=inputs,
        result=outputs,
        properties={
            "@type": "CreateAction",
            "name": name,
            "actionStatus": "http://schema.org/CompletedActionStatus",
            "agent": DEVELOPERS,
        },
    )


def _add_intermediate(described, path: str) -> Entity:
    about = "written by one job and read by another; not in the archive"
    return described.add_jsonld(
        {"@id": f"#{path}", "@type": "CreativeWork", "name": path, "description": about}
    )
