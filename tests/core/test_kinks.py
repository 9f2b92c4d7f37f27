"""Points whose separation lies next to a kink of F_s(d): they came back wrong, and as converged.

A last Newton step that crossed the kink was not looked at again.  The inputs are those of the
default of then, centred sizes about the plane of the surfaces; the right values are from mpmath.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from methods import POINT

import thirdbody as tb
from benchmarks.points import read_rows

INPUTS = {
    **{"apparent_area": 2.61754e-06, "reference_roughness": 3e-07},
    **{"summit_offset_ratio": 0.0, "summit_deviation_ratio": 1.0},
    **{"summit_parameter": 1.5168, "summit_parameter_exponent": 0.40724},
    **{"summit_radius": 6.92447e-06, "summit_radius_exponent": -0.760942},
    **{"mean_ratio": 0.893311, "spread_ratio": 1.98554},
    **{"truncation": 1.59456, "participation": 0.00315168, "elastic_depth_ratio": 0.0111},
}
ROWS = read_rows(Path(__file__).parents[1] / "golden" / "kinks.csv")


@pytest.mark.parametrize("others", [0, 1999])
@pytest.mark.parametrize("row", ROWS, ids=["2.2e-6 off", "9.0e-5 off among others", "4.6 % off"])
def test_a_point_next_to_a_kink_is_right_alone_and_first_of_many(parameters, row, others, method):
    values = {name: float(value) for name, value in row.items()}
    rtol, conditions = values.pop("rtol"), {name: values.pop(name) for name in POINT}
    loads = np.append(conditions.pop("load"), np.geomspace(1e-7, 1e-4, others))
    inputs = replace(parameters, **INPUTS)
    found = tb.solve(load=loads, **conditions, parameters=inputs, rtol=rtol)
    assert found.solution_status[0] == "converged"
    bound = found.error_bound[0]
    assert bound <= rtol
    for quantity, value in values.items():
        assert abs(getattr(found, quantity)[0] / value - 1.0) <= bound, quantity
