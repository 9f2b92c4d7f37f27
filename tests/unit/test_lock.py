"""One run at a time, where it may write."""

import os

import pytest

from thirdbody.run.lock import hold_alone, require_writable


def test_the_lock_is_for_one_and_goes_with_its_holder(tmp_path):
    held = hold_alone(tmp_path / "made" / "lock")
    with pytest.raises(OSError, match="another run is under way"):
        hold_alone(tmp_path / "made" / "lock")
    held.close()
    hold_alone(tmp_path / "made" / "lock").close()


def test_a_folder_that_may_not_be_written_to_is_named(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "results").mkdir()
    require_writable("results")
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(OSError, match="results may not be written to"):
        require_writable("results")
