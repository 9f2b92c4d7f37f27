"""Products that appear whole or not at all."""

import errno
import os
import subprocess
import sys

import pytest

from thirdbody.files import atomic_write


def listing(folder):
    return sorted(path.name for path in folder.iterdir())


def test_products_appear_once_their_block_is_done(tmp_path):
    places = tmp_path / "a.csv", tmp_path / "b.json"
    with atomic_write(*places) as (first, second):
        first.write_text("1")
        second.write_text("2")
        assert not any(place.exists() for place in places)
    assert [place.read_text() for place in places] == ["1", "2"]
    assert listing(tmp_path) == ["a.csv", "b.json"]


WRITER = """
import sys
from thirdbody.files import atomic_write
with atomic_write("a.csv", "b.csv") as (first, _):
    first.write_text("half")
    print("begun", flush=True)
    sys.stdin.read()
"""


def test_what_a_killed_writer_leaves_is_removed_and_what_another_writes_is_not(tmp_path):
    def begun():
        pipes = dict(stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=tmp_path)
        writer = subprocess.Popen([sys.executable, "-c", WRITER], **pipes)
        assert writer.stdout.readline() == b"begun\n"
        return writer

    with begun() as killed:
        killed.kill()
    (left,) = listing(tmp_path)
    with begun() as alive:
        assert left not in listing(tmp_path)
        (kept,) = listing(tmp_path)
        with atomic_write(tmp_path / "a.csv") as (part,):
            part.write_text("whole")
        assert listing(tmp_path) == [kept, "a.csv"]
        alive.kill()
    with atomic_write(tmp_path / "a.csv") as (part,):
        part.write_text("again")
    assert listing(tmp_path) == ["a.csv"] and (tmp_path / "a.csv").read_text() == "again"


@pytest.mark.parametrize("failure", [RuntimeError, KeyboardInterrupt, FileNotFoundError])
def test_a_failure_leaves_all_as_it_was(tmp_path, failure):
    old = tmp_path / "a"
    old.write_text("old")
    with pytest.raises(failure), atomic_write(old, tmp_path / "b") as (first, _):
        first.write_text("half")
        raise failure
    assert old.read_text() == "old"
    assert listing(tmp_path) == ["a"]


def test_a_product_that_was_not_written_keeps_all_of_them_away(tmp_path):
    old = tmp_path / "a"
    old.write_text("old")
    missing = "a, .*/b cannot be written"
    with pytest.raises(OSError, match=missing), atomic_write(old, tmp_path / "b") as (first, _):
        first.write_text("new")
    assert old.read_text() == "old"
    assert listing(tmp_path) == ["a"]


def test_want_of_room_names_the_product(tmp_path):
    message = "table.csv cannot be written .No space left on device"
    with pytest.raises(OSError, match=message), atomic_write(tmp_path / "table.csv"):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.parametrize(
    ("path", "message"),
    [
        ("no/a.csv", r"no/a.csv cannot be written \(No such file or directory\)"),
        ("file/a.csv", r"file/a.csv cannot be written \(Not a directory\)"),
        ("folder", r"folder cannot be written \(Is a directory\)"),
        ("x" * 300, r"x+ cannot be written \(File name too long\)"),
        ("", "empty name"),
        ("a\0b", "embedded null"),
        (None, "NoneType"),
    ],
)
def test_a_place_where_nothing_can_be_written_is_named_before_the_block_runs(
    tmp_path, monkeypatch, path, message
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    with pytest.raises((OSError, TypeError, ValueError), match=message), atomic_write(path):
        raise AssertionError("the block ran")
    assert listing(tmp_path) == ["file", "folder"]


@pytest.mark.skipif(not os.path.isdir("/proc/self/fd"), reason="open files have no names here")
def test_a_name_of_an_open_pipe_is_written(tmp_path):
    reader, writer = os.pipe()
    place = tmp_path / "stdout"
    place.symlink_to(f"/proc/self/fd/{writer}")  # as /dev/stdout is
    with atomic_write(place) as (part,):
        part.write_text("a line\n")
    assert os.read(reader, 100) == b"a line\n" and place.is_symlink()
    os.close(reader)
    os.close(writer)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes have no names here")
def test_a_pipe_is_written_and_stays_a_pipe(tmp_path):
    place = tmp_path / "pipe"
    os.mkfifo(place)
    reader = os.open(place, os.O_RDONLY | os.O_NONBLOCK)
    with atomic_write(place) as (part,):
        part.write_text("a line\n")
    assert os.read(reader, 100) == b"a line\n" and place.is_fifo()
    os.close(reader)


def test_what_is_written_over_keeps_its_mode_and_a_read_only_file_stays(tmp_path, monkeypatch):
    place = tmp_path / "table.csv"
    place.write_text("first")
    place.chmod(0o600)
    with atomic_write(place) as (part,):
        part.write_text("second")
    assert place.stat().st_mode & 0o777 == 0o600
    monkeypatch.setattr(os, "access", lambda path, mode: False)  # root may write all files
    with pytest.raises(OSError, match="cannot be written"), atomic_write(place):
        raise AssertionError("the block ran")
    assert place.read_text() == "second"
