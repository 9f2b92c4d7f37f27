"""How a release is called, dated and cited: CITATION.cff, codemeta.json and Zenodo's metadata.

``pyproject.toml`` gives the version and ``CITATION.cff`` everything else, the date too: the same
sources give the same archive whenever it is made.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import yaml

from thirdbody.configuration.plain_yaml import read_yaml

DATA_LICENCE = "CC-BY-4.0"
SPDX = "https://spdx.org/licenses/"


@dataclass(frozen=True)
class Release:
    """Name, version and date of a release, and ``citation``, the content of CITATION.cff."""

    name: str
    version: str
    date: str  # ISO 8601
    citation: dict

    @classmethod
    def of(cls, pyproject, citation) -> Release:
        """The release that the files ``pyproject`` and ``citation`` describe.

        Raises ``ValueError`` if they do not give the same version.
        """
        project = tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]
        cited = read_yaml(citation)
        if cited["version"] != project["version"]:
            raise ValueError(
                f"{citation}: version is {cited['version']}; "
                f"allowed: {project['version']}, as in {pyproject}"
            )
        return cls(project["name"], project["version"], cited["date-released"], cited)

    @property
    def full_name(self) -> str:
        """Name of the folder and of the archive file."""
        return f"{self.name}-{self.version}"

    @property
    def authors(self) -> list[str]:
        return [author["name"] for author in self.citation["authors"]]

    @property
    def paper(self) -> dict:
        """The paper that is reproduced."""
        return self.citation["references"][0]

    @property
    def paper_text(self) -> str:
        """The paper as it stands in a list of references."""
        paper = self.paper
        names = " and ".join(f"{a['family-names']} {a['given-names']}" for a in paper["authors"])
        return (
            f"{names} ({paper['year']}), {paper['title']}. {paper['journal']} {paper['volume']}:"
            f"{paper['start']}. https://doi.org/{paper['doi']}"
        )

    @property
    def text(self) -> str:
        """The release as it stands in a list of references."""
        year = self.date.partition("-")[0]
        return (
            f"{', '.join(self.authors)} ({year}), {self.citation['title']}, version {self.version}"
        )


def software_versions(pyproject) -> dict[str, str]:
    """Installed versions of what the project itself asks for, to run its workflow."""
    project = tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]
    wanted = [*project["dependencies"], *project["optional-dependencies"]["workflow"]]
    names = sorted(re.match(r"[\w.-]+", requirement)[0] for requirement in wanted)
    return {name: version(name) for name in names}


def citation_text(release: Release) -> str:
    """CITATION.cff of the release."""
    return yaml.safe_dump(release.citation, sort_keys=False, allow_unicode=True, width=10**6)


def codemeta(release: Release, software: dict[str, str]) -> dict:
    """codemeta.json (CodeMeta 3.0); ``software`` are versions by name."""
    cited = release.citation
    return {
        "@context": "https://w3id.org/codemeta/3.0",
        "@type": "SoftwareSourceCode",
        "name": release.name,
        "description": cited["abstract"],
        "version": release.version,
        "datePublished": release.date,
        "author": [{"@type": "Organization", "name": name} for name in release.authors],
        "license": f"{SPDX}{cited['license']}",
        "keywords": cited["keywords"],
        "programmingLanguage": "Python",
        "softwareRequirements": [
            {"@type": "SoftwareApplication", "name": name, "version": number}
            for name, number in software.items()
        ],
        "referencePublication": {
            "@type": "ScholarlyArticle",
            "name": release.paper["title"],
            "identifier": f"https://doi.org/{release.paper['doi']}",
        },
    }


def zenodo(release: Release) -> dict:
    """Body of a deposit to Zenodo's interface; the file stands in the archive only, as a
    ``.zenodo.json`` in the repository would make Zenodo ignore its CITATION.cff."""
    cited = release.citation
    return {
        "metadata": {
            "upload_type": "dataset",
            "title": cited["title"],
            "creators": [{"name": name} for name in release.authors],
            "description": cited["abstract"],
            "version": release.version,
            "publication_date": release.date,
            "access_right": "open",
            "license": DATA_LICENCE.lower(),
            "language": "eng",
            "keywords": cited["keywords"],
            "notes": f"The source code in the archive is licensed under {cited['license']}.",
            "related_identifiers": [
                {
                    "identifier": release.paper["doi"],
                    "relation": "isDerivedFrom",
                    "resource_type": "publication-article",
                }
            ],
        }
    }
