"""A mutated configuration file is refused in one line that names the fault, or means something."""

import collections
import shutil
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest
from harm import LONG
from mutations import Mutation, mutations, slips
from workspace import ROOT, run_here

from thirdbody.configuration import schema
from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.configuration.settings import read_plain, require_surfaces, workflow_settings
from thirdbody.data.scene import Scene
from thirdbody.model.parameters import Parameters
from thirdbody.study.claims import load_claims

NAMES = (
    "a b",
    "it's",
    'say "no"',
    "a\nb",
    "$(touch pwned)",
    "`touch pwned`",
    "; touch pwned",
    "é*",
)
CLAIMS = "config/claims.yaml"
CHEAP = "results/extracted/table1/all.csv"
UNREADABLE = ("TRACEBACK", "\\Z", "(?", "^[")  # what is no line for people: regular expressions
MADE = ("results", "logs", ".snakemake", "__pycache__")
# what Snakemake says of its own settings before it reads the workflow
ANNOUNCED = ("Using workflow specific profile", "Config file config/")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with the configuration alone."""
    root = tmp_path_factory.mktemp("mutated")
    shutil.copytree(ROOT / "config", root / "config")
    return root


@pytest.fixture
def in_folder(folder, monkeypatch):
    monkeypatch.chdir(folder)
    monkeypatch.setattr(schema, "config_directory", lambda: folder / "config")
    return folder


def outcome(mutation: Mutation) -> str:
    """How the file is taken, read as the Snakefile reads it: ``read``, or the line of its refusal."""
    try:
        files = "config/config.yaml", "config/scenes.yaml"
        read_plain(*files)
        merged = {}
        for file in files:
            merged |= read_yaml(file)
        settings = workflow_settings(merged)
        require_surfaces(settings)
        if mutation.file == CLAIMS:  # else they are as they were
            load_claims(CLAIMS)
    except ValueError as error:
        return str(error)
    inputs = Parameters(**settings["parameters"])
    for name, scene in settings["scenes"].items():
        assert np.isfinite(Scene.of(name, scene, inputs.newtons_per_load).load).all()
    return "read"


def test_each_is_read_or_refused_in_one_line_that_names_the_fault(in_folder, tell):
    chosen = [*slips(), *mutations()[:: 1 if LONG else 12]]
    before = {path.name for path in in_folder.rglob("*")}
    count, faults = collections.Counter(), []
    for mutation in chosen:
        place = in_folder / mutation.file
        original = place.read_bytes()
        place.write_bytes(mutation.content)
        try:
            told = outcome(mutation)
        except Exception as error:
            told = f"TRACEBACK {type(error).__name__}: {error}"
        finally:
            place.write_bytes(original)
        count["read" if told == "read" else "refused"] += 1
        named = any(word in told for word in mutation.words)
        if told != "read" and (
            not named
            or len(told.splitlines()) != 1
            or len(told) > 700
            or any(word in told for word in UNREADABLE)
        ):
            faults.append(f"{mutation.name} -> {told[:300]}")
    assert not faults, "\n".join(faults)
    assert {path.name for path in in_folder.rglob("*")} == before
    tell(f"{len(chosen)} mutated configurations: {dict(count)}")
    assert count["refused"] >= len(slips())
    assert len(chosen) >= 300 or not LONG


def contents(root):
    """Every file that no run makes."""
    files = (path for path in root.rglob("*") if path.is_file())
    return {str(path): path.read_bytes() for path in files if not set(MADE) & set(path.parts)}


def run_all(sources, place, cases):
    """Run the workflow on each case, a pair of a file's content and its name; side by side.

    The file is given as ``--config changes=``.  Yields exit code, what was said, and whether any
    file appeared or changed that is none of the workflow's.
    """
    context = get_context("forkserver")
    context.set_forkserver_preload(["snakemake.cli", "jsonschema", "yte"])
    with ProcessPoolExecutor(2, context, max_tasks_per_child=1) as pool:
        under_way = []
        for number, (content, name) in enumerate(cases):
            root, said = place / str(number), place / f"{number}.txt"
            sources.copied_to(root)
            (root / name).write_bytes(content)
            before = contents(root)
            arguments = ("-c1", CHEAP, "--config", f"changes={name}")
            under_way.append((root, before, said, pool.submit(run_here, root, arguments, said)))
        for root, before, said, code in under_way:
            yield code.result(), said.read_text(errors="replace"), contents(root) == before


def test_the_command_takes_a_sample_as_the_reader_does(sources, tmp_path, tell):
    ours = ("config/config.yaml", "config/scenes.yaml")
    chosen = [each for each in mutations() if each.file in ours][:: 7 if LONG else 60]
    chosen += slips()[:: 1 if LONG else 8]
    cases = [(each.content, NAMES[place % len(NAMES)]) for place, each in enumerate(chosen)]
    codes = collections.Counter()
    for mutation, (code, said, kept) in zip(chosen, run_all(sources, tmp_path, cases), strict=True):
        lines = [line for line in said.splitlines() if line and not line.startswith(ANNOUNCED)]
        assert "Traceback" not in said, f"{mutation.name}\n{said}"
        assert code == 0 or len(lines) == 1, f"{mutation.name}\n{said}"
        assert kept, mutation.name
        codes["completed" if code == 0 else "refused"] += 1
    tell(f"{len(chosen)} mutated configurations given to the command: {dict(codes)}")
