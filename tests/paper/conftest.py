"""A small release, for the tests of its formats and of its verification."""

import os
from pathlib import Path

import matplotlib.style
import pytest
from small_release import make_release, this_release

from thirdbody.plotting.drawing import STYLE

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def style():
    """The style of the figures."""
    with matplotlib.style.context(STYLE, after_reset=True):
        yield


@pytest.fixture(scope="session")
def built(tmp_path_factory):
    """The folder of a release; tests leave it as it is."""
    before = Path.cwd()
    os.chdir(ROOT)  # the paths of sources are relative to it
    folder = make_release(tmp_path_factory.mktemp("release"))
    os.chdir(before)
    return folder


@pytest.fixture(scope="session")
def release():
    """The name, version and date of this release."""
    return this_release(ROOT)
