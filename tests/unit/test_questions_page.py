"""The page of the ten questions: its commands are those of the command's help, its calls run."""

import re
from pathlib import Path

import pytest

from thirdbody.command.questions import EXAMPLES

PAGE = (Path(__file__).parents[2] / "docs" / "questions.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_page_shows_the_example_and_what_it_prints(name):
    commands = [" ".join(block.replace("\\\n", " ").split()) for block in blocks("sh")]
    assert EXAMPLES[name] in commands
    assert f"<!-- question {name} -->\n```text\n" in PAGE


def test_the_calls_run(capsys):
    names = {}
    for block in blocks("python"):
        exec(block, names)
    printed = capsys.readouterr().out
    assert "State at load 10 N" in printed and "Two interfaces" in printed


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)
