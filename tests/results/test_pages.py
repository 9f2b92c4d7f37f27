"""Numbers in README and docs are those of the run."""

import runpy
from pathlib import Path

import pytest

pytestmark = pytest.mark.results

TOOL = Path(__file__).parents[2] / "docs" / "readme_numbers.py"


def test_the_pages_say_what_the_results_say(capsys):
    status = runpy.run_path(TOOL)["main"]([])
    assert status == 0, capsys.readouterr().out
