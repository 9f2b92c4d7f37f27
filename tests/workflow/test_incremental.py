"""A change is followed by what depends on it, and by nothing else."""

import csv
import os
import re
import time
from dataclasses import replace

import pytest
from workspace import ROOT

from thirdbody.files import read_yaml

DEFAULT = read_yaml(ROOT / "config/config.yaml")["calibrated"]
FIGURE = ("datasets/{0}.nc", "bands/{0}.nc", "extracted/*/{0}.csv", "figures/{0}[._]*")
FIGURES = ("figures/fig0[3-9]*", "figures/fig1?*", "figures/panel_*")
EXTRACTED = ("extracted/tpca_loads/*", "extracted/transitions/*")
ALL_CURVES = ("datasets/*", "bands/*", *EXTRACTED, *FIGURES)
GATHERED = ("tables/tpca_loads.*", "tables/transitions.*")
WINDOWS = ("extracted/tpca_windows/*", "tables/tpca_windows.*")
SHOWING_WINDOWS = ("figures/fig09*", "figures/fig10*")
# what stands beside the paper's numbers
PRINTED = (
    "extracted/printed/*",
    "extracted/verdicts/*",
    *FIGURES,
    "tables/tpca_*",
    "tables/transitions.*",
)
PAPER_TABLES = ("extracted/table[12]/*", "tables/table[12].*")
SCHEMATICS = ("figures/fig0[12].*",)
SENSITIVITY = ("extracted/sensitivity/*", "tables/sensitivity.*", "figures/sensitivity.*")
CLAIMS = ("claims/claims.*", "figures/claims.*")
HELD_OUT = ("claims/held_out.csv", "tables/held_out.*")
# what carries the agreement, and by how much printed numbers are missed
DEPARTURES = ("extracted/departures/*", "tables/departures.*")
DEPARTURES += ("extracted/deviations/*", "tables/deviations.*")
COVERAGE = ("extracted/coverage/*", "tables/coverage.*")
SETS = ("extracted/coverage_of_sets/*", "tables/coverage_of_sets.*")
JUDGED = (*CLAIMS, *DEPARTURES, *COVERAGE)
DIGITS = ("extracted/apparent_area/*", "extracted/limits/*")
DIGITS += ("tables/apparent_area.*", "tables/limits.*")
TABLES_SHOWN = ("index.html", "captions.md", "SHA256SUMS")
PAGE = ("explorer/*", *TABLES_SHOWN)
ALL = (*ALL_CURVES, *GATHERED, *WINDOWS, *PAPER_TABLES, *SCHEMATICS, *JUDGED, *SENSITIVITY, *PAGE)
ALL += ("extracted/verdicts/*",)
PROFILES = ("tables/profiles.*", "figures/profiles.*")
ALL += DIGITS + HELD_OUT + SETS + PROFILES
FORMATS = ("csv", "html", "tex")


def of_figure(name):
    return tuple(pattern.format(name) for pattern in FIGURE)


def remade(workspace):
    """Products that a real run writes again."""
    before = workspace.stamps()
    run = workspace.snakemake()
    assert run.returncode == 0, run.stdout + run.stderr
    return {name for name, stamp in workspace.stamps().items() if before.get(name) != stamp}


def dry_run_after(workspace, file, change):
    """What the next run would do after a ``change`` of a ``file``."""
    workspace.rewrite(file, change)
    asked = workspace.snakemake("--dry-run", "--quiet", "host")  # with counts and reasons
    assert asked.returncode == 0, asked.stdout + asked.stderr
    return asked.stdout


def jobs_in(said):
    """Rules of the jobs in a dry run, with how many there are of each."""
    counted = said.partition("Job stats:\n")[2].partition("\n\n")[0].splitlines()[2:]
    return {name: int(count) for name, count in map(str.split, counted) if name != "total"}


def commented(text):
    return f"{text}\n# changed\n"


PUBLISHED = {"write_index": 1, "write_sums": 1, "all": 1}


def test_another_definition_of_a_turning_point_extracts_solves_nothing_and_is_named(workspace):
    file = "src/thirdbody/core/turning_points.py"
    said = dry_run_after(workspace, file, commented)
    jobs = jobs_in(said)
    assert jobs["extract_curves"] == 11
    assert jobs["find_windows"] == 1
    assert not jobs.keys() & {"solve_scene", "solve_ensemble", "draw_schematic"}
    changes = re.findall(r"Params have changed since last execution: (.+)", said)
    assert changes and {*re.findall(r"'(\S+) \w{8}'", "".join(changes))} == {file}


def test_another_style_of_one_figure_draws_that_figure(workspace):
    jobs = jobs_in(dry_run_after(workspace, "src/chenhorng/figures/sensitivity.py", commented))
    assert jobs == {"render_sensitivity": 1} | PUBLISHED


def test_another_template_of_verdicts_judges_again_and_draws_no_figure(workspace):
    jobs = jobs_in(dry_run_after(workspace, "src/chenhorng/claims/claims.html.j2", commented))
    judged = {"judge_claims": 1, "render_claims": 1, "write_table": 1, "build_explorer": 1}
    assert jobs == judged | PUBLISHED


def test_another_scene_remakes_its_figure_and_the_tables_that_gather_it(workspace):
    workspace.put("config/scenes.yaml", "scenes/fig08/curves/0/viscosity_cSt", [0, 80])
    assert workspace.pending() == workspace.products(*of_figure("fig08"), *GATHERED, *PAGE)


def test_another_style_draws_again_and_solves_nothing(workspace):
    workspace.rewrite("src/thirdbody/plotting/paper.mplstyle", commented)
    assert workspace.pending() == workspace.products("figures/*", *PAGE)


def test_another_formula_of_the_paper_tables_remakes_these_tables(workspace):
    workspace.rewrite("src/chenhorng/claims/paper_tables.py", commented)
    assert remade(workspace) == workspace.products(*PAPER_TABLES, *DIGITS, *TABLES_SHOWN)
    assert not workspace.pending()


def test_another_layout_of_tables_writes_them_and_solves_nothing(workspace):
    workspace.rewrite("src/chenhorng/tables.py", commented)
    pending = workspace.pending()
    assert pending >= workspace.products("tables/*", *PAGE)
    assert pending.isdisjoint(workspace.products("datasets/*", "bands/*"))


CONFIG, FIRST = "config/config.yaml", ("figures/fig01.*", *TABLES_SHOWN)
SHOWN_WINDOWS = (*WINDOWS, *SHOWING_WINDOWS, *PAGE)
STATEMENT = ("config/claims.yaml", "0/statement", "Particles matter.")


@pytest.mark.parametrize(
    ("file", "key", "value", "patterns"),
    [
        (CONFIG, "rtol", 1e-8, (*ALL_CURVES, *GATHERED, *PAGE)),
        (CONFIG, "windows/roughness_nm", [100, 300], SHOWN_WINDOWS),
        (*STATEMENT, (*JUDGED, *PRINTED, *PAGE)),
        ("config/held_out.yaml", "0/statement", "Particles matter.", (*HELD_OUT, *TABLES_SHOWN)),
        (CONFIG, "schematics/fig01/0/load_N", 21.0, FIRST),
        (DEFAULT, "inputs/truncation", 1.8, ALL),
    ],
    ids=["rtol", "windows", "a statement", "a held-out statement", "a drawing", "calibrated"],
)
def test_another_setting_reruns_what_it_enters(workspace, file, key, value, patterns):
    workspace.put(file, key, value)
    assert workspace.pending() == workspace.products(*patterns)


def test_comments_in_the_configuration_and_dates_of_files_rerun_nothing(workspace):
    later = time.time() + 3 * 3600
    for folder in ("config", "src", "workflow"):
        for path in (workspace.root / folder).rglob("*.*"):
            os.utime(path, (later, later))
    for file in (
        "config",
        "scenes",
        "claims",
        "inputs",
        "calibration",
        "paper_tables",
        "printed_digits",
        "held_out",
        "findings",
    ):
        workspace.rewrite(f"config/{file}.yaml", lambda text: f"# a remark\n{text}")
    assert not workspace.pending()


def test_a_profile_of_the_user_that_looks_at_dates_alone_keeps_nothing_old(
    workspace, tmp_path, monkeypatch
):
    (tmp_path / "config.yaml").write_text("rerun-triggers: [mtime]\n")
    monkeypatch.setenv("SNAKEMAKE_PROFILE", str(tmp_path))
    workspace.put("config/scenes.yaml", "scenes/fig05/title", "Another title")
    assert workspace.pending() >= workspace.products(*of_figure("fig05"))


def test_the_library_of_another_checkout_is_refused(workspace):
    run = replace(workspace, imported=(ROOT / "src", ROOT)).snakemake("--dry-run")
    assert run.returncode != 0
    assert f"the library is {ROOT / 'src/thirdbody'}; allowed: that of this checkout" in run.stderr


def test_a_dry_run_says_what_would_run_and_claims_nothing(sources):
    asked = sources.snakemake("--dry-run")
    assert asked.returncode == 0, asked.stderr
    jobs = re.findall(r"^Job \d+: (.+)$", asked.stdout, re.MULTILINE)
    assert len(jobs) > 60 and jobs[-1] == "All products of the paper"
    assert "Reason: " not in asked.stdout


def test_what_is_missing_is_made_again_with_what_is_made_from_it(workspace):
    expected = workspace.products(*of_figure("fig05"), *GATHERED, "figures/fig07[._]*", *PAGE)
    for name in ("datasets/fig05.nc", "figures/fig07.svg", "tables/table2.tex"):
        (workspace.root / "results" / name).unlink()
    assert workspace.pending() == expected | {f"tables/table2.{format}" for format in FORMATS}


def test_statements_of_ones_own_are_judged_apart_from_those_of_the_paper(workspace):
    own = """
- id: rig
  place: our test rig
  statement: At this load the solids carry three quarters of it.
  quote: our notebook
  kind: value
  quantity: solid_load_fraction
  conditions: {viscosity_cSt: 90, particle_diameter_nm: 500, roughness_nm: 300,
    particle_density_per_m2: 1.0e+11, load: 1.62e-5}
  published: 0.75
  tolerance: {absolute: 0.05, reason: scatter of the measurements}
"""
    (workspace.root / "config/mine.yaml").write_text(own)
    before = workspace.stamps()
    run = workspace.snakemake("results/claims/mine.csv")
    assert run.returncode == 0, run.stderr
    (row,) = csv.DictReader((workspace.root / "results/claims/mine.csv").open())
    assert row["verdict"] == "holds" and abs(float(row["value"]) - 0.7991) < 1e-3
    assert {name: workspace.stamps()[name] for name in before} == before
    workspace.rewrite("config/mine.yaml", lambda text: text.replace("load:", "load_N:"))
    refused = workspace.snakemake("results/claims/mine.csv")
    assert refused.returncode != 0
    assert "config/mine.yaml: 'rig': conditions: 'load_N' is no condition; " in refused.stderr
