"""The folder of a release, sealed as a bag of BagIt 1.0 (RFC 8493), and its zip file.

The package ``bagit`` does not write the bag.  It declares version 0.97, and lists tag files in the
order of the disk, so that two bags of the same files differ.  Tests validate bags with it.
"""

import os
import shutil
import subprocess
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from runpy import run_path
from typing import Any

import yaml

from chenhorng.archive.citation import Release
from chenhorng.archive.crate import METADATA, PRODUCT_FOLDERS, crate
from chenhorng.archive.descriptions import describe_content, table_schemas
from chenhorng.archive.files import files_in, render, render_json, write_json
from thirdbody.files import digest
from thirdbody.version import current

LICENCES = ("LICENSE", "LICENSE-DATA")
VERIFICATION = "verification/"
VERSION = "src/thirdbody/version.json"
DECLARATION = "BagIt-Version: 1.0\nTag-File-Character-Encoding: UTF-8\n"


def stage(
    folder: Path,
    products: Sequence[str | os.PathLike],
    sources: Iterable[str],
    settings: Mapping[str, Any],
    software: dict[str, str],
    release: Release,
) -> None:
    """Fill the ``folder`` of a release, from the root of the repository: copy the files, describe
    them, and add checksums, ``tagmanifest-sha256.txt`` last.

    ``products`` are files in the folders ``PRODUCT_FOLDERS`` of ``results/``, and the index and the
    captions beside these folders, to which pages link.  ``settings`` is the
    content of ``configuration/``, by file name.  ``software`` has the versions of the packages that
    were used.  A release of an unknown version raises ``ValueError``.
    """
    if not release.date:
        raise ValueError(
            f"the version is {release.version}; allowed: a repository, "
            "or a copy made by git archive or a release"
        )
    shutil.rmtree(folder, ignore_errors=True)
    data = folder / "data"
    for path in map(Path, products):
        folder_of_kind = path.parent.name if path.parent.name in PRODUCT_FOLDERS else ""
        _copy(path, data / folder_of_kind / path.name)
    for source in sources:
        _copy(source, data / "source" / source)
        if source.startswith(VERIFICATION):
            _copy(source, folder / source)
    stored = {"version": current().text, "date": release.date, "commit": current().commit}
    write_json(data / "source" / VERSION, stored)
    for licence in LICENCES:
        _copy(licence, data / licence)
    content_sha256 = run_path(f"{VERIFICATION}content_hash.py")["content_sha256"]
    contents = {path.name: content_sha256(path) for path in sorted(data.glob("datasets/*.nc"))}
    write_json(data / "datasets" / "content-sha256.json", contents)
    for name, content in settings.items():
        write_json(data / "configuration" / f"{name}.json", content)
    cited = yaml.safe_dump(release.citation, sort_keys=False, allow_unicode=True, width=10**6)
    (data / "CITATION.cff").write_text(cited, encoding="utf-8")
    write_json(data / "codemeta.json", render_json("codemeta.json", release=release))
    titles = {name: title for name, title in PRODUCT_FOLDERS.items() if (data / name).is_dir()}
    write_json(data / "table-schemas.json", table_schemas(data, titles))
    content = describe_content(data, titles)
    readme = render("README.md", release=release, software=software, **content)
    (folder / "README.md").write_text(readme, encoding="utf-8")
    write_json(folder / METADATA, crate(folder, titles, release))
    seal(folder, release)


def _copy(source: str | os.PathLike, target: Path) -> None:
    """Copy the content of a file, but not its mode, owner or time."""
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)


def seal(folder: Path, release: Release) -> None:
    """Make a bag of a ``folder`` with a payload in ``data/``; the same files make the same bag."""
    payload = files_in(folder / "data", folder)
    size = sum((folder / name).stat().st_size for name in payload)
    information = render("bag-info.txt", release=release, oxum=f"{size}.{len(payload)}")
    (folder / "bag-info.txt").write_text(information, encoding="utf-8")
    (folder / "bagit.txt").write_text(DECLARATION, encoding="utf-8")
    _write_manifest(folder, "manifest", payload)
    not_tags = ("data/", "tagmanifest-")
    tags = [name for name in files_in(folder, folder) if not name.startswith(not_tags)]
    _write_manifest(folder, "tagmanifest", tags)


def _write_manifest(folder: Path, kind: str, names: list[str]) -> None:
    lines = [f"{digest(folder / name)}  {name}\n" for name in names]
    (folder / f"{kind}-sha256.txt").write_text("".join(lines), encoding="utf-8")


def pack(folder: Path, archive: str | os.PathLike) -> None:
    """Write a sealed ``folder`` as a zip file; the same files make the same bytes.  They lie at the
    root of the zip file, where programs look for ``ro-crate-metadata.json``.

    Raises ``ValueError``, and writes nothing, if the folder does not match its checksums.
    """
    program = f"{VERIFICATION}verify.py"
    command = [sys.executable, program, str(folder), "--sums"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        reason = (done.stdout or done.stderr).strip()
        raise ValueError(f"{folder} is not packed: {reason}; stage the release again")
    with open(archive, "wb") as packed:
        run_path(program)["write_zip"](folder, files_in(folder, folder), packed)
