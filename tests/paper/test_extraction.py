"""Rows of turning points and transitions: each says how its values are to be taken."""

from dataclasses import replace

import numpy as np
import pytest

import thirdbody as tb
from chenhorng.extraction import tpca_rows, transition_rows
from thirdbody.curves import Condition
from thirdbody.netcdf import read_plain
from thirdbody.variables import CONDITION_AXES

AXES = {
    "load": np.geomspace(1e-8, 1e-2, 80),
    "viscosity": [0.0, 2e-7, 9e-5],
    "particle_diameter": [3e-7, 5e-7],
    "roughness": [1e-7, 3e-7],
    "particle_density": [1e11],
}
# surfaces so soft that films press harder than they are, and summits soon cover more than there is
SOFT = {"hardness_surface_1": 3e7, "hardness_surface_2": 3e7}


@pytest.mark.filterwarnings("ignore::thirdbody.OutOfRangeWarning")
@pytest.mark.parametrize("rows_of", [tpca_rows, transition_rows])
def test_each_row_has_the_values_and_the_status_of_its_point(parameters, rows_of, tmp_path):
    statuses = set()
    for changes in ({}, SOFT):
        inputs = replace(parameters, **changes)
        tb.stream(tmp_path / "mine.nc", **AXES, parameters=inputs)
        rows = rows_of("mine", read_plain(tmp_path / "mine.nc"), inputs)
        assert rows
        columns = [axis.column for axis in CONDITION_AXES]
        given = Condition(*np.array([[row[name] for name in columns] for row in rows]).T)
        load = np.array([row["load"] for row in rows])
        solution = tb.solve(load=load, **given._asdict(), parameters=inputs)
        assert [row["solution_status"] for row in rows] == [*solution.solution_status]
        newtons = load * inputs.newtons_per_load
        assert [row["normal_load_N"] for row in rows] == pytest.approx(newtons)
        beside = np.multiply.outer([1.0 - 1e-6, 1.0 + 1e-6], load)
        around = tb.solve(load=beside, **given._asdict(), parameters=inputs)
        for index, row in enumerate(rows if not changes else ()):
            values = getattr(around, row.get("quantity", "particle_contact_area_ratio"))[:, index]
            if "level" in row:
                assert values.min() <= row["level"] <= values.max(), row
            else:
                assert values == pytest.approx(row["peak_ratio"], rel=1e-6), row
        statuses |= set(solution.solution_status)
    assert "converged" in statuses and len(statuses) > 1
