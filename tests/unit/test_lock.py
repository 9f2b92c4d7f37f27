"""One run at a time, where it may write."""

import os

import pytest

from thirdbody.run.lock import Hold, require_writable


def test_the_lock_is_for_one_and_goes_with_its_holder(tmp_path):
    held = Hold(tmp_path / "made" / "lock")
    with pytest.raises(OSError, match="another run is under way"):
        Hold(tmp_path / "made" / "lock")
    held.close()
    Hold(tmp_path / "made" / "lock").close()


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
