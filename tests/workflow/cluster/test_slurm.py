"""Runs whose jobs are in the queue of a real SLURM, and what they survive there."""

import os
import shutil
import signal

import pytest
from single_node import NODE, wait_until
from workspace import MADE_BY_RUNS, ended, is_product, start

PROFILE = ("--profile", "workflow/profiles/slurm", "--seconds-between-status-checks", "1")
FIGURE, TABLE = "results/figures/fig09.png", "results/tables/table1.md"
SCRIPT = "workflow/scripts/recompute_paper_table.py"
# a job that lasts until the test lets it go on
HELD = """
    import pathlib, time
    while not pathlib.Path("go").exists():
        time.sleep(0.1)
    with logged"""


@pytest.fixture
def fresh(sources, tmp_path):
    return sources.copied_to(tmp_path / "thirdbody")


@pytest.fixture
def held(fresh):
    """Sources whose job for Table 1 waits for a file ``go``."""
    fresh.rewrite(SCRIPT, lambda text: text.replace("\n    with logged", HELD))
    return fresh


@pytest.fixture
def begin(held):
    """Function that starts a run for Table 1, which ends with the test."""
    runs = []

    def start_another():
        runs.append(start(held, TABLE, *PROFILE))
        return runs[-1]

    yield start_another
    for run in runs:
        if run.poll() is None:
            kill(run)


def kill(run):
    run.send_signal(signal.SIGKILL)
    run.communicate()


def complete(run, workspace, finished):
    """Let the held job go on, and require that the run succeeds; what it said."""
    (workspace.root / "go").touch()
    code, said = ended(run)
    assert code == 0, said
    assert (workspace.root / TABLE).read_bytes() == (finished.root / TABLE).read_bytes()
    return said


def test_the_bytes_are_those_of_one_machine(cluster, fresh, finished):
    before = cluster.jobs("all")
    run = fresh.snakemake(FIGURE, "results/tables/tpca_windows.csv", *PROFILE)
    assert run.returncode == 0, run.stdout + run.stderr
    made = {name for name in fresh.stamps() if not name.startswith("accuracy/")}
    assert "datasets/fig09.nc" in made
    for name in made:
        content = (fresh.root / "results" / name).read_bytes()
        assert content == (finished.root / "results" / name).read_bytes(), name
    checked = fresh.execute("make", "sums")
    assert checked.returncode == 0, checked.stdout
    records = fresh.root.glob("results/.custody/**/*.sha256")
    assert len(list(records)) == len(fresh.stamps())
    assert len(cluster.jobs("all")) == len(before) + 2
    assert not list((fresh.root / ".snakemake/slurm").iterdir())
    late = (fresh.root / "results/datasets/fig09.nc").stat().st_mtime - 60
    os.utime(fresh.root / FIGURE, (late, late))  # as of a host whose clock is a minute late
    assert "Nothing to be done" in fresh.snakemake("--dry-run", FIGURE).stdout


def test_the_atlas_goes_out_by_chunk(cluster, fresh, charted):
    before = cluster.jobs("all")
    run = fresh.snakemake("atlas", *PROFILE)
    assert run.returncode == 0, run.stdout + run.stderr
    assert cluster.purposes(but=before) == {"solve_chunk": 3, "chart": 1}
    here, _ = charted
    agree(fresh, here, "results", but="atlas/cost")


def test_the_calibration_goes_out_by_reading_and_seed(cluster, calibrated, sources, tmp_path):
    there = calibrated.copied_to(tmp_path / "thirdbody")
    for name in (*MADE_BY_RUNS, "config/calibrated"):
        shutil.rmtree(there.root / name)
    shutil.copytree(sources.root / "config/calibrated", there.root / "config/calibrated")
    before = cluster.jobs("all")
    run = there.snakemake("calibrate", *PROFILE)
    assert run.returncode == 0, run.stdout + run.stderr
    # two readings, each searched and sampled from two seeds
    jobs = {"search_reading": 4, "sample_reading": 4, "summarise_reading": 2}
    assert cluster.purposes(but=before) == jobs
    agree(there, calibrated, "results")
    agree(there, calibrated, "config/calibrated")


def agree(one, other, folder, but="nothing"):
    """Require the same files with the same bytes in a folder, ``but`` those that begin so."""
    contents = [
        {
            str(path.relative_to(each.root / folder)): path.read_bytes()
            for path in (each.root / folder).rglob("*")
            if is_product(path)
        }
        for each in (one, other)
    ]
    assert contents[0].keys() == contents[1].keys()
    for name, content in contents[0].items():
        assert name.startswith(but) or content == contents[1][name], name


def test_a_job_may_be_cancelled_and_its_node_go_down(cluster, held, begin, finished):
    run = begin()
    first = cluster.running()
    cluster.ask("scancel", first)
    second = cluster.running(but=first)
    node = ("scontrol", "update", f"nodename={NODE}")
    cluster.ask(*node, "state=down", "reason=test")
    wait_until(lambda: second in cluster.jobs("pending"))
    cluster.ask(*node, "state=resume")
    said = complete(run, held, finished)
    assert f"job {first} of SLURM has ended as CANCELLED" in said
    assert second in cluster.jobs("completed")


def test_the_controller_may_stop_and_start(cluster, held, begin, finished):
    cluster.stop_controller()
    run = begin()
    while "waiting for its controller" not in run.stdout.readline():
        assert run.poll() is None
    cluster.start_controller()
    cluster.running()
    cluster.stop_controller()
    (held.root / "go").touch()
    wait_until((held.root / "results/extracted/table1/all.csv").exists)
    cluster.start_controller()
    complete(run, held, finished)


def test_the_controller_may_be_killed_and_started(cluster, held, begin, finished):
    run = begin()
    job = cluster.running()
    cluster.kill_controller()
    (held.root / "go").touch()
    wait_until((held.root / "results/extracted/table1/all.csv").exists)
    cluster.start_controller()
    complete(run, held, finished)
    assert job in cluster.jobs("completed")


def test_a_killed_run_is_started_again(cluster, held, begin, finished):
    run = begin()
    first = cluster.running()
    kill(run)
    assert cluster.jobs("running") == [first]
    run = begin()
    second = cluster.running(but=first)  # of two runs no jobs are under way together
    assert first in cluster.jobs("cancelled")
    kill(run)
    (held.root / "go").touch()
    wait_until(lambda: second in cluster.jobs("completed"))
    said = complete(begin(), held, finished)
    assert "1 of 1  Writing table table1" in said  # what the job made on its own counts
    assert "Nothing to be done" in held.snakemake("--dry-run", TABLE).stdout
