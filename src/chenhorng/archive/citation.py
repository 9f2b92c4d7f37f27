"""Name, version, date and citation of a release; the same commit has the same ones."""

import re
import tomllib
from dataclasses import dataclass
from importlib.metadata import version
from os import PathLike
from pathlib import Path
from typing import Any, Self

import yaml

from thirdbody.version import current


@dataclass(frozen=True)
class Release:
    """A release of the project: its name, version, date (ISO 8601) and ``CITATION.cff``."""

    name: str
    version: str
    date: str
    citation: dict[str, Any]

    @classmethod
    def of(cls, pyproject: str | PathLike, citation: str | PathLike, is_paper: bool = True) -> Self:
        """The release that ``pyproject.toml`` and ``CITATION.cff`` describe, with the version, date
        and hash of the commit.  If the configuration is not that of the paper (``is_paper``), the
        version and the title say so."""
        name = _read_project(pyproject)["name"]
        cited = yaml.safe_load(Path(citation).read_text(encoding="utf-8"))
        number, date, commit = current()
        known = {"version": number, "date-released": date, "commit": commit}
        cited |= {key: value for key, value in known.items() if value}
        if not is_paper:
            cited["version"] += ".changed" if "+" in number else "+changed"
            cited["title"] += ", with a changed configuration"
        return cls(name, cited["version"], date, cited)

    @property
    def full_name(self) -> str:
        """Name of the folder and, without its suffix, of the archive file."""
        return f"{self.name}-{self.version}"

    @property
    def authors(self) -> list[str]:
        """Names of the authors, persons and others."""
        return [
            author.get("name") or f"{author['given-names']} {author['family-names']}"
            for author in self.citation["authors"]
        ]

    @property
    def paper_url(self) -> str:
        """The address of the paper."""
        return f"https://doi.org/{self.citation['references'][0]['doi']}"

    @property
    def paper_text(self) -> str:
        """The paper as an entry of a reference list."""
        paper = self.citation["references"][0]
        names = " and ".join(f"{a['family-names']} {a['given-names']}" for a in paper["authors"])
        return (
            f"{names} ({paper['year']}), {paper['title']}. {paper['journal']} {paper['volume']}:"
            f"{paper['start']}. {self.paper_url}"
        )


def software_versions(pyproject: str | PathLike) -> dict[str, str]:
    """Installed versions of the packages that the workflow requires, by name."""
    project = _read_project(pyproject)
    wanted, names = [*project["dependencies"], f"{project['name']}[workflow]"], set()
    while wanted:
        ((name, extras),) = re.findall(r"^([\w.-]+)(?:\[([\w,]+)\])?", wanted.pop())
        if name != project["name"]:
            names.add(name)
            continue
        for extra in extras.split(","):
            wanted += project["optional-dependencies"][extra]
    return {name: version(name) for name in sorted(names)}


def _read_project(pyproject: str | PathLike) -> dict[str, Any]:
    return tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]
