"""Time of a clean run of the workflow over that of the same jobs if they did nothing but import.

    python benchmarks/measure_overhead.py [--repeats 3] [--configfile FILE] [target ...]

The difference is what the jobs really do.  Both kinds of runs take turns, each in a copy of the
repository.  As other work on the machine changes from minute to minute, each run is compared with
the one right after it, and the median of these ratios counts.  Exit code 1 if it is above ``LIMIT``.
"""

from __future__ import annotations

import argparse
import ast
import resource
import shutil
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from tests.workflow.workspace import MADE_BY_RUNS, Workspace

LIMIT = 1.3  # of the ratio of elapsed times
WRITE_NOTHING = """
if __name__ == "__main__":
    for path in snakemake.output:
        open(path, "w").close()
"""
TELL_COST = """
if __name__ == "__main__":
    import resource
    usage = resource.getrusage(resource.RUSAGE_SELF)
    with open({costs!r}, "a") as stream:
        stream.write(f"{rule} {{usage.ru_utime + usage.ru_stime}}\\n")
"""


@dataclass(frozen=True)
class Cost:
    """What a clean run took.

    Attributes
    ----------
    elapsed, processor : float
        Time on the clock, and processor time of all processes [s].
    per_rule : dict
        Processor time of all jobs of a rule [s], by name of its script.
    jobs : dict
        Number of jobs, by the same names.
    """

    elapsed: float
    processor: float
    per_rule: dict[str, float]
    jobs: dict[str, int]


def only_imports(script: str) -> str:
    """A script that imports what another does, and writes empty outputs.

    Parameters
    ----------
    script : str
        Source code; its import statements count wherever they stand.

    Returns
    -------
    str
        Source code.
    """
    kinds = (ast.Import, ast.ImportFrom)
    statements = [
        ast.unparse(node) for node in ast.walk(ast.parse(script)) if isinstance(node, kinds)
    ]
    return "\n".join(dict.fromkeys(statements)) + "\n" + WRITE_NOTHING


def prepared(root: Path, hollow: bool) -> Workspace:
    """Copy the repository so that its jobs record what they cost.

    Parameters
    ----------
    root : Path
        Where to.
    hollow : bool
        Whether the jobs are to do nothing but import.
    """
    workspace = Workspace.of_sources(root)
    costs = str(root / "costs.txt")
    for script in (root / "workflow" / "scripts").glob("*.py"):
        text = script.read_text(encoding="utf-8")
        work = only_imports(text) if hollow else text
        script.write_text(work + TELL_COST.format(costs=costs, rule=script.stem), encoding="utf-8")
    return workspace


def clean_run(workspace: Workspace, targets: Sequence[str], config: Sequence[str]) -> Cost:
    """Delete all products and run the workflow.

    Parameters
    ----------
    workspace : Workspace
        One of ``prepared``.
    targets : sequence of str
        Products to make; if empty, all.
    config : sequence of str
        Further arguments of Snakemake.

    Raises
    ------
    SystemExit
        If the run fails; its output is the message.
    """
    costs = workspace.root / "costs.txt"
    costs.unlink(missing_ok=True)
    for name in MADE_BY_RUNS:
        shutil.rmtree(workspace.root / name, ignore_errors=True)
    before, start = processor_time(), time.perf_counter()
    run = workspace.snakemake(*targets, config=config)
    elapsed = time.perf_counter() - start
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    told = [line.split() for line in costs.read_text(encoding="utf-8").splitlines()]
    per_rule = Counter()
    for rule, seconds in told:
        per_rule[rule] += float(seconds)
    jobs = Counter(rule for rule, _ in told)
    return Cost(elapsed, processor_time() - before, per_rule, jobs)


def processor_time() -> float:
    """User and system time [s] of all processes that were started here and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def middle(costs: list[Cost]) -> Cost:
    """Medians over repeated runs."""
    rules = costs[0].jobs
    return Cost(
        median(cost.elapsed for cost in costs),
        median(cost.processor for cost in costs),
        {rule: median(cost.per_rule[rule] for cost in costs) for rule in rules},
        rules,
    )


def middle_ratio(full: list[Cost], hollow: list[Cost], time: str) -> float:
    """Median of the ratios [1] of each full run to the hollow one after it.

    ``time`` is the attribute of ``Cost`` that is meant.
    """
    pairs = zip(full, hollow, strict=True)
    return median(getattr(run, time) / getattr(imports, time) for run, imports in pairs)


def report(runs: list[Cost], imports_only: list[Cost]) -> str:
    """Text: times of both kinds of runs, their ratio, and what each rule adds to its imports."""
    full, hollow = middle(runs), middle(imports_only)
    ratio = middle_ratio(runs, imports_only, "elapsed")
    lines = [
        f"{'medians [s]':<24}{'run':>9}{'imports':>9}{'ratio':>8}",
        f"{'elapsed':<24}{full.elapsed:>9.2f}{hollow.elapsed:>9.2f}{ratio:>8.3f}",
        f"{'processor, all':<24}{full.processor:>9.2f}{hollow.processor:>9.2f}"
        f"{middle_ratio(runs, imports_only, 'processor'):>8.3f}",
        "",
        f"{'processor by rule [s]':<24}{'run':>9}{'imports':>9}{'ratio':>8}{'excess':>9}"
        f"{'jobs':>6}{'share':>8}",
    ]
    added = {rule: full.per_rule[rule] - hollow.per_rule[rule] for rule in full.jobs}
    for rule in sorted(added, key=added.get, reverse=True):
        run, imports = full.per_rule[rule], hollow.per_rule[rule]
        lines.append(
            f"{rule:<24}{run:>9.2f}{imports:>9.2f}{run / imports:>8.3f}{added[rule]:>9.2f}"
            f"{full.jobs[rule]:>6}{run / full.processor:>8.1%}"
        )
    own = [cost.processor - sum(cost.per_rule.values()) for cost in (full, hollow)]
    lines.append(f"{'snakemake itself':<24}{own[0]:>9.2f}{own[1]:>9.2f}")
    lines += ["", f"ratio of elapsed times {ratio:.3f}; allowed: at most {LIMIT}"]
    return "\n".join(lines)


def main() -> None:
    """Measure what the command line asks for, print it, and exit with 1 above the limit."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--repeats", type=int, default=3, help="runs of each kind")
    parser.add_argument("--configfile", help="settings on top of config/config.yaml")
    parser.add_argument("targets", nargs="*", help="products, by default all")
    given = parser.parse_args()
    config = ("--configfile", given.configfile) if given.configfile else ()
    full, hollow = [], []
    with tempfile.TemporaryDirectory() as place:
        running = prepared(Path(place) / "full", hollow=False)
        importing = prepared(Path(place) / "hollow", hollow=True)
        for _ in range(given.repeats):
            full.append(clean_run(running, given.targets, config))
            hollow.append(clean_run(importing, given.targets, config))
            print(f"run {full[-1].elapsed:.2f} s, imports {hollow[-1].elapsed:.2f} s", flush=True)
    print("\n" + report(full, hollow))
    sys.exit(middle_ratio(full, hollow, "elapsed") > LIMIT)


if __name__ == "__main__":
    main()
