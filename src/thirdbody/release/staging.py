"""The folder of a release: products, sources and configuration, described and sealed."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path, PurePosixPath
from runpy import run_path

import yaml

from thirdbody.release.bag import seal
from thirdbody.release.citation import Release
from thirdbody.release.crate import KINDS, METADATA, Run, crate
from thirdbody.release.datapackage import data_package
from thirdbody.release.files import write_json
from thirdbody.release.guide import describe_content, render

LICENCES = ("LICENSE", "LICENSE-DATA")
VERIFICATION = "verification/"


@contextmanager
def whole_folder(place: str | os.PathLike) -> Iterator[Path]:
    """Yield an empty folder to fill, which takes its ``place`` when the block ends without an error."""
    place = Path(place)
    part = place.with_name(f".{place.name}.partial")
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir(parents=True)
    try:
        yield part
        shutil.rmtree(place, ignore_errors=True)
        os.replace(part, place)
    finally:
        shutil.rmtree(part, ignore_errors=True)


def stage(
    folder: Path,
    products: Sequence[str | os.PathLike],
    sources: Iterable[str],
    run: Run,
    release: Release,
) -> None:
    """Fill the folder of a release: copy the files, describe them, and seal all with sums.

    The current folder must be the root of the repository.

    Parameters
    ----------
    folder : Path
        An empty folder.
    products : sequence of path
        Files in ``results/``, whose folder there is their kind; at least one dataset.
    sources : iterable of str
        Files of the source code, with the programs in ``verification/``.
    run : Run
        The run of the workflow that made the products.
    release : Release
        Name, version, date and citation.

    Raises
    ------
    ValueError
        If a product is of an unknown kind, or nothing describes the columns of a table.
    OSError
        If a file cannot be read or written.
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
    content_sha256 = run_path(f"{VERIFICATION}content_hash.py")["content_sha256"]
    contents = {path.name: content_sha256(path) for path in sorted(data.glob("datasets/*.nc"))}
    write_json(data / "datasets" / "content-sha256.json", contents)
    for name, content in run.settings.items():
        write_json(data / "configuration" / f"{name}.json", content)
    cited = yaml.safe_dump(release.citation, sort_keys=False, allow_unicode=True, width=10**6)
    (data / "CITATION.cff").write_text(cited, encoding="utf-8")
    known = {"release": release, "software": run.software}
    for name in ("codemeta.json", "zenodo.json"):
        write_json(data / name, json.loads(render(name, **known)))
    found = {_kind(path) for path in products}
    kinds = {kind: title for kind, title in KINDS.items() if kind in found}
    write_json(data / "datapackage.json", data_package(data, kinds, release))
    write_json(data / METADATA, crate(data, kinds, run, release))
    readme = render("README.md", **known, **describe_content(data, kinds))
    (folder / "README.md").write_text(readme, encoding="utf-8")
    seal(folder, release)


def _kind(product) -> str:
    """Kind of a product: the folder of ``results/`` that it lies in."""
    kind = PurePosixPath(product).parent.name
    if kind not in KINDS:
        raise ValueError(f"{product}: kind {kind!r} is unknown; allowed: {', '.join(KINDS)}")
    return kind


def _copy(path: str | os.PathLike, place: Path) -> None:
    """Copy the bytes of a file, but not its mode, owner or time."""
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, place)
