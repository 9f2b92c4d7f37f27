"""A cluster of one node, started once."""

import os
import shutil

import pytest
from single_node import PLUGIN, PROGRAMS, Cluster

PACKAGES = "slurm-wlm munge"


def what_is_missing():
    """Why there can be no cluster here, or nothing."""
    if None in map(shutil.which, PROGRAMS):
        return f"SLURM is not installed; on Debian: apt-get install {PACKAGES}"
    if not PLUGIN.is_dir():
        return "Snakemake's plugin for SLURM is not installed: make .venv/slurm.done"
    return "root alone can start a node of SLURM" if os.geteuid() else None


@pytest.fixture(scope="session")
def cluster(tmp_path_factory):
    """A cluster that is up; in continuous integration its absence is an error."""
    missing = what_is_missing()
    if missing:
        (pytest.fail if os.environ.get("CI") else pytest.skip)(missing)
    cluster = Cluster(tmp_path_factory.mktemp("cluster"))
    try:
        cluster.start_all()
        yield cluster
    finally:
        cluster.stop()
