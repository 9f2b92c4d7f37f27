"""Time of a clean run of the paper on a cluster over that on this machine, and whether products agree.

    python benchmarks/measure_cluster.py [--folder FOLDER] [--repeats 1]

Both kinds of runs take turns, in copies of the repository.  Without a folder the cluster is one node
on this machine, started from Debian's packages slurm-wlm and munge by root and stopped at the end.
A folder that all hosts share, and this environment on all of them, measure the cluster at hand.  Exit
code 1 if products differ, or if the median of the ratios is above ``LIMIT``.
"""

from __future__ import annotations

import argparse
import hashlib
import shutil
import sys
import tempfile
import time
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from statistics import median

from tests.workflow.cluster.single_node import Cluster
from tests.workflow.workspace import MADE_BY_RUNS, Workspace

LIMIT = 3.0  # of the ratio of elapsed times
PROFILE = ("--profile", "workflow/profiles/slurm")
MEASURED = "accuracy/"  # products that hold times, never the same twice


def clean_run(workspace: Workspace, options: Sequence[str]) -> tuple[float, int]:
    """Delete all products and run the workflow.

    Parameters
    ----------
    workspace : Workspace
        A copy of the repository.
    options : sequence of str
        Further arguments of Snakemake.

    Returns
    -------
    tuple of float and int
        Elapsed time [s] and number of submissions.

    Raises
    ------
    SystemExit
        If the run fails; its output is the message.
    """
    for name in MADE_BY_RUNS:
        shutil.rmtree(workspace.root / name, ignore_errors=True)
    start = time.perf_counter()
    run = workspace.snakemake(*options, config=())
    elapsed = time.perf_counter() - start
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    return elapsed, run.stderr.count("Submitted ")


def sums(workspace: Workspace) -> dict[str, str]:
    """SHA-256 of each product but measured times, by name."""
    results = workspace.root / "results"
    names = [name for name in workspace.stamps() if not name.startswith(MEASURED)]
    return {name: hashlib.sha256((results / name).read_bytes()).hexdigest() for name in names}


def main() -> None:
    """Measure, print, and exit with 1 if products differ or the cluster takes too long."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--folder", type=Path, help="shared by all hosts of the cluster at hand")
    parser.add_argument("--repeats", type=int, default=1, help="runs of each kind")
    given = parser.parse_args()
    ratios = []
    with ExitStack() as stack:
        place = Path(stack.enter_context(tempfile.TemporaryDirectory(dir=given.folder)))
        if given.folder is None:
            (place / "daemons").mkdir()
            cluster = Cluster(place / "daemons")
            stack.callback(cluster.stop)
            cluster.start_all()
        here = Workspace.of_sources(place / "here")
        there = Workspace.of_sources(place / "there")
        for _ in range(given.repeats):
            local, _ = clean_run(here, ())
            queued, submissions = clean_run(there, PROFILE)
            ratios.append(queued / local)
            print(
                f"here {local:.1f} s, cluster {queued:.1f} s in {submissions} submissions, "
                f"ratio {ratios[-1]:.2f}",
                flush=True,
            )
        made, same = sums(here), sums(there)
    differing = sorted(name for name in made.keys() | same if made.get(name) != same.get(name))
    print(f"{len(made)} products, of which differ: {', '.join(differing) or 'none'}")
    print(f"ratio {median(ratios):.2f}; allowed: at most {LIMIT}")
    sys.exit(bool(differing) or median(ratios) > LIMIT)


if __name__ == "__main__":
    main()
