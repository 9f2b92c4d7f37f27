"""BagIt 1.0 (RFC 8493): a folder with the sums of all its files.

In such a folder, a *bag*, the *payload* lies in ``data/``; all files beside it are *tag files*.
Manifests list the sums of both.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from os import PathLike
from pathlib import Path

from thirdbody.release.citation import Release

ALGORITHMS = ("sha256", "sha512")
DECLARATION = "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n"


def seal(folder: Path, release: Release) -> None:
    """Make a bag of a folder: write its description and the sums of all files.

    The same content gives the same bytes.

    Parameters
    ----------
    folder : Path
        Has the payload in ``data/``; the tag files are written beside it.
    release : Release
        What the folder holds.

    Raises
    ------
    OSError
        If a file cannot be read or written.

    References
    ----------
    RFC 8493, doi:10.17487/RFC8493.

    Examples
    --------
    In the root of the repository:

    >>> import tempfile
    >>> release = Release.of("pyproject.toml", "CITATION.cff")
    >>> with tempfile.TemporaryDirectory() as place:
    ...     payload = Path(place, "data")
    ...     payload.mkdir()
    ...     _ = (payload / "hello.txt").write_text("hello")
    ...     seal(Path(place), release)
    ...     Path(place, "manifest-sha256.txt").read_text().split()[1]
    'data/hello.txt'
    """
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
    """List all files below a folder.

    Parameters
    ----------
    folder : Path
        Where to look, at any depth.
    root : Path
        What the names are relative to.

    Returns
    -------
    list of str
        Sorted names with forward slashes.
    """
    paths = (path for path in folder.rglob("*") if path.is_file())
    return sorted(path.relative_to(root).as_posix() for path in paths)


def digest(path: str | PathLike, algorithm: str) -> str:
    """Sum of the bytes of a file.

    Parameters
    ----------
    path : path
        The file.
    algorithm : str
        As ``hashlib`` names it, such as ``sha256``.

    Returns
    -------
    str
        Hexadecimal digits.
    """
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


def _write_manifest(folder: Path, manifest: str, algorithm: str, names: Iterable[str]) -> None:
    lines = [f"{digest(folder / name, algorithm)}  {name}\n" for name in names]
    (folder / manifest).write_text("".join(lines), encoding="utf-8")
