"""A mutated configuration file is refused in one line that names the fault, or means something."""

import collections
import shutil

import numpy as np
import pytest
from harm import LONG
from mutations import Mutation, mutations, slips
from workspace import ROOT

from thirdbody.configuration import schema
from thirdbody.configuration.settings import read_settings
from thirdbody.data.scene import Scene
from thirdbody.model.parameters import Parameters
from thirdbody.study.claims import load_claims

CLAIMS = "config/claims.yaml"
UNREADABLE = ("TRACEBACK", "\\Z", "(?", "^[")  # what is no line for people: regular expressions


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
        settings = read_settings({}, "config")
        if mutation.file == CLAIMS:  # else they are as they were
            load_claims(CLAIMS)
    except ValueError as error:
        return str(error)
    inputs = Parameters(**settings["parameters"])
    for name, scene in settings["scenes"].items():
        assert np.isfinite(Scene.of(name, scene, inputs.newtons_per_load).load).all()
    return "read"


def test_each_is_read_or_refused_in_one_line_that_names_the_fault(in_folder, tell):
    chosen = [*slips(), *mutations(1 if LONG else 8)]
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
