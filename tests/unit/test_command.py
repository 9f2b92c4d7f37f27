"""The command: every example runs, JSON parses, exit codes and messages are as promised."""

import json
import shlex
import subprocess
import sys

import pytest

from thirdbody.command.main import ANSWERED, BAD_INPUT, NONE_FOUND, main
from thirdbody.command.questions import QUESTIONS, example

DRY = "--viscosity-cSt 0 --roughness-nm 300 --particle-density-per-m2 0 --load-N 10"
# a command, and what its one line says
REFUSED = {
    "state --load-N ten": "--load-N is 'ten'; allowed: a positive number, without unit",
    "state --load-N 0": "--load-N is '0'; allowed: a positive number, without unit",
    "state --load-N nan": "--load-N is 'nan'; allowed: a positive number, without unit",
    "state --viscosity-cSt -1": "--viscosity-cSt is '-1'; allowed: a zero or positive number",
    "state --load-N 1": "required: --viscosity-cSt",
    "state --load 1": "required: --load-N",
    "state --inputs absent.yaml": "--inputs is 'absent.yaml'",
    "answer": "allowed: state, viscosity, size",
    f"size {DRY} --from 100 --to 10": "--from is 100; allowed: less than --to, 10",
    "bearing --ball wood": "--ball is 'wood'; allowed: steel, silicon-nitride, alumina",
    "bearing --ball 205,0.7,5": "--ball is '205,0.7,5'",
    "bearing --speed-m-per-s 2": "--speed-m-per-s is 2.0 and the oil's density None; allowed: both",
    "curve --along time": "--along is 'time'; allowed: load, viscosity",
    "curve --along load --from 1 --to 2": "--viscosity-cSt is missing; allowed: a number",
    "curve --along load --count 1": "--count is '1'; allowed: a whole number from 2 to 100000",
    f"curve {DRY} --particle-diameter-nm 0 --along load --from 1 --to 2 --plot a.txt": (
        "a.txt ends with 'txt'; allowed: svg, pdf, png"
    ),
    f"curve {DRY} --particle-diameter-nm 0 --along load --from 1 --to 2 --csv no/a.csv": "no/a.csv",
}


def run(command):
    """The exit code of a command line."""
    try:
        return main(shlex.split(command))
    except SystemExit as left:
        return left.code


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_example_of_each_question_works(name, capsys):
    command = QUESTIONS[name].example.removeprefix("thirdbody ")
    assert run(command) == ANSWERED
    capsys.readouterr()
    assert run(f"{command} --json") == ANSWERED
    assert json.loads(capsys.readouterr().out)


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_help_shows_the_example(name, capsys):
    assert run(f"{name} --help") == 0
    assert QUESTIONS[name].example in capsys.readouterr().out


@pytest.mark.parametrize("command", REFUSED)
def test_bad_input_is_one_line(command, capsys):
    assert run(command) == BAD_INPUT
    printed = capsys.readouterr()
    assert printed.out == ""
    (line,) = printed.err.splitlines()
    assert line.startswith("thirdbody") and REFUSED[command] in line


def test_what_does_not_occur_has_an_exit_code_of_its_own(capsys):
    assert run(f"size {DRY}") == NONE_FOUND
    assert "none" in capsys.readouterr().out


def test_a_written_bearing_is_read_by_the_other_questions(capsys):
    assert run("bearing --ball-radius-mm 10 --write mine.yaml") == ANSWERED
    assert run(example("compare", more="--other-inputs mine.yaml --json")) == BAD_INPUT
    capsys.readouterr()
    command = example("compare", more="--other-inputs mine.yaml --json").partition(" ")[2]
    assert run(command) == ANSWERED
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)["rows"]}
    thickness = rows["film_thickness"]
    assert thickness["value"] != pytest.approx(thickness["other"], rel=0.1)


def test_a_curve_is_printed_as_it_is_written(capsys):
    command = example("curve", "load", "--along load --from 1 --to 50 --count 3").partition(" ")[2]
    assert run(command) == ANSWERED
    printed = capsys.readouterr().out
    assert run(f"{command} --csv curve.csv") == ANSWERED
    with open("curve.csv", encoding="utf-8") as written:
        assert written.read() == printed
    assert len(printed.splitlines()) == 4


def test_the_module_is_the_command():
    done = subprocess.run([sys.executable, "-m", "thirdbody", "--help"], capture_output=True)
    assert done.returncode == 0 and b"turning-point" in done.stdout
