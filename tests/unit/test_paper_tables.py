"""Tables 1 and 2 as printed, and each derived entry from the others."""

from pathlib import Path

import numpy as np
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


@pytest.mark.parametrize(
    ("table", "symbol", "expected", "verdict"),
    [
        ("table2", "W", [8.857e-4, 1.7715], "differs"),  # printed 0.00086
        ("table2", "sigma*", [1.574803, 7.874016], "agrees"),
        ("table1", "E_ss", [111.9118, np.nan], "agrees"),  # 1/E = 2 (1 - 0.29^2)/205 GPa
        ("table1", "E_sa", [111.9118, np.nan], "agrees"),
        ("table2", "eta_a", [np.nan, np.nan], "input"),
    ],
)
def test_a_derived_entry_follows_from_the_others(tables, table, symbol, expected, verdict):
    row = tables[table][symbol]
    found = np.array([row["recomputed_low"], row["recomputed_high"]], float)
    assert_allclose(found, expected, rtol=1e-4)
    assert row["verdict"] == verdict


@pytest.mark.parametrize(
    ("printed", "verdict"), [([1.57, 7.87], "agrees"), ([1.58, 7.87], "differs")]
)
def test_agreement_is_judged_to_the_printed_digits(parameters, printed, verdict):
    row = {"property": "", "symbol": "", "unit": "1e-5", "printed": printed, "digits": 3}
    (judged,) = paper_table([row | {"recompute": "roughness_parameter"}], parameters)
    assert judged["verdict"] == verdict
