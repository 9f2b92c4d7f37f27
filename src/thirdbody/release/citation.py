"""Name, version, date and citation of a release, in the vocabularies that archives ask for.

``pyproject.toml`` gives the name and version, ``CITATION.cff`` everything else.  The date too is
written there and not taken from a clock: the same sources give the same archive at any time.
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

from thirdbody.configuration.plain_yaml import read_yaml

DATA_LICENCE = "CC-BY-4.0"
SPDX = "https://spdx.org/licenses/"


@dataclass(frozen=True)
class Release:
    """A release of the project, as its files describe it.

    Attributes
    ----------
    name : str
        Name of the project.
    version : str
        Number of the release.
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
        """Read the release from the files that describe it.

        Parameters
        ----------
        pyproject, citation : path
            ``pyproject.toml`` and ``CITATION.cff``.

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
        project = tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]
        cited = read_yaml(citation)
        if cited["version"] != project["version"]:
            raise ValueError(
                f"{citation}: version is {cited['version']}; "
                f"allowed: {project['version']}, as in {pyproject}"
            )
        return cls(project["name"], project["version"], cited["date-released"], cited)

    def of_other_configuration(self) -> Release:
        """The same under a name and version that say that the configuration is not the paper's.

        Examples
        --------
        >>> release = Release.of("pyproject.toml", "CITATION.cff").of_other_configuration()
        >>> release.full_name.endswith("+changed")
        True
        >>> release.citation["title"].rpartition(", ")[2]
        'with a changed configuration'
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


def software_versions(pyproject: str | PathLike) -> dict[str, str]:
    """Installed versions of the packages that running the workflow asks for.

    Parameters
    ----------
    pyproject : path
        ``pyproject.toml``, whose dependencies and those of the extra ``workflow`` are meant.

    Returns
    -------
    dict
        Versions by name of the package.

    Raises
    ------
    importlib.metadata.PackageNotFoundError
        If one of them is not installed.
    """
    project = tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]
    wanted = [*project["dependencies"], *project["optional-dependencies"]["workflow"]]
    names = sorted(re.match(r"[\w.-]+", requirement)[0] for requirement in wanted)
    return {name: version(name) for name in names}


def citation_text(release: Release) -> str:
    """Text of the file ``CITATION.cff`` in the archive."""
    return yaml.safe_dump(release.citation, sort_keys=False, allow_unicode=True, width=10**6)


def codemeta(release: Release, software: dict[str, str]) -> dict[str, Any]:
    """Describe the software in the vocabulary CodeMeta 3.0.

    Parameters
    ----------
    release : Release
        What is described.
    software : dict
        Versions of the packages that it runs on, by name.

    Returns
    -------
    dict
        Content of ``codemeta.json``.

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
            "identifier": f"https://doi.org/{release.paper['doi']}",
        },
    }


def zenodo(release: Release) -> dict[str, Any]:
    """Describe the archive as Zenodo asks for it when one is deposited.

    The description is part of the archive only: a file ``.zenodo.json`` in the repository would
    make Zenodo ignore its ``CITATION.cff``.

    Returns
    -------
    dict
        Body of a request to Zenodo's programming interface.
    """
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
