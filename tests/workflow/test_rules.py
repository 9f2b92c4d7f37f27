"""The workflow is plain Snakemake: formatted, linted, short, and without private names."""

import re
import sys
from pathlib import Path

import pytest
from workspace import ROOT

FILES = [ROOT / "Snakefile", *sorted((ROOT / "workflow").rglob("*.*"))]
CODE = [path for path in FILES if path.suffix in ("", ".smk", ".py", ".yaml")]


@pytest.mark.parametrize("path", CODE, ids=lambda path: path.name)
def test_no_private_name_of_snakemake_is_used(path):
    text = path.read_text(encoding="utf-8")
    assert not re.search(r"\b(workflow|snakemake|rules|config|dag)\._\w", text)  # private names
    assert not re.search(r"\bworkflow(\.\w+)+\s*=[^=]", text)  # assignments to its objects
    assert not re.search(r"getLogger|addHandler|sys\.argv|__use_yte__|gc\.", text)


def test_the_linter_of_snakemake_finds_nothing(sources):
    run = sources.snakemake("--lint", config=())
    assert run.returncode == 0, run.stdout + run.stderr


def test_the_formatter_would_change_nothing(sources):
    snakefmt = Path(sys.executable).with_name("snakefmt")
    run = sources.execute(str(snakefmt), "--check", "Snakefile", "workflow")
    assert run.returncode == 0, run.stdout + run.stderr
