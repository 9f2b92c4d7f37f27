"""Tools keep the rule of imports (contracts in pyproject.toml) and the style of source and rules."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
CHECKS = {
    "rooms import only from below": ["lint-imports", "--no-cache"],
    "ruff finds no fault": ["ruff", "check", "--no-cache"],
    "every file is formatted": ["ruff", "format", "--check", "--no-cache"],
    "every rule is formatted": ["snakefmt", "--check", "Snakefile", "workflow"],
    "Snakemake finds no fault": ["snakemake", "--lint"],
}


@pytest.mark.parametrize("check", CHECKS)
def test_source(check):
    tool, *arguments = CHECKS[check]
    command = [Path(sys.executable).with_name(tool), *arguments]
    library = {"PYTHONPATH": str(ROOT / "src")}
    done = subprocess.run(
        command, cwd=ROOT, env=os.environ | library, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
