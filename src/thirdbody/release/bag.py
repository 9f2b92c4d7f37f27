"""BagIt 1.0 (RFC 8493): a folder with checksums of all its files, and its zip file.

The package ``bagit`` is not used for writing: it declares version 0.97 and lists tag files in disk
order, so that two bags of the same files differ.  Tests validate bags with it.
"""

from __future__ import annotations

import zipfile
from datetime import date
from os import PathLike
from pathlib import Path

from thirdbody.data.files import digest
from thirdbody.release.citation import Release
from thirdbody.release.files import files_in, render

ALGORITHMS = ("sha256", "sha512")
DECLARATION = "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n"
FILE_MODE = 0o100644 << 16  # a regular file, writable by its owner
UNIX = 3  # code of the system with these modes


def seal(folder: Path, release: Release) -> None:
    """Make a bag of a folder with a payload in ``data/``; the same files give the same bytes."""
    payload = files_in(folder / "data", folder)
    size = sum((folder / name).stat().st_size for name in payload)
    information = render("bag-info.txt", release=release, oxum=f"{size}.{len(payload)}")
    (folder / "bag-info.txt").write_text(information, encoding="utf-8")
    (folder / "bagit.txt").write_text(DECLARATION, encoding="utf-8")
    _write_manifests(folder, "manifest", payload)
    not_tags = ("data/", "tagmanifest-")
    tags = [name for name in files_in(folder, folder) if not name.startswith(not_tags)]
    _write_manifests(folder, "tagmanifest", tags)


def _write_manifests(folder: Path, kind: str, names: list[str]) -> None:
    for algorithm in ALGORITHMS:
        lines = [f"{digest(folder / name, algorithm)}  {name}\n" for name in names]
        (folder / f"{kind}-{algorithm}.txt").write_text("".join(lines), encoding="utf-8")


def pack(folder: Path, archive: str | PathLike, day: str) -> None:
    """Write a sealed folder as a zip file, with the date ``day`` (ISO 8601); the same files give the
    same bytes, which are not compressed, because compression depends on the version.
    """
    moment = (*date.fromisoformat(day).timetuple()[:3], 0, 0, 0)
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_STORED) as packed:
        for name in files_in(folder, folder):
            member = zipfile.ZipInfo(f"{folder.name}/{name}", moment)
            member.create_system = UNIX
            member.external_attr = FILE_MODE
            packed.writestr(member, (folder / name).read_bytes())
