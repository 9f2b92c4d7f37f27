"""A mutated configuration file is refused in one line that names the fault, or means something."""

import collections
import shutil

import numpy as np
import pytest
from harm import LONG
from mutations import Mutation, mutations
from workspace import ROOT

from thirdbody import configuration
from thirdbody.parameters import Parameters
from thirdbody.scene import Scene

MUTATIONS = mutations()[:: 1 if LONG else 4]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with the configuration alone."""
    root = tmp_path_factory.mktemp("mutated")
    shutil.copytree(ROOT / "config", root / "config")
    return root


@pytest.fixture
def in_folder(folder, monkeypatch):
    monkeypatch.chdir(folder)
    monkeypatch.setattr(configuration, "config_directory", lambda: folder / "config")
    return folder


def outcome(mutation: Mutation) -> str:
    """How the file is taken, read as the Snakefile reads it: ``read``, or the line of its refusal."""
    try:
        files = "config/config.yaml", "config/scenes.yaml"
        configuration.read_plain(*files)
        merged = {}
        for file in files:
            merged |= configuration.read_yaml(file)
        settings = configuration.workflow_settings(merged)
    except ValueError as error:
        return str(error)
    inputs = Parameters(**settings["parameters"])
    for name, scene in settings["scenes"].items():
        assert np.isfinite(Scene.of(name, scene, inputs.newtons_per_load).load).all()
    return "read"


def test_each_is_read_or_refused_in_one_line_that_names_the_fault(in_folder, tell):
    before = {path.name for path in in_folder.rglob("*")}
    count, faults = collections.Counter(), []
    for mutation in MUTATIONS:
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
        if told != "read" and (not named or len(told.splitlines()) != 1 or len(told) > 700 or "TRACEBACK" in told):
            faults.append(f"{mutation.name} -> {told[:300]}")
    assert not faults, "\n".join(faults)
    assert {path.name for path in in_folder.rglob("*")} == before
    tell(f"{len(MUTATIONS)} mutated configurations: {dict(count)}")
    assert len(MUTATIONS) >= 300 or not LONG
