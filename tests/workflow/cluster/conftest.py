"""A cluster of one node, started once."""

import os
import shutil

import pytest
from single_node import PROGRAMS, Cluster

ABSENT = "SLURM is not installed; on Debian: apt-get install slurm-wlm munge"
NOT_ROOT = "root alone can start a node of SLURM"


@pytest.fixture(scope="session")
def cluster(tmp_path_factory):
    """A cluster that is up; in continuous integration its absence is an error."""
    absent = ABSENT if None in map(shutil.which, PROGRAMS) else None
    absent = absent or (NOT_ROOT if os.geteuid() else None)
    if absent:
        (pytest.fail if os.environ.get("CI") else pytest.skip)(absent)
    cluster = Cluster(tmp_path_factory.mktemp("cluster"))
    try:
        cluster.start_all()
        yield cluster
    finally:
        cluster.stop()
