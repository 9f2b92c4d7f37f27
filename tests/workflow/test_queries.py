"""Whoever only asks changes nothing, waits for nobody and hears the truth about damaged products."""

import re
import sys

import pytest

from thirdbody.run.lock import Hold

DAMAGED = "results/extracted/table1/all.csv"  # between a configuration and a table
FOLLOWER = "results/tables/table1.md"
UNHARMED = "results/tables/table2.md"
RULE, FOLLOWING_RULE = "recompute_paper_table", "write_table"
BROKEN = "src/thirdbody/run/__pycache__/closure.*.pyc"


def contents(workspace):
    """Name, time of change and bytes of all in the folder but what Snakemake notes for itself."""
    found = {}
    for path in workspace.root.rglob("*"):
        name = path.relative_to(workspace.root)
        if name.parts[0] != ".snakemake":
            inside = path.read_bytes() if path.is_file() else None
            found[str(name)] = path.stat().st_mtime_ns, inside
    return found


@pytest.fixture(autouse=True)
def bytecode_is_written(monkeypatch):
    """By whoever does not take care."""
    monkeypatch.delenv("PYTHONDONTWRITEBYTECODE", raising=False)


@pytest.fixture(scope="module")
def harmed(finished, tmp_path_factory):
    """A finished run of which a product and a module's bytecode are damaged, while a run is on."""
    workspace = finished.copied_to(tmp_path_factory.mktemp("asked") / "thirdbody")
    (workspace.root / DAMAGED).write_text("harmed")
    workspace.execute(sys.executable, "-m", "compileall", "-q", "src")
    (bytecode,) = workspace.root.glob(BROKEN)
    bytecode.write_bytes(bytecode.read_bytes()[:100])
    with Hold(workspace.root / ".snakemake/thirdbody.lock"):
        yield workspace


@pytest.fixture
def ask(harmed):
    """Function that asks Snakemake; what it says."""

    def ask(*query):
        before = contents(harmed)
        asked = harmed.snakemake(*query)
        assert asked.returncode == 0, asked.stdout + asked.stderr
        assert contents(harmed) == before
        return asked

    return ask


def assert_named(asked):
    line = f"{DAMAGED} is not as it was made: to be made again"
    assert [each for each in asked.stderr.splitlines() if "as it was made" in each] == [line]


def test_dry_run(ask):
    asked = ask("--dry-run")
    assert_named(asked)
    jobs = dict(re.findall(r"Job \d+: (.*)\nReason: (.*)\n", asked.stdout))
    assert jobs.pop("Recomputing table1 of the paper") == "Forced execution"
    assert jobs.pop("Writing table table1") == f"Input files updated by another job: {DAMAGED}"
    assert not [job for job in jobs if "table2" in job or "fig03" in job]


def test_dry_run_of_what_the_damage_does_not_reach(ask):
    asked = ask("--dry-run", UNHARMED)
    assert_named(asked)
    assert "Nothing to be done" in asked.stdout + asked.stderr


@pytest.mark.parametrize("query", ["--summary", "--detailed-summary"])
def test_summaries(ask, query):
    asked = ask(query)
    assert_named(asked)
    rows = (line.split("\t") for line in asked.stdout.splitlines())
    told = {name: (status, plan) for name, *_, status, plan in rows}
    assert told[DAMAGED] == ("missing", "update pending")
    assert told[FOLLOWER] == ("ok", "update pending")
    assert told[UNHARMED] == ("ok", "no update")


def test_graph_of_jobs(ask):
    """Snakemake draws a job dashed that is not to be run."""
    asked = ask("--dag")
    assert_named(asked)
    drawn = re.findall(r'label = "(\w+)\b.*style="([\w,]+)"', asked.stdout)
    pending = {rule for rule, style in drawn if "dashed" not in style}
    assert {RULE, FOLLOWING_RULE} <= pending
    assert not pending & {"solve_scene", "judge_claims", "render_figure"}


@pytest.mark.parametrize("query", ["--rulegraph", "--filegraph", "--list-untracked"])
def test_what_shows_no_plan_names_the_damaged_product(ask, query):
    assert_named(ask(query))


def test_report(ask, tmp_path):
    assert_named(ask("--report", str(tmp_path / "report.html")))
    assert (tmp_path / "report.html").exists()


@pytest.mark.parametrize("query", ["--list-rules", "--lint"])
def test_what_knows_of_no_products(ask, query):
    ask(query)


def test_a_fresh_clone_stays_fresh(sources, tmp_path):
    workspace = sources.copied_to(tmp_path / "thirdbody")
    before = contents(workspace)
    assert workspace.snakemake("--dry-run").returncode == 0
    assert contents(workspace) == before


def test_a_run_that_finds_another_changes_nothing(harmed):
    before = contents(harmed)
    run = harmed.snakemake()
    assert run.returncode == 1
    assert run.stderr.splitlines()[-1].startswith("another run is under way in this folder")
    assert contents(harmed) == before


def test_a_run_makes_what_the_queries_said(harmed, recorded, tmp_path):
    workspace = harmed.copied_to(tmp_path / "thirdbody")
    pending = workspace.pending()
    before = workspace.stamps()
    run = workspace.snakemake()
    assert run.returncode == 0, run.stdout + run.stderr
    assert_named(run)
    after = workspace.stamps()
    made = {name for name in after if before[name] != after[name]}
    assert {name for name in made if not name.startswith(".custody/")} == pending
    assert not workspace.pending()
