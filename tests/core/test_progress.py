"""Long calls show a bar on a terminal, and nothing elsewhere; short calls show nothing."""

import io

import numpy as np
import pytest

import thirdbody as tb
from thirdbody import progress
from thirdbody.progress import progress_bar

AXES = {
    "load": np.geomspace(1e-6, 1e-3, 30),
    "viscosity": [0.0, 9e-5],
    "particle_diameter": [0.0, 3e-7],
    "roughness": [1e-7, 3e-7],
    "particle_density": [1e11],
}


class Terminal(io.StringIO):
    def isatty(self):
        return True


def given_to(monkeypatch, stream, is_shown=True):
    """What the standard error ``stream`` gets of a bar."""
    monkeypatch.setattr("sys.stderr", stream)
    with progress_bar(2000, is_shown) as bar:
        for _ in range(4):
            bar.update(500)
    return stream and stream.getvalue()


def test_a_terminal_shows_a_bar_that_counts_all_points(monkeypatch):
    monkeypatch.setattr(progress, "FIRST", 0.0)
    *_, last = given_to(monkeypatch, Terminal()).split("\r")
    assert last.startswith("100%|") and last.endswith("points/s]\n")
    assert "2.00k/2.00k" in last


def test_a_short_call_a_log_and_a_call_without_progress_show_nothing(monkeypatch):
    assert given_to(monkeypatch, Terminal()) == ""  # over before a bar is due
    monkeypatch.setattr(progress, "FIRST", 0.0)
    assert given_to(monkeypatch, io.StringIO()) == ""
    assert given_to(monkeypatch, Terminal(), is_shown=False) == ""
    assert given_to(monkeypatch, None) is None  # without a console


@pytest.mark.parametrize("call", ["grid", "stream", "find", "transitions", "turning_point"])
def test_long_calls_show_it_unless_told_not_to(monkeypatch, parameters, call, tmp_path):
    others = {name: values for name, values in AXES.items() if name != "load"}
    arguments = {
        "grid": ((), AXES),
        "stream": ((tmp_path / "grid.nc",), AXES),
        "find": (("solid_load_fraction", 0.9, "load"), dict.fromkeys(others, 1e-7)),
        "transitions": (("load",), dict.fromkeys(others, 1e-7)),
        "turning_point": ((), dict.fromkeys(others, 1e-7)),
    }
    positional, conditions = arguments[call]
    monkeypatch.setattr(progress, "FIRST", 0.0)
    monkeypatch.setattr("sys.stderr", Terminal())
    for is_shown in (False, True):
        getattr(tb, call)(*positional, **conditions, parameters=parameters, progress=is_shown)
        assert ("100%" in progress.sys.stderr.getvalue()) == is_shown
