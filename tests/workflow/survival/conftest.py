"""The products of an undisturbed run, to compare with."""

import pytest
from harm import complete, products


@pytest.fixture(scope="session")
def undisturbed(finished):
    """Content of each product of a run, by its name under ``results/``."""
    return products(finished.root / "results")


@pytest.fixture(scope="session")
def released(finished, tmp_path_factory):
    """The repository after such a run and `snakemake release`; not to be written to."""
    workspace = finished.copied_to(tmp_path_factory.mktemp("released") / "thirdbody")
    complete(workspace, "release")
    return workspace
