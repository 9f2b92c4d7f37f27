"""What surfaces cannot be, and what the digits of printed numbers leave open."""

import math
from dataclasses import replace

import pytest

from chenhorng.claims.limits import IMPOSSIBLE, POSSIBLE, limit_rows, nayak_alpha
from chenhorng.home import config_directory
from chenhorng.sheets import sheet_of
from thirdbody.core.parameters import mccool_summits
from thirdbody.files import read_yaml

DIGITS = read_yaml(config_directory() / "printed_digits.yaml")
SPEED = 7.3e-10, 2


def rows_of(inputs):
    rows = limit_rows(inputs, DIGITS, SPEED, (100, 500))
    return {(row["condition"], row["quantity"]): row for row in rows}


@pytest.fixture(scope="module")
def inputs(defaults):
    """Surfaces of eta_s R sigma = 0.036 at 300 nm, in proportion to sigma."""
    surfaces = {"summit_parameter": 0.036, "summit_parameter_exponent": 1.0}
    table2 = {"elastic_modulus_surfaces": 112e9, "ball_radius": 6.35e-3, "apparent_area": 6e-6}
    return replace(defaults.best, **surfaces, **table2, summit_deviation_ratio=1.2)


@pytest.mark.parametrize("summit_parameter", [0.025, 0.05, 0.3])
def test_alpha_is_that_of_mccool(summit_parameter):
    """McCool (1986): the plane of the summits is 4 sigma/sqrt(pi alpha) above the mean plane, and
    their variance is 1 - 0.8968/alpha of that of the surface."""
    alpha, summits = nayak_alpha(summit_parameter), mccool_summits(summit_parameter)
    plane = 4.0 / math.sqrt(math.pi * alpha)
    assert summits["summit_offset_ratio"] == pytest.approx(plane, rel=1e-4)
    variance = summits["summit_deviation_ratio"] ** 2
    assert 1.0 - variance == pytest.approx(0.8968 / alpha, rel=1e-3)


def test_no_isotropic_gaussian_surface_has_these_summits(inputs):
    rows = rows_of(inputs)
    found = [rows[f"σ = {sigma} nm", "α of Nayak"] for sigma in (100, 200, 300, 400, 500)]
    assert [row["verdict"] for row in found] == [IMPOSSIBLE] * 2 + [POSSIBLE] * 3
    alphas = [768.0 * math.pi * (0.036 * ratio / 3.0) ** 2 for ratio in range(1, 6)]
    assert [row["value"] for row in found] == pytest.approx(alphas)
    assert nayak_alpha(0.02493) < 1.5 < nayak_alpha(0.02494)
    assert found[0]["remark"].startswith("η_s R σ is 0.012;")
    assert found[0]["remark"].endswith("at least 0.0249")
    assert rows["any roughness", "σ_s/σ"]["verdict"] == IMPOSSIBLE
    equal = replace(inputs, summit_deviation_ratio=1.0)
    assert rows_of(equal)["any roughness", "σ_s/σ"]["verdict"] == POSSIBLE


@pytest.mark.parametrize(("newtons", "times"), [(1, 1567.7), (10, 337.75), (80, 84.436)])
def test_the_nominal_area_is_many_areas_of_hertz(inputs, newtons, times):
    row = rows_of(inputs)[f"F_t = {newtons} N", "A_n over the area of Hertz"]
    assert row["value"] == pytest.approx(times, rel=1e-4)
    assert row["verdict"] == ""


@pytest.mark.parametrize(
    ("viscosity", "thickness", "newtons", "remark"),
    [
        (70, "0.000115", (32.829, 30.167, 35.714), "27.7 to 38.9 N"),
        (120, "0.000163", (27.903, 25.501, 30.519), "23.9 to 32.5 N"),
    ],
)
def test_the_digits_of_u_leave_the_load_in_w_a_range(inputs, viscosity, thickness, newtons, remark):
    condition = f"Figure 11C, {viscosity} cSt, H_c = {thickness}"
    row = rows_of(inputs)[condition, "load in W [N]"]
    assert [row["value"], row["low"], row["high"]] == pytest.approx(newtons, rel=1e-4)
    assert row["remark"].startswith(remark)


def test_the_sheet_has_a_line_for_each_limit(inputs):
    rows = limit_rows(inputs, DIGITS, SPEED, (100, 500))
    sheet = sheet_of("limits", rows, (), 1.0)
    assert len(sheet.rows) == len(rows)
    assert sheet.rows[0]["value"] == "0.347" and sheet.rows[0]["low"] == "1.50"
