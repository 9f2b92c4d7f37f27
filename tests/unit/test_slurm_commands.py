"""What a run tells SLURM and understands of its answers; the answers are written here."""

import json

import pytest

from thirdbody.run import slurm
from thirdbody.run.start import SETTINGS, require_unchanged

AWAY = "slurm_load_jobs error: Unable to contact slurm controller (connect failure)"
RESOURCES = {"mem_mb": 1000, "runtime": 2, "quiet": 1}


@pytest.fixture
def answer(tmp_path, monkeypatch):
    """Function that has a command answer: with a line and an exit code, the same way each time or,
    if ``once``, then with success; what it was asked is in a file."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    monkeypatch.setenv(slurm.RUN, "thirdbody-0123456789ab")
    monkeypatch.setattr(slurm, "PAUSE", 0.0)

    def write(command, line, code=0, once=""):
        file = tmp_path / command
        then = f'[ -e {command}.asked ] && echo "{once}" && exit' if once else ""
        stream = 2 if code else 1
        file.write_text(
            f'#!/bin/sh\n{then}\necho "$@" >> {command}.asked\necho "{line}" >&{stream}\nexit {code}\n'
        )
        file.chmod(0o755)
        return tmp_path / f"{command}.asked"

    return write


def jobscript(tmp_path, **resources):
    script = tmp_path / "job.sh"
    told = {"rule": "search_reading", "jobid": 7, "threads": 1, "resources": RESOURCES | resources}
    script.write_text(f"#!/bin/sh\n{slurm.PROPERTIES}{json.dumps(told)}\ntrue\n")
    return str(script)


def test_a_job_asks_for_what_its_rule_needs(tmp_path, answer):
    asked = answer("sbatch", "12;cluster")
    assert slurm.submit(jobscript(tmp_path, runtime=30)) == "12"
    for option in (
        *("--mem=1000", "--time=30", "--cpus-per-task=1", "--job-name=thirdbody-0123456789ab"),
        "--comment=search_reading 7",
    ):
        assert option in asked.read_text()
    assert "--exclusive" not in asked.read_text()


def test_a_job_that_measures_times_is_alone_on_its_node(tmp_path, answer):
    asked = answer("sbatch", "12")
    slurm.submit(jobscript(tmp_path, quiet=100))
    assert "--exclusive" in asked.read_text()


def test_what_the_controller_refuses_is_told(tmp_path, answer):
    refusal = "sbatch: error: invalid partition specified: nope"
    answer("sbatch", refusal, 1)
    with pytest.raises(SystemExit, match=refusal):
        slurm.submit(jobscript(tmp_path))


@pytest.mark.parametrize(("queue", "number"), [("", "13"), ("12 search_reading 7", "12")])
def test_a_job_is_submitted_once_whenever_the_controller_goes_away(
    tmp_path, answer, capsys, queue, number
):
    """Before it has taken the job, and after."""
    answer("sbatch", AWAY, 1, once="13")
    answer("scontrol", "DOWN", 1, once="UP")
    answer("squeue", queue)
    assert slurm.submit(jobscript(tmp_path)) == number
    assert "waiting for its controller" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("line", "code", "word"),
    [
        ("PENDING", 0, "running"),
        ("RUNNING", 0, "running"),
        ("COMPLETED", 0, "success"),
        ("OUT_OF_MEMORY", 0, "failed"),
        (AWAY, 1, "running"),
        ("slurm_load_jobs error: Invalid job id specified", 1, "success"),
    ],
)
def test_states_in_one_word(answer, capsys, line, code, word):
    answer("squeue", line, code)
    assert slurm.status("12") == word
    said = "job 12 of SLURM has ended as OUT_OF_MEMORY; it said: .snakemake/slurm/12.log\n"
    assert capsys.readouterr().err == (said if word == "failed" else "")


def test_jobs_that_cannot_be_cancelled_are_told(tmp_path, answer, capsys):
    answer("sbatch", "12")
    answer("scancel", AWAY, 1)
    slurm.cancel("thirdbody-0123456789ab")  # it had none
    assert not capsys.readouterr().err
    slurm.submit(jobscript(tmp_path))
    slurm.cancel("thirdbody-0123456789ab")
    assert "scancel --name=thirdbody-0123456789ab" in capsys.readouterr().err


def test_a_job_ends_if_the_configuration_was_changed(monkeypatch):
    monkeypatch.delenv(SETTINGS, raising=False)
    require_unchanged({"rtol": 1e-9}, is_job=True)  # where variables do not reach jobs
    monkeypatch.setenv(SETTINGS, "")
    require_unchanged({"rtol": 1e-9}, is_job=False)
    require_unchanged({"rtol": 1e-9}, is_job=True)
    with pytest.raises(SystemExit, match="the configuration was changed after the run"):
        require_unchanged({"rtol": 1e-6}, is_job=True)
