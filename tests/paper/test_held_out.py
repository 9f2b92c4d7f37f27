"""Statements of other papers: each has its source, and no search for inputs sees them."""

import re
from pathlib import Path

import numpy as np
import pytest

from chenhorng.calibration.calibration import Objective
from chenhorng.claims.claims import load_claims
from chenhorng.sources import Sources
from thirdbody.files import read_yaml
from thirdbody.variables import CONDITION_AXES

ROOT = Path(__file__).parents[2]
HELD_OUT = load_claims(ROOT / "config/held_out.yaml")
FITTED = load_claims(ROOT / "config/claims.yaml")
SETTINGS = read_yaml(ROOT / "config/calibration.yaml")
# Table 2, as far as a statement can be at its conditions
TABLE_2 = {
    "viscosity_cSt": (0, 150),
    "particle_diameter_nm": (0, 1000),
    "roughness_nm": (100, 500),
    "particle_density_per_m2": (1e10, 5e12),
}
SEARCHING = ("calibrate.smk", "common.smk")


def content(claim):
    """What a statement says, whatever its id is."""
    return claim.kind, claim.quantity, claim.direction, claim.conditions, claim.reference


def seen(objective):
    """Held-out statements that an objective has, under their own id or another."""
    ids = {claim.id for claim in objective.claims}
    contents = [content(claim) for claim in objective.claims]
    return [each.id for each in HELD_OUT if each.id in ids or content(each) in contents]


def files_of_searches():
    """The rules of the calibration, their scripts, and the modules that these import."""
    rules = ROOT / "workflow/rules"
    scripts = re.findall(r"scripts/(\w+\.py)", (rules / "calibrate.smk").read_text())
    sources = Sources(ROOT / "src", ROOT, "thirdbody", "chenhorng")
    named = {
        text.partition(" ")[0]
        for script in scripts
        for text in sources.of_script(ROOT / "workflow/scripts" / script)
    }
    settings = ["config/calibration.yaml", "config/config.yaml", "config/claims.yaml"]
    return [*(rules / name for name in SEARCHING), *(ROOT / name for name in (*named, *settings))]


def test_the_objective_of_a_search_has_none_of_them(parameters):
    inputs = parameters.as_dict()
    assert seen(Objective.of(FITTED, SETTINGS, inputs)) == []
    added = Objective.of((*FITTED, HELD_OUT[0]), SETTINGS, inputs)
    assert seen(added) == [HELD_OUT[0].id]


def test_no_search_and_no_setting_of_one_names_the_file_or_a_statement():
    files = files_of_searches()
    assert ROOT / "src/chenhorng/calibration/search.py" in files
    assert ROOT / "workflow/scripts/choose_default.py" in files
    words = re.compile("|".join(["held_out", *(claim.id for claim in HELD_OUT)]))
    assert [path for path in files if words.search(path.read_text(encoding="utf-8"))] == []
    # they are judged elsewhere, so the words are those to look for
    assert words.search((ROOT / "workflow/rules/draw.smk").read_text(encoding="utf-8"))


@pytest.mark.parametrize("claim", HELD_OUT, ids=lambda claim: claim.id)
def test_each_has_a_source_and_is_at_conditions_of_table_2(claim):
    assert re.fullmatch(r".+ \(\d{4}\), abstract, doi:10\.\d{4,}/\S+", claim.place)
    assert "1390335" not in claim.place and claim.quote and claim.statement
    for axis in CONDITION_AXES:
        low, high = TABLE_2[axis.alias]
        for curve in (claim.conditions, claim.reference):
            values = np.atleast_1d(curve.get(axis.alias, low))
            assert (low <= values).all() and (values <= high).all()
    assert claim.limits.get("load_max_N", 80.0) <= 80.0


def test_what_is_said_to_be_new_has_no_figure_and_the_rest_names_those_of_the_paper():
    figures = {figure for claim in FITTED for figure in claim.all_figures}
    assert all(set(claim.figures) <= figures for claim in HELD_OUT)
    assert any(claim.figures for claim in HELD_OUT) and any(not c.figures for c in HELD_OUT)


def test_a_number_that_no_abstract_prints_stands_for_words_of_it():
    named = [claim for claim in HELD_OUT if np.asarray(claim.published).dtype.kind == "f"]
    assert named
    for claim in named:
        printed = all(f"{value:g}" in claim.quote for value in np.atleast_1d(claim.published))
        assert printed or (claim.stands_for and claim.stands_for in claim.quote)
