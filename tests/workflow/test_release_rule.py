"""`snakemake release`: what goes to an archive, and what the verification in it finds.

That it is the same bytes wherever it is made is tested by ``survival/test_killed.py``.
"""

import json
import subprocess
import sys

import pytest
from workspace import MINIMAL, ROOT, Workspace

from thirdbody.paper.archive.citation import Release
from thirdbody.paper.archive.files import files_in

FILES = ROOT / "pyproject.toml", ROOT / "CITATION.cff"
PAPER = Release.of(*FILES)
CHANGED = Release.of(*FILES, is_paper=False)
NAME = PAPER.full_name


@pytest.fixture(scope="module")
def released(finished, tmp_path_factory):
    """The folder of a release, among the results that it was made of."""
    workspace = finished.copied_to(tmp_path_factory.mktemp("released") / "a folder")
    run = workspace.snakemake("release")
    assert run.returncode == 0, run.stdout + run.stderr
    return workspace.root / "results" / "release" / NAME


def verified_with_products(released):
    """Exit code and output of the verification, which leaves the datasets to the tests of products."""
    program = ROOT / "verification" / "verify.py"
    command = [sys.executable, program, released, "--sums", "--results", released.parents[1]]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, done.stdout


def test_the_paper_s_name_is_for_the_paper_s_configuration(released):
    workspace = Workspace(released.parents[2])
    dry_run = workspace.snakemake("release", "--dry-run", *MINIMAL)
    assert f"{CHANGED.full_name}.zip" in dry_run.stdout + dry_run.stderr
    crate = json.loads((released / "data" / "ro-crate-metadata.json").read_text(encoding="utf-8"))
    (root,) = (each for each in crate["@graph"] if each["@id"] == "./")
    assert root["version"] == PAPER.version


def test_release_is_one_folder_its_archive_and_the_record(released, tell):
    made = {path.name for path in released.parent.iterdir()}
    assert made == {NAME, f"{NAME}.zip", "provenance.json"}
    record = json.loads((released.parent / "provenance.json").read_text(encoding="utf-8"))
    assert record["archive"]["sha256"] and record["host"] and record["time"] and record["user"]
    code, line = verified_with_products(released)
    assert code == 0, line
    tell(f"archive: {line.strip()}")


def test_every_product_is_in_the_release(released):
    sums = (released.parents[1] / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    products = {line.split("  ", 1)[1] for line in sums}
    archived = set(files_in(released / "data", released / "data"))
    left_out = {name.partition("/")[0] for name in products - archived}
    assert left_out == {"captions.md", "extracted", "index.html", "schematics"}


def test_no_damaged_product_is_released(released, tmp_path):
    workspace = Workspace(released.parents[2]).copied_to(tmp_path / "damaged")
    product = workspace.root / "results/figures/fig05.svg"
    content = product.read_bytes()
    product.write_bytes(content[: len(content) // 2])
    stage = f"results/release/{NAME}/tagmanifest-sha256.txt"
    run = workspace.snakemake("--force", stage, "--allowed-rules", "stage_release")
    assert run.returncode != 0
    message = "results/figures/fig05.svg is not as its job made it; remake it: snakemake"
    assert message in run.stdout + run.stderr


def test_damaged_products_and_archive_file_are_named(released):
    results = released.parents[1]
    names = "datasets/fig03.nc", "tables/table1.csv", "figures/fig08.svg", f"release/{NAME}.zip"
    contents = {results / name: (results / name).read_bytes() for name in names}
    for path, content in contents.items():
        path.write_bytes(content[: len(content) // 2])
    code, line = verified_with_products(released)
    for path, content in contents.items():
        path.write_bytes(content)
    assert code == 1
    assert all(name in line for name in names)
