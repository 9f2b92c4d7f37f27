"""The whole workflow: every product, its sums, its pages and its report."""

import json
import re
import shutil
import subprocess
from html import unescape

from workspace import ended, start

from thirdbody.symbols import html

CURVE_FIGURES = [f"fig{number:02d}" for number in range(3, 14)]
FIGURES = ["fig01", "fig02", *CURVE_FIGURES]
FINDINGS = ["modes", "size", "viscosity", "turning_point", "turning_point_viscosity"]
TABLES = ["table1", "table2", "tpca_loads", "tpca_windows", "transitions"]
FIGURE_FORMATS, TABLE_FORMATS = ("svg", "pdf", "png", "csv", "md", "json"), ("csv", "html", "tex")
PRODUCTS = {
    *(f"datasets/{figure}.nc" for figure in CURVE_FIGURES),
    *(f"figures/{figure}.{format}" for figure in FIGURES for format in FIGURE_FORMATS),
    *(f"figures/{figure}_wide.csv" for figure in CURVE_FIGURES),
    *(f"figures/panel_{name}.{format}" for name in FINDINGS for format in FIGURE_FORMATS[:3]),
    *(f"tables/{table}.{format}" for table in TABLES for format in TABLE_FORMATS),
    *(f"claims/claims.{format}" for format in ("csv", "html", "md")),
    *("explorer/index.html", "index.html", "captions.md", "SHA256SUMS"),
}

MINE = """
scenes:
  mine:
    title: Two sizes of particles in a thick oil
    load_axis: {load_N: [0.04, 80.0], count: 12}
    curves:
      - viscosity_cSt: [0, 120]
        particle_diameter_nm: [300, 600]
        roughness_nm: [300]
        particle_density_per_m2: [1.0e+11]
"""


def test_a_run_makes_every_product(finished):
    made = {name for name in finished.stamps() if (finished.root / "results" / name).stat().st_size}
    assert made >= PRODUCTS


def sums_of(workspace):
    """Exit code and output of the check of all sums."""
    command = ["sha256sum", "--quiet", "--check", "SHA256SUMS"]
    results = workspace.root / "results"
    done = subprocess.run(command, cwd=results, capture_output=True, text=True)
    return done.returncode, done.stdout


def test_an_edited_product_is_refused_until_it_is_made_again(workspace):
    assert sums_of(workspace) == (0, "")
    workspace.rewrite("results/tables/table2.tex", lambda text: text.replace("1", "2", 1))
    refused = workspace.snakemake()
    assert refused.returncode == 1
    assert "table2.tex is not as its job made it" in refused.stdout + refused.stderr
    made_again = "--force", "results/tables/table2.tex", "results/SHA256SUMS"
    code, said = ended(start(workspace, *made_again))
    assert code == 0, said
    last = said.splitlines()[-1]  # of both streams, as on a terminal
    assert "statements hold; open results/index.html in a browser" in last and len(last) <= 100
    assert sums_of(workspace) == (0, "")
    (workspace.root / "results/figures/fig08.csv").write_text("damaged")
    assert sums_of(workspace) == (1, "figures/fig08.csv: FAILED\n")


def test_deleted_logs_harm_no_run(workspace):
    shutil.rmtree(workspace.root / "logs")
    (workspace.root / "results/tables/table1.tex").unlink()
    run = workspace.snakemake()
    assert run.returncode == 0, run.stdout + run.stderr
    assert sums_of(workspace) == (0, "")


def test_products_without_their_record_are_refused(workspace):
    shutil.rmtree(workspace.root / ".snakemake")
    asked = workspace.snakemake("--dry-run")
    assert asked.returncode == 1
    assert "results has products without .snakemake" in asked.stderr


def test_a_scene_of_ones_own_has_all_that_a_figure_of_the_paper_has(workspace):
    (workspace.root / "mine.yaml").write_text(MINE)
    names = ["datasets/mine.nc", "figures/mine.png", "bands/mine.nc", "tables/mine_transitions.csv"]
    names += [f"tables/mine_tpca_loads.{format}" for format in TABLE_FORMATS]
    wanted = [f"results/{name}" for name in names]
    before = workspace.stamps()
    run = workspace.snakemake(*wanted, "--config", "changes=mine.yaml")
    assert run.returncode == 0, run.stderr
    after = workspace.stamps()
    assert {f"results/{name}" for name in after} >= set(wanted)
    assert {name: after[name] for name in before} == before  # the paper's products stay as they are
    page = (workspace.root / "results/tables/mine_tpca_loads.html").read_text(encoding="utf-8")
    assert "<sub>TPCA</sub>" in page
    assert workspace.snakemake("--dry-run").returncode == 0


def test_the_report_shows_every_figure_and_table(finished, tmp_path, monkeypatch):
    monkeypatch.setenv("https_proxy", "http://localhost:9")  # where no server answers
    place = tmp_path / "report.html"
    run = finished.snakemake("--report", str(place))
    assert run.returncode == 0, run.stderr
    page = place.read_text(encoding="utf-8")
    for name in finished.products("figures/*.png", "tables/*.html"):
        assert f"results/{name}" in page


def plain(page):
    """The text of a page, without tags."""
    return " ".join(unescape(re.sub("<[^>]*>", " ", page)).split())


def test_the_index_leads_to_all_products_and_says_what_fails(finished):
    page = (finished.root / "results/index.html").read_text(encoding="utf-8")
    addresses = re.findall(r'(?:href|src)="([^"]*)"', page)
    local = {link for link in addresses if not link.startswith(("http", "#", "data:"))}
    local = {link.partition("#")[0] for link in local}  # also a row, or a filter
    assert all((finished.root / "results" / link).is_file() for link in local)
    shown = {
        name
        for name in PRODUCTS
        if not name.startswith(("index", "SHA256SUMS")) and not name.endswith(".json")
    }
    assert shown <= local
    claims = json.loads((finished.root / "results/claims/claims.json").read_text())
    text = plain(page)
    captions = (finished.root / "results/captions.md").read_text(encoding="utf-8")
    for statement in claims["statements"]:
        if statement["verdict"] == "fails" and statement["place"].startswith("Figure"):
            assert plain(html(statement["statement"])) in text
            assert statement["statement"] in captions.replace("\\", "")  # without escapes
