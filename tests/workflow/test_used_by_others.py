"""The workflow as a part of other work: a module, a run in another folder, a deployed copy."""

import shutil
import subprocess
import sys
import zipfile

import netCDF4
import pytest
from workspace import Workspace

TABLE, DATASET = "results/tables/table2.csv", "results/datasets/fig03.nc"
MODULE = """
module paper:
    snakefile: "{snakefile}"
    {given}

use rule * from paper as paper_*

rule own:
    default_target: True
    input: {wanted}
"""
# what `snakedeploy deploy-workflow` writes
DEPLOYED = """
from snakemake.utils import min_version

min_version("6.10.0")

configfile: "config/config.yaml"

module thirdbody:
    snakefile:
        github("thirdbody/thirdbody", path="Snakefile", tag="v1")
    config:
        config

use rule * from thirdbody
"""


@pytest.fixture
def elsewhere(sources, tmp_path):
    """The folder of other work, where the library is that of ``sources``."""
    return Workspace(tmp_path / "elsewhere", sources.packages)


def write(workspace, path, text):
    place = workspace.root / path
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(text, encoding="utf-8")


def made(workspace, *names, arguments=()):
    """Have ``names`` made, and return the bytes of each."""
    run = workspace.snakemake(*names, *arguments)
    assert run.returncode == 0, run.stdout + run.stderr
    return [(workspace.root / name).read_bytes() for name in names]


def loads_in(dataset):
    """The number of loads of a dataset, from its bytes."""
    with netCDF4.Dataset("memory", memory=dataset) as opened:
        return opened.dimensions["load"].size


def test_a_module_takes_some_keys_and_puts_all_below_a_prefix(sources, elsewhere):
    snakefile = sources.root / "Snakefile"
    given = 'config: {"load_axis": {"count": 24}}\n    prefix: "contact"'
    product = f"contact/{DATASET}"
    module = MODULE.format(snakefile=snakefile, given=given, wanted=f'"{product}"')
    # a rule that is used once more reads the module once more
    module += "\nuse rule find_windows from paper as paper_find_windows with:\n    threads: 2\n"
    write(elsewhere, "workflow/Snakefile", module)
    (dataset,) = made(elsewhere, product)
    assert loads_in(dataset) == 24
    assert not (elsewhere.root / "results").exists()


def test_a_run_in_another_folder_makes_the_same_there(sources, finished, elsewhere):
    there = ("--snakefile", str(sources.root / "Snakefile"))
    elsewhere.root.mkdir()
    before = set(sources.root.rglob("*"))
    products = made(elsewhere, TABLE, DATASET, arguments=there)
    assert products == [(finished.root / name).read_bytes() for name in (TABLE, DATASET)]
    added = set(sources.root.rglob("*")) - before
    assert [path for path in added if "__pycache__" not in path.parts] == []


@pytest.fixture(scope="module")
def installed(sources, tmp_path_factory):
    """A folder of packages with the wheel of the sources: no repository lies around it."""
    folder = tmp_path_factory.mktemp("installed")
    built = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(built, cwd=sources.root, check=True, capture_output=True)
    (wheel,) = folder.glob("*.whl")
    zipfile.ZipFile(wheel).extractall(folder / "packages")
    return folder / "packages"


@pytest.fixture
def published(sources, tmp_path, monkeypatch, needs_git):
    """A git repository of the sources with the tag v1, which git takes for one on GitHub."""
    copy = sources.copied_to(tmp_path / "published")
    person = ("-c", "user.name=tests", "-c", "user.email=tests@localhost")
    for command in (
        ("init", "--quiet"),
        ("add", "."),
        ("commit", "-qm", "all", "--allow-empty"),
        ("tag", "v1"),
    ):
        done = copy.execute("git", *person, *command)
        assert done.returncode == 0, done.stderr
    monkeypatch.setenv("GIT_CONFIG_COUNT", "1")
    monkeypatch.setenv("GIT_CONFIG_KEY_0", f"url.file://{copy.root}.insteadOf")
    monkeypatch.setenv("GIT_CONFIG_VALUE_0", "https://github.com/thirdbody/thirdbody")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return copy


def test_a_deployed_copy_follows_the_configuration_beside_it(published, installed, tmp_path):
    deployed = Workspace(tmp_path / "deployed", (installed,))
    write(deployed, "workflow/Snakefile", DEPLOYED)
    shutil.copytree(published.root / "config", deployed.root / "config")
    deployed.put("config/scenes.yaml", "load_axis/count", 24)
    deployed.rewrite("config/paper_tables.yaml", lambda text: text.replace("0.04, 80", "0.05, 80"))
    dataset, table = made(deployed, DATASET, TABLE)
    assert loads_in(dataset) == 24
    assert b",0.05,80," in table
