"""Name, version, date and citation of a release, in the vocabularies that archives ask for.

``pyproject.toml`` gives the name and version, ``CITATION.cff`` all else, also the date: the same
sources give the same archive on any day.  The package ``cffconvert`` is not used: it describes an
organisation as a person and leaves out the paper, and it needs an environment of its own.
"""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass, replace
from importlib.metadata import version
from os import PathLike
from pathlib import Path
from typing import Any

import yaml

DATA_LICENCE = "CC-BY-4.0"
SPDX = "https://spdx.org/licenses/"


@dataclass(frozen=True)
class Release:
    """A release of the project.

    Attributes
    ----------
    name : str
        Name of the project.
    version : str
        Version of the release.
    date : str
        Day of the release, ISO 8601.
    citation : dict
        Content of ``CITATION.cff``.
    """

    name: str
    version: str
    date: str
    citation: dict[str, Any]

    @classmethod
    def of(cls, pyproject: str | PathLike, citation: str | PathLike) -> Release:
        """Read ``pyproject.toml`` and ``CITATION.cff``.

        Raises
        ------
        ValueError
            If the two files do not give the same version.

        Examples
        --------
        In the root of the repository:

        >>> release = Release.of("pyproject.toml", "CITATION.cff")
        >>> release.full_name == f"thirdbody-{release.version}"
        True
        """
        project = _read_project(pyproject)
        cited = yaml.safe_load(Path(citation).read_text(encoding="utf-8"))
        if cited["version"] != project["version"]:
            raise ValueError(
                f"{citation}: version is {cited['version']}; "
                f"allowed: {project['version']}, as in {pyproject}"
            )
        return cls(project["name"], project["version"], cited["date-released"], cited)

    def of_other_configuration(self) -> Release:
        """The same with a name and version which say that the configuration is not the paper's.

        Examples
        --------
        >>> release = Release.of("pyproject.toml", "CITATION.cff").of_other_configuration()
        >>> release.full_name.endswith("+changed")
        True
        """
        version = f"{self.version}+changed"
        title = f"{self.citation['title']}, with a changed configuration"
        citation = {**self.citation, "version": version, "title": title}
        return replace(self, version=version, citation=citation)

    @property
    def full_name(self) -> str:
        """Name of the folder and of the archive file."""
        return f"{self.name}-{self.version}"

    @property
    def authors(self) -> list[str]:
        """Names of the authors of the release."""
        return [author["name"] for author in self.citation["authors"]]

    @property
    def paper(self) -> dict[str, Any]:
        """The paper that is reproduced: the first reference of ``CITATION.cff``."""
        return self.citation["references"][0]

    @property
    def paper_url(self) -> str:
        """Address of the paper, by its DOI."""
        return f"https://doi.org/{self.paper['doi']}"

    @property
    def paper_text(self) -> str:
        """The paper as it stands in a list of references."""
        paper = self.paper
        names = " and ".join(f"{a['family-names']} {a['given-names']}" for a in paper["authors"])
        return (
            f"{names} ({paper['year']}), {paper['title']}. {paper['journal']} {paper['volume']}:"
            f"{paper['start']}. {self.paper_url}"
        )

    @property
    def text(self) -> str:
        """The release as it stands in a list of references."""
        title = f"{self.citation['title']}, version {self.version}"
        return f"{', '.join(self.authors)} ({self.date[:4]}), {title}"


def software_versions(pyproject: str | PathLike) -> dict[str, str]:
    """Installed versions of the packages that the workflow asks for, by name.

    Raises
    ------
    importlib.metadata.PackageNotFoundError
        If one of them is not installed.
    """
    project = _read_project(pyproject)
    wanted, names = [*project["dependencies"], f"{project['name']}[workflow]"], set()
    while wanted:
        name, extras = re.match(r"([\w.-]+)(?:\[([\w,]+)\])?", wanted.pop()).groups()
        if name == project["name"]:
            for extra in extras.split(","):
                wanted += project["optional-dependencies"][extra]
        else:
            names.add(name)
    return {name: version(name) for name in sorted(names)}


def _read_project(pyproject: str | PathLike) -> dict[str, Any]:
    return tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]


def citation_text(release: Release) -> str:
    """Text of the file ``CITATION.cff`` in the archive."""
    return yaml.safe_dump(release.citation, sort_keys=False, allow_unicode=True, width=10**6)


def codemeta(release: Release, software: dict[str, str]) -> dict[str, Any]:
    """Content of ``codemeta.json`` (CodeMeta 3.0).

    Parameters
    ----------
    release : Release
        What is described.
    software : dict
        Versions of the packages that it runs on, by name.

    References
    ----------
    https://w3id.org/codemeta/3.0
    """
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
            "identifier": release.paper_url,
        },
    }


def zenodo(release: Release) -> dict[str, Any]:
    """Body of the request that deposits the archive at Zenodo.

    It is part of the archive only: a file ``.zenodo.json`` in the repository would make Zenodo ignore
    ``CITATION.cff``.
    """
    cited = release.citation
    paper = {
        "identifier": release.paper["doi"],
        "relation": "isDerivedFrom",
        "resource_type": "publication-article",
    }
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
            "related_identifiers": [paper],
        }
    }
