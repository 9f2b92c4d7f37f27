"""The recipes of the documentation give these numbers with the calibrated inputs.

As functions of the library they gave the same numbers to the recipes' digits, with the inputs of
that time.
"""

import re
from pathlib import Path

import numpy as np
import pytest

DOCS = Path(__file__).parents[2] / "docs"
CELL = re.compile(r"```\{code-cell\} ipython3\n(?!:tags)(.*?)```", re.DOTALL)


@pytest.fixture(scope="module")
def page():
    """What the cells of the page define, and what they print."""
    pytest.importorskip("matplotlib").use("agg")
    cells = CELL.findall((DOCS / "recipes.md").read_text(encoding="utf-8"))
    printed, names = [], {"print": lambda *values: printed.append(" ".join(map(str, values)))}
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(DOCS / "examples")
        for cell in cells:
            exec(cell, names)
    return names | {"printed": "\n".join(printed)}


def test_columns_of_a_table_are_conditions(page):
    expected = [0.9999826778, 0.8459379873]
    assert page["states"]["solid_load_fraction"].tolist() == pytest.approx(expected)


def test_friction_and_resistance(page):
    assert page["printed"].startswith("[0.11  0.096 0.056] [0.0138 0.0037 0.0024]\n")
    expected = [0.11999893, 0.11985936, 0.0785845, 0.03376372]
    assert page["stribeck"][::10].tolist() == pytest.approx(expected, rel=1e-6)
    speeds = [3.75985, 7.21116, 13.982352]
    assert page["changes"]["speed_m_per_s"].tolist() == pytest.approx(speeds, rel=1e-6)


def test_measurements_stand_beside_the_model(page):
    assert page["coefficients"].tolist() == pytest.approx([0.1107147727, 0.03588254792])
    assert "2.18e-07 ohm m" in page["printed"]
    table = page["table"]
    columns = ["model", "low", "high", "residual"]
    first = [0.1107125188, 0.1107111732, 0.1107136461, 0.00038748121]
    last = [0.06049589969, 0.0589484397, 0.06805494037, -4.58996875e-05]
    assert table[columns].iloc[0].tolist() == pytest.approx(first, rel=1e-5)
    assert table[columns].iloc[-1].tolist() == pytest.approx(last, rel=1e-5)
    assert np.sqrt(np.mean(table["residual"] ** 2)) == pytest.approx(0.002100275, rel=1e-4)
    assert table["measured"].between(table["low"], table["high"]).sum() == 5


def test_inputs_are_fitted_with_the_ensemble_as_their_prior(page):
    values = [0.4411623758, 1.0328158058e-4, 0.1106230276, 0.03594322809]
    errors = [0.1650057635, 8.139416913e-06, 0.0012708375, 0.003377663471]
    assert page["fitted"]["value"].tolist() == pytest.approx(values, rel=1e-5)
    assert page["fitted"]["error"].tolist() == pytest.approx(errors, rel=1e-3)
    of_prior = [0.1700632342, 1.575407919e-05]
    assert page["fitted"]["prior_error"].tolist()[:2] == pytest.approx(of_prior, rel=1e-5)


def test_uncertain_inputs(page):
    table = page["uncertain"].describe().T
    assert table["mean"].tolist() == pytest.approx([0.99555, 0.82854], abs=5e-5)
    assert table["std"].tolist() == pytest.approx([0.00502, 0.01396], abs=5e-5)


def test_oils_and_debris(page):
    """The sizes of the inputs have a mean cube of their own: that of a normal cut at 0 and
    X_max."""
    viscosity = page["viscosity_cSt"]
    assert viscosity(80, {40: 47.2, 100: 6.9}) == pytest.approx(11.29593159)
    assert viscosity(80, {40: 46, 100: 6.643921353}) == pytest.approx(10.895591868)
    assert viscosity(80, {40: 32, 100: 5.4}) == pytest.approx(8.5, abs=0.05)  # an example of D341
    grades = re.findall(r"ISO VG (\d+) has ([\d.]+) cSt at 75 degrees", page["printed"])
    assert grades == [("320", "56.4"), ("460", "74.5"), ("680", "100.5")]
    counts = re.findall(r"(\S+) particles per m2", page["printed"])
    sizes = np.linspace(0.0, page["mean"] + page["inputs"].truncation * page["deviation"], 20001)
    weights = np.exp(-0.5 * ((sizes - page["mean"]) / page["deviation"]) ** 2)
    cube = (weights @ sizes**3) / weights.sum()
    expected = [1.946353444e8, 1.946353444e8 * 500e-9**3 / cube]
    assert list(map(float, counts)) == pytest.approx(expected, rel=1e-3)


def test_surfaces(page):
    """The function that is gone lost a row at each edge of the heights by a rounding error."""
    assert "\n298.96" in page["printed"]
    assert page["sigma"] == pytest.approx(1.991225988e-7)
    assert page["radius"] == pytest.approx(4.749853e-6, rel=5e-3)
    assert page["density"] == pytest.approx(3.463580e10, rel=5e-3)
    share = float(page["printed"].splitlines()[-1])
    assert share == pytest.approx(0.6282213802, rel=5e-3)
