"""Ways to harm a run, and what must hold after it: the products of an undisturbed one."""

from __future__ import annotations

import ctypes
import os
import random
import signal
import subprocess
import time
from pathlib import Path

from workspace import Workspace, ended, start

LONG = os.environ.get("SURVIVAL") == "long"  # `make test-survival`
PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH = 24, 1, 2


def complete(workspace: Workspace, *arguments) -> str:
    """What a run says that must succeed."""
    code, said = ended(start(workspace, *arguments))
    assert code == 0, said
    return said


def release_in(workspace: Workspace) -> Path:
    """The folder of the release in a workspace."""
    (folder,) = workspace.root.glob("results/release/*/")
    return folder


def obey_permissions() -> None:
    """Take from this process, and those it starts, root's right to pass over file permissions."""
    if os.geteuid() == 0:
        for capability in (CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH):
            assert ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, capability, 0, 0, 0) == 0


def jobs_begun(workspace: Workspace, since: float = 0.0) -> int:
    """Jobs whose log was written at the time ``since`` or later."""
    logs = workspace.root.glob("logs/**/*.log")
    return sum(log.stat().st_mtime >= since for log in logs)


def kill_all(run: subprocess.Popen) -> None:
    """End a run and all its jobs by SIGKILL."""
    os.killpg(run.pid, signal.SIGKILL)
    run.communicate(timeout=60)


def kill_main(run: subprocess.Popen) -> None:
    """End the main process of a run by SIGKILL; its jobs live on."""
    os.kill(run.pid, signal.SIGKILL)
    run.stdout.close()
    run.wait(60)


def kill_job(run: subprocess.Popen) -> None:
    """End one job of a run by SIGKILL, if there is one; the run goes on without it."""
    jobs = subprocess.run(
        ["pgrep", "-f", "-g", str(run.pid), r"\.snakemake/scripts/"], capture_output=True, text=True
    ).stdout.split()
    for job in jobs[:1]:
        os.kill(int(job), signal.SIGKILL)
    run.communicate(timeout=600)


WAYS = (kill_main, kill_job, kill_all)


def kill_at(
    workspace: Workspace,
    jobs: int,
    chance: random.Random,
    *arguments,
    kill=kill_all,
    since=0.0,
) -> bool:
    """Start a run and ``kill`` it soon after ``jobs`` jobs have begun; False if it ended before."""
    run = start(workspace, *arguments)
    while jobs_begun(workspace, since) < jobs and run.poll() is None:
        time.sleep(0.02)
    time.sleep(chance.uniform(0.0, 1.0))
    alive = run.poll() is None
    kill(run) if alive else run.communicate()
    return alive


def products(root: Path) -> dict[str, bytes]:
    """Content of each product under ``root``; hidden files are none."""
    files = (path for path in sorted(root.rglob("*")) if path.is_file())
    return {
        str(path.relative_to(root)): path.read_bytes()
        for path in files
        if not path.name.startswith(".")
    }


def assert_same(root: Path, undisturbed: dict[str, bytes]) -> None:
    """Every product under ``root`` is there, byte for byte that of ``undisturbed``; no others."""
    found = products(root)
    assert set(found) == set(undisturbed)
    assert not [name for name in found if found[name] != undisturbed[name]]
