"""Copies of the repository in which Snakemake really runs, each on its own copy of the library."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
MINIMAL = ("--configfile", "config/minimal.yaml")
INTERPRETATIONS = (
    "uncentred_summit_wide_full_natural",
    "uncentred_surface_wide_full",
)  # calibrated in tests
SNAKEMAKE = (str(Path(sys.executable).with_name("snakemake")), "-c2")
MADE_BY_RUNS = ("results", "logs", ".snakemake")
NOT_SOURCES = (".git", ".venv", "dist", "__pycache__", ".*_cache", ".hypothesis", "*.egg-info")


@dataclass(frozen=True)
class Workspace:
    """A copy of the repository at ``root``, or a folder of other work.

    Python imports from ``imported``; from the copy itself if there are none.
    """

    root: Path
    imported: tuple[Path, ...] = ()

    @property
    def packages(self) -> tuple[Path, ...]:
        """Folders that Python imports from."""
        return self.imported or (self.root / "src", self.root)

    @classmethod
    def of_sources(cls, root: Path) -> Workspace:
        """A copy of what a clone would hold: nothing that a run or an installation made."""
        skipped = shutil.ignore_patterns(*NOT_SOURCES)

        def left_out(directory, names):
            made = MADE_BY_RUNS if Path(directory) == ROOT else ()
            return skipped(directory, names) | {name for name in names if name in made}

        shutil.copytree(ROOT, root, ignore=left_out)
        return cls(root)

    def copied_to(self, root: Path) -> Workspace:
        """The same with results and times of change, elsewhere."""
        shutil.copytree(self.root, root)
        return Workspace(root)

    def execute(self, *command) -> subprocess.CompletedProcess:
        """Run a command at the root; ``thirdbody`` is that of ``packages``, whichever is installed."""
        library = {"PYTHONPATH": os.pathsep.join(map(str, self.packages))}
        return subprocess.run(
            command,
            cwd=self.root,
            env=os.environ | library,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=900,
        )

    def python(self, code: str, *arguments) -> subprocess.CompletedProcess:
        """Run a Python program in an interpreter of its own."""
        return self.execute(sys.executable, "-c", code, *arguments)

    def snakemake(self, *arguments, config=MINIMAL) -> subprocess.CompletedProcess:
        """Run the Snakemake of this interpreter on two cores."""
        return self.execute(*SNAKEMAKE, *arguments, *config)

    def products(self, *patterns: str) -> set[str]:
        """Files under ``results/`` that match; each pattern must match one at least."""
        results = self.root / "results"
        found = set()
        for pattern in patterns:
            matches = {str(path.relative_to(results)) for path in results.glob(pattern)}
            assert matches, f"nothing is called results/{pattern}"
            found |= matches
        return found

    def stamps(self) -> dict[str, int]:
        """When each product under ``results/`` was written [ns]."""
        results = self.root / "results"
        files = (path for path in results.rglob("*") if path.is_file())
        return {str(path.relative_to(results)): path.stat().st_mtime_ns for path in files}

    def pending(self) -> set[str]:
        """Files under ``results/`` that the next run would make."""
        rows = self.summary()
        return {row["output_file"] for row in rows if row["plan"] == "update pending"}

    def summary(self) -> list[dict[str, str]]:
        """Snakemake's own table of every output, file names relative to ``results/``."""
        told = self.snakemake("--detailed-summary")
        assert told.returncode == 0, told.stderr
        header, *lines = (line.split("\t") for line in told.stdout.splitlines() if "\t" in line)
        rows = [dict(zip(header, line, strict=True)) for line in lines]
        return [row | {"output_file": row["output_file"].removeprefix("results/")} for row in rows]

    def rewrite(self, path: str, change: Callable[[str], str]) -> None:
        """Replace the text of a file by what ``change`` makes of it."""
        file = self.root / path
        text = file.read_text(encoding="utf-8")
        changed = change(text)
        assert changed != text, f"{path} stays as it is"
        file.write_text(changed, encoding="utf-8")

    def put(self, path: str, key: str, value) -> None:
        """Give ``key`` of a YAML file, such as ``scenes/fig03/curves/0``, another value."""
        self.rewrite(path, lambda text: with_value(text, key, value))


def start(workspace: Workspace, *arguments, config=MINIMAL, prepare=None) -> subprocess.Popen:
    """A run under way in a session of its own; ``prepare`` is called in its first process."""
    return subprocess.Popen(
        [*SNAKEMAKE, *arguments, *config],
        cwd=workspace.root,
        env=os.environ | {"PYTHONPATH": str(workspace.root / "src")},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        start_new_session=True,
        preexec_fn=prepare,
    )


def ended(run: subprocess.Popen) -> tuple[int, str]:
    """Exit code of a run and all it said."""
    said, _ = run.communicate(timeout=900)
    assert "Traceback" not in said, said
    return run.returncode, said


ABSENT = object()


def with_value(text: str, key: str, value) -> str:
    """YAML ``text`` with another value of ``key``, or without it where that is ``ABSENT``."""
    content = yaml.safe_load(text)
    *way, last = (int(word) if word.isdigit() else word for word in key.split("/"))
    place = content
    for word in way:
        place = place[word]
    if value is ABSENT:
        del place[last]
    else:
        place[last] = value
    return yaml.safe_dump(content, sort_keys=False, allow_unicode=True)


CHEAP = "results/extracted/table1/all.csv"  # what a run makes that is not refused
# what Snakemake says of its own settings before it reads the workflow
ANNOUNCED = ("Using workflow specific profile", "Config file config/")


def run_side_by_side(sources: Workspace, place: Path, cases) -> Iterator[tuple]:
    """Run the workflow on each case: what prepares its copy of the repository, and more arguments.

    Yields exit code, lines that were said, and whether every file that no run makes is as it was.
    """
    context = get_context("forkserver")
    context.set_forkserver_preload(["snakemake.cli", "jsonschema", "yte"])
    with ProcessPoolExecutor(2, context, max_tasks_per_child=1) as pool:
        under_way = []
        for number, (prepare, arguments) in enumerate(cases):
            root, said = place / str(number), place / f"{number}.txt"
            sources.copied_to(root)
            prepare(root)
            job = pool.submit(run_here, root, ("-c1", CHEAP, *arguments), said)
            under_way.append((root, _contents(root), said, job))
        for root, before, said, job in under_way:
            code = job.result()
            lines = said.read_text(encoding="utf-8", errors="replace").splitlines()
            messages = [line for line in lines if line and not line.startswith(ANNOUNCED)]
            made = () if code else ("logs", "extracted")
            yield code, messages, _contents(root, made) == before


def _contents(root: Path, made=()) -> dict[str, bytes]:
    """Every file but those in which Snakemake keeps its books, and those in folders of ``made``."""
    files = (path for path in root.rglob("*") if path.is_file())
    skipped = {".snakemake", "__pycache__", *made}
    return {str(path): path.read_bytes() for path in files if not skipped.intersection(path.parts)}


def run_here(root: Path, arguments: tuple[str, ...], said: Path) -> int:
    """Snakemake in this very process, which ends after it; exit code, and all it says in ``said``.

    A process forked from one that has Snakemake loaded spares most of the time of a short run.
    """
    with open(said, "w", encoding="utf-8") as stream:
        os.dup2(stream.fileno(), 1)
        os.dup2(stream.fileno(), 2)
    os.chdir(root)
    sys.argv = ["snakemake", *arguments]
    os.environ["PYTHONPATH"] = os.pathsep.join([str(root / "src"), str(root)])
    sys.path[:0] = [str(root / "src"), str(root)]
    from snakemake.cli import main

    try:
        code = main(list(arguments))
    except SystemExit as end:
        code = end.code
    except BaseException:
        traceback.print_exc()
        code = 1
    if isinstance(code, str):
        print(code, file=sys.stderr)
    return code if isinstance(code, int) else int(code is not None)
