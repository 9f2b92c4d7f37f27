"""What the explorer's page is built from: content out of products, one file out of several."""

import hashlib
import json
import re
from pathlib import Path
from types import SimpleNamespace

import pytest

from thirdbody.paper.claims.claims import load_claims
from thirdbody.paper.page import page as building
from thirdbody.paper.page.page import figure_content, page_text, plain_text
from thirdbody.plain_yaml import config_directory

HERE = Path(building.__file__).parent
CURVE = "nu = 90 cSt; x_a = 300 nm; sigma = 300 nm; eta_a = 1e+11 m-2"
DRAWN = f"""panel,curve,x_name,x,y_name,y
A,{CURVE},load,1e-6,separation,4e-7
A,{CURVE},load,1e-5,separation,3e-7
A,printed; fig99-value,load,1e-5,separation,3.123456e-7
A,tolerance; fig99-value,load,1e-5,separation,2e-7
A,tolerance; fig99-value,load,1e-5,separation,4e-7
A,printed at every load; fig99-level,load,1e-6,separation,3e-7
A,printed at every load; fig99-level,load,1e-5,separation,3e-7
A,tolerance; fig99-level,load,1e-6,separation,2e-7
A,tolerance; fig99-level,load,1e-6,separation,4e-7
A,printed at every load; fig99-level,load,1e-6,separation,6e-7
A,printed at every load; fig99-level,load,1e-5,separation,6e-7
A,tolerance; fig99-level,load,1e-6,separation,5e-7
A,tolerance; fig99-level,load,1e-6,separation,7e-7
A,turning points,load,1e-5,separation,3e-7
A,printed along x; fig99-limit,load,2e-6,separation,
A,tolerance; fig99-limit,load,1e-6,separation,
A,tolerance; fig99-limit,load,3e-6,separation,
"""
CAPTION = SimpleNamespace(title="Figure 99. A title", text="What it tells.")


@pytest.fixture
def figure(tmp_path):
    """The content of a small figure."""
    (tmp_path / "fig99.csv").write_text(DRAWN, encoding="utf-8")
    return figure_content(tmp_path / "fig99.csv", CAPTION, least=0.0)


def test_a_figure_has_its_conditions_marks_and_caption(figure):
    assert (figure["name"], figure["title"]) == ("fig99", "Figure 99. A title")
    assert figure["caption"] == "What it tells."
    (condition,) = figure["curves"]
    assert condition == {
        "viscosity": 9e-5, "particle_diameter": 3e-7, "roughness": 3e-7, "particle_density": 1e11,
    }  # fmt: skip
    (panel,) = figure["panels"]
    assert panel["curves"] == [0] and panel["turning_points"] and not panel["locus"]
    (mark,) = panel["printed"]
    assert mark == {
        "id": "fig99-value",
        "at": [1e-5, 3.1235e-7],
        "ends": [[1e-5, 2e-7], [1e-5, 4e-7]],
    }
    (limit,) = panel["limits"]
    assert limit["at"] == [2e-6, None] and limit["ends"] == [[1e-6, None], [3e-6, None]]
    first, second = panel["levels"]
    assert first["id"] == "fig99-level" and first["at"][1] == 3e-7
    assert second["at"][1] == 6e-7 and [y for _, y in second["ends"]] == [5e-7, 7e-7]


def test_quotes_are_read_without_latex():
    quote = r"For $\sigma = 500 nm$, $A_{sa,t}^*$ is 0 (at $F_{TPCA}^* = 3.27 \times 10^{-6}$)."
    assert plain_text(quote) == "For σ = 500 nm, A_sa,t* is 0 (at F_TPCA* = 3.27×10⁻⁶)."
    quotes = [plain_text(claim.quote) for claim in load_claims(config_directory() / "claims.yaml")]
    assert [quote for quote in quotes if re.search(r"[\\${}^]|</", quote)] == []


@pytest.mark.parametrize("title", ["</script><b>", "a <!--<script> b"])
def test_content_cannot_end_or_continue_its_script(title):
    text = page_text({"figures": [title]})
    given = re.search(r'id="content">(.*?)</script>', text, re.DOTALL)[1]
    assert json.loads(given) == {"figures": [title]} and "<" not in given


def test_content_without_a_number_is_no_page():
    with pytest.raises(ValueError, match="not JSON compliant"):
        page_text({"value": float("nan")})


def test_the_charting_library_is_the_one_that_is_named():
    notice = (HERE / "vendor" / "README.md").read_text(encoding="utf-8")
    library = (HERE / "vendor" / "d3.min.js").read_bytes()
    assert hashlib.sha256(library).hexdigest() in notice
    version = re.search(rb"d3js\.org v([\d.]+)", library)[1].decode()
    makefile = (HERE.parents[3] / "Makefile").read_text(encoding="utf-8")
    assert f"version {version}" in notice and f"D3 := {version}\n" in makefile
    assert f"D3 {version}" in (HERE / "page" / "index.html").read_text(encoding="utf-8")
