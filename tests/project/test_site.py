"""The documentation becomes a site without a warning, its notebooks run, and it loads nothing."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

DOCS = Path(__file__).parents[2] / "docs"
LOADED = re.compile(r"""<(?:script|img|link|iframe)\b[^>]*\b(?:src|href)=["'](https?:[^"']*)""")


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    place = tmp_path_factory.mktemp("site") / "html"  # as in the Makefile
    build = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", DOCS, place]
    ended = subprocess.run(build, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    return place


def test_every_page_is_reached_from_the_first(site):
    first = (site / "index.html").read_text(encoding="utf-8")
    for page in {page.stem for page in DOCS.glob("*.md")} - {"index"}:
        assert (site / f"{page}.html").is_file() and f'href="{page}.html' in first, page


def test_notebooks_show_what_they_computed(site):
    paper = (site / "notebooks" / "the_paper_in_ten_minutes.html").read_text(encoding="utf-8")
    assert paper.count("<img") >= 4
    mine = (site / "notebooks" / "my_own_bearing.html").read_text(encoding="utf-8")
    assert re.search(r"mixed lubrication: from \d+ cSt", mine)
    assert "worst promised error: " in mine


def test_the_gallery_shows_a_figure_for_each_of_its_parts(site):
    page = (site / "gallery.html").read_text(encoding="utf-8")
    assert page.count("<img") == page.count("<h2>") == 4


def test_the_reference_has_all_keys_and_inputs(site):
    page = (site / "configuration.html").read_text(encoding="utf-8")
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
