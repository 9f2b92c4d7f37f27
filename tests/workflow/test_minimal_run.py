"""The whole workflow on few loads, from sources to every product."""

import json
import re
from pathlib import Path

import pytest

from thirdbody.run.report import PARTS

CURVE_FIGURES = [f"fig{number:02d}" for number in range(3, 14)]
FIGURES = ["fig01", "fig02", *CURVE_FIGURES]
TABLES = ["table1", "table2", "tpca_loads", "tpca_windows", "transitions"]
PRODUCTS = {
    *(f"datasets/{figure}.nc" for figure in CURVE_FIGURES),
    *(
        f"figures/{figure}.{kind}"
        for figure in FIGURES
        for kind in ("svg", "pdf", "png", "csv", "md")
    ),
    *(
        f"tables/{table}.{kind}"
        for table in TABLES
        for kind in ("csv", "html", "json", "md", "tex")
    ),
    "claims/claims.csv",
    "claims/claims.html",
    "claims/claims.md",
    "explorer/index.html",
    "accuracy/solver_cost.csv",
}

MINE = """
scenes:
  mine:
    title: Two sizes of particles in a thick oil
    curves:
      - viscosity_cSt: [0, 120]
        particle_diameter_nm: [300, 600]
        roughness_nm: [300]
        particle_density_per_m2: [1.0e+11]
"""


def test_a_minimal_run_makes_every_product(finished):
    made = {name for name in finished.stamps() if (finished.root / "results" / name).stat().st_size}
    assert made >= PRODUCTS


def test_nothing_unfinished_is_left_behind(finished):
    assert not [name for name in finished.stamps() if ".partial" in name]


def test_every_job_leaves_a_log_and_a_benchmark(finished, recorded):
    logs = {name for row in recorded for name in row["log-file(s)"].split(",")}
    benchmarks = {log.replace(".log", ".tsv") for log in logs}
    assert all((finished.root / name).is_file() for name in logs | benchmarks)


def test_nothing_is_left_to_do_after_a_run(finished):
    run = finished.snakemake("--dry-run")
    assert run.returncode == 0
    assert "Nothing to be done" in run.stdout + run.stderr


@pytest.mark.parametrize("module", ["thirdbody", "thirdbody.model.film"])
def test_a_copy_of_the_repository_runs_its_own_library(finished, module):
    told = finished.python(f"import {module}; print({module}.__file__)")
    assert told.stdout.startswith(str(finished.root / "src"))


def test_a_scene_of_ones_own_has_all_that_a_figure_of_the_paper_has(workspace):
    (workspace.root / "mine.yaml").write_text(MINE)
    names = (
        "datasets/mine.nc",
        "figures/mine.png",
        "bands/mine.nc",
        *(f"tables/mine_tpca_loads.{kind}" for kind in ("csv", "html", "json", "md", "tex")),
        "tables/mine_transitions.csv",
    )
    wanted = [f"results/{name}" for name in names]
    before = workspace.stamps()
    run = workspace.snakemake(*wanted, "--config", "changes=mine.yaml")
    assert run.returncode == 0, run.stderr
    after = workspace.stamps()
    assert {f"results/{name}" for name in after} >= set(wanted)
    assert {name: after[name] for name in before} == before  # the paper's products stay as they are
    assert "F_TPCA" in (workspace.root / "results/tables/mine_tpca_loads.md").read_text()
    assert workspace.snakemake("--dry-run").returncode == 0


def in_report(page, variable):
    """The value of a variable of the report's own program."""
    start = re.search(rf"<script id=\"{variable}\">\s*var {variable} = ", page).end()
    return json.JSONDecoder().raw_decode(page, start)[0]


@pytest.fixture(scope="module")
def report(finished, tmp_path_factory):
    """What the report of a finished run shows, made where no server answers."""
    place = tmp_path_factory.mktemp("report") / "report.html"
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("https_proxy", "http://localhost:9")
        run = finished.snakemake("--report", str(place))
    assert run.returncode == 0, run.stderr
    assert "Warning" not in run.stderr
    page = place.read_text(encoding="utf-8")
    return {name: in_report(page, name) for name in ("results", "categories")}


def test_the_report_shows_every_figure_and_table_with_its_caption(finished, report):
    shown = {name.removeprefix("results/"): entry for name, entry in report["results"].items()}
    wanted = finished.products("*/*.png", "*/*.html")
    assert set(shown) == wanted >= {name for name in PRODUCTS if name.endswith((".png", ".html"))}
    for name, entry in shown.items():
        assert entry["data_uri"].startswith(f"data:{entry['mime_type']}")
        title = entry["labels"]["title"].replace("\N{FIGURE SPACE}", "")
        assert entry["caption"].startswith(
            "<p>Every statement" if "claims.html" in name else f"<p><strong>{title}.</strong>"
        )


def test_the_report_has_the_parts_of_the_paper(report):
    parts = {
        part: {Path(name).stem for some in groups.values() for name in some}
        for part, groups in report["categories"].items()
    }
    on_demand = "6 Solver", "7 Atlas"
    assert parts == {part: set(names) for part, names in PARTS.items() if part not in on_demand}
