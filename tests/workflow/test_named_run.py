"""A run with a name keeps its files to itself, and others theirs."""

import re

import pytest
from workspace import ROOT

from chenhorng.configuration.settings import read_settings

SOFT = "inputs: {hardness_surface_1: 3.0e+9}\nrun: soft\n"
CHANGES = "--config", "changes=soft.yaml"
MADE = (
    "results/soft/tables/table1.html",
    "results/soft/datasets/fig03.nc",
    "results/soft/extracted/tpca_loads/fig03.csv",
)
RULES = "".join(path.read_text() for path in ROOT.glob("workflow/rules/*.smk"))


@pytest.fixture(scope="module")
def twofold(finished, tmp_path_factory):
    """A finished run without a name, beside one of a few products with another input."""
    workspace = finished.copied_to(tmp_path_factory.mktemp("twofold") / "thirdbody")
    (workspace.root / "soft.yaml").write_text(SOFT)
    run = workspace.snakemake(*MADE, *CHANGES)
    assert run.returncode == 0, run.stderr
    return workspace


def files(root, *folders):
    """Times of all files in ``folders``, by name."""
    paths = (path for folder in folders for path in (root / folder).rglob("*") if path.is_file())
    return {str(path.relative_to(root)): path.stat().st_mtime_ns for path in paths}


def test_all_of_a_named_run_is_in_its_folder(finished, twofold):
    before, after = (files(each.root, "results", "logs") for each in (finished, twofold))
    added = after.keys() - before.keys()
    assert added >= {*MADE, "results/soft/logs/solve_scene/fig03.log"}
    assert all(name.startswith("results/soft/") for name in added)
    assert {name: after[name] for name in before} == before
    datasets = (twofold.root / path / "datasets/fig03.nc" for path in ("results", "results/soft"))
    assert len({path.read_bytes() for path in datasets}) == 2


@pytest.mark.parametrize("arguments", [(), (*MADE, *CHANGES)], ids=["back", "and forth"])
def test_switching_computes_nothing(twofold, arguments):
    run = twofold.snakemake("--dry-run", *arguments)
    assert run.returncode == 0, run.stderr
    assert "Nothing to be done" in run.stdout + run.stderr


def test_the_name_changes_no_byte(finished, twofold):
    table = "tables/table1.html"
    run = twofold.snakemake(f"results/same/{table}", "--config", "run=same")
    assert run.returncode == 0, run.stderr
    same = (twofold.root / "results/same" / table).read_bytes()
    assert same == (finished.root / "results" / table).read_bytes()


def test_a_run_is_not_called_like_a_folder_of_products():
    """Its files would mix with those of the run without a name."""
    for name in set(re.findall(r'"<results>/(\w+)/', RULES)):
        with pytest.raises(ValueError, match="that no product has"):
            read_settings({"run": name}, ROOT / "config")
