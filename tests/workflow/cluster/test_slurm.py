"""Runs whose jobs are in the queue of a real SLURM, and what they survive there."""

import os
import shutil
import signal
import subprocess

import pytest
from single_node import PARTITION, PLUGIN, wait_until
from workspace import INTERPRETATIONS, MADE_BY_RUNS, MINIMAL, SNAKEMAKE, ended

PROFILE = ("--profile", "profiles/slurm")
QUICK = ("--slurm-init-seconds-before-status-checks", "1", "--max-status-checks-per-second", "1")
GIVEN = (f"slurm_partition={PARTITION}", "runtime=10")
FIGURE, TABLE = "results/figures/fig03.png", "results/extracted/table1/all.csv"
SCRIPT = "workflow/scripts/recompute_paper_tables.py"
long = pytest.mark.skipif(os.environ.get("SURVIVAL") != "long", reason="make test-survival")
# a job that lasts until the test lets it go on
HELD = """
import pathlib, time
pathlib.Path("begun").touch()
while not pathlib.Path("go").exists():
    time.sleep(0.1)
with job"""


def submit(workspace, *targets):
    """A run on the cluster, under way."""
    folders = (*workspace.packages, PLUGIN)
    return subprocess.Popen(
        [SNAKEMAKE[0], *targets, *PROFILE, *QUICK, "--default-resources", *GIVEN],
        cwd=workspace.root,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(map(str, folders))},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def complete(run):
    """What a run says that must succeed."""
    code, said = ended(run)
    assert code == 0, said
    return said


def made_as(here, there):
    """Names of all products of ``there``; they have the bytes of those of ``here``."""
    made = set(there.stamps())
    for name in made:
        one, other = (each.root / "results" / name for each in (here, there))
        assert one.read_bytes() == other.read_bytes(), name
    return made


@pytest.fixture
def fresh(sources, tmp_path):
    return sources.copied_to(tmp_path / "thirdbody")


@pytest.fixture
def begin(fresh):
    """Function that starts a run for Table 1, whose job waits for a file ``go``; the run ends with
    the test."""
    fresh.rewrite(SCRIPT, lambda text: text.replace("\nwith job", HELD))
    runs = []

    def start():
        runs.append(submit(fresh, TABLE))
        return runs[-1]

    yield start
    for run in runs:
        if run.poll() is None:
            kill(run)


def wait_for_begun(workspace):
    """Wait until a job for Table 1 has begun."""
    begun = workspace.root / "begun"
    wait_until(begun.exists)
    begun.unlink()


def kill(run):
    run.send_signal(signal.SIGKILL)
    run.communicate()


@long
def test_the_bytes_are_those_of_one_machine(cluster, fresh, finished):
    before = cluster.jobs("all")
    complete(submit(fresh, FIGURE))
    assert {"datasets/fig03.nc", "bands/fig03.nc", "figures/fig03.png"} <= made_as(finished, fresh)
    assert cluster.submitted("solve", but=before) == cluster.submitted("draw", but=before) == 1
    assert len(cluster.jobs("all")) == len(before) + 2
    assert "Nothing to be done" in fresh.snakemake("--dry-run", FIGURE).stdout


@long
def test_the_atlas_goes_out_by_chunk_and_the_calibration_by_interpretation_and_seed(
    cluster, atlas_run, calibrated, sources, tmp_path
):
    there = calibrated.copied_to(tmp_path / "thirdbody")
    for name in (*MADE_BY_RUNS, "config/calibrated"):
        shutil.rmtree(there.root / name)
    shutil.copytree(sources.root / "config/calibrated", there.root / "config/calibrated")
    chunks = [f"results/atlas/chunks/{roughness}nm.nc" for roughness in (100, 300, 500)]
    before = cluster.jobs("all")
    adopted = f"results/calibration/{INTERPRETATIONS[0]}.yaml"
    complete(submit(there, *chunks, adopted, *MINIMAL))
    # the first interpretation is searched from both seeds
    wanted = {"solve_chunk": 3, "search_inputs": 2, "search_fold": 2, "summarise_inputs": 1}
    for rule, jobs in wanted.items():
        assert cluster.submitted(rule, but=before) == jobs
    for here, name in [(calibrated, adopted), *((atlas_run[0], chunk) for chunk in chunks)]:
        assert (there.root / name).read_bytes() == (here.root / name).read_bytes(), name


@long
def test_a_job_may_be_cancelled_its_node_go_down_and_the_controller_be_away(
    cluster, fresh, begin, finished
):
    run = begin()
    first = cluster.running()
    cluster.ask("scancel", first)
    second = cluster.running(but=first)
    wait_for_begun(fresh)
    cluster.cut_power_of_node()
    wait_until(lambda: second in cluster.jobs("pending"))
    cluster.start_node()
    wait_until(lambda: cluster.hurry(second) or (fresh.root / "begun").exists())
    cluster.stop_controller()
    (fresh.root / "go").touch()
    wait_until((fresh.root / TABLE).exists)
    cluster.start_controller()
    said = complete(run)
    assert f"JOB {first} ON node CANCELLED" in said
    assert "DUE TO NODE FAILURE" in said
    assert said.count("Trying to restart job") == 2
    assert made_as(finished, fresh)


def test_a_killed_run_is_started_again(cluster, fresh, begin, finished):
    run = begin()
    first = cluster.running()
    kill(run)
    run = begin()
    second = cluster.running(but=first)
    assert first in cluster.jobs("running")  # what the killed run submitted goes on
    (fresh.root / "go").touch()
    complete(run)
    wait_until(lambda: {first, second} <= set(cluster.jobs("completed")))
    assert made_as(finished, fresh)
    assert "Nothing to be done" in fresh.snakemake("--dry-run", TABLE).stdout
