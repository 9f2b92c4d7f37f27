"""Long calls say how far they have come, on a terminal and in a log; short ones nothing."""

import io
from types import SimpleNamespace

import numpy as np
import pytest

import thirdbody as tb
from thirdbody import progress
from thirdbody.progress import Progress

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


@pytest.fixture
def clock(monkeypatch):
    """List of times, the last of which it is."""
    times = [0.0]
    monkeypatch.setattr(progress, "monotonic", lambda: times[-1])
    return times


@pytest.fixture(params=[Terminal, io.StringIO], ids=["terminal", "log"])
def stream(request, monkeypatch):
    """The standard error stream, for which every call is long."""
    stream = request.param()
    # pytest takes the true one
    monkeypatch.setattr(progress, "sys", SimpleNamespace(stderr=stream))
    for name in ("FIRST_BAR", "NEXT_BAR", "LINE"):
        monkeypatch.setattr(progress, name, 0.0)
    return stream


def test_what_is_over_soon_or_not_to_be_shown_says_nothing(clock, monkeypatch):
    terminal = Terminal()
    for stream, seconds, is_shown in [
        (terminal, 1, True),
        (terminal, 1000, False),
        (None, 9, True),
    ]:
        monkeypatch.setattr("sys.stderr", stream)  # None without a console
        with Progress(1, "points", is_shown) as shown:
            clock.append(clock[-1] + seconds)
            shown.add(1)
    assert terminal.getvalue() == ""


@pytest.mark.parametrize("call", ["grid", "stream", "find", "transitions", "turning_point"])
def test_long_calls_say_how_far_they_are_unless_told_not_to(stream, parameters, call, tmp_path):
    given = {name: values for name, values in AXES.items() if name != "load"}
    arguments = {
        "grid": ((), AXES),
        "stream": ((tmp_path / "grid.nc",), AXES),
        "find": (("solid_load_fraction", 0.9, "load"), dict.fromkeys(given, 1e-7)),
        "transitions": (("load",), dict.fromkeys(given, 1e-7)),
        "turning_point": ((), dict.fromkeys(given, 1e-7)),
    }
    place, axes = arguments[call]
    for shown in (False, True):
        getattr(tb, call)(*place, **axes, parameters=parameters, progress=shown)
        assert ("100% of" in stream.getvalue()) == shown


def shown_by(stream, clock, monkeypatch, total, seconds):
    """What a stream gets of a call that reports four times."""
    monkeypatch.setattr("sys.stderr", stream)
    with Progress(total, "points", True) as shown:
        for clock[:] in ([each] for each in seconds):
            shown.add(total // 4)
    return stream.getvalue()


def test_a_terminal_shows_one_bar_that_grows_and_a_log_gets_lines(clock, monkeypatch):
    bar = shown_by(Terminal(), clock, monkeypatch, 2000, (1.0, 4.0, 4.1, 8.0))
    first, second, last = bar.split("\r")[1:]
    assert first.startswith(f"[{'#' * 15}{' ' * 15}]  50% of 2,000 points, 4 s, about 4 s left")
    assert second.startswith(f"[{'#' * 30}] 100% of 2,000 points, 8 s\x1b")
    assert last == f"{second}\n"
    clock[:] = [0.0]
    log = shown_by(io.StringIO(), clock, monkeypatch, 400, (20.0, 40.0, 50.0, 80.0))
    assert log.splitlines() == [
        " 50% of 400 points, 40 s, about 40 s left",
        "100% of 400 points, 80 s",
    ]
