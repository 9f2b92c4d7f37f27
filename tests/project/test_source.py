"""Tools keep the rule of imports (contracts in pyproject.toml) and the style of source and rules;
the workflow is plain Snakemake."""

import os
import re
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

import grimp
import pytest

import thirdbody

ROOT = Path(__file__).resolve().parents[2]
PUBLIC_API = Path(__file__).with_name("public_api.py")
CHECKS = {
    "packages import only from below": ["lint-imports", "--no-cache"],
    "ruff finds no fault": ["ruff", "check", "--no-cache"],
    "every file is formatted": ["ruff", "format", "--check", "--no-cache"],
    "every rule is formatted": ["snakefmt", "--check", "Snakefile", "workflow"],
    "types agree": ["mypy"],
    # without the configuration of this repository, as in one with the installed library
    "the library is typed for users": [
        *("mypy", "--strict", "--config-file=", "--cache-dir=.mypy_cache/user"),
        PUBLIC_API,
    ],
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


def test_no_module_imports_itself_through_others():
    """Imports for types alone count too."""
    graph = grimp.build_graph("thirdbody", "chenhorng", cache_dir=None)
    imports = {name: graph.find_modules_directly_imported_by(name) for name in graph.modules}
    TopologicalSorter(imports).prepare()  # raises CycleError


def test_the_users_file_has_every_public_name():
    names = set(re.findall(r"(?<=\btb\.)\w+", PUBLIC_API.read_text(encoding="utf-8")))
    assert names == {*thirdbody.__all__}


def test_snakemake_asks_for_nothing_but_environments():
    """All is in the environment of Snakemake, which reads the configuration with the same
    library."""
    snakemake = Path(sys.executable).with_name("snakemake")
    library = {"PYTHONPATH": str(ROOT / "src")}
    done = subprocess.run(
        [snakemake, "--lint"],
        cwd=ROOT,
        env=os.environ | library,
        capture_output=True,
        text=True,
    )
    titles = set(re.findall(r"^    \* (.*?):$", done.stdout + done.stderr, re.MULTILINE))
    assert titles == {"Specify a conda environment or container for each rule."}


WORKFLOW = [ROOT / "Snakefile", *sorted((ROOT / "workflow").rglob("*.*"))]
CODE = [path for path in WORKFLOW if path.suffix in ("", ".smk", ".py", ".yaml")]


@pytest.mark.parametrize("path", CODE, ids=lambda path: path.name)
def test_no_private_name_of_snakemake_is_used(path):
    text = path.read_text(encoding="utf-8")
    assert not re.search(r"\b(workflow|snakemake|rules|config|dag)\._\w", text)  # private names
    assert not re.search(r"\bworkflow(\.\w+)+\s*=[^=]", text)  # assignments to its objects
    assert not re.search(r"addHandler|sys\.argv|__use_yte__|gc\.", text)


SCRIPTS = [
    (rule, script)
    for path in sorted(ROOT.glob("workflow/rules/*.smk"))
    for rule in re.split(r"\n(?=rule |checkpoint )", path.read_text(encoding="utf-8"))
    for script in re.findall(r'"\.\./scripts/(\w+\.py)"', rule)
]


@pytest.mark.parametrize(("rule", "script"), SCRIPTS, ids=[script for _, script in SCRIPTS])
def test_a_rule_depends_on_its_own_script(rule, script):
    names = f'sources_of("{script}")', f'SOURCES.text(HOME / "workflow/scripts/{script}")'
    assert any(name in rule for name in names)


IMPORTING = [*ROOT.glob("workflow/scripts/*.py"), *ROOT.glob("src/chenhorng/**/*.py")]


@pytest.mark.parametrize("path", IMPORTING, ids=lambda path: path.name)
def test_jobs_import_modules_of_the_library_not_its_lazy_names(path):
    """A job depends on the modules that its script imports; behind ``tb.solve`` no import is
    seen."""
    text = path.read_text(encoding="utf-8")
    assert not re.search(r"^ *(import thirdbody\b(?!\.)|from thirdbody import)", text, re.MULTILINE)
