"""The file ``ro-crate-metadata.json``, which describes the files of an archive.

It is a Workflow RO-Crate 1.0 (https://w3id.org/workflowhub/workflow-ro-crate/1.0), a profile of
RO-Crate 1.1.
"""

from pathlib import Path, PurePosixPath
from typing import Any

from rocrate.rocrate import ROCrate

from chenhorng.archive.citation import Release
from chenhorng.archive.files import files_in, media_type, render_json
from thirdbody.ensembles import RANGE

METADATA = "ro-crate-metadata.json"
WORKFLOW = "data/source/Snakefile"
# the files of the bag itself, which describe the others
OF_BAG = ("bag-info.txt", "bagit.txt", "manifest-sha256.txt", "tagmanifest-sha256.txt")
# folders of products, named as in results/, and their titles
PRODUCT_FOLDERS = {
    "datasets": "solved points, one file a figure",
    "bands": f"{RANGE} (_low, _high)",
    "tables": "tables of the paper and what was extracted from the datasets",
    "figures": "figures, with the points drawn as CSV",
    "claims": "statements of the paper and their verdicts",
    "explorer": "a page for any browser: figures, statements and the model itself",
}
OTHER_FOLDERS = {
    "data/configuration": "configuration of the run, and the inputs of the model that follow",
    "data/source": "source code of the library, the workflow and the tests",
    "verification": "programs that check the archive without the library",
}


def crate(folder: Path, titles: dict[str, str], release: Release) -> dict[str, Any]:
    """Content of ``ro-crate-metadata.json`` for the ``folder`` of an archive.  ``titles`` has the
    titles of the folders of products in ``data/``."""
    known = render_json("crate.json", release=release, workflow=WORKFLOW)
    described = ROCrate(version="1.1")
    for entity in known["entities"]:
        described.add_jsonld(entity)
    files = {}
    for path in files_in(folder, folder):
        properties = _file_properties(path, release) | known["files"].get(path, {})
        if path == WORKFLOW:
            files[path] = described.add_workflow(
                dest_path=path, properties=properties, main=True, lang="snakemake"
            )
        elif path not in (METADATA, *OF_BAG):
            files[path] = described.add_file(dest_path=path, properties=properties)
    products = {f"data/{name}": title for name, title in titles.items()}
    for path, title in (OTHER_FOLDERS | products).items():
        properties = {"name": PurePosixPath(path).name, "description": title}
        entity = described.add_dataset(dest_path=f"{path}/", properties=properties)
        entity["hasPart"] = [part for name, part in files.items() if name.startswith(f"{path}/")]
    for name, value in known["root"].items():
        described.root_dataset[name] = value
    return described.metadata.generate()


def _file_properties(path: str, release: Release) -> dict[str, Any]:
    """Properties of a file; its licence is among them if it differs from that of the archive."""
    properties: dict[str, Any] = {
        "name": PurePosixPath(path).name,
        "encodingFormat": media_type(path),
    }
    is_code = path.startswith(("data/source/", "verification/"))
    if is_code and not path.startswith("data/source/config/"):
        properties["license"] = {"@id": f"https://spdx.org/licenses/{release.citation['license']}"}
    return properties
