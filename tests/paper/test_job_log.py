"""The log of a job, and one line for a failure that a user can mend."""

import os
import sys
from logging import makeLogRecord
from types import SimpleNamespace

import pytest

from chenhorng.job_log import SUMS, job, logged, require_as_made, without_none
from thirdbody.files import digest, unreadable


def test_what_is_printed_goes_to_the_log_in_utf_8(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("LC_ALL", "C")
    log = tmp_path / "log"
    with logged(log):
        print("σ = 300 nm")
        print("slowly", file=sys.stderr)
    assert log.read_bytes() == f"σ = 300 nm{os.linesep}slowly{os.linesep}".encode()
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize("error", [ValueError("load is -1"), OSError("no room on the disk")])
def test_a_foreseeable_failure_is_one_line_and_exit_code_1(tmp_path, error):
    log = tmp_path / "log"
    with pytest.raises(SystemExit) as ended, logged(log):
        raise error
    assert ended.value.code == 1
    assert log.read_text() == f"{error}\n"


def test_a_damaged_product_is_named_with_the_command_that_remakes_it(tmp_path):
    product, log = tmp_path / "table.csv", tmp_path / "log"
    with pytest.raises(SystemExit), logged(log):
        raise unreadable(product, "half a row")
    reason = f"{product} cannot be read (half a row)"
    assert log.read_text() == f"{reason}; remake it: snakemake -c2 --force {product}\n"


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (KeyError("load"), "KeyError: 'load'"),
        (SystemExit("no more"), "SystemExit: no more"),
        (KeyboardInterrupt(), "KeyboardInterrupt"),
    ],
)
def test_any_other_failure_is_a_traceback_in_the_log(tmp_path, error, said):
    log = tmp_path / "log"
    with pytest.raises(SystemExit) as ended, logged(log):
        print("begun")
        raise error
    begun, first, *_, last = log.read_text().splitlines()
    assert (begun, first) == ("begun", "Traceback (most recent call last):")
    assert last == said
    assert ended.value.code == 1


def test_a_log_that_cannot_be_written_is_named(tmp_path):
    with pytest.raises(SystemExit, match="no/log cannot be written"), logged(tmp_path / "no/log"):
        pass


@pytest.fixture
def snakemake(tmp_path, monkeypatch):
    """What a script has of its job: two outputs, of which one is there from an earlier run, and an
    input that no job made."""
    monkeypatch.chdir(tmp_path)
    SUMS.parent.mkdir()
    (tmp_path / "a.csv").write_text("old")
    (tmp_path / "style").write_text("plain")
    output = {"a": str(tmp_path / "a.csv"), "b": str(tmp_path / "b.csv")}

    class Named(list):
        keys = output.keys

    return SimpleNamespace(
        log=[tmp_path / "job.log"],
        input=[str(tmp_path / "style")],
        output=Named(output.values()),
    )


def test_a_job_moves_its_products_into_place_together(snakemake, tmp_path):
    with job(snakemake) as output:
        output.a.write_text("new")
        assert (tmp_path / "a.csv").read_text() == "old"
        output.b.write_text("other")
        print("done")
    assert (tmp_path / "a.csv").read_text() == "new" and (tmp_path / "b.csv").read_text() == "other"
    sums = [f"{digest(path)}  {path}" for path in snakemake.output]
    assert SUMS.read_text().splitlines() == sums
    assert (tmp_path / "job.log").read_text() == "done\n"


def test_a_product_that_is_not_as_its_job_made_it_is_refused(snakemake, tmp_path):
    with job(snakemake) as output:
        output.a.write_text("new")
        output.b.write_text("other")
    require_as_made(snakemake.output)
    (tmp_path / "b.csv").write_text("edited")
    with pytest.raises(OSError, match="b.csv is not as its job made it"):
        require_as_made(snakemake.output)
    with job(snakemake) as output:  # of two jobs the later one counts
        output.a.write_text("new")
        output.b.write_text("edited")
    require_as_made(snakemake.output)
    SUMS.unlink()  # nothing says that a product was harmed
    (tmp_path / "b.csv").write_text("harmed")
    require_as_made(snakemake.output)


def test_a_job_refuses_an_input_that_is_not_as_its_job_made_it(snakemake, tmp_path):
    made, log = str(tmp_path / "made.csv"), tmp_path / "job.log"
    (tmp_path / "made.csv").write_text("whole")
    SUMS.write_text(f"{digest(made)}  {made}\n")
    snakemake.input.append(made)
    with job(snakemake) as output:
        output.a.write_text("drawn")
        output.b.write_text("from it")
    (tmp_path / "made.csv").write_text("harmed")
    with pytest.raises(SystemExit), job(snakemake):
        pytest.fail("the job must not begin")
    reason = f"{made} is not as its job made it; remake it: snakemake -c2 --force {made}\n"
    assert log.read_text() == reason
    assert (tmp_path / "a.csv").read_text() == "drawn"


def test_a_job_that_fails_leaves_all_as_it_was(snakemake, tmp_path):
    with pytest.raises(SystemExit), job(snakemake) as output:
        output.a.write_text("new")
        raise ValueError("load is -1")
    assert {path.name for path in tmp_path.iterdir()} == {".snakemake", "a.csv", "job.log", "style"}
    assert not SUMS.exists()
    assert (tmp_path / "a.csv").read_text() == "old"
    assert (tmp_path / "job.log").read_text() == "load is -1\n"


@pytest.mark.parametrize(
    ("level", "message", "shown"),
    [("ERROR", None, "failed"), ("ERROR", "words", "words"), ("INFO", None, None)],
)
def test_a_failed_job_without_a_message_has_failed(level, message, shown):
    record = makeLogRecord({"levelname": level, "rule_msg": message})
    assert without_none(record)
    assert record.rule_msg == shown
