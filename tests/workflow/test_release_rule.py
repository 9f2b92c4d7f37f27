"""`snakemake release`: what goes to an archive, and what the verification in it finds.

That it is the same bytes wherever it is made is tested by ``survival/test_killed.py``.
"""

import json
import subprocess
import sys

import pytest
from workspace import ROOT, Workspace

from thirdbody.release.bag import files_in
from thirdbody.release.citation import Release
from thirdbody.release.codecheck import targets

PAPER = Release.of(ROOT / "pyproject.toml", ROOT / "CITATION.cff")
NAME = PAPER.of_other_configuration().full_name  # of the few loads that are solved here


@pytest.fixture(scope="module")
def released(finished, tmp_path_factory):
    """The folder of a release, among the results that it was made of."""
    workspace = finished.copied_to(tmp_path_factory.mktemp("released") / "a folder")
    run = workspace.snakemake("release")
    assert run.returncode == 0, run.stdout + run.stderr
    return workspace.root / "results" / "release" / NAME


def verified(program, *arguments):
    """Exit code and output of the verification ``program``."""
    command = [sys.executable, program, *arguments]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, done.stdout


def verified_with_products(released):
    program = ROOT / "verification" / "verify.py"
    return verified(program, released, "--results", released.parents[1])


def test_the_paper_s_name_is_for_the_paper_s_configuration(released):
    workspace = Workspace(released.parents[2])
    dry_run = workspace.snakemake("release", "--dry-run", config=())
    assert f"{PAPER.full_name}.zip" in dry_run.stdout + dry_run.stderr
    crate = json.loads((released / "data" / "ro-crate-metadata.json").read_text(encoding="utf-8"))
    (root,) = (each for each in crate["@graph"] if each["@id"] == "./")
    assert root["version"] == PAPER.of_other_configuration().version


def test_release_is_one_folder_its_archive_and_the_record(released, tell):
    made = {path.name for path in released.parent.iterdir()}
    assert made == {NAME, f"{NAME}.zip", "provenance.json"}
    code, line = verified_with_products(released)
    assert code == 0, line
    assert "11 datasets" in line
    tell(f"archive: {line.strip()}")


def test_sums_of_all_products_hold_after_a_release(released):
    root = Workspace(released.parents[2])
    told = root.execute("make", "--no-print-directory", "sums")
    assert (told.returncode, told.stdout) == (0, ""), told.stderr
    archive = released.with_name(f"{NAME}.zip")
    archive.write_bytes(content := archive.read_bytes() + b"harmed")
    told = root.execute("make", "--no-print-directory", "sums")
    archive.write_bytes(content.removesuffix(b"harmed"))
    assert told.returncode != 0
    assert told.stdout == f"results/release/{NAME}.zip: FAILED\n"


def test_every_target_of_the_workflow_is_in_the_release(released):
    listed = {name.removeprefix("results/") for name in targets(ROOT / "workflow/Snakefile")}
    archived = set(files_in(released / "data", released / "data"))
    assert {name.partition("/")[0] for name in listed - archived} == {"accuracy"}


def test_crate_follows_every_product_to_its_rule(released):
    graph = json.loads((released / "data/ro-crate-metadata.json").read_text(encoding="utf-8"))
    entities = {entity["@id"]: entity for entity in graph["@graph"]}
    jobs = [one for one in entities.values() if one["@type"] == "CreateAction"]
    made = {one["@id"] for job in jobs if job["@id"] != "#run" for one in listed(job["result"])}
    made_by_run = {one["@id"] for one in listed(entities["#run"]["result"])}
    assert made_by_run - made == {"datasets/content-sha256.json"}
    drawing = entities["#render_figure-fig09"]
    assert drawing["instrument"]["@id"] == "source/workflow/scripts/render_figure.py"
    assert {"@id": "datasets/fig09.nc"} in listed(drawing["object"])
    assert {"@id": "configuration/config.json"} in listed(entities["#solve_scene-fig09"]["object"])


def listed(value):
    """``value`` as a list: JSON-LD writes a list of one as the one."""
    return value if isinstance(value, list) else [value]


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
