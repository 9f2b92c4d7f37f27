"""Pages of the documentation say what the files, the solver and the command say."""

import re
import runpy
from pathlib import Path

import pytest

from thirdbody.command import EXAMPLES
from thirdbody.core.regimes import WITHOUT_VALUES
from thirdbody.variables import AXES, FLAGS, NORMAL_LOAD, STATUS_MEANINGS, VARIABLES

DOCS = Path(__file__).parents[2] / "docs"
NOMENCLATURE = (DOCS / "nomenclature.md").read_text(encoding="utf-8")
QUESTIONS = (DOCS / "questions.md").read_text(encoding="utf-8")
TOOL = DOCS / "readme_numbers.py"


def test_the_page_has_every_condition_and_variable_as_the_files_have_them():
    tool = runpy.run_path(TOOL)
    assert tool["renewed"](NOMENCLATURE, {"variables": tool["variables_block"]}) == NOMENCLATURE
    for each in (*AXES.values(), NORMAL_LOAD, *VARIABLES.values()):
        assert f"`{each.name}`" in NOMENCLATURE


def test_the_page_and_the_files_explain_each_status_once_and_alike():
    row = r"^\| `(\w+)` \| ([^|]+) \| (given|nan; regime and mode -1) \|$"
    rows = re.findall(row, NOMENCLATURE, re.M)
    assert [(name, text) for name, text, _ in rows] == list(STATUS_MEANINGS.items())
    assert tuple(name for name, _, values in rows if values != "given") == WITHOUT_VALUES
    flag = FLAGS["solution_status"]
    assert flag.meanings == tuple(STATUS_MEANINGS)
    assert flag.comment.split("; ") == [": ".join(row[:2]) for row in rows]


def blocks(language):
    """Examples of a language in the page of the ten questions."""
    return re.findall(rf"```{language}\n(.*?)```", QUESTIONS, re.DOTALL)


def test_the_page_shows_each_question_and_what_it_prints():
    commands = {" ".join(block.replace("\\\n", " ").split()) for block in blocks("sh")}
    assert commands >= set(EXAMPLES.values())
    assert all(f"<!-- question {name} -->\n```text\n" in QUESTIONS for name in EXAMPLES)


def test_the_calls_of_the_questions_run(capsys):
    names = {}
    for block in blocks("python"):
        exec(block, names)
    printed = capsys.readouterr().out
    assert "State at load 10 N" in printed and "Two interfaces" in printed


@pytest.mark.parametrize(
    ("page", "run", "same"),
    [
        ("takes 1.2 µs", "takes  3.5 µs", True),
        ("takes 1.2 µs", "takes 3.7 µs", False),
        ("takes 1.2 µs", "took 1.2 µs", False),
        ("1e-05 of 0", "1e-05 of 1", False),
        ("1 and 2", "1 and", False),
    ],
)
def test_measured_numbers_agree_up_to_a_factor(page, run, same):
    assert runpy.run_path(TOOL)["agree"](page, run) == same
