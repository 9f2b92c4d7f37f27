"""The command: every example runs, JSON parses, exit codes and files are as promised."""

import json
import os
import re
import shlex
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pandas as pd
import pytest

import thirdbody as tb
from thirdbody import inputs
from thirdbody.__main__ import run as run_command
from thirdbody.command import ANSWERED, BAD_INPUT, NONE_FOUND, main
from thirdbody.files import read_yaml

COMMANDS = ["state", "transitions", "turning-point", "curve", "compare", "bearing"]
LAYER = "--roughness-nm 300 --particle-density-per-m2 1e11 --particle-diameter-nm 500"
STATE = f"state --load-N 10 --viscosity-cSt 90 {LAYER}"
CURVE = f"curve --along load --from 1 --to 2 --viscosity-cSt 0 {LAYER}"
REFUSED = [  # a command, and what its refusal names
    ("answer", "answer"),
    ("state", "--load-N, --viscosity-cSt, --particle-diameter-nm"),
    ("state --load-N ten", "--load-N"),
    (f"{STATE} --load-N 0", "load_N is 0"),
    (f"{STATE} --viscosity-cSt -1", "viscosity_cSt is -1"),
    (f"{STATE} --inputs absent.yaml", "absent.yaml"),
    (f"transitions --along time {LAYER}", "time"),
    (f"transitions --along viscosity --viscosity-cSt 90 --load-N 10 {LAYER}", "--along viscosity"),
    (f"{CURVE} --load-N 10", "--along load"),
    (f"transitions --along viscosity --from 100 --to 10 --load-N 10 {LAYER}", "(100.0, 10.0)"),
    (f"{CURVE} --csv same.svg --plot ./same.svg", "--plot is ./same.svg, the file of --csv"),
    (f"{CURVE} --csv same.svg --plot SAME.svg", "--plot is SAME.svg, the file of --csv"),
    (f"{CURVE} --csv no/a.csv", "no/a.csv"),
    (f"{CURVE} --plot a.txt", "txt"),
    (f"{CURVE} --count 1", "count is 1"),
    (f"{CURVE} --from 0", "error: --from is 0; allowed: a positive number\n"),
    (f"{CURVE} --from -5", "error: --from is -5; allowed: a positive number\n"),
    (f"{CURVE} --to inf", "error: --to is inf; allowed: a positive number\n"),
    ("bearing --ball wood", "wood"),
    ("bearing --ball 205,0.7,5", "0.7"),
    ("bearing --speed-m-per-s 2", "speed_m_per_s is 2"),
    ("bearing --flat steel --particle 205,0.29,4", "particle has a hardness of 4 GPa"),
    (f"compare {STATE.removeprefix('state ')}", "--other-"),
]


def run(text):
    """The exit code of a command, which argparse ends itself for help and for options that it
    refuses.
    """
    try:
        return main(shlex.split(text))
    except SystemExit as ended:
        return ended.code


@pytest.fixture
def example(capsys):
    """Function that gives the example of a command, from its help."""

    def from_help(name):
        assert run(f"{name} --help") == ANSWERED
        text = capsys.readouterr().out.partition("example:")[2]
        return re.sub(r"\\\n\s*", "", text).strip().removeprefix("thirdbody ")

    return from_help


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch, defaults):
    """An empty folder, a plain terminal, and two members of the ensemble, which are enough here."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.setenv("NO_COLOR", "1")
    every = inputs.ensemble_of
    inputs.or_calibrated(None)  # the library keeps it, with all members

    def with_two_members(calibrated):
        ensemble = every(calibrated)
        return replace(ensemble, members=ensemble.members[:2])

    monkeypatch.setattr(inputs, "ensemble_of", with_two_members)


@pytest.mark.parametrize("name", COMMANDS)
def test_the_example_of_each_command_works(name, example, capsys):
    assert run(example(name)) == ANSWERED
    printed = capsys.readouterr()
    assert printed.out or name == "curve"
    assert printed.err == ""


@pytest.mark.parametrize("name", COMMANDS)
def test_help_fits_a_terminal(name, capsys):
    assert run(f"{name} --help") == ANSWERED
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80


WIDE = "--load-N 123456 --viscosity-cSt 99999 --roughness-nm 77.7777 --particle-density-per-m2 3e9"
SHORT = [  # answers with long rows, with notes and warnings of every kind, with and without a range
    f"{STATE} --verbose",
    f"state {WIDE} --particle-diameter-nm 3e6 --verbose",
    f"state {WIDE} --particle-diameter-nm 99.9999 --speed-m-per-s 0.000123456",
    f"compare {STATE.removeprefix('state ')} --other-particle-diameter-nm 5000 --other-load-N 1e4",
    f"compare {WIDE} --particle-diameter-nm 1000 --other-particle-diameter-nm 3e6",
    f"compare {STATE.removeprefix('state ')} --other-inputs mine.yaml",
    f"transitions --viscosity-cSt 90 {LAYER} --from 0.01 --to 20000",
    f"transitions --along speed --load-N 10 --viscosity-cSt 90 {LAYER}",
    f"transitions --along particle_density --load-N 10 --viscosity-cSt 90 {LAYER[:18]}"
    " --particle-diameter-nm 500",
    f"turning-point --viscosity-cSt 90 {LAYER} --to 5000 --inputs mine.yaml",
    f"{CURVE} --csv curve.csv --to 20000",
    "bearing --ball alumina --flat 100,0.3,0.5 --particle 2100,0.3,90 --ball-radius-mm 3.7",
]


@pytest.mark.parametrize("text", SHORT)
def test_answers_and_warnings_fit_a_terminal(text, capsys):
    assert run("bearing --ball-radius-mm 10 --apparent-area-mm2 3 --write mine.yaml") == ANSWERED
    capsys.readouterr()
    assert run(text) in (ANSWERED, NONE_FOUND)
    printed = capsys.readouterr()
    lines = (printed.out + printed.err).splitlines()
    # ASCII alone: no letter is two columns wide
    assert lines and [line for line in lines if len(line) > 80 or not line.isascii()] == []


def test_rows_that_differ_little_are_told_if_asked_for(capsys):
    symbols = {}
    for option in ("", "--verbose"):
        assert run(f"{STATE} {option}") == ANSWERED
        lines = capsys.readouterr().out.splitlines()
        symbols[option] = {line.split()[0] for line in lines if line and line[0] != " "}
    assert symbols["--verbose"] - symbols[""] == {"A_n", "p_n", "A_H", "p_H"}


def test_no_command_is_cut_in_the_list(capsys):
    assert run("--help") == ANSWERED
    listed = capsys.readouterr().out
    for name in COMMANDS:
        assert run(f"{name} --help") == ANSWERED
        about = capsys.readouterr().out.splitlines()[2]
        assert re.search(rf"^    {name}\s+{re.escape(about)}$", listed, re.MULTILINE)


@pytest.mark.parametrize("name", ["state", "transitions", "turning-point", "compare", "bearing"])
def test_an_answer_is_read_as_json(name, example, capsys):
    assert run(f"{example(name)} --json") == ANSWERED
    assert json.loads(capsys.readouterr().out)


@pytest.mark.parametrize(("text", "named"), REFUSED)
def test_bad_input_is_named_and_answers_nothing(text, named, capsys):
    assert run(text) == BAD_INPUT
    printed = capsys.readouterr()
    assert printed.out == "" and named in printed.err and "Traceback" not in printed.err
    assert max(map(len, printed.err.splitlines())) <= 80


def test_two_speeds_are_compared_as_two_viscosities(capsys):
    def values(options):
        assert run(f"compare {STATE.partition(' ')[2]} {options} --json") == ANSWERED
        rows = json.loads(capsys.readouterr().out)["rows"]
        return [row["other"] for row in rows if isinstance(row["other"], float)]

    faster = values("--speed-m-per-s 2 --other-speed-m-per-s 4")
    thicker = values("--speed-m-per-s 2 --other-viscosity-cSt 180")
    assert faster == pytest.approx(thicker)


def test_what_does_not_occur_has_an_exit_code_of_its_own(capsys):
    dry = "--viscosity-cSt 0 --roughness-nm 300 --particle-density-per-m2 0"
    assert run(f"transitions --along particle_diameter --load-N 10 {dry}") == NONE_FOUND
    assert "none" in capsys.readouterr().out


def test_a_number_in_another_unit_is_warned_of(capsys):
    assert run(f"{STATE} --load-N 1e5 --json") == ANSWERED
    printed = capsys.readouterr()
    assert json.loads(printed.out)
    assert "warning: load_N is 100000 N; usual: " in printed.err


def test_the_version_is_printed(capsys):
    assert run("--version") == ANSWERED
    assert capsys.readouterr().out == f"thirdbody {tb.__version__}\n"


def test_ctrl_c_is_quiet(capsys, monkeypatch):
    def interrupted():
        raise KeyboardInterrupt

    monkeypatch.setattr("thirdbody.command.main", interrupted)
    assert run_command() == 130
    assert capsys.readouterr() == ("", "")


def test_a_written_bearing_is_read_by_the_other_commands(capsys):
    assert run("bearing --ball-radius-mm 10 --write mine.yaml") == ANSWERED
    capsys.readouterr()
    assert run(f"compare {STATE.removeprefix('state ')} --other-inputs mine.yaml --json") == 0
    rows = json.loads(capsys.readouterr().out)["rows"]
    (thickness,) = [row for row in rows if row["symbol"] == "H_c"]
    assert thickness["value"] != pytest.approx(thickness["other"], rel=0.05)


def test_what_a_bearing_leaves_open_is_not_written_and_stays_open(defaults):
    found = tb.bearing(tb.load_parameters(), ball_radius_mm=10.0)
    first, second = found.members
    assert run("bearing --ball-radius-mm 10 --write mine.yaml") == ANSWERED
    written = read_yaml("mine.yaml")
    assert written["ball_radius"] == 0.01
    assert written["speed_per_viscosity"] == pytest.approx(0.635 * defaults.speed_per_viscosity)
    other = second.as_dict()
    is_open = {name for name, value in first.as_dict().items() if value != other[name]}
    assert is_open and written.keys() == {*first.as_dict(), "setup"} - is_open
    again = tb.load_parameters("mine.yaml")
    assert again == found


def test_a_curve_is_printed_as_it_is_written_and_drawn(capsys):
    assert run(f"{CURVE} --count 3 --csv -") == ANSWERED
    printed = capsys.readouterr().out
    assert run(f"{CURVE} --count 3 --csv curve.csv --plot curve.svg") == ANSWERED
    assert Path("curve.csv").read_text(encoding="utf-8") == printed
    assert run(f"{CURVE} --count 3 --plot alone.svg") == ANSWERED
    assert capsys.readouterr().out == ""
    for drawn in ("curve.svg", "alone.svg"):
        assert Path(drawn).read_text(encoding="utf-8").startswith("<?xml")
    table = pd.read_csv("curve.csv")
    assert table["load_N"].tolist() == pytest.approx([1.0, 2.0**0.5, 2.0])


@pytest.fixture
def mine(capsys):
    """A file of inputs, by other names too."""
    assert run("bearing --ball-radius-mm 10 --write mine.yaml") == ANSWERED
    capsys.readouterr()
    os.symlink("mine.yaml", "link.svg")
    os.link("mine.yaml", "hard.csv")
    os.symlink(inputs.CALIBRATED_FILE, "calibrated.yaml")
    return Path("mine.yaml")


@pytest.mark.parametrize("name", ["mine.yaml", "./mine.yaml", "MINE.yaml", "link.svg", "hard.csv"])
@pytest.mark.parametrize(
    "command",
    [
        "bearing --inputs mine.yaml --write",
        f"{CURVE} --inputs mine.yaml --csv",
        f"{CURVE} --inputs mine.yaml --plot",
        f"{CURVE} --inputs link.svg --csv",
    ],
)
def test_a_file_that_is_read_is_never_written(mine, command, name, capsys):
    before, names = mine.read_bytes(), sorted(os.listdir())
    assert run(f"{command} {name}") == BAD_INPUT
    assert f"{name}, the file of --inputs; allowed: another file" in capsys.readouterr().err
    assert mine.read_bytes() == before and sorted(os.listdir()) == names


def test_the_inputs_of_the_library_are_never_written(mine, capsys):
    before = inputs.CALIBRATED_FILE.read_bytes()
    assert run("bearing --ball-radius-mm 10 --write calibrated.yaml") == BAD_INPUT
    assert "the file of the library" in capsys.readouterr().err
    assert inputs.CALIBRATED_FILE.read_bytes() == before


def test_a_file_beside_the_one_that_is_read_is_written(mine):
    assert run("bearing --inputs mine.yaml --write other.yaml") == ANSWERED
    assert tb.load_parameters("other.yaml") == tb.load_parameters("mine.yaml")


def test_output_is_printed_in_any_encoding():
    arguments = [sys.executable, "-m", "thirdbody", "bearing"]
    for encoding in ("cp1252", "ascii"):
        environment = os.environ | {"PYTHONIOENCODING": encoding}
        done = subprocess.run(arguments, capture_output=True, env=environment)
        assert (done.returncode, done.stderr) == (ANSWERED, b"")
        assert b"E_ss" in done.stdout
