"""The habits of the rules: linted, formatted, logged, measured, and one literal list of products."""

import re
import sys
from pathlib import Path

import pytest
from test_minimal_run import PRODUCTS
from workspace import ROOT, Workspace

from thirdbody.release.codecheck import targets
from thirdbody.run.closure import import_closure

RULES = Workspace(ROOT).rules()
WORKING = [name for name, text in RULES.items() if "\n    output:" in text]


def test_rule_all_lists_every_product_once():
    listed = targets(ROOT / "workflow/Snakefile")
    assert len(listed) == len(set(listed))
    assert {name.removeprefix("results/") for name in listed} >= PRODUCTS


@pytest.mark.parametrize("rule", WORKING)
def test_each_rule_has_log_benchmark_message_and_one_thread(rule):
    for directive in ("log:", "benchmark:", "message:", "conda:", "threads: 1"):
        assert f"\n    {directive}" in RULES[rule], directive


@pytest.mark.parametrize("rule", WORKING)
def test_each_rule_runs_a_script_and_has_its_modules_as_inputs(rule):
    (script,) = re.findall(r'"\.\./scripts/(\w+\.py)"', RULES[rule])
    listed = f'modules=import_closure("workflow/scripts/{script}")' in RULES[rule]
    assert listed == bool(import_closure(f"workflow/scripts/{script}"))


@pytest.mark.parametrize(
    "file", sorted((ROOT / "workflow").rglob("*.*")), ids=lambda file: file.name
)
def test_workflow_files_stay_small(file):
    lines = file.read_text(encoding="utf-8").count("\n") if file.suffix in (".py", ".smk") else 0
    assert lines < (200 if file.suffix == ".smk" else 60)


def test_the_linter_of_snakemake_finds_nothing(sources):
    run = sources.snakemake("--lint", config=())
    assert run.returncode == 0, run.stdout + run.stderr


def test_the_formatter_would_change_nothing(sources):
    snakefmt = Path(sys.executable).with_name("snakefmt")
    run = sources.execute(str(snakefmt), "--check", "workflow/Snakefile", "workflow/rules")
    assert run.returncode == 0, run.stdout + run.stderr
