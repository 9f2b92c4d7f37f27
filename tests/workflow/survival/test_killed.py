"""A killed run is started again by the same command and gives what an undisturbed one gives."""

import random

import pytest
from harm import LONG, assert_same, complete, jobs_begun, kill_at

KILLS, RUNS = (20, 4) if LONG else (2, 1)


def test_a_killed_run_started_again_gives_the_same_products(
    sources, finished, undisturbed, tmp_path, tell
):
    """Moments are spread over the jobs and dealt to the runs in turn, with a time at random."""
    jobs, chance = jobs_begun(finished), random.Random(5)
    moments = [round(jobs * (kill + 0.5) / KILLS) for kill in range(KILLS)]
    killed = []
    for number in range(RUNS):
        workspace = sources.copied_to(tmp_path / str(number))
        killed += [moment for moment in moments[number::RUNS] if kill_at(workspace, moment, chance)]
        complete(workspace)
        assert_same(workspace.root / "results", undisturbed)
    tell(f"{len(killed)} kills of the whole group in {RUNS} runs, after {killed} of {jobs} jobs")
    assert len(killed) >= 0.9 * KILLS


@pytest.mark.skipif(not LONG, reason="make test-survival")
def test_jobs_that_outlive_their_run_harm_nothing(sources, finished, undisturbed, tmp_path, tell):
    workspace = sources.copied_to(tmp_path / "thirdbody")
    chance = random.Random(6)
    moments = [round(jobs_begun(finished) * share) for share in (0.1, 0.4, 0.7)]
    killed = sum(kill_at(workspace, moment, chance, whole_group=False) for moment in moments)
    complete(workspace)
    assert_same(workspace.root / "results", undisturbed)
    tell(f"{killed} kills of the first process alone")
    assert killed
