"""The documentation becomes a site without a warning: its examples run, and it loads nothing."""

import re
import subprocess
import sys
from pathlib import Path

import pandas as pd
import pytest

from thirdbody.variables import AXES, VARIABLES

DOCS = Path(__file__).parents[2] / "docs"
LOADED = re.compile(r"""<(?:script|img|link|iframe)\b[^>]*\b(?:src|href)=["'](https?:[^"']*)""")


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    pytest.importorskip("myst_nb")
    place = tmp_path_factory.mktemp("site") / "html"  # as in the Makefile
    build = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", DOCS, place]
    ended = subprocess.run(build, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    return place


def test_every_page_is_reached_from_the_first(site):
    first = (site / "index.html").read_text(encoding="utf-8")
    for page in {page.stem for page in DOCS.glob("*.md")} - {"index"}:
        assert (site / f"{page}.html").is_file() and f'href="{page}.html' in first, page


@pytest.mark.parametrize(
    ("page", "count"), [("tutorial", 5), ("questions", 1), ("recipes", 1), ("gallery", 20)]
)
def test_a_page_shows_the_figures_that_its_examples_draw(site, page, count):
    text = (site / f"{page}.html").read_text(encoding="utf-8")
    assert len(re.findall(r'<img[^>]*src="_images/', text)) == count


def test_one_point_by_hand_is_that_of_the_library(site):
    by_hand = pd.read_html(site / "model.html", match="by hand")[0]
    assert len(by_hand) == 5
    assert by_hand["by hand"].to_numpy() == pytest.approx(by_hand["library"].to_numpy(), rel=1e-7)


def test_tables_of_results_are_computed(site):
    """Printed numbers with their deviations, statements that fail, and what each departure is
    worth.
    """
    page = site / "results.html"
    (numbers,) = pd.read_html(page, match="fig10b-window-500nm")
    row = numbers.set_index("id").loc["fig10b-window-500nm"].iloc[0]
    assert row["printed"] == "0.8" and row["deviation"].startswith("−")
    deviation = 100.0 * (float(row["computed"]) / float(row["printed"]) - 1.0)
    assert -float(row["deviation"].strip("−%")) == pytest.approx(deviation, abs=0.1)
    (departures,) = pd.read_html(page, match="h_e at first yield")
    counts = departures.set_index("departure")["holds"]
    assert counts["as it is"] > counts["h_e at first yield"]
    assert (pd.read_html(page, match="found")[0]["found"].str.len() > 10).all()
    (names,) = pd.read_html(site / "model.html", match="name in files and code")
    assert len(names) == len(AXES) + 1 + len(VARIABLES)


def test_the_reference_has_all_keys_and_inputs(site):
    page = (site / "workflow.html").read_text(encoding="utf-8")
    for key in ("run", "windows.count", "load_axis.load_N", "scenes.NAME.title", "ball_radius"):
        assert f'<span class="pre">{key}</span>' in page, key


def test_formulas_need_no_script(site):
    page = (site / "model.html").read_text(encoding="utf-8")
    assert page.count("<math") > 10
    assert page.count("overflow-x: auto") == page.count('display="block"')  # on narrow screens
    assert "$" not in page.split("<body", 1)[1]


def test_nothing_is_loaded_from_elsewhere(site):
    for page in site.rglob("*.html"):
        assert LOADED.findall(page.read_text(encoding="utf-8")) == [], page.name
