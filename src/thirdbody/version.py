"""The version of this software, as git knows it.

In a repository this module asks git at run time, so that an editable installation reports the
commit that runs.  Elsewhere it reads ``version.json``: ``git archive`` writes the commit into that
file, the build of a wheel, an sdist or a release the version.  hatchling imports this module for
the version, so it needs only the standard library.
"""

import json
import os
import re
import subprocess
from functools import cache
from pathlib import Path
from typing import NamedTuple

STORED = Path(__file__).with_suffix(".json")
REPOSITORY = Path(__file__).resolve().parents[2]
UNKNOWN = "0+unknown"  # neither git nor the file knows the version
ELSEWHERE = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE")  # set by git for its hooks


class Version(NamedTuple):
    """The version (PEP 440), date (ISO 8601) and hash of a commit; an unknown date or hash is
    empty."""

    text: str
    date: str = ""
    commit: str = ""


def current() -> Version:
    """The version of the running code."""
    return _of_repository() or _stored()


@cache
def _stored() -> Version:
    content = json.loads(STORED.read_text(encoding="utf-8"))
    if "version" in content:
        return Version(content["version"], content["date"], content["commit"])
    if content["commit"].startswith("$"):  # a copy that git archive did not make
        return Version(UNKNOWN)
    commit = content["commit"]
    return Version(_numbered(content["tag"], 0, commit), content["date"], commit)


@cache
def _of_repository() -> Version | None:
    if not (REPOSITORY / ".git").exists():
        return None
    try:
        commit, date = _git("log", "-1", "--no-show-signature", "--format=%H %cs").split()
        edited = ".dirty" if _git("status", "--porcelain", "--untracked-files=no") else ""
        return Version(_version_of(commit, edited), date, commit)
    except (OSError, subprocess.CalledProcessError, ValueError):  # no git, or no commit
        return None


def _version_of(commit: str, edited: str) -> str:
    """The version of a commit of the repository, ``0+g...`` in a shallow clone without a tag."""
    tags = ("--tags", "--match=v[0-9]*", "--exclude=*[!v0-9.]*")  # v0.1.0
    try:
        return _numbered(_git("describe", "--long", *tags, commit), 0, commit, edited)
    except subprocess.CalledProcessError:  # no tag
        if _git("rev-parse", "--is-shallow-repository") == "true":
            return f"0+g{commit[:7]}{edited}"
        return _numbered("", int(_git("rev-list", "--count", commit)), commit, edited)


def _git(*arguments: str) -> str:
    # A hook of another repository sets variables that would lead git there.  Optional locks would
    # write to this repository.
    environment = {name: value for name, value in os.environ.items() if name not in ELSEWHERE}
    environment["GIT_OPTIONAL_LOCKS"] = "0"
    # git refuses a folder of another user, because it could run programs from there.  This module
    # already runs from there.
    command = ["git", "-c", f"safe.directory={REPOSITORY.as_posix()}", *arguments]
    done = subprocess.run(
        command, cwd=REPOSITORY, env=environment, capture_output=True, encoding="utf-8", check=True
    )
    return done.stdout.rstrip("\n")


def _numbered(described: str, distance: int, commit: str, edited: str = "") -> str:
    """The version of a tag.  After the tag: the next minor version with the number of commits."""
    found = re.fullmatch(r"v(\d+)\.(\d+)([\d.]*?)(?:-(\d+)-g\w+)?", described)
    major, minor, rest, since = found.groups(default="0") if found else ("0", "0", "", distance)
    if found and since == "0" and not edited:
        return f"{major}.{minor}{rest}"
    return f"{major}.{int(minor) + 1}.0.dev{since}+g{commit[:7]}{edited}"
