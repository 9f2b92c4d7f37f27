"""Where the time of a clean run of the workflow goes.

    python benchmarks/measure_overhead.py [--repeats 3] [--before COMMIT] [--configfile FILE] [target ...]

The jobs of a run in a copy of the repository record what they are busy with.  Runs take turns with
those of a second copy, whose jobs write empty files: what these take on the clock is the part of
Snakemake and of the starts of interpreters.  Medians count, as other work on the machine changes
from minute to minute.  With ``--before`` whole runs of the repository as it is take turns with those
of a commit instead, both in this environment.
"""

from __future__ import annotations

import argparse
import json
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from textwrap import indent

from benchmarks.job_times import START, WORK
from tests.workflow.workspace import MADE_BY_RUNS, ROOT, Workspace

COSTS = "costs.jsonl"  # what the jobs of a run record
NOTHING = """
for path in snakemake.output:
    open(path, "w").close()
if False:  # the modules that the rule has as inputs
"""
RECORD = "from benchmarks.job_times import record; record({place!r}, {rule!r})\n"
RECORD_WHOLE = """
if workflow.is_main_process:
    from benchmarks.job_times import record_whole
    record_whole({place!r}, {rule!r})
"""
SNAKEMAKE = "Snakemake itself"
INTERPRETER = "starts of the interpreter"
PREAMBLE = "Snakemake's part of scripts"
END = "ends of the interpreter"
LIBRARIES = 8  # as many are named, those that take longest to import


@dataclass(frozen=True)
class Cost:
    """What a clean run took.

    Attributes
    ----------
    elapsed : float
        Time on the clock [s].
    processor : float
        Processor time of all processes [s].
    snakemake : float
        That of Snakemake itself [s].
    jobs : list of dict
        What each job recorded, see ``job_times.record``.
    """

    elapsed: float
    processor: float
    snakemake: float
    jobs: list[dict]


def prepared(root: Path, empty: bool) -> Workspace:
    """Copy the repository so that its jobs record what they take.

    Parameters
    ----------
    root : Path
        Where to.
    empty : bool
        Whether the jobs are to write empty files, and do nothing else.
    """
    workspace = Workspace.of_sources(root)
    place = str(root / COSTS)
    with open(root / "workflow" / "Snakefile", "a", encoding="utf-8") as snakefile:
        snakefile.write(RECORD_WHOLE.format(place=place, rule=SNAKEMAKE))
    for script in (root / "workflow" / "scripts").glob("*.py"):
        text = script.read_text(encoding="utf-8")
        work = NOTHING + indent(text, "    ") if empty else text
        begin = RECORD.format(place=place, rule=script.stem)
        script.write_text(begin + work, encoding="utf-8")
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
    costs = workspace.root / COSTS
    costs.unlink(missing_ok=True)
    elapsed, processor = whole_run(workspace, targets, config)
    told = [json.loads(line) for line in costs.read_text(encoding="utf-8").splitlines()]
    *jobs, snakemake = sorted(told, key=lambda job: job["rule"] == SNAKEMAKE)
    return Cost(elapsed, processor, snakemake[WORK], jobs)


def whole_run(
    workspace: Workspace, targets: Sequence[str], config: Sequence[str]
) -> tuple[float, float]:
    """Delete all products and run the workflow, as ``clean_run`` does; returns the time on the clock and
    the processor time [s]."""
    for name in MADE_BY_RUNS:
        shutil.rmtree(workspace.root / name, ignore_errors=True)
    before, start = processor_time(), time.perf_counter()
    run = workspace.snakemake(*targets, config=config)
    elapsed = time.perf_counter() - start
    if run.returncode:
        sys.exit(run.stdout + run.stderr)
    return elapsed, processor_time() - before


def clone_of(commit: str, root: Path) -> Workspace:
    """A clone of the repository at a ``commit``."""
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(root)], check=True)
    subprocess.run(["git", "checkout", "--quiet", commit], cwd=root, check=True)
    return Workspace(root)


def compare(
    commit: str, repeats: int, targets: Sequence[str], config: Sequence[str], place: Path
) -> None:
    """Print what whole runs of a ``commit`` and of the repository take, in turns; the first of each,
    which compiles modules, does not count."""
    runs = {
        commit: clone_of(commit, place / "before"),
        "now": Workspace.of_sources(place / "now"),
    }
    taken = {name: [] for name in runs}
    for number in range(repeats + 1):
        for name, workspace in runs.items():
            each = whole_run(workspace, targets, config)
            if number:
                taken[name].append(each)
                told = f"{each[0]:.1f} s on the clock, {each[1]:.1f} s of processor time"
                print(f"{name}: {told}", flush=True)
    for index, what in enumerate(("on the clock", "processor time")):
        before, now = (sum(each[index] for each in times) for times in taken.values())
        print(f"{what}: {now / before:.1%} of that before")


def processor_time() -> float:
    """User and system time [s] of all processes that were started here and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def start_of_interpreter(repeats: int = 20) -> float:
    """Processor time [s] of an interpreter that does nothing."""
    before = processor_time()
    for _ in range(repeats):
        subprocess.run([sys.executable, "-c", "pass"], check=True)
    return (processor_time() - before) / repeats


def parts(run: Cost, interpreter: float) -> dict[str, float]:
    """Processor time of a run [s] by what it was spent on; ``interpreter`` is that of one start."""
    told = Counter()
    for job in run.jobs:
        told.update({name: value for name, value in job.items() if name != "rule"})
    starts = interpreter * len(run.jobs)
    end = run.processor - run.snakemake - told.total()
    split = {INTERPRETER: starts, SNAKEMAKE: run.snakemake, PREAMBLE: told.pop(START) - starts}
    return split | {WORK: told.pop(WORK), END: end} | told


def by_rule(run: Cost) -> dict[str, tuple[int, float, float]]:
    """Jobs, and processor time [s] of imports and of work, by rule."""
    found = {}
    for job in run.jobs:
        count, imports, work = found.get(job["rule"], (0, 0.0, 0.0))
        libraries = sum(job[name] for name in job if name not in ("rule", START, WORK))
        found[job["rule"]] = count + 1, imports + libraries, work + job[WORK]
    return found


def report(runs: list[Cost], empty: list[Cost], interpreter: float) -> str:
    """Text: times of both kinds of runs, processor time by what it is spent on, and by rule."""
    split = [parts(run, interpreter) for run in runs]
    names = dict.fromkeys(name for each in split for name in each)
    middle = {name: median(each.get(name, 0.0) for each in split) for name in names}
    known = [INTERPRETER, SNAKEMAKE, PREAMBLE, WORK, END]
    libraries = sorted(names.keys() - known, key=middle.get, reverse=True)
    rows = [(name, middle[name]) for name in known]
    rows += [(f"importing {name}", middle[name]) for name in libraries[:LIBRARIES]]
    rows += [("importing others", sum(middle[name] for name in libraries[LIBRARIES:]))]
    total = sum(value for _, value in rows)
    lines = [
        f"{'medians [s]':<28}{'run':>9}{'empty jobs':>12}",
        f"{'on the clock':<28}{_middle(runs, 'elapsed'):>9.1f}{_middle(empty, 'elapsed'):>12.1f}",
        f"{'processor':<28}{_middle(runs, 'processor'):>9.1f}{_middle(empty, 'processor'):>12.1f}",
        "",
        f"{'processor time of the run':<28}{'[s]':>9}{'share':>12}",
        *(f"{name:<28}{value:>9.1f}{value / total:>12.1%}" for name, value in rows),
        f"{'all but the starts':<28}{total - middle[INTERPRETER]:>9.1f}",
        "",
        f"{'processor time by rule [s]':<28}{'jobs':>9}{'imports':>12}{'work':>9}",
    ]
    rules = [by_rule(run) for run in runs]
    table = [
        (rule, count, *(median(each[rule][part] for each in rules) for part in (1, 2)))
        for rule, (count, *_) in rules[0].items()
    ]
    for rule, count, imports, work in sorted(table, key=lambda row: -row[2] - row[3]):
        lines.append(f"{rule:<28}{count:>9}{imports:>12.2f}{work:>9.2f}")
    return "\n".join(lines)


def _middle(costs: list[Cost], attribute: str) -> float:
    return median(getattr(cost, attribute) for cost in costs)


def main() -> None:
    """Measure what the command line asks for, and print it."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--repeats", type=int, default=3, help="runs of each kind")
    parser.add_argument(
        "--before", metavar="COMMIT", help="whole runs, in turns with those of a commit"
    )
    parser.add_argument("--configfile", help="settings on top of config/config.yaml")
    parser.add_argument("targets", nargs="*", help="products, by default all")
    given = parser.parse_args()
    config = ("--configfile", given.configfile) if given.configfile else ()
    with tempfile.TemporaryDirectory() as place:
        if given.before:
            compare(given.before, given.repeats, given.targets, config, Path(place))
            return
        full, empty = [], []
        working = prepared(Path(place) / "full", empty=False)
        idle = prepared(Path(place) / "empty", empty=True)
        for _ in range(given.repeats):
            full.append(clean_run(working, given.targets, config))
            empty.append(clean_run(idle, given.targets, config))
            print(f"run {full[-1].elapsed:.1f} s, empty jobs {empty[-1].elapsed:.1f} s", flush=True)
    print("\n" + report(full, empty, start_of_interpreter()))


if __name__ == "__main__":
    main()
