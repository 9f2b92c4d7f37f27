"""What a run says on the terminal, to a person."""

from pathlib import Path

import pytest

WANTED = "results/tables/table1.md"
MAKER = "workflow/scripts/recompute_paper_table.py"
LINES = ["1 of 2  Recomputing table1 of the paper", "2 of 2  Writing table table1"]


@pytest.fixture
def fresh(sources, tmp_path):
    """The repository before any run."""
    return sources.copied_to(tmp_path / "thirdbody")


def test_a_run_says_one_line_a_job(fresh):
    run = fresh.snakemake(WANTED)
    profile, *said, log, time = [line for line in run.stderr.splitlines() if line]
    assert said == LINES
    assert profile.startswith("Using workflow specific profile")
    assert log.startswith("Complete log(s): ") and time.startswith("Elapsed time: ")
    complete = Path(log.removeprefix("Complete log(s): ")).read_text(encoding="utf-8")
    assert "Select jobs to execute" in complete and "Finished jobid" in complete


def test_a_job_that_fails_says_why(fresh):
    fresh.rewrite(
        MAKER, lambda text: text.replace("\n    with logged", "\n    1 / 0\n    with logged")
    )
    run = fresh.snakemake(WANTED)
    assert run.returncode == 1
    assert LINES[0] in run.stderr and LINES[1] not in run.stderr
    assert "ZeroDivisionError" in run.stderr and "Error in rule recompute_paper_table" in run.stderr


def test_verbose_says_all(fresh):
    assert "Select jobs to execute" in fresh.snakemake(WANTED, "--verbose").stderr
