"""A solution as a dataset and as a table: nothing loses its name, its unit or its meaning."""

import numpy as np
import pytest
import xarray as xr
from methods import POINT

import thirdbody as tb
from thirdbody.data.conditions import AXES
from thirdbody.data.quantities import VARIABLES
from thirdbody.model.regimes import SOLUTION_STATUSES

LOADS = np.array([1e-6, 1e-5, 1e-4])
OILS = np.array([0.0, 9e-5])


@pytest.fixture
def solved(parameters):
    """Function that solves the point above with other conditions."""
    return lambda **given: tb.solve(**(POINT | given), parameters=parameters)


def test_each_variable_has_the_labels_of_the_data_contract(solved, parameters):
    dataset = solved(load=LOADS[:, None], viscosity=OILS).to_dataset()
    grid = tb.grid(
        **(POINT | {"load": LOADS, "viscosity": OILS}), parameters=parameters, variables=VARIABLES
    )
    assert set(dataset.data_vars) == {*grid.data_vars, "separation_count"}
    for name, variable in grid.data_vars.items():
        np.testing.assert_allclose(dataset[name].values, variable.values.squeeze(), rtol=1e-9)
        expected = {key: each for key, each in variable.attrs.items() if key != "_FillValue"}
        np.testing.assert_equal(dataset[name].attrs, expected)
    for name in AXES:
        np.testing.assert_array_equal(dataset[name].values, grid[name].values.squeeze())
        assert dataset[name].attrs == grid[name].attrs
    assert dataset["separation_count"].attrs["long_name"]


@pytest.mark.parametrize(
    ("given", "dimensions"),
    [
        ({}, {}),
        ({"load": LOADS}, {"load": 3}),
        ({"load": LOADS[:, None], "viscosity": OILS}, {"load": 3, "viscosity": 2}),
        ({"load": LOADS[:2], "viscosity": OILS}, {"point": 2}),
        ({"load": [LOADS[:2], LOADS[1:]], "viscosity": OILS}, {"load": 2, "point": 2}),
        ({"load": [LOADS[:2], LOADS[1:]]}, {"point_0": 2, "point_1": 2}),
        ({"load": [[1e-5]], "viscosity": OILS}, {"load": 1, "viscosity": 2}),
    ],
    ids=["a point", "a curve", "a grid", "pairs", "pairs and more", "a table", "of length 1"],
)
def test_a_dimension_is_called_by_the_condition_that_has_it_to_itself(solved, given, dimensions):
    dataset = solved(**given).to_dataset()
    assert dict(dataset.sizes) == dimensions
    for name in AXES:
        expected = np.broadcast_to((POINT | given)[name], tuple(dimensions.values()))
        found = dataset[name].broadcast_like(dataset["separation"])
        np.testing.assert_array_equal(found.transpose(*dimensions).values, expected)


def test_arrays_of_xarray_keep_their_labels(solved):
    loads = xr.DataArray(LOADS, dims="day", coords={"day": ["Mon", "Tue", "Wed"]})
    dataset = solved(load=loads, viscosity=xr.DataArray(OILS, dims="oil")).to_dataset()
    assert dict(dataset.sizes) == {"day": 3, "oil": 2}
    assert dataset["day"].values.tolist() == ["Mon", "Tue", "Wed"]
    assert dataset["load"].dims == ("day",) and dataset["viscosity"].dims == ("oil",)
    np.testing.assert_array_equal(dataset["load"], LOADS)
    table = solved(load=loads).to_dataframe()
    assert table["day"].tolist() == ["Mon", "Tue", "Wed"]


def test_variables_that_were_not_asked_for_are_not_there(parameters):
    wanted = ["separation", "contact_mode"]
    solution = tb.solve(**POINT, parameters=parameters, variables=wanted)
    assert set(solution.to_dataset().data_vars) == {*wanted}
    none = tb.solve(**(POINT | {"load": LOADS}), parameters=parameters, variables=[])
    assert dict(none.to_dataset().sizes) == {"load": 3}


def test_a_table_has_a_row_a_point_and_names_for_flags(solved):
    with pytest.warns(tb.OutOfRangeWarning):
        solution = solved(load=[[1e-6], [1.0]], viscosity=OILS)
    table = solution.to_dataframe()
    assert tuple(table.columns[: len(AXES)]) == tuple(AXES)
    assert table["load"].tolist() == [1e-6, 1e-6, 1.0, 1.0]
    np.testing.assert_array_equal(table["separation"], solution.separation.ravel())
    assert table["solution_status"].tolist() == [
        SOLUTION_STATUSES[code] for code in solution.solution_status.ravel()
    ]
    unsolved = solution.lubrication_regime.ravel() < 0
    assert unsolved.any()
    np.testing.assert_array_equal(table["lubrication_regime"].isna(), unsolved)
    assert table.attrs["units"]["separation"] == "m"
