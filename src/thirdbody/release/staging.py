"""The folder of a release: products, sources and configuration, described and sealed."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from runpy import run_path
from typing import Any

import yaml

from thirdbody.release.bag import seal
from thirdbody.release.citation import Release
from thirdbody.release.crate import KINDS, METADATA, crate
from thirdbody.release.descriptions import data_package, describe_content
from thirdbody.release.files import render, render_json, write_json

LICENCES = ("LICENSE", "LICENSE-DATA")
VERIFICATION = "verification/"


def stage(
    folder: Path,
    products: Sequence[str | os.PathLike],
    sources: Iterable[str],
    settings: Mapping[str, Any],
    jobs: list[dict[str, Any]],
    software: dict[str, str],
    release: Release,
) -> None:
    """Fill the folder of a release, from the root of the repository: copy the files, describe them,
    and add checksums, ``tagmanifest-sha512.txt`` last.

    ``products`` are files in the folders ``KINDS`` of ``results/``, ``settings`` the content of
    ``configuration/``, by file name.  ``jobs`` of the workflow have the name of their ``rule``, and
    ``inputs`` and ``outputs``, paths relative to the root; ``software`` are the versions of the
    packages used.
    """
    shutil.rmtree(folder, ignore_errors=True)
    data = folder / "data"
    for path in map(Path, products):
        _copy(path, data / path.parent.name / path.name)
    for path in sources:
        _copy(path, data / "source" / path)
        if path.startswith(VERIFICATION):
            _copy(path, folder / path)
    for path in LICENCES:
        _copy(path, data / path)
    content_sha256 = run_path(f"{VERIFICATION}content_hash.py")["content_sha256"]
    contents = {path.name: content_sha256(path) for path in sorted(data.glob("datasets/*.nc"))}
    write_json(data / "datasets" / "content-sha256.json", contents)
    for name, content in settings.items():
        write_json(data / "configuration" / f"{name}.json", content)
    cited = yaml.safe_dump(release.citation, sort_keys=False, allow_unicode=True, width=10**6)
    (data / "CITATION.cff").write_text(cited, encoding="utf-8")
    known = {"release": release, "software": software}
    for name in ("codemeta.json", "zenodo.json"):
        write_json(data / name, render_json(name, **known))
    kinds = {kind: title for kind, title in KINDS.items() if (data / kind).is_dir()}
    write_json(data / "datapackage.json", data_package(data, kinds, release))
    write_json(data / METADATA, crate(data, kinds, jobs, software, release))
    readme = render("README.md", **known, **describe_content(data, kinds))
    (folder / "README.md").write_text(readme, encoding="utf-8")
    seal(folder, release)


def _copy(path: str | os.PathLike, place: Path) -> None:
    """Copy the content of a file, but not its mode, owner or time."""
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, place)
