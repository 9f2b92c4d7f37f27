"""Tables 1 and 2 as printed, and each derived entry from the others."""

from dataclasses import replace
from pathlib import Path

import pytest
from numpy.testing import assert_allclose

from thirdbody.configuration.plain_yaml import read_yaml
from thirdbody.data.paper_tables import paper_table

PRINTED = Path(__file__).parents[2] / "config" / "paper_tables.yaml"


@pytest.fixture(scope="module")
def tables(parameters):
    """Rows of both tables by their symbols."""
    return {
        name: {row["symbol"]: row for row in paper_table(rows, parameters)}
        for name, rows in read_yaml(PRINTED).items()
    }


def recomputed(row):
    return [row["recomputed_low"], row["recomputed_high"]]


def test_the_load_parameter_follows_from_the_loads(tables):
    row = tables["table2"]["W"]
    assert_allclose(recomputed(row), [8.857e-4, 1.7715], rtol=1e-4)


def test_the_printed_load_parameter_is_named_as_a_disagreement(tables):
    row = tables["table2"]["W"]
    assert row["verdict"] == "differs"
    assert "printed 0.00086 against 0.000886" in row["remark"]
    # the high end agrees to its two digits
    assert "1.8" not in row["remark"]


def test_the_dimensionless_roughness_follows_from_the_roughness(tables):
    expected = [100e-9 / 6.35e-3 * 1e5, 500e-9 / 6.35e-3 * 1e5]
    assert_allclose(recomputed(tables["table2"]["sigma*"]), expected, rtol=1e-15)
    assert tables["table2"]["sigma*"]["verdict"] == "agrees"


def test_the_hertz_modulus_follows_from_steel(tables):
    # 1/E = 2 (1 - 0.29^2)/205 GPa
    for symbol in ("E_ss", "E_sa"):
        assert tables["table1"][symbol]["recomputed_low"] == pytest.approx(111.9118, rel=1e-6)
        assert tables["table1"][symbol]["verdict"] == "agrees"


def test_a_row_that_nothing_recomputes_is_an_input(tables):
    row = tables["table2"]["eta_a"]
    assert row["verdict"] == "input"
    assert recomputed(row) == [None, None]


@pytest.mark.parametrize(
    ("printed", "verdict"), [([1.57, 7.87], "agrees"), ([1.58, 7.87], "differs")]
)
def test_agreement_is_judged_to_the_printed_digits(parameters, printed, verdict):
    row = {"property": "", "symbol": "", "unit": "1e-5", "printed": printed, "digits": 3}
    (judged,) = paper_table([row | {"recompute": "roughness_parameter"}], parameters)
    assert judged["verdict"] == verdict


def test_another_ball_gives_another_verdict(parameters):
    inputs = replace(parameters, ball_radius=2.0 * parameters.ball_radius)
    rows = paper_table(read_yaml(PRINTED)["table2"], inputs)
    verdicts = {row["symbol"]: row["verdict"] for row in rows}
    assert verdicts["sigma*"] == "differs"
