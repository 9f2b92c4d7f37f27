"""Time of a clean run, against that of the same jobs if all they do is import what they import.

    python benchmarks/measure_overhead.py [--repeats 3] [--configfile FILE] [target ...]

Both are run in turn in copies of the repository.  What else the machine does changes from minute to
minute: it is the ratio of each run to the one after it that counts, and the median of these.  Exit
code 1 if it is above the limit.
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
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from workspace import MADE_BY_RUNS, Workspace

LIMIT = 1.3
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
    """A clean run: elapsed and processor time [s], and the latter per rule with its jobs."""

    elapsed: float
    processor: float
    per_rule: dict[str, float]
    jobs: dict[str, int]


def only_imports(script: str) -> str:
    """The import statements of ``script``, wherever they stand, and empty outputs."""
    kinds = (ast.Import, ast.ImportFrom)
    statements = [
        ast.unparse(node) for node in ast.walk(ast.parse(script)) if isinstance(node, kinds)
    ]
    return "\n".join(dict.fromkeys(statements)) + "\n" + WRITE_NOTHING


def prepared(root: Path, hollow: bool) -> Workspace:
    """A copy of the repository whose jobs tell what they cost; ``hollow`` ones only import."""
    workspace = Workspace.of_sources(root)
    costs = str(root / "costs.txt")
    for script in (root / "workflow" / "scripts").glob("*.py"):
        text = script.read_text(encoding="utf-8")
        work = only_imports(text) if hollow else text
        script.write_text(work + TELL_COST.format(costs=costs, rule=script.stem), encoding="utf-8")
    return workspace


def clean_run(workspace: Workspace, targets, config) -> Cost:
    """Run everything from nothing."""
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
    """User and system time [s] of all processes started here that have ended."""
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
    """Median of the ratios of a ``time`` of runs to that of the runs after them."""
    pairs = zip(full, hollow, strict=True)
    return median(getattr(run, time) / getattr(imports, time) for run, imports in pairs)


def report(runs: list[Cost], imports_only: list[Cost]) -> str:
    """Both times and their ratio, then what each rule adds to its imports."""
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
