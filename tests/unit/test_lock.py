"""One run at a time, where it may write, on whatever host."""

import fcntl
import os
import subprocess
import sys
import time

import pytest

from thirdbody.run import lock
from thirdbody.run.lock import Hold, require_writable

BEAT = 0.05
# holds the folder that is given until it is killed, on a host of its own
HOLD = f"""
import fcntl, sys, time
from thirdbody.run import lock
lock._host = lambda: "login2/booted-otherwise"
if sys.argv[2] == "lying":
    fcntl.flock = lambda *_: None
hold = lock.Hold(sys.argv[1], {BEAT})
print(hold.name, hold.before, flush=True)
time.sleep(60)
"""


def test_the_lock_is_for_one_and_goes_with_its_holder(tmp_path):
    held = Hold(tmp_path / "made" / "lock")
    with pytest.raises(OSError, match="another run is under way"):
        Hold(tmp_path / "made" / "lock")
    held.close()
    Hold(tmp_path / "made" / "lock").close()


@pytest.fixture
def hold_elsewhere(tmp_path):
    """Function that has a run on another host hold the folder; its process, its name, the one before."""
    runs = []

    def begin(locks="lying"):
        command = [sys.executable, "-c", HOLD, str(tmp_path / "lock"), locks]
        runs.append(subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE))
        return (runs[-1], *runs[-1].stdout.readline().decode().split())

    yield begin
    for run in runs:
        run.kill()
        run.communicate()


def no_lock(*_):
    raise OSError(38, "Function not implemented")


@pytest.mark.parametrize("flock", [lambda *_: None, no_lock], ids=["lies", "is not there"])
def test_without_a_lock_that_all_hosts_see_a_run_is_alone(
    tmp_path, monkeypatch, hold_elsewhere, flock
):
    run, name, before = hold_elsewhere()
    assert before == "None"
    monkeypatch.setattr(fcntl, "flock", flock)
    with pytest.raises(OSError, match="another run is under way in this folder, on login2; wait"):
        Hold(tmp_path / "lock", BEAT)
    run.kill()
    run.wait()
    with Hold(tmp_path / "lock", BEAT) as held:  # nothing is to be cleaned up
        assert held.before == name
    assert not (tmp_path / "lock.run").exists()


def test_of_runs_that_find_a_dead_one_together_one_succeeds_it(tmp_path, hold_elsewhere):
    hold_elsewhere()[0].kill()
    command = [sys.executable, "-c", HOLD, str(tmp_path / "lock"), "lying"]
    runs = [subprocess.Popen(command, stdout=subprocess.PIPE) for _ in range(4)]
    end = time.monotonic() + 20
    while len(alive := [run for run in runs if run.poll() is None]) > 1 and time.monotonic() < end:
        time.sleep(BEAT)
    time.sleep(4 * BEAT)  # so that it finds a successor, if there is one
    codes = [run.poll() for run in runs]
    for run in runs:
        run.kill()
        run.communicate()
    assert len(alive) == codes.count(None) == 1


def test_a_run_that_was_taken_for_dead_ends(tmp_path, hold_elsewhere):
    run, name, _ = hold_elsewhere()
    record = tmp_path / "lock.run"
    record.write_text(record.read_text().replace(name, "thirdbody-0123456789ab"))
    assert run.wait(5) == 1
    assert b"was taken for dead" in run.communicate()[1]
    assert "thirdbody-0123456789ab" in record.read_text()


def test_a_run_that_is_killed_here_is_succeeded_at_once(tmp_path):
    path = tmp_path / "lock"
    hold = f"import os; from thirdbody.run.lock import Hold; Hold({str(path)!r}); os._exit(0)"
    subprocess.run([sys.executable, "-c", hold], check=True)
    begun = time.monotonic()
    with Hold(path) as held:
        assert held.before
    assert time.monotonic() - begun < lock.BEAT


def test_a_record_for_which_there_was_no_room_stops_nobody(tmp_path):
    (tmp_path / "lock.run").touch()
    with Hold(tmp_path / "lock", BEAT) as held:
        assert held.before is None


def test_a_folder_that_may_not_be_written_to_is_named(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    require_writable("results")
    (tmp_path / "results/tables").mkdir(parents=True)
    require_writable("results")
    for closed in ("results/tables", "results"):
        monkeypatch.setattr(os, "access", lambda path, mode, closed=closed: str(path) != closed)
        with pytest.raises(OSError, match=f"^{closed} may not be written to; allow it, or run in"):
            require_writable("results")
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(OSError, match=r"^\. may not be written to"):
        require_writable("logs")


@pytest.mark.parametrize("put", [lambda path: path.touch(), lambda path: path.symlink_to("/no/a")])
def test_what_is_in_the_place_of_a_folder_is_named(tmp_path, monkeypatch, put):
    monkeypatch.chdir(tmp_path)
    put(tmp_path / "results")
    with pytest.raises(OSError, match="^results is no folder; move it away"):
        require_writable("results")
