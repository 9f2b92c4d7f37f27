"""The table of variables agrees with the solver and with the page that explains the symbols."""

import re
from pathlib import Path

import pytest

from thirdbody.data.conditions import AXES
from thirdbody.data.quantities import CONTRACT, FLAGS, NORMAL_LOAD, QUANTITIES, VARIABLES
from thirdbody.model.regimes import STATUS_MEANINGS, WITHOUT_VALUES
from thirdbody.solver import solution

PAGE = (Path(__file__).parents[2] / "docs" / "nomenclature.md").read_text(encoding="utf-8")
GREEK = {"nu": "ν", "sigma": "σ", "eta_a": "η_a"}
# | symbol | `name` ... | unit | equation |
ROW = re.compile(r"^\| (\S+) \| `(\w+)`[^|]*\| ([^|]+) \| ([^|]*)\|$", re.MULTILINE)
EXPLAINED = {
    name: (symbol, unit.strip(), eq.strip()) for symbol, name, unit, eq in ROW.findall(PAGE)
}


def test_every_variable_of_a_solution_is_described_and_no_other():
    assert VARIABLES.keys() == set(solution.VARIABLES) - {"separation_count"}
    assert FLAGS.keys() == set(solution.FLAGS)
    assert list(QUANTITIES) == list(solution.QUANTITIES)
    assert set(VARIABLES) - set(CONTRACT) == {"error_bound"}


def test_each_stands_under_its_own_name_and_only_flags_have_meanings():
    for name, quantity in VARIABLES.items():
        assert quantity.name == name
        assert bool(quantity.meanings) == (name in FLAGS)


@pytest.mark.parametrize("quantity", [NORMAL_LOAD, *QUANTITIES.values()], ids=lambda q: q.name)
def test_the_page_explains_every_variable_alike(quantity):
    assert EXPLAINED[quantity.name] == (quantity.symbol, quantity.units, quantity.equation)


@pytest.mark.parametrize("axis", [axis for axis in AXES.values() if axis.name != "load"])
def test_the_page_explains_every_condition_alike(axis):
    assert EXPLAINED[axis.name][:2] == (GREEK.get(axis.symbol, axis.symbol), axis.units)


def test_the_page_explains_every_flag():
    for flag in FLAGS.values():
        assert f"`{flag.name}`" in PAGE


def test_the_page_and_the_files_explain_each_status_once_and_alike():
    rows = re.findall(r"^\| `(\w+)` \| ([^|]+) \| (given|nan; regime and mode -1) \|$", PAGE, re.M)
    assert [(name, text) for name, text, _ in rows] == list(STATUS_MEANINGS.items())
    assert tuple(name for name, _, values in rows if values != "given") == WITHOUT_VALUES
    flag = FLAGS["solution_status"]
    assert flag.meanings == tuple(STATUS_MEANINGS)
    assert flag.comment.split("; ") == [": ".join(row[:2]) for row in rows]
