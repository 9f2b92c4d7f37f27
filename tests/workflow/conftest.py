"""One full run on the minimal configuration; every test gets a copy of it to harm."""

import fcntl

import pytest
from workspace import Workspace


@pytest.fixture(scope="session")
def sources(tmp_path_factory):
    """A fresh copy of the repository, nothing run; not to be written to."""
    return Workspace.of_sources(tmp_path_factory.mktemp("sources") / "thirdbody")


@pytest.fixture(scope="session")
def finished(sources, tmp_path_factory, worker_id):
    """The repository after a full minimal run, the same for all processes that test; not to be
    written to."""
    own = tmp_path_factory.getbasetemp()
    shared = own if worker_id == "master" else own.parent
    made = shared / "finished"
    with open(shared / "finished.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not made.exists():
            workspace = sources.copied_to(own / "running")
            run = workspace.snakemake()
            assert run.returncode == 0, run.stdout + run.stderr
            workspace.root.rename(made)
    return Workspace(made)


@pytest.fixture(scope="session")
def recorded(finished):
    """What Snakemake recorded of each output of that run."""
    return finished.summary()


@pytest.fixture
def workspace(finished, tmp_path):
    """The repository after a full minimal run, for one test to change."""
    return finished.copied_to(tmp_path / "thirdbody")
