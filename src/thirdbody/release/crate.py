"""ro-crate-metadata.json: what each file of an archive is, and which was made from which.

The description is an RO-Crate 1.1 with the profile Workflow Run Crate 0.5: a graph of entities that
refer to each other by ``@id``.  The run of the workflow is one ``CreateAction``; each of its jobs
is another, with the script of its rule as the instrument.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from thirdbody.release.bag import files_in
from thirdbody.release.citation import DATA_LICENCE, SPDX, Release
from thirdbody.release.media import media_type

METADATA = "ro-crate-metadata.json"
WORKFLOW = "source/workflow/Snakefile"
CONFIGURATION = "configuration/config.json"
CONTEXT = "https://w3id.org/ro/crate/1.1/context"
SPECIFICATION = "https://w3id.org/ro/crate/1.1"
WORKFLOW_CRATE = "https://w3id.org/workflowhub/workflow-ro-crate/1.0"
PROFILES = {
    "https://w3id.org/ro/wfrun/process/0.5": ("Process Run Crate", "0.5"),
    "https://w3id.org/ro/wfrun/workflow/0.5": ("Workflow Run Crate", "0.5"),
    WORKFLOW_CRATE: ("Workflow RO-Crate", "1.0"),
}
LANGUAGE = "https://w3id.org/workflowhub/workflow-ro-crate#snakemake"
DEVELOPERS = "#developers"
COMPLETED = "http://schema.org/CompletedActionStatus"
BIOSCHEMAS = "https://bioschemas.org/profiles"
# Folders of products and their titles; they are called alike in results/ and in an archive.
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
class Job:
    """A job of the workflow.

    Paths are those that the workflow uses, relative to the root of the repository.

    Attributes
    ----------
    rule : str
        Name of its rule.
    wildcards : dict
        Values of the rule's wildcards, by name.
    script : str
        Path of the script that the rule runs.
    modules : list of str
        Paths of the modules of the project that the script imports, directly or not.
    inputs, outputs : list of str
        Paths of the files that it reads and writes.
    configured : bool
        Whether it takes parameters from the configuration.
    """

    rule: str
    wildcards: dict[str, str]
    script: str
    modules: list[str]
    inputs: list[str]
    outputs: list[str]
    configured: bool

    @property
    def name(self) -> str:
        """Rule and values of the wildcards, for readers."""
        values = ", ".join(self.wildcards.values())
        return f"{self.rule} ({values})" if values else self.rule


@dataclass(frozen=True)
class Run:
    """How the products were made.

    Attributes
    ----------
    settings : dict
        What the workflow was given; each entry becomes a file of this name in the archive.
    jobs : list of Job
        Jobs that made the products.
    software : dict
        Versions of the packages that the workflow ran on, by name.
    """

    settings: dict[str, dict[str, Any]]
    jobs: list[Job]
    software: dict[str, str]


def crate(data: Path, kinds: dict[str, str], run: Run, release: Release) -> dict[str, Any]:
    """Describe the files of an archive and how they were made.

    Parameters
    ----------
    data : Path
        Folder of the archive that holds products, sources and configuration.
    kinds : dict
        Title of each folder of products in ``data``, by name.
    run : Run
        The run of the workflow that made the products.
    release : Release
        What the archive is of.

    Returns
    -------
    dict
        Content of ``ro-crate-metadata.json``.

    Raises
    ------
    KeyError
        If the script or a module of a job is not among the files in ``data``.

    References
    ----------
    https://w3id.org/ro/crate/1.1, https://w3id.org/ro/wfrun/workflow/0.5

    Examples
    --------
    In the root of the repository:

    >>> import tempfile
    >>> release = Release.of("pyproject.toml", "CITATION.cff")
    >>> with tempfile.TemporaryDirectory() as place:
    ...     tables = Path(place, "tables")
    ...     tables.mkdir()
    ...     (tables / "table1.csv").touch()
    ...     run = Run(settings={}, jobs=[], software={"snakemake": "9.0.0"})
    ...     described = crate(Path(place), {"tables": "tables of the paper"}, run, release)
    >>> [entity["name"] for entity in described["@graph"] if entity["@type"] == "File"]
    ['table1.csv']
    """
    files = [path for path in files_in(data, data) if path != METADATA]
    folders = FOLDERS | kinds
    products = [path for path in files if path.partition("/")[0] in kinds]
    archived = {f"results/{path}": path for path in products}
    archived |= {path.removeprefix("source/"): path for path in files if path.startswith("source/")}
    scripts = _scripts(run.jobs, archived, release)
    graph = [
        *_root(files, folders, run.jobs, release),
        *_context(run.software, release),
        _workflow(scripts, run.software, release),
        *_parameters(kinds),
        *(_file(path, release) | scripts.get(path, {}) for path in files if path != WORKFLOW),
        *(_folder(folder, title, files, folder in kinds) for folder, title in folders.items()),
        _run(products, release),
        *_actions(run.jobs, archived),
    ]
    return {"@context": CONTEXT, "@graph": graph}


def _refer(*identifiers):
    """References to entities: a mapping for one of them, else a list."""
    found = [{"@id": identifier} for identifier in identifiers]
    return found[0] if len(found) == 1 else found


def _root(files, folders, jobs, release: Release) -> list[dict]:
    """The entity of the metadata file itself, and that of the whole crate."""
    top = [path for path in files if "/" not in path]
    descriptor = {
        "@id": METADATA,
        "@type": "CreativeWork",
        "about": _refer("./"),
        "conformsTo": _refer(SPECIFICATION, WORKFLOW_CRATE),
    }
    root = {
        "@id": "./",
        "@type": "Dataset",
        "name": release.citation["title"],
        "description": release.citation["abstract"],
        "version": release.version,
        "datePublished": release.date,
        "license": _refer(f"{SPDX}{DATA_LICENCE}"),
        "author": _refer(DEVELOPERS),
        "publisher": _refer(DEVELOPERS),
        "keywords": ", ".join(release.citation["keywords"]),
        "isBasedOn": _refer(f"https://doi.org/{release.paper['doi']}"),
        "conformsTo": _refer(*PROFILES),
        "mainEntity": _refer(WORKFLOW),
        "hasPart": _refer(*(f"{folder}/" for folder in folders), WORKFLOW, *top),
        "mentions": _refer("#run", *(f"#{_slug(job)}" for job in jobs)),
    }
    return [descriptor, root]


def _context(software, release: Release) -> list[dict]:
    """What the crate refers to: profiles, people, licences, the paper and the software."""
    paper = release.paper
    return [
        *(
            {"@id": profile, "@type": "CreativeWork", "name": name, "version": number}
            for profile, (name, number) in PROFILES.items()
        ),
        {
            "@id": DEVELOPERS,
            "@type": "Organization",
            "name": ", ".join(release.authors),
        },
        *(
            {"@id": f"{SPDX}{licence}", "@type": "CreativeWork", "name": licence}
            for licence in (DATA_LICENCE, release.citation["license"])
        ),
        {
            "@id": f"https://doi.org/{paper['doi']}",
            "@type": "ScholarlyArticle",
            "name": paper["title"],
            "creditText": release.paper_text,
        },
        {
            "@id": LANGUAGE,
            "@type": "ComputerLanguage",
            "name": "Snakemake",
            "alternateName": "SMK",
            "identifier": _refer("https://doi.org/10.1093/bioinformatics/bts480"),
            "url": _refer("https://snakemake.readthedocs.io"),
            "version": software["snakemake"],
        },
        *(
            {
                "@id": _package(name, number),
                "@type": "SoftwareApplication",
                "name": name,
                "version": number,
            }
            for name, number in software.items()
        ),
    ]


def _package(name, number) -> str:
    """Package URL (purl) of a Python package."""
    return f"pkg:pypi/{name.lower()}@{number}"


def _workflow(scripts, software, release: Release) -> dict:
    """The workflow, with references to the scripts of its rules and to its software."""
    return _file(WORKFLOW, release) | {
        "@type": ["File", "SoftwareSourceCode", "ComputationalWorkflow"],
        "name": f"workflow of {release.full_name}",
        "version": release.version,
        "creator": _refer(DEVELOPERS),
        "conformsTo": _refer(f"{BIOSCHEMAS}/ComputationalWorkflow/1.0-RELEASE"),
        "programmingLanguage": _refer(LANGUAGE),
        "hasPart": _refer(*scripts),
        "input": _refer("#configuration"),
        "output": _refer("#products"),
        "softwareRequirements": _refer(*(_package(*pair) for pair in software.items())),
    }


def _parameters(kinds) -> list[dict]:
    """Formal parameters of the workflow: its configuration goes in, the products come out."""
    shape = _refer(f"{BIOSCHEMAS}/FormalParameter/1.0-RELEASE")
    return [
        {
            "@id": "#configuration",
            "@type": "FormalParameter",
            "name": "configuration",
            "description": "what is computed, and the inputs of the model",
            "additionalType": "File",
            "encodingFormat": media_type(CONFIGURATION),
            "valueRequired": True,
            "conformsTo": shape,
            "workExample": _refer(CONFIGURATION),
        },
        {
            "@id": "#products",
            "@type": "FormalParameter",
            "name": "products",
            "description": ", ".join(kinds),
            "additionalType": "Dataset",
            "conformsTo": shape,
            "workExample": _refer(*(f"{kind}/" for kind in kinds)),
        },
    ]


def _scripts(jobs, archived, release: Release) -> dict[str, dict]:
    """What the files of the rules' scripts have beyond other files, by their paths."""
    found = {}
    for job in jobs:
        path = archived[job.script]
        modules = [archived[module] for module in job.modules]
        found[path] = {
            "@type": ["File", "SoftwareSourceCode"],
            "name": job.rule,
            "version": release.version,
            "programmingLanguage": "Python",
            "softwareRequirements": _refer(*modules),
        }
    return found


def _file(path: str, release: Release) -> dict:
    """A file of the archive; it names its licence if that is not the one of the whole."""
    entity = {
        "@id": path,
        "@type": "File",
        "name": PurePosixPath(path).name,
        "encodingFormat": media_type(path),
    }
    if path == CONFIGURATION:
        entity["exampleOfWork"] = _refer("#configuration")
    if path.startswith("source/") and not path.startswith("source/config/"):
        entity["license"] = _refer(f"{SPDX}{release.citation['license']}")
    return entity


def _folder(folder: str, title: str, files, made: bool) -> dict:
    """A folder of the archive with references to its files; ``made``: the run made them."""
    parts = [path for path in files if path.startswith(f"{folder}/")]
    entity = {"@id": f"{folder}/", "@type": "Dataset", "name": folder, "description": title}
    entity["hasPart"] = _refer(*parts)
    return entity | ({"exampleOfWork": _refer("#products")} if made else {})


def _run(products, release: Release) -> dict:
    """The action that the run of the whole workflow is."""
    return {
        "@id": "#run",
        "@type": "CreateAction",
        "name": f"run of the workflow of {release.full_name}",
        "description": "its time, host and user are in provenance.json, beside the archive",
        "actionStatus": COMPLETED,
        "agent": _refer(DEVELOPERS),
        "instrument": _refer(WORKFLOW),
        "object": _refer(CONFIGURATION),
        "result": _refer(*products),
    }


def _actions(jobs: list[Job], archived) -> list[dict]:
    """An action for each job, and an entity for each file of a job that is not in the archive."""
    graph, between = [], {}
    for job in jobs:
        inputs = [archived.get(path, f"#{path}") for path in job.inputs]
        outputs = [archived.get(path, f"#{path}") for path in job.outputs]
        between |= {name: None for name in (*inputs, *outputs) if name.startswith("#")}
        if job.configured:
            inputs.append(CONFIGURATION)
        action = {
            "@id": f"#{_slug(job)}",
            "@type": "CreateAction",
            "name": job.name,
            "description": f"job of the rule {job.rule}",
            "actionStatus": COMPLETED,
            "agent": _refer(DEVELOPERS),
            "instrument": _refer(archived[job.script]),
            "result": _refer(*outputs),
        }
        graph.append(action | ({"object": _refer(*inputs)} if inputs else {}))
    graph += [
        {
            "@id": name,
            "@type": "CreativeWork",
            "name": name.removeprefix("#"),
            "description": "written by one job and read by another; not in the archive",
        }
        for name in between
    ]
    return graph


def _slug(job: Job) -> str:
    """Name of a job that can stand in an ``@id``."""
    return "-".join((job.rule, *job.wildcards.values()))
