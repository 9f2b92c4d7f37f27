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
        with atomic_write(tmp_path / "a.csv") as part:
            part.write_text("whole")
        assert listing(tmp_path) == [kept, "a.csv"]
        alive.kill()
    with atomic_write(tmp_path / "a.csv") as part:
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
        ("pipe", r"pipe cannot be written \(Not a regular file\)"),
        ("link", r"pipe cannot be written \(Not a regular file\)"),
        ("x" * 300, r"x+ cannot be written \(File name too long\)"),
        ("", "'' is not a file name; allowed: the path of a file to write"),
        ("a\0b", r"'a\\x00b' is not a file name"),
        (None, "None is not a file name"),
    ],
)
def test_a_place_where_nothing_can_be_written_is_named_before_the_block_runs(
    tmp_path, monkeypatch, path, message
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")  # as /dev/full, which root would replace
    (tmp_path / "link").symlink_to("pipe")
    with pytest.raises((OSError, ValueError), match=message), atomic_write(path):
        raise AssertionError("the block ran")
    assert listing(tmp_path) == ["file", "folder", "link", "pipe"]
    assert (tmp_path / "pipe").is_fifo() and (tmp_path / "link").is_symlink()
