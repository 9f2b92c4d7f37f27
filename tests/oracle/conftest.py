"""The oracle, compiled for each file of tests."""

import pytest

from tests.oracle.extended import Oracle


@pytest.fixture(scope="module")
def oracle(tmp_path_factory):
    return Oracle(tmp_path_factory.mktemp("oracle"))
