"""`snakemake release`: what goes to an archive, and what the verification in it finds.

That it is the same bytes wherever it is made is tested by ``survival/test_killed.py``.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from workspace import MINIMAL, ROOT, Workspace

from chenhorng.archive.citation import Release
from chenhorng.archive.files import files_in
from thirdbody.files import digest

FILES = ROOT / "pyproject.toml", ROOT / "CITATION.cff"
PAPER = Release.of(*FILES)
CHANGED = Release.of(*FILES, is_paper=False)
NAME = PAPER.full_name


@pytest.fixture(scope="module")
def released(finished, tmp_path_factory, needs_git):
    """The folder of a release, among the results that it was made of."""
    workspace = finished.copied_to(tmp_path_factory.mktemp("released") / "a folder")
    run = workspace.snakemake("release")
    assert run.returncode == 0, run.stdout + run.stderr
    return workspace.root / "results" / "release" / NAME


def verified(released):
    """Exit code and output of the verification, which leaves the datasets to the tests of
    products."""
    program = ROOT / "verification" / "verify.py"
    command = [sys.executable, program, released, "--sums", "--packed"]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, done.stdout


def test_the_paper_s_name_is_for_the_paper_s_configuration(released):
    workspace = Workspace(released.parents[2])
    dry_run = workspace.snakemake("release", "--dry-run", *MINIMAL)
    assert f"{CHANGED.full_name}.zip" in dry_run.stdout + dry_run.stderr
    crate = json.loads((released / "ro-crate-metadata.json").read_text(encoding="utf-8"))
    (root,) = (each for each in crate["@graph"] if each["@id"] == "./")
    assert root["version"] == PAPER.version


def test_release_is_one_folder_its_archive_and_the_record(released, tell):
    made = {path.name for path in released.parent.iterdir()}
    assert made == {NAME, f"{NAME}.zip", f"{NAME}-provenance.json"}
    record = released.with_name(f"{NAME}-provenance.json").read_text(encoding="utf-8")
    record = json.loads(record)
    assert record["archive"]["sha256"] and record["host"] and record["time"] and record["user"]
    code, line = verified(released)
    assert code == 0, line
    tell(f"archive: {line.strip()}")


def test_every_product_is_in_the_release(released):
    sums = (released.parents[1] / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    products = {line.split("  ", 1)[1] for line in sums}
    archived = set(files_in(released / "data", released / "data"))
    left_out = {name.partition("/")[0] for name in products - archived}
    assert left_out == {"extracted"}


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


@pytest.mark.parametrize("name", [f"{NAME}/data/tables/table1.csv", f"{NAME}.zip"])
def test_make_verify_names_a_damaged_file_of_any_release(released, tmp_path, name):
    place = tmp_path / "results" / "soft"
    shutil.copytree(released.parent, place / "release")
    shutil.copytree(ROOT / "verification", tmp_path / "verification")
    (place / "release" / name).write_bytes(b"damaged")
    (tmp_path / "results" / "SHA256SUMS").write_text(
        f"{digest(ROOT / 'LICENSE')}  {ROOT / 'LICENSE'}\n"
    )
    python = f"BIN={Path(sys.executable).parent}"
    make = ["make", "--file", ROOT / "Makefile", "--assume-old", ".venv/workflow.done"]
    done = subprocess.run([*make, "verify", python], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode != 0
    assert Path(name).name in done.stdout
