"""Copies of the repository in which Snakemake really runs, each on its own copy of the library."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import yaml

ROOT = Path(__file__).resolve().parents[2]
# of the atlas, the accuracy and the calibration
MINIMAL = ("--config", "changes=config/minimal.yaml")
SEARCHED = yaml.safe_load((ROOT / "config" / "calibration.yaml").read_text())["interpretations"]
# calibrated in tests: one that is searched from scattered sets, and one that starts from it
WIDE = next(name for name, each in SEARCHED.items() if "nearby" not in each)
NEARBY = next(name for name, each in SEARCHED.items() if each.get("nearby") == WIDE)
INTERPRETATIONS = WIDE, NEARBY
SNAKEMAKE = (str(Path(sys.executable).with_name("snakemake")), "-c2")
MADE_BY_RUNS = ("results", "logs", ".snakemake")
OTHER_TARGETS = ("accuracy", "atlas", "calibration", "release")
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
        if (ROOT / ".git").exists() and shutil.which("git"):  # which knows the version
            borrowed = [
                "git",
                "clone",
                "--quiet",
                "--shared",
                "--no-checkout",
                ROOT,
                root / "borrowed",
            ]
            subprocess.run(borrowed, check=True)
            (root / "borrowed" / ".git").rename(root / ".git")
            (root / "borrowed").rmdir()
            subprocess.run(["git", "reset", "--quiet"], cwd=root, check=True)
        return cls(root)

    def take_products(self) -> None:
        """Copy what `snakemake` has made in the repository, with its records."""
        for name in MADE_BY_RUNS:
            if (ROOT / name).is_dir():
                ignored = shutil.ignore_patterns(*OTHER_TARGETS)
                shutil.copytree(ROOT / name, self.root / name, ignore=ignored)

    def copied_to(self, root: Path) -> Workspace:
        """The same with results and times of change, elsewhere."""
        shutil.copytree(self.root, root)
        return Workspace(root)

    def execute(self, *command) -> subprocess.CompletedProcess:
        """Run a command at the root; ``thirdbody`` is that of ``packages``, whichever is
        installed."""
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

    def snakemake(self, *arguments, config=()) -> subprocess.CompletedProcess:
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
        listed = self.snakemake("--detailed-summary")
        assert listed.returncode == 0, listed.stderr
        header, *lines = (line.split("\t") for line in listed.stdout.splitlines() if "\t" in line)
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


def start(workspace: Workspace, *arguments, prepare=None) -> subprocess.Popen:
    """A run under way in a session of its own; ``prepare`` is called in its first process."""
    return subprocess.Popen(
        [*SNAKEMAKE, *arguments],
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


def with_value(text: str, key: str, value) -> str:
    """YAML ``text`` with another value of ``key``."""
    content = yaml.safe_load(text)
    *way, last = (int(word) if word.isdigit() else word for word in key.split("/"))
    place = content
    for word in way:
        place = place[word]
    place[last] = value
    return yaml.safe_dump(content, sort_keys=False, allow_unicode=True)
