"""Jobs of a run in the queue of SLURM: `sbatch` takes them, `squeue` tells what became of them.

The profile ``workflow/profiles/slurm`` has Snakemake run this file by its path, for each job and each
question:

    python slurm.py submit JOBSCRIPT    # prints the number of the job
    python slurm.py status NUMBER       # prints success, failed or running

No accounting database is needed.  While the controller does not answer nothing is lost: a submission
waits for it, and jobs count as running.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path

RUN = "THIRDBODY_RUN"  # variable with the name of the run, which is that of its jobs
SAID = Path(".snakemake/slurm")  # what jobs say, until they have succeeded
PROPERTIES = "# properties = "  # begins the line of a jobscript that tells resources
AWAY = "slurm controller", "timed out"  # in what is said by commands that the controller left alone
LIMITS = {"mem_mb": "--mem", "runtime": "--time"}  # options of `sbatch`, by resource
ALL_QUIET = 100  # of the resource `quiet`, for jobs that measure times: they get a node each
GONE = "Invalid job id"
PAUSE = 2.0  # seconds between questions to a controller that is waited for
PATIENCE = 60.0  # seconds until cancelled jobs have ended
WORDS = {"COMPLETED": "success"} | dict.fromkeys(
    (
        *("BOOT_FAIL", "CANCELLED", "DEADLINE", "FAILED", "NODE_FAIL"),
        *("OUT_OF_MEMORY", "PREEMPTED", "REVOKED", "TIMEOUT"),
    ),
    "failed",
)


def submit(script: str) -> str:
    """Put a job into the queue, once.

    Parameters
    ----------
    script
        Its jobscript, as Snakemake writes it.

    Returns
    -------
    str
        The number of the job.

    Raises
    ------
    SystemExit
        With what `sbatch` says, if the controller refuses the job.
    """
    with open(script, encoding="utf-8") as lines:
        told = next(line for line in lines if line.startswith(PROPERTIES))
    properties = json.loads(told.removeprefix(PROPERTIES))
    resources, run = properties["resources"], os.environ[RUN]
    comment = f"{properties.get('groupid') or properties['rule']} {properties['jobid']}"
    SAID.mkdir(parents=True, exist_ok=True)
    mark_of(run).touch()
    options = [
        *("--parsable", "--requeue", "--export=ALL", "--open-mode=append"),
        *(f"--output={SAID}/%j.log", f"--job-name={run}", f"--comment={comment}"),
        f"--cpus-per-task={properties['threads']}",
        *(f"{option}={resources[name]}" for name, option in LIMITS.items() if name in resources),
    ]
    if resources.get("quiet") == ALL_QUIET:
        options.append("--exclusive")
    while True:
        done = _ask("sbatch", *options, script)
        if done.returncode == 0:
            return done.stdout.partition(";")[0].strip()
        if not any(words in done.stderr for words in AWAY):
            sys.exit(done.stderr.strip())
        print("SLURM does not answer; waiting for its controller", file=sys.stderr)
        while _ask("scontrol", "ping").returncode != 0:
            time.sleep(PAUSE)
        queue = _ask("squeue", "--noheader", f"--name={run}", "--format=%A %k").stdout
        taken = [line.partition(" ")[0] for line in queue.splitlines() if line.endswith(comment)]
        if taken:  # before the controller went away
            return taken[0]


def status(number: str) -> str:
    """What became of a job.

    Parameters
    ----------
    number
        Its number.

    Returns
    -------
    str
        ``running`` also while it waits, and as long as the controller does not answer; ``success`` also
        if the controller has forgotten the job: Snakemake then looks whether its products are there.
    """
    asked = _ask("squeue", "--noheader", "--states=all", "--format=%T", f"--jobs={number}")
    state, said = asked.stdout.strip(), SAID / f"{number}.log"
    is_gone = GONE in asked.stderr or (asked.returncode == 0 and not state)
    word = "success" if is_gone else WORDS.get(state, "running")
    if word == "success":
        said.unlink(missing_ok=True)
    elif word == "failed":
        print(f"job {number} of SLURM has ended as {state}; it said: {said}", file=sys.stderr)
    return word


def mark_of(run: str) -> Path:
    """The file that is there while jobs of ``run`` may be in the queue."""
    return SAID / run


def cancel(run: str) -> None:
    """Cancel the jobs of a run that has ended without them, and wait until they have ended as well.

    Parameters
    ----------
    run
        The name of the run.
    """
    if not mark_of(run).exists():
        return
    if _ask("scancel", f"--name={run}").returncode != 0:
        print(f"jobs of the run before may be under way: scancel --name={run}", file=sys.stderr)
        return
    end = time.monotonic() + PATIENCE
    while _ask("squeue", "--noheader", f"--name={run}").stdout and time.monotonic() < end:
        time.sleep(PAUSE)
    mark_of(run).unlink(missing_ok=True)


def _ask(*command: str) -> subprocess.CompletedProcess:
    """What a command of SLURM answers, in words that do not depend on the language."""
    return subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)


if __name__ == "__main__":
    print({"submit": submit, "status": status}[sys.argv[1]](sys.argv[2]))
