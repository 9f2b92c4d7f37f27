"""A killed run is started again by the same command and gives what an undisturbed one gives."""

import filecmp
import random
import shutil
import subprocess
import sys
import zipfile

import pytest
from harm import LONG, assert_same, complete, jobs_begun, kill_at, release_in
from workspace import Workspace

from thirdbody.release.bag import files_in

KILLS, RUNS = 20, 4
ELSEWHERE = {
    "TZ": "Pacific/Kiritimati",
    "LC_ALL": "C",
    "PYTHONUTF8": "0",
    "PYTHONCOERCECLOCALE": "0",
    "PYTHONHASHSEED": "1",
}
USED = {"config": ("--configfile", "used.json")}
long = pytest.mark.skipif(not LONG, reason="make test-survival")


def test_source_in_the_archive_makes_the_same_archive_elsewhere_though_killed_twice(
    finished, released, tmp_path, monkeypatch, tell
):
    first, jobs, chance = release_in(released), jobs_begun(finished), random.Random(5)
    with zipfile.ZipFile(first.with_name(f"{first.name}.zip")) as archive:
        archive.extractall(tmp_path)
    subprocess.run([sys.executable, tmp_path / first.name / "verification/verify.py"], check=True)
    unpacked = tmp_path / first.name / "data"
    elsewhere = Workspace(shutil.copytree(unpacked / "source", tmp_path / "elsewhere"))
    shutil.copyfile(unpacked / "configuration/config.json", elsewhere.root / "used.json")
    for name, value in ELSEWHERE.items():
        monkeypatch.setenv(name, value)
    moments = [jobs // 4, 3 * jobs // 4]
    killed = [kill_at(elsewhere, moment, chance, "release", **USED) for moment in moments]
    complete(elsewhere, "release", **USED)
    again, names = release_in(elsewhere), files_in(first, first)
    assert files_in(again, again) == names
    assert filecmp.cmpfiles(first, again, names, shallow=False) == (names, [], [])
    archives = {folder.with_name(f"{first.name}.zip").read_bytes() for folder in (first, again)}
    assert len(archives) == 1
    tell(f"archive: {len(names)} files of the same bytes from two runs, one killed twice")
    assert all(killed)


@long
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


@long
def test_jobs_that_outlive_their_run_harm_nothing(sources, finished, undisturbed, tmp_path, tell):
    workspace = sources.copied_to(tmp_path / "thirdbody")
    chance = random.Random(6)
    moments = [round(jobs_begun(finished) * share) for share in (0.1, 0.4, 0.7)]
    killed = sum(kill_at(workspace, moment, chance, whole_group=False) for moment in moments)
    complete(workspace)
    assert_same(workspace.root / "results", undisturbed)
    tell(f"{killed} kills of the first process alone")
    assert killed
