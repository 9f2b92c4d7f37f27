"""ro-crate-metadata.json: description of each file of an archive, by RO-Crate 1.1
(https://w3id.org/ro/crate/1.1)."""

from pathlib import Path, PurePosixPath
from typing import Any

from rocrate.rocrate import ROCrate

from chenhorng.archive.citation import Release
from chenhorng.archive.files import files_in, media_type, render_json

METADATA = "ro-crate-metadata.json"
# folders of products, named as in results/, and their titles
KINDS = {
    "datasets": "solved points, one file a figure",
    "bands": "range of each quantity, 5 to 95 % (_low, _high), over the calibrated ensemble",
    "tables": "tables of the paper and what was extracted from the datasets",
    "figures": "figures, with the points drawn as CSV",
    "claims": "statements of the paper and their verdicts",
    "explorer": "a page for any browser: figures, statements and the model itself",
}
FOLDERS = {
    "configuration": "configuration of the run and the inputs of the model that follow from it",
    "source": "source code of the library, the workflow and the tests",
}


def crate(data: Path, kinds: dict[str, str], release: Release) -> dict[str, Any]:
    """Content of ``ro-crate-metadata.json`` for the folder ``data`` of an archive; ``kinds`` has the
    titles of its folders of products."""
    known = render_json("crate.json", release=release)
    described = ROCrate(version="1.1")
    for entity in known["entities"]:
        described.add_jsonld(entity)
    files = {
        path: described.add_file(dest_path=path, properties=_file_properties(path, release))
        for path in files_in(data, data)
        if path != METADATA
    }
    for folder, title in (FOLDERS | kinds).items():
        properties = {"name": folder, "description": title}
        entity = described.add_dataset(dest_path=f"{folder}/", properties=properties)
        entity["hasPart"] = [part for path, part in files.items() if path.startswith(f"{folder}/")]
    for name, value in known["root"].items():
        described.root_dataset[name] = value
    return described.metadata.generate()


def _file_properties(path: str, release: Release) -> dict[str, Any]:
    """Properties of a file, with its licence if it differs from that of the archive."""
    properties: dict[str, Any] = {
        "name": PurePosixPath(path).name,
        "encodingFormat": media_type(path),
    }
    if path.startswith("source/") and not path.startswith("source/config/"):
        properties["license"] = {"@id": f"https://spdx.org/licenses/{release.citation['license']}"}
    return properties
