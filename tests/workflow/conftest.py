"""Runs of each target, made once; every test gets a copy to harm."""

import fcntl
import json
import os
import signal
import time

import pytest
import yaml
from workspace import INTERPRETATIONS, MINIMAL, NEARBY, Workspace, start

BUDGET = {
    "scattered": 4,
    "starts": 1,
    "descents": 1,
    "hops": 1,
    "iterations": 1,
    "evaluations": 1,
    "nearby_evaluations": 1,
}
BUDGET |= {"elastic_radius": 5e-5, "walkers": 18, "steps": 1}
KEPT = "kept.json"  # what there was of the atlas when its run was killed


@pytest.fixture(scope="session")
def sources(tmp_path_factory):
    """A fresh copy of the repository, nothing run; not to be written to."""
    return Workspace.of_sources(tmp_path_factory.mktemp("sources") / "thirdbody")


@pytest.fixture(scope="session")
def made_once(sources, tmp_path_factory, worker_id):
    """Function that gives what ``make`` makes of a copy of the repository, the same for all
    processes that test; not to be written to."""
    own = tmp_path_factory.getbasetemp()
    shared = own if worker_id == "master" else own.parent

    def once(name, make):
        made = shared / name
        with open(shared / f"{name}.lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not made.exists():
                workspace = sources.copied_to(own / f"making_{name}")
                make(workspace)
                workspace.root.rename(made)
        return Workspace(made)

    return once


def succeed(workspace, *arguments):
    """A run that has to succeed."""
    run = workspace.snakemake(*arguments)
    assert run.returncode == 0, run.stdout + run.stderr


@pytest.fixture(scope="session")
def finished(made_once):
    """The repository after a run, which takes from the repository what is up to date."""
    return made_once("finished", _finish)


def _finish(workspace):
    workspace.take_products()
    succeed(workspace)


@pytest.fixture(scope="session")
def atlas_run(made_once):
    """The repository after a run of the atlas that was killed when two chunks were there, and went
    on; and when the products were written that the kill left."""
    workspace = made_once("atlas_run", _make_atlas)
    return workspace, json.loads((workspace.root / KEPT).read_text(encoding="utf-8"))


def _make_atlas(workspace):
    first = start(workspace, "atlas", "-c1", *MINIMAL)
    chunks = workspace.root / "results" / "atlas" / "chunks"
    while len(list(chunks.glob("[0-9]*.nc"))) < 2:  # then Snakemake has recorded the first
        assert first.poll() is None, "it ended before"
        time.sleep(0.05)
    os.killpg(first.pid, signal.SIGKILL)
    first.communicate()
    (workspace.root / KEPT).write_text(json.dumps(workspace.stamps()), encoding="utf-8")
    succeed(workspace, "atlas", *MINIMAL)


@pytest.fixture(scope="session")
def calibrated(made_once):
    """The repository after the calibration of two interpretations."""
    return made_once("calibrated", _calibrate)


def _calibrate(workspace):
    settings = yaml.safe_load((workspace.root / "config/calibration.yaml").read_text())
    headline = settings["headline"][:1]

    def smaller(text):
        settings = yaml.safe_load(text)
        settings["budget"], settings["seeds"] = BUDGET, [1, 2]
        settings["folds"] = [[3, 4, 5, 6, 7, 8], [9, 10, 11, 12, 13]]
        settings["headline"] = headline
        settings["ensemble"] = {"of": NEARBY, "of_each_fold": 2}
        settings["profiles"] = [{"of": NEARBY, "along": "reach", "levels": [4.4]}]
        settings["interpretations"] = {
            name: settings["interpretations"][name] for name in INTERPRETATIONS
        }
        return yaml.safe_dump(settings)

    def fewer(text):
        statements = yaml.safe_load(text)
        every = [*statements[::8], *(row for row in statements if row["id"] in headline)]
        return yaml.safe_dump(list({row["id"]: row for row in every}.values()))

    workspace.rewrite("config/calibration.yaml", smaller)
    workspace.rewrite("config/claims.yaml", fewer)
    succeed(workspace, "calibrate", *MINIMAL)


@pytest.fixture
def workspace(finished, tmp_path):
    """The repository after a run, for one test to change."""
    return finished.copied_to(tmp_path / "thirdbody")
