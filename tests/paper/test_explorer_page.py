"""What the explorer's page is built from: content out of products, one file out of several."""

import hashlib
import json
import re
from pathlib import Path

import pytest

from chenhorng.claims.claims import load_claims
from chenhorng.home import config_directory
from chenhorng.page import build as building
from chenhorng.page.build import figure_content, page_text, plain_text

HERE = Path(building.__file__).parent
SOME, OTHER = {"viscosity": 9e-5, "roughness": 3e-7}, {"viscosity": 0.0, "roughness": 3e-7}


def test_a_curve_of_several_panels_is_in_the_page_once():
    panels = [
        {"letter": "A", "curves": [SOME], "hairlines": [], "ranged": [SOME]},
        {"letter": "B", "curves": [OTHER, SOME], "hairlines": [OTHER], "ranged": [SOME]},
    ]
    record = {"place": "Figure 99", "heading": "Figure 99. A title", "message": "What it tells."}
    figure = figure_content("fig99", record | {"panels": panels})
    assert (figure["name"], figure["part"]) == ("fig99", "Figure 99")
    assert figure["curves"] == [SOME, OTHER]
    assert [panel["curves"] for panel in figure["panels"]] == [[0], [1, 0]]
    assert [panel["hairlines"] for panel in figure["panels"]] == [[], [1]]
    assert [panel["ranged"] for panel in figure["panels"]] == [[0], [0]]


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
    makefile = (HERE.parents[2] / "Makefile").read_text(encoding="utf-8")
    assert f"version {version}" in notice and f"D3 := {version}\n" in makefile
    assert f"D3 {version}" in (HERE / "web" / "index.html").read_text(encoding="utf-8")
