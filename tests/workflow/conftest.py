"""One full run on the minimal configuration; every test gets a copy of it to harm."""

import pytest
from workspace import Workspace


@pytest.fixture(scope="session")
def sources(tmp_path_factory):
    """A fresh copy of the repository, nothing run; not to be written to."""
    return Workspace.of_sources(tmp_path_factory.mktemp("sources") / "thirdbody")


@pytest.fixture(scope="session")
def finished(sources, tmp_path_factory):
    """The repository after a full minimal run; not to be written to."""
    workspace = sources.copied_to(tmp_path_factory.mktemp("finished") / "thirdbody")
    run = workspace.snakemake()
    assert run.returncode == 0, run.stdout + run.stderr
    return workspace


@pytest.fixture(scope="session")
def recorded(finished):
    """What Snakemake recorded of each output of that run."""
    return finished.summary()


@pytest.fixture
def workspace(finished, tmp_path):
    """The repository after a full minimal run, for one test to change."""
    return finished.copied_to(tmp_path / "thirdbody")
