"""The products of an undisturbed run, to compare with."""

import pytest
from harm import products


@pytest.fixture(scope="session")
def undisturbed(finished):
    """Content of each product of a full minimal run, by its name under ``results/``."""
    return products(finished.root / "results")


@pytest.fixture
def tell(capsys):
    """Print a count that is to be seen."""

    def print_through(line):
        with capsys.disabled():
            print(f"\n{line}")

    return print_through
