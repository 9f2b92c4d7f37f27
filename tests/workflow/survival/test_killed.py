"""A killed run is started again by the same command and gives what an undisturbed one gives."""

import filecmp
import random
import shutil
import subprocess
import sys
import time
import zipfile
from collections import Counter

import pytest
from harm import LONG, WAYS, assert_same, complete, jobs_begun, kill_at, release_in
from workspace import Workspace, ended, start

from chenhorng.archive.files import files_in

KILLS = 30 if LONG else 2  # those that the run of the atlas does not undergo
ELSEWHERE = {"TZ": "Pacific/Kiritimati", "LC_ALL": "C", "PYTHONHASHSEED": "1"}
ELSEWHERE |= {"PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
# what is lost and made again in the gate, by a job each at least
LOST = [f"{kind}/fig04.*" for kind in ("datasets", "bands", "figures")]


@pytest.mark.skipif(not LONG, reason="make test-survival")
def test_source_in_the_archive_makes_the_same_archive_elsewhere_though_killed_twice(
    finished, released, tmp_path, monkeypatch, tell
):
    first, jobs, chance = release_in(released), jobs_begun(finished), random.Random(5)
    with zipfile.ZipFile(first.with_name(f"{first.name}.zip")) as archive:
        archive.extractall(tmp_path / first.name)
    subprocess.run([sys.executable, tmp_path / first.name / "verification/verify.py"], check=True)
    unpacked = tmp_path / first.name / "data"
    elsewhere = Workspace(shutil.copytree(unpacked / "source", tmp_path / "elsewhere"))
    for name, value in ELSEWHERE.items():
        monkeypatch.setenv(name, value)
    moments = [jobs // 4, 3 * jobs // 4]
    killed = [kill_at(elsewhere, moment, chance, "release") for moment in moments]
    complete(elsewhere, "release")
    again, names = release_in(elsewhere), files_in(first, first)
    assert files_in(again, again) == names
    assert filecmp.cmpfiles(first, again, names, shallow=False) == (names, [], [])
    archives = {folder.with_name(f"{first.name}.zip").read_bytes() for folder in (first, again)}
    assert len(archives) == 1
    tell(f"archive: {len(names)} files of the same bytes from two runs, one killed twice")
    assert all(killed)


def test_a_run_killed_again_and_again_gives_the_same_products(
    sources, finished, undisturbed, tmp_path, tell
):
    """Moments are spread over the jobs, with a time at random; each way of killing in turn."""
    begin = sources if LONG else finished
    workspace = begin.copied_to(tmp_path / "thirdbody")
    jobs = jobs_begun(finished) if LONG else len(LOST)
    if not LONG:
        for name in workspace.products(*LOST):
            (workspace.root / "results" / name).unlink()
    chance, killed, begun = random.Random(5), Counter(), time.time()
    for number in range(KILLS):
        kill = WAYS[number % len(WAYS)]
        moment = round(jobs * (number + 0.5) / KILLS)
        killed[kill.__name__] += kill_at(workspace, moment, chance, kill=kill, since=begun)
    complete(workspace)
    assert_same(workspace.root / "results", undisturbed)
    assert not [*workspace.root.glob("results/**/.*.partial*")]  # what jobs were writing
    tell(f"killed at {KILLS} moments of {jobs} jobs: {dict(killed)}")
    assert killed.total() >= 0.9 * KILLS


def test_two_runs_at_once_lose_nothing(workspace, undisturbed, tell):
    """Either may fail where the other replaces its files; the same command then completes."""
    for name in ("table1.csv", "table2.csv"):
        (workspace.root / "results/tables" / name).unlink()
    codes = [ended(run)[0] for run in [start(workspace), start(workspace)]]
    complete(workspace)
    assert_same(workspace.root / "results", undisturbed)
    tell(f"two runs at once ended with {codes}")
