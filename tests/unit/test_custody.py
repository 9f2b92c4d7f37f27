"""One run at a time, and products that are not what was made."""

import hashlib
import os

import pytest

from thirdbody.data.files import logged, whole
from thirdbody.run.custody import (
    hold_alone,
    recorded_digests,
    remove_damaged,
    require_recorded,
    require_writable,
)


@pytest.fixture
def made(tmp_path, monkeypatch):
    """A folder in which a job made two products."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "results").mkdir()
    (tmp_path / "logs").mkdir()
    with logged("logs/job.log"), whole("results/a.csv", "results/b.csv") as parts:
        for part in parts:
            part.write_text("made")
    return tmp_path


def test_the_lock_is_for_one_and_goes_with_its_holder(tmp_path):
    held = hold_alone(tmp_path / "made" / "lock")
    with pytest.raises(OSError, match="another run is under way"):
        hold_alone(tmp_path / "made" / "lock")
    held.close()
    hold_alone(tmp_path / "made" / "lock").close()


def test_the_log_records_what_was_made(made):
    digest = hashlib.sha256(b"made").hexdigest()
    assert recorded_digests("logs") == {f"results/{name}.csv": {digest} for name in "ab"}


def test_only_what_differs_from_its_record_is_removed(made):
    (made / "results/a.csv").write_text("harmed")
    (made / "results/unrecorded.csv").write_text("somebody's own")
    assert remove_damaged("logs") == ["results/a.csv"]
    assert sorted(os.listdir("results")) == ["b.csv", "unrecorded.csv"]
    assert remove_damaged("logs") == []


def test_a_product_that_another_rule_made_before_is_whole_by_either_record(made):
    (made / "results/a.csv").write_text("made anew")
    digest = hashlib.sha256(b"made anew").hexdigest()
    (made / "logs/later.log").write_text(f"{digest}  results/a.csv\n")
    assert remove_damaged("logs") == []


def test_a_record_never_reaches_out_of_the_results(made):
    (made / "logs/job.log").write_bytes(b"0" * 64 + b"  results/../kept.txt\n\xff\n")
    (made / "kept.txt").write_text("kept")
    remove_damaged("logs")
    assert (made / "kept.txt").exists()


def test_a_folder_in_place_of_a_product_is_named(made):
    (made / "results/a.csv").unlink()
    (made / "results/a.csv").mkdir()
    with pytest.raises(OSError, match="results/a.csv"):
        remove_damaged("logs")


def test_a_product_without_a_record_is_named_with_the_command_that_remakes_it(made):
    require_recorded(["results/a.csv", "results/b.csv"], "logs")
    (made / "results/unrecorded.csv").write_text("somebody's own")
    (made / "results/b.csv").write_text("harmed")
    for product in ("results/unrecorded.csv", "results/b.csv"):
        with pytest.raises(ValueError, match=f"^{product} .*; remake it: .* --force {product}$"):
            require_recorded(["results/a.csv", product], "logs")


def test_a_folder_that_may_not_be_written_to_is_named(made, monkeypatch):
    require_writable("results")
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    with pytest.raises(OSError, match="results may not be written to"):
        require_writable("results")
