"""The command: every example runs, JSON parses, exit codes and messages are as promised."""

import json
import os
import shlex
import subprocess
import sys
import warnings
from pathlib import Path

import pytest

import thirdbody as tb
from thirdbody import inputs
from thirdbody.__main__ import run as command
from thirdbody.command import ANSWERED, BAD_INPUT, EXAMPLES, NONE_FOUND, NOT_WRITTEN, STOPPED, main
from thirdbody.plain_yaml import read_yaml

DRY = "--viscosity-cSt 0 --roughness-nm 300 --particle-density-per-m2 0 --load-N 10"
CURVE = f"curve {DRY} --particle-diameter-nm 0 --along load --from 1 --to 2"
BEARING = EXAMPLES["bearing"].partition(" ")[2]
STATE = EXAMPLES["state"].partition(" ")[2]
# a command, and what its one line says
REFUSED = {
    "": "QUESTION is missing; allowed: state, viscosity, size",
    "answer": "QUESTION is 'answer'; allowed: state, viscosity, size",
    "state --load-N ten": "--load-N is 'ten'; allowed: a number, without unit",
    f"{STATE} --load-N 0": "--load-N is 0; allowed: positive finite numbers",
    f"{STATE} --viscosity-cSt -1": "--viscosity-cSt is -1; allowed: zero or positive finite numbers",
    "state --load_N 1": "there is no option --load_N (Possible options: --load-N)",
    f"{STATE} --inputs absent.yaml": "--inputs is 'absent.yaml'",
    f"size {DRY} --from 100 --to 10": "--from is 100; allowed: positive numbers less than --to, 10",
    f"curve {DRY} --particle-diameter-nm 0 --along load --from 0 --to 2": "--from is 0; allowed: pos",
    f"{CURVE} --csv ''": "'' is not a file name",
    f"compare {STATE.removeprefix('state ')} --other-roughness-nm 0": "--other-roughness-nm is 0",
    "compare-data": "FILE is missing",
    "compare-data ''": "'' cannot be read (No such file or directory)",
    "compare-data absent.csv": "absent.csv cannot be read (No such file or directory)",
    "bearing --ball wood": "--ball is 'wood'; allowed: steel, silicon-nitride, alumina",
    "bearing --ball 205,0.7,5": "--ball is '205,0.7,5'",
    "bearing --speed-m-per-s 2": "--speed-m-per-s is 2 and the oil's density None; allowed: both",
    f"compare {STATE.removeprefix('state ')}": "--other-... is missing; allowed: one or more",
    "curve --along time --from 1 --to 2": "--along is 'time'; allowed: load, viscosity",
    "curve --along laod --from 1 --to 2": "roughness, particle_density",
    "curve --along load --from 1 --to 2": "--viscosity-cSt is missing; allowed: a number",
    f"{CURVE} --count 1": "count is 1; allowed: 2 or more",
    f"{CURVE} --plot a.txt": "a.txt ends with 'txt'; allowed: svg, pdf, png",
}


def run(text):
    return main(shlex.split(text))


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    """An empty folder, and two members of the ensemble, which are enough here."""
    monkeypatch.chdir(tmp_path)
    every = inputs.ensemble_of
    monkeypatch.setattr(inputs, "ensemble_of", lambda *given: every(*given)[:2])
    monkeypatch.setattr(inputs, "_calibrated", inputs.load_parameters)  # not from the cache


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_example_of_each_question_works(name, capsys):
    example = EXAMPLES[name].partition(" ")[2]
    assert run(f"{example} --json") == ANSWERED
    assert json.loads(capsys.readouterr().out)
    assert run(f"{name} --help") == ANSWERED
    assert EXAMPLES[name] in capsys.readouterr().out


@pytest.mark.parametrize("text", REFUSED)
def test_bad_input_is_one_line(text, capsys):
    assert run(text) == BAD_INPUT
    printed = capsys.readouterr()
    (line,) = printed.err.splitlines()
    assert printed.out == "" and line.startswith("thirdbody") and REFUSED[text] in line


@pytest.mark.parametrize(
    ("text", "path"),
    [
        (f"{CURVE} --csv no/a.csv", "no/a.csv"),
        (f"{CURVE} --plot no/a.svg", "no/a.svg"),
        ("bearing --ball-radius-mm 10 --write no/mine.yaml", "no/mine.yaml"),
    ],
)
def test_a_file_that_cannot_be_written_is_one_line_with_the_code_for_it(text, path, capsys):
    assert run(text) == NOT_WRITTEN
    (line,) = capsys.readouterr().err.splitlines()
    assert line.endswith(f"{path} cannot be written (No such file or directory)")


def test_a_number_in_another_unit_is_told_before_what_it_makes_impossible(capsys):
    assert run("bearing --ball-radius-mm 0.006") == BAD_INPUT
    warned, refused = capsys.readouterr().err.splitlines()
    assert "warning: --ball-radius-mm is 0.006 mm; usual: 0.1 to" in warned
    assert "derived from --ball-radius-mm: " in refused and "cross-section of a ball" in refused


def test_what_does_not_occur_has_an_exit_code_of_its_own(capsys):
    assert run(f"size {DRY}") == NONE_FOUND
    assert "none" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (f"{STATE} --load-N 1e5", "thirdbody state: warning: --load-N is 100000 N; usual: "),
        (
            "bearing --ball 205000,0.29,5000",
            "modulus_GPa is 205000 GPa; usual: 0.1 to 2000 GPa, and hardness_GPa is 5000 GPa; usual: ",
        ),
    ],
)
def test_what_is_in_another_unit_is_one_line_in_the_unit_that_is_typed(capsys, text, message):
    assert run(f"{text} --json") == ANSWERED
    printed = capsys.readouterr()
    assert json.loads(printed.out)
    (line,) = printed.err.splitlines()
    assert message in line


def test_the_version_is_printed(capsys, monkeypatch):
    monkeypatch.setattr("importlib.metadata.version", lambda name: "1.2")
    assert run("--version") == ANSWERED
    assert capsys.readouterr().out == "thirdbody 1.2\n"


def test_ctrl_c_before_a_question_is_asked_is_quiet(capsys, monkeypatch):
    def interrupted():
        raise KeyboardInterrupt

    monkeypatch.setattr("thirdbody.command.main", interrupted)
    assert command() == STOPPED
    assert capsys.readouterr() == ("", "")


def test_ctrl_c_says_how_to_go_on_and_warnings_that_are_not_for_users_are_not_shown(
    capsys, monkeypatch
):
    def interrupted(*given, **more):
        warnings.warn("unclosed file", ResourceWarning, stacklevel=1)
        warnings.warn("load is odd", UserWarning, stacklevel=1)
        raise KeyboardInterrupt

    monkeypatch.setattr("thirdbody.answers.interface.solve", interrupted)
    assert run(STATE) == STOPPED
    assert capsys.readouterr().err.splitlines() == [
        "thirdbody state: warning: load is odd",
        "thirdbody state: stopped; run the same command again to start over",
    ]


def test_a_written_bearing_is_read_by_the_other_questions(capsys):
    assert run("bearing --ball-radius-mm 10 --write mine.yaml") == ANSWERED
    capsys.readouterr()
    example = EXAMPLES["compare"].partition(" ")[2]
    assert run(f"{example} --other-inputs mine.yaml --json") == ANSWERED
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)["rows"]}
    thickness = rows["film_thickness"]
    assert thickness["value"] != pytest.approx(thickness["other"], rel=0.05)


def test_what_a_bearing_leaves_open_is_not_written_and_stays_open(defaults):
    found = tb.bearing(ball_radius_mm=10.0)
    first, second = found.members
    assert run("bearing --ball-radius-mm 10 --write mine.yaml") == ANSWERED
    written = read_yaml("mine.yaml")
    assert written["ball_radius"] == 0.01
    assert written["speed_per_viscosity"] == pytest.approx(0.635 * defaults.speed_per_viscosity)
    other = second.as_dict()
    is_open = {name for name, value in first.as_dict().items() if value != other[name]}
    assert is_open and written.keys() == first.as_dict().keys() - is_open
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = tb.load_parameters("mine.yaml")
    assert again == found and again.members == found.members


def test_a_curve_is_printed_as_it_is_written(capsys):
    assert run(f"{CURVE} --count 3") == ANSWERED
    printed = capsys.readouterr().out
    assert run(f"{CURVE} --count 3 --csv curve.csv") == ANSWERED
    assert Path("curve.csv").read_text(encoding="utf-8") == printed
    assert len(printed.splitlines()) == 4


def process(text, **more):
    """The command in a process of its own."""
    command = [sys.executable, "-m", "thirdbody", *shlex.split(text)]
    return subprocess.Popen(command, **{"stderr": subprocess.PIPE} | more)


@pytest.mark.parametrize("encoding", ["cp1252", "ascii"])
def test_output_is_printed_in_any_encoding(encoding):
    environment = os.environ | {"PYTHONIOENCODING": encoding}
    out, err = process(BEARING, stdout=subprocess.PIPE, env=environment).communicate()
    assert b"quantity" in out and b"\\u" not in out
    assert err == b""


@pytest.mark.parametrize("arguments", [BEARING, "--help"], ids=["answer", "help"])
def test_a_closed_pipe_is_silent_and_a_closed_output_is_not(arguments):
    running = process(arguments, stdout=subprocess.PIPE)
    running.stdout.close()
    assert running.stderr.read() == b""
    assert running.wait() == ANSWERED
    closed = process(arguments, preexec_fn=lambda: os.close(1))
    assert b"the answer cannot be written (standard output is closed)" in closed.stderr.read()
    assert closed.wait() == NOT_WRITTEN
    silent = process(STATE, stdout=subprocess.DEVNULL, preexec_fn=lambda: os.close(2))
    assert silent.wait() == ANSWERED


@pytest.mark.parametrize("arguments", [BEARING, "bearing --help"], ids=["answer", "help"])
def test_a_full_device_is_one_line(arguments):
    with open("/dev/full", "w") as full:
        running = process(arguments, stdout=full)
        _, err = running.communicate()
        refused = process("bearing --ball wood", stderr=full).wait()
    message = b"thirdbody bearing: the answer cannot be written (No space left on device)\n"
    assert (running.returncode, err, refused) == (NOT_WRITTEN, message, BAD_INPUT)
