"""What is installed is locked, few and named; importing it does nothing."""

import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT = PYPROJECT["project"]
EXTRAS = PROJECT["optional-dependencies"]
PYTHON = "Programming Language :: Python :: 3."
# imports every module of the library except those of matplotlib, cma, which imports that, and
# emcee, which imports h5py: they write or run when imported (a cache of fonts, uname); and prints
# what was run, reached or written
IMPORT_ALL = """
import importlib, os, pkgutil, sys
sys.dont_write_bytecode = True
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT
DEEDS = {"subprocess.Popen", "os.system", "os.exec", "os.fork", "os.posix_spawn", "socket.connect"}
DEEDS |= {f"os.{deed}" for deed in ("mkdir", "rename", "remove", "rmdir", "link", "symlink")}

def hook(event, given):
    if event in DEEDS or (event == "open" and given[2] & WRITING):
        print(event, *given[:2])

import thirdbody
sys.addaudithook(hook)
names = [module.name for module in pkgutil.walk_packages(thirdbody.__path__, "thirdbody.")]
left_out = "thirdbody.plotting", "chenhorng.figures"
left_out += "chenhorng.calibration.search", "chenhorng.calibration.choice"
names = [name for name in names if not name.startswith(left_out)]
for name in names:
    importlib.import_module(name)
print(len(names))
"""


def name_of(requirement):
    return re.match(r"[\w-]+", requirement)[0].lower()


def named_by(*extras):
    """Packages that the project names for itself and for some extras."""
    named = {name_of(one) for one in PROJECT["dependencies"]}
    for requirement in (one for extra in extras for one in EXTRAS[extra]):
        own = re.fullmatch(rf"{PROJECT['name']}\[([\w,]+)\]", requirement)
        named |= named_by(*own[1].split(",")) if own else {name_of(requirement)}
    return named


def test_there_is_a_reason_for_every_direct_dependency():
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = text.partition("\n## Dependencies\n")[2].partition("\n## ")[0]
    rows = re.findall(r"(?m)^\| ([^|]+) \| [^|]+ \|$", table)
    named = {name.lower() for row in rows[1:] for name in row.strip().split(", ")}
    to_build = {name_of(one) for one in PYPROJECT["dependency-groups"]["build"]}
    assert named == named_by(*EXTRAS) | to_build
    assert not named_by(*EXTRAS) & to_build


def test_each_python_that_is_tested_is_classified():
    workflow = (ROOT / ".github" / "workflows" / "tests.yml").read_text(encoding="utf-8")
    matrix = yaml.safe_load(workflow)["jobs"]["library"]["strategy"]["matrix"]
    pythons = [f"{PYTHON}{python.removeprefix('3.')}" for python in matrix["python"]]
    assert pythons == [one for one in PROJECT["classifiers"] if one.startswith(PYTHON)]


def test_the_citation_and_the_package_name_one_repository():
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert citation["repository-code"] == PROJECT["urls"]["Source"]
    assert PROJECT["urls"].keys() == {"Documentation", "Source", "Issues", "Changelog", "Paper"}


@pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")
@pytest.mark.parametrize("name", ["pyproject.toml", "CITATION.cff"])
def test_a_forgotten_placeholder_is_named(tmp_path, name):
    def placeholders():
        command = ["make", "--silent", "--file", ROOT / "Makefile", "placeholders"]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True)

    for written in ("pyproject.toml", "CITATION.cff"):
        (tmp_path / written).write_text("Source: https://example.org/thirdbody\n")
    assert placeholders().returncode == 0
    (tmp_path / name).write_text("Source: https://placeholder.invalid/source\n")
    done = placeholders()
    assert done.returncode != 0
    assert done.stdout == f"{name}:1:Source: https://placeholder.invalid/source\n"


def test_importing_the_library_runs_nothing_and_writes_nothing(tmp_path, tell):
    done = subprocess.run(
        [sys.executable, "-c", IMPORT_ALL], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    *deeds, count = done.stdout.splitlines()
    assert deeds == []
    assert list(tmp_path.iterdir()) == []
    tell(f"library: {count} modules imported, nothing run, reached or written")
