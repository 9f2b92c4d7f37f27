"""The whole workflow on few loads, from sources to every product."""

import pytest

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
    *(f"tables/{table}.{kind}" for table in TABLES for kind in ("csv", "json", "md", "tex")),
    "claims/claims.csv",
    "claims/claims.md",
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
        "extracted/tpca_loads/mine.csv",
    )
    wanted = [f"results/{name}" for name in names]
    before = workspace.stamps()
    run = workspace.snakemake(*wanted, "--config", "changes=mine.yaml")
    assert run.returncode == 0, run.stderr
    after = workspace.stamps()
    assert {f"results/{name}" for name in after} >= set(wanted)
    assert {name: after[name] for name in before} == before  # the paper's products stay as they are
    assert workspace.snakemake("--dry-run").returncode == 0


def test_the_report_is_one_file_made_offline(workspace, tmp_path):
    report = tmp_path / "report.html"
    run = workspace.snakemake("--report", str(report))
    assert run.returncode == 0, run.stderr
    assert b"</html>" in report.read_bytes()
