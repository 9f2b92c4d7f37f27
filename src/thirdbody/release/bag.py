"""BagIt 1.0 (RFC 8493): sums of everything in a folder whose payload lies in ``data/``."""

from __future__ import annotations

import hashlib
from pathlib import Path

from thirdbody.release.citation import Release

ALGORITHMS = ("sha256", "sha512")
DECLARATION = "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n"


def seal(folder: Path, release: Release) -> None:
    """Write the tag files of a bag into ``folder``: the same content gives the same bytes."""
    payload = files_in(folder / "data", folder)
    size = sum((folder / name).stat().st_size for name in payload)
    (folder / "bagit.txt").write_text(DECLARATION, encoding="utf-8")
    (folder / "bag-info.txt").write_text(
        _description(release, size, len(payload)), encoding="utf-8"
    )
    for algorithm in ALGORITHMS:
        _write_manifest(folder, f"manifest-{algorithm}.txt", algorithm, payload)
    others = ("data/", "tagmanifest-")
    tags = [name for name in files_in(folder, folder) if not name.startswith(others)]
    for algorithm in ALGORITHMS:
        _write_manifest(folder, f"tagmanifest-{algorithm}.txt", algorithm, tags)


def files_in(folder: Path, root: Path) -> list[str]:
    """Sorted names, relative to ``root``, of all files below ``folder``."""
    paths = (path for path in folder.rglob("*") if path.is_file())
    return sorted(path.relative_to(root).as_posix() for path in paths)


def digest(path, algorithm: str) -> str:
    """Hexadecimal sum of the bytes of a file."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, algorithm).hexdigest()


def _description(release: Release, size: int, count: int) -> str:
    fields = {
        "Source-Organization": ", ".join(release.authors),
        "External-Identifier": release.full_name,
        "External-Description": release.citation["title"],
        "Bagging-Date": release.date,
        "Payload-Oxum": f"{size}.{count}",
    }
    return "".join(f"{name}: {value}\n" for name, value in fields.items())


def _write_manifest(folder: Path, manifest: str, algorithm: str, names) -> None:
    lines = [f"{digest(folder / name, algorithm)}  {name}\n" for name in names]
    (folder / manifest).write_text("".join(lines), encoding="utf-8")
