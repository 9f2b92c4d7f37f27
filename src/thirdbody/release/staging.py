"""The folder of a release: products, sources and configuration, described and sealed."""

from __future__ import annotations

import json
import os
import shutil
from contextlib import contextmanager
from pathlib import Path, PurePosixPath
from runpy import run_path

from thirdbody.release.bag import seal
from thirdbody.release.citation import Release, citation_text, codemeta, zenodo
from thirdbody.release.crate import KINDS, Run, crate
from thirdbody.release.datapackage import data_package
from thirdbody.release.guide import guide

LICENCES = ("LICENSE", "LICENSE-DATA")
VERIFICATION = "verification/"
CONTENT_HASH = f"{VERIFICATION}content_hash.py"


@contextmanager
def whole_folder(place):
    """A new folder to fill beside ``place``, which it replaces once the block is done."""
    place = Path(place)
    beside = place.with_name(f".{place.name}.partial")
    former = place.with_name(f".{place.name}.former")
    for rest in (beside, former):
        shutil.rmtree(rest, ignore_errors=True)
    beside.mkdir(parents=True)
    try:
        yield beside
        if place.exists():
            os.replace(place, former)
        os.replace(beside, place)
    finally:
        for rest in (beside, former):
            shutil.rmtree(rest, ignore_errors=True)


def stage(folder: Path, products, sources, run: Run, release: Release) -> None:
    """Fill the empty ``folder`` with files of the repository, which is the current folder.

    ``products`` are paths in ``results/``, ``sources`` those of the source code, among them the
    programs that check an archive.  Raises ``ValueError`` for a product of an unknown kind.
    """
    data = folder / "data"
    for path in products:
        _copy(path, data / _kind(path) / Path(path).name)
    for path in sources:
        _copy(path, data / "source" / path)
        if path.startswith(VERIFICATION):
            _copy(path, folder / path)
    for path in LICENCES:
        _copy(path, data / path)
    content_sha256 = run_path(CONTENT_HASH)["content_sha256"]
    contents = {path.name: content_sha256(path) for path in sorted(data.glob("datasets/*.nc"))}
    _write_json(data / "datasets" / "content-sha256.json", contents)
    for name, content in run.settings.items():
        _write_json(data / "configuration" / f"{name}.json", content)
    (data / "CITATION.cff").write_text(citation_text(release), encoding="utf-8")
    _write_json(data / "codemeta.json", codemeta(release, run.software))
    _write_json(data / "zenodo.json", zenodo(release))
    found = {_kind(path) for path in products}
    kinds = {kind: title for kind, title in KINDS.items() if kind in found}
    _write_json(data / "datapackage.json", data_package(data, kinds, release))
    _write_json(data / "ro-crate-metadata.json", crate(data, kinds, run, release))
    (folder / "README.md").write_text(guide(data, kinds, run.software, release), encoding="utf-8")
    seal(folder, release)


def _kind(product) -> str:
    """The folder of ``results/`` that a product lies in."""
    kind = PurePosixPath(product).parent.name
    if kind not in KINDS:
        raise ValueError(f"{product}: kind {kind!r} is unknown; allowed: {', '.join(KINDS)}")
    return kind


def _copy(path, place: Path) -> None:
    """Copy bytes alone: no mode, owner or time."""
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, place)


def _write_json(path: Path, content) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
