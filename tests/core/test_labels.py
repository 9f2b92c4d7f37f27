"""Results as datasets and as tables: nothing loses its name, its unit or its meaning."""

import copy
import json
import operator
import pickle
import re
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from methods import ENGINEERING, POINT

import thirdbody as tb
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import mean_and_largest
from thirdbody.core.regimes import FLAG_MEANINGS
from thirdbody.variables import AXES, FLAGS, VARIABLES

LOADS = np.array([1e-6, 1e-5, 1e-4])
OILS = np.array([0.0, 9e-5])


@pytest.fixture
def solved(parameters):
    """Function that solves the point above with other conditions."""
    return lambda **given: tb.solve(**(POINT | {"parameters": parameters} | given))


def test_each_variable_has_the_labels_of_the_data_contract(solved, parameters):
    dataset = solved(load=LOADS[:, None], viscosity=OILS).to_dataset()
    axes = POINT | {"load": LOADS, "viscosity": OILS}
    grid = tb.grid(**axes, parameters=parameters, variables=VARIABLES)
    assert set(dataset.data_vars) == set(grid.data_vars)
    for name, variable in grid.data_vars.items():
        expected = variable.values.squeeze()
        if name in FLAGS:
            assert (dataset[name].values == expected).all()
        else:
            np.testing.assert_allclose(dataset[name].values, expected, rtol=1e-9)
        np.testing.assert_equal(dataset[name].attrs, variable.attrs)
    for name in AXES:
        np.testing.assert_array_equal(dataset[name].values, grid[name].values.squeeze())
        assert dataset[name].attrs == grid[name].attrs


@pytest.mark.parametrize(
    ("given", "dimensions"),
    [
        ({}, {}),
        ({"load": LOADS}, {"load": 3}),
        ({"load": LOADS[:, None], "viscosity": OILS}, {"load": 3, "viscosity": 2}),
        ({"load": LOADS[:2], "viscosity": OILS}, {"point": 2}),
        (
            {"load": np.array([LOADS[:2], LOADS[1:]]), "viscosity": OILS},
            {"point_0": 2, "point_1": 2},
        ),
        ({"load": np.array([LOADS[:2], LOADS[1:]])}, {"point_0": 2, "point_1": 2}),
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


def test_variables_that_were_not_asked_for_are_not_there(solved):
    wanted = ["separation", "contact_mode"]
    assert set(solved(variables=wanted).to_dataset().data_vars) == {*wanted}


def test_a_table_has_a_row_a_point_and_names_for_flags(solved):
    with pytest.warns(tb.OutOfRangeWarning):
        solution = solved(load=[[1e-6], [1.0]], viscosity=OILS)
    table = solution.to_dataframe()
    assert {*POINT, "load_N", "separation_m", "film_thickness"} <= {*table.columns}
    assert table["load"].tolist() == [1e-6, 1e-6, 1.0, 1.0]
    np.testing.assert_array_equal(table["separation_m"], solution.separation.ravel())
    assert (solution.solution_status.ravel() == table["solution_status"]).all()
    unsolved = solution.lubrication_regime.ravel() == "without_values"
    assert unsolved.any()
    np.testing.assert_array_equal(table["lubrication_regime"].isna(), unsolved)


def test_where_people_read_a_full_film_has_no_contact_mode(solved):
    solution = solved(load=1e-6, viscosity=[9e-5, 1e-3])
    assert solution.lubrication_regime[1] == "full_film"
    assert solution.to_dataframe()["contact_mode"].isna().tolist() == [False, True]
    assert re.search(r"^contact_mode +none \(1\), \w+ \(1\)$", str(solution), re.MULTILINE)
    assert (solution.to_dataset()["contact_mode"] != "without_values").all()


# loads and oils with each regime, three modes and a point without values
EVERY = {"load_N": [0.5, 5.0, 50.0, 1e6], "viscosity_cSt": [0.0, 90.0, 300.0]}
REGIMES = [["boundary", "boundary", "full_film"], ["boundary", "boundary", "mixed"]]


@pytest.fixture
def every():
    """All combinations of the loads and oils: a solution, its dataset and table, and a grid."""
    loads, oils = EVERY.values()
    with pytest.warns(tb.OutOfRangeWarning):
        solution = tb.solve(load_N=np.array(loads)[:, None], viscosity_cSt=oils, **REST)
        grid = tb.grid(**EVERY, **REST).squeeze()
    return solution, solution.to_dataset(), solution.to_dataframe(), grid


def test_states_are_names_behind_every_door(every, tmp_path):
    solution, dataset, table, grid = every
    grid.to_netcdf(tmp_path / "grid.nc")
    read = xr.load_dataset(tmp_path / "grid.nc")
    assert solution.lubrication_regime[:2].tolist() == REGIMES
    for flag, meanings in FLAG_MEANINGS.items():
        for name in meanings:
            expected = [str(state) == name for state in getattr(solution, flag).ravel()]
            for states in (getattr(solution, flag), dataset[flag], grid[flag], read[flag]):
                assert np.ravel(states == name).tolist() == expected
                assert pd.Series(np.ravel(states)).isin([name]).tolist() == expected
                assert [state in {name} for state in np.ravel(states)] == expected
            assert pd.Series(np.ravel(solution.variables[flag])).map({name: 1.0}).sum() == sum(
                expected
            )
            if flag != "contact_mode":  # which tables do not show in a full film
                assert (table[flag] == name).tolist() == expected
    assert {*np.ravel(grid["contact_mode"])} >= {"surface_surface", "hybrid", "without_values"}


def test_states_have_the_codes_of_files(every, tmp_path):
    solution, dataset, *_ = every
    with pytest.warns(tb.OutOfRangeWarning):
        tb.stream(tmp_path / "grid.nc", **EVERY, **REST)
    for flag, codes in xr.load_dataset(tmp_path / "grid.nc")[[*FLAGS]].items():
        assert codes.dtype == np.int8
        for states in (getattr(solution, flag), dataset[flag].values):
            np.testing.assert_array_equal(states.astype(int), codes.values.squeeze())


def test_what_is_no_name_of_a_state_is_not_compared(every):
    solution, dataset, _, grid = every
    point = solution.contact_mode[0, 0]
    assert pickle.loads(pickle.dumps(point)) is copy.deepcopy(point) is point
    for other in ("surface surface", "mixed", 2, np.int8(2)):
        for states in (point, solution.contact_mode, dataset["contact_mode"], grid.contact_mode):
            for compare in (operator.eq, operator.ne):
                with pytest.raises(ValueError, match=r"ContactMode is .*; allowed: two_body, surf"):
                    compare(states, other)
    masked = grid.where(grid.normal_load > 1.0)  # with nan
    assert (masked["lubrication_regime"] == "mixed").values[:2].tolist() == [
        [False] * 3,
        [name == "mixed" for name in REGIMES[1]],
    ]


def test_conditions_are_selected_in_the_units_in_which_they_were_given(every):
    loads = np.geomspace(0.04, 80.0, 7)  # numbers of 17 digits
    names = [axis.alias for axis in AXES.values() if axis.name not in ("load", "viscosity")]
    rest = dict(zip(names, ([100.0, 300.0], [200.0, 300.0], [1e10, 1e11]), strict=True))
    grid = tb.grid(load_N=loads, viscosity_cSt=[0.0, 0.3, 90.0], **rest)
    place = {"load_N": loads[3], "viscosity_cSt": 0.3} | {key: rest[key][0] for key in rest}
    chosen, point = grid.sel(place), tb.solve(**place)
    assert chosen["separation"].item() == pytest.approx(float(point.separation), rel=1e-9)
    assert chosen["lubrication_regime"] == point.lubrication_regime
    assert grid["viscosity_cSt"].attrs["units"] == "cSt" and grid["load_N"].attrs["units"] == "N"
    with pytest.raises(KeyError):
        grid.sel(load_N=10)
    near = grid.sel(load_N=loads[5] * 1.01, method="nearest")
    assert near["load_N"] == loads[5] and near["load"] == grid["load"][5]
    _, dataset, *_ = every
    assert dataset.sel(load_N=5, viscosity_cSt=300)["lubrication_regime"] == "mixed"
    with pytest.raises(ValueError, match="more than one index"):
        grid.stack(point=["load", "viscosity"])
    assert grid.drop_indexes(["load_N", "viscosity_cSt"]).stack(point=["load", "viscosity"]).sizes
    assert not {axis.alias for axis in AXES.values()} & {*tb.grid(**POINT).coords}


def test_names_of_a_grid_are_made_when_they_are_used(every):
    """They stay right in copies, parts and files of copies, and are text for xarray."""
    *_, grid = every
    expected = grid["lubrication_regime"].values
    assert expected.tolist()[:2] == REGIMES
    for other in (copy.deepcopy(grid), pickle.loads(pickle.dumps(grid)), grid.load()):
        np.testing.assert_array_equal(other["lubrication_regime"], expected)
    chosen = {
        "load": xr.DataArray([0, 1], dims="pair"),
        "viscosity": xr.DataArray([2, 1], dims="pair"),
    }
    assert grid["lubrication_regime"].isel(chosen).values.tolist() == ["full_film", "boundary"]
    assert grid["lubrication_regime"].isel(load=[2, 0], viscosity=-1).values.tolist() == [
        expected[2, -1],
        expected[0, -1],
    ]


def test_results_carry_the_inputs_and_the_version(parameters):
    """As a grid does: with lists along the roughness, or power laws if it is no axis."""
    few = tb.load_parameters().members[:3]
    ensemble = tb.Ensemble(few, tb.load_parameters().setup)
    given = ENGINEERING | {"roughness_nm": [100, 300], "parameters": ensemble}
    for members in (False, True):
        grid = tb.grid(**given, members=members).attrs
        found = tb.solve(**given, members=members).to_dataset().attrs
        assert found["software_version"] == tb.__version__
        for name in ("model_parameters", "Conventions", *(["ensemble"] if members else [])):
            assert found[name] == grid[name]
    pairs = tb.solve(**given | {"load_N": [1.0, 10.0]}).to_dataset().attrs["model_parameters"]
    model = json.loads(pairs)
    again = {name: model[name] for name in Parameters.names() if name in model}
    assert {"summit_radius", "summit_parameter_exponent", "summit_deviation_ratio"} <= {*again}
    assert again.items() <= few[0].as_dict().items()
    listed = json.loads(grid["model_parameters"])
    assert {*listed} - {*model} == {"eta_s", "R", "sigma_s", "y_s"}


def test_a_coordinate_called_like_a_condition_is_the_condition():
    """xarrays of loads in newtons, labelled by themselves: ``load`` is F_t* all the same."""
    loads = xr.DataArray([5.0, 10.0], dims="load", coords={"load": [5.0, 10.0]})
    dataset = tb.solve(load_N=loads, **OIL, **REST).to_dataset()
    expected = tb.solve(load_N=[5.0, 10.0], **OIL, **REST).to_dataset()
    xr.testing.assert_identical(dataset, expected)
    np.testing.assert_allclose(dataset["normal_load"], [5.0, 10.0])


def test_a_table_says_what_areas_and_films_are_relative_to(parameters):
    table = tb.solve(**ENGINEERING, parameters=parameters).to_dataframe()
    area, ratios, _ = table.attrs["notes"]
    assert f"A_n of the inputs is {1e6 * parameters.apparent_area:.3g} mm2" in area
    assert f"film_thickness over R_x = {1e3 * parameters.ball_radius:.4g} mm" in ratios
    height = table["film_thickness"] * parameters.ball_radius
    np.testing.assert_allclose(height, table["separation_m"])


SURFACE = dict(roughness_nm=300, particle_density_per_m2=1e11)
REST = SURFACE | dict(particle_diameter_nm=500)
OIL = {"viscosity_cSt": 90}


def test_conditions_of_two_dimensions_are_labelled_and_selected(solved):
    """A map of sizes relative to the roughness: the sizes vary along both dimensions."""
    roughness = np.array([1e-7, 2e-7, 3e-7])
    sizes = roughness * np.array([[0.5], [1.0]])
    solution = solved(particle_diameter=sizes, roughness=roughness)
    table = solution.to_dataframe()
    assert table["particle_diameter"].tolist() == sizes.ravel().tolist()
    dataset = solution.to_dataset()
    assert not {*dataset.sizes} & {"particle_diameter"}
    for name, dimension in zip(dataset["separation"].dims, sizes.shape, strict=True):
        assert dataset.sizes[name] == dimension
    both = solved(particle_diameter=sizes, roughness=roughness + 0.0 * sizes)
    pd.testing.assert_frame_equal(
        both.to_dataframe()[[*table]], table, check_exact=True, check_like=True
    )


def test_the_load_stands_in_newtons_beside_the_dimensionless_one():
    loads = [5.0, 10.0]
    expected = np.array(loads)
    for found in (
        tb.solve(load_N=loads, **OIL, **REST),
        tb.solve(load_N=xr.DataArray(loads, dims="time"), **OIL, **REST),
        tb.solve(load_N=loads, viscosity_cSt=[90, 120], **REST),
    ):
        dataset = found.to_dataset()
        np.testing.assert_allclose(dataset["normal_load"], expected, rtol=1e-12)
        assert dataset["normal_load"].attrs["units"] == "N"
        assert dataset["normal_load"].dims == dataset["load"].dims
        table = found.to_dataframe()
        assert table["load_N"].tolist() == loads
    one = tb.solve(load_N=10, viscosity_cSt=[0, 90], **REST).to_dataset()
    assert one["normal_load"].item() == pytest.approx(10.0)


TABLE = pd.DataFrame({"load": [5.0, 10.0, 20.0], "oil": [50.0, 90.0, 120.0]}, index=["a", "b", "c"])


def test_columns_of_a_table_are_conditions_and_results_have_their_index():
    runs = TABLE[TABLE["load"] > 5.0].rename_axis("run")
    found = tb.solve(load_N=runs["load"], viscosity_cSt=runs["oil"], **REST)
    expected = tb.solve(load_N=[10.0, 20.0], viscosity_cSt=[90.0, 120.0], **REST)
    np.testing.assert_array_equal(found.separation, expected.separation)
    table = found.to_dataframe()
    assert table.index.equals(runs.index) and table.index.name == "run"
    assert table["load_N"].tolist() == [10.0, 20.0]
    assert table["viscosity_cSt"].tolist() == [90.0, 120.0]
    days = runs.set_index(pd.to_datetime(["2026-01-02", "2026-01-03"]))
    found = tb.solve(load_N=days["load"], viscosity_cSt=90, **REST).to_dataframe()
    assert found.index.equals(days.index)


@pytest.mark.parametrize(
    ("index", "labels"),
    [
        (pd.Index([*"abc"]), {"row": [*"abc"]}),
        (pd.Index([7, 8, 9], name="run"), {"run": [7, 8, 9]}),
        (pd.Index([7, 8, 9], name="load"), {"row": [7, 8, 9]}),
        (
            pd.MultiIndex.from_product([["one"], [1, 2, 3]], names=["rig", "rig"]),
            {"rig": ["one"] * 3, "row_1": [1, 2, 3]},
        ),
    ],
    ids=["labels", "with a name", "with the name of a condition", "of two levels"],
)
def test_the_index_of_columns_is_a_coordinate_of_the_dataset(index, labels):
    runs = TABLE.set_index(index)
    curve = tb.solve(load_N=runs["load"], viscosity_cSt=90, **REST)
    pairs = tb.solve(load_N=runs["load"], viscosity_cSt=runs["oil"], **REST)
    crossed = tb.solve(load_N=runs["load"], viscosity_cSt=[[0.0], [90.0]], **REST)
    for found in (curve, pairs, crossed):
        dataset = found.to_dataset()
        for name, values in labels.items():
            assert dataset[name].dims == (dataset["separation"].dims[-1],)
            assert dataset[name].values.tolist() == values
    assert not {*labels} & {*curve.to_dataframe()}


@pytest.mark.parametrize(
    "index",
    [
        pd.date_range("2026-01-02", periods=2, tz="Europe/Berlin", name="start"),
        pd.date_range("2026-01-02", periods=2, name="start"),
        pd.period_range("2026-01", periods=2, freq="M", name="start"),
        pd.CategoricalIndex(["dry", "wet"], name="start"),
        pd.Index([1, 2], dtype="Int64", name="start"),
    ],
    ids=["with a time zone", "times", "months", "categories", "nullable"],
)
def test_datasets_with_any_index_are_written(tmp_path, index):
    loads = pd.Series([5.0, 10.0], index=index)
    solution = tb.solve(load_N=loads, viscosity_cSt=90, **REST)
    assert solution.to_dataframe().index.equals(index)
    dataset = solution.to_dataset()
    dataset.to_netcdf(tmp_path / "solution.nc")
    written = xr.load_dataset(tmp_path / "solution.nc")
    assert (written["start"].values == dataset["start"].values).all()
    assert dataset["start"].astype(str).values[0].startswith(str(index[0])[:10])


def test_columns_with_different_indexes_are_refused():
    others = TABLE.set_index([[1, 2, 3]])
    with pytest.raises(ValueError, match="load_N and viscosity_cSt have different indexes"):
        tb.solve(load_N=TABLE["load"], viscosity_cSt=others["oil"], **REST)


def test_each_point_of_a_column_and_other_arrays_has_the_label_of_its_row():
    found = tb.solve(load_N=TABLE["load"], viscosity_cSt=[[0.0], [90.0]], **REST).to_dataframe()
    assert found.index.tolist() == [*"abcabc"]
    assert found.loc["b", "load_N"].tolist() == [10.0, 10.0]
    one = tb.solve(load_N=TABLE["load"].iloc[:1], viscosity_cSt=[0, 90], **REST).to_dataframe()
    assert one.index.tolist() == [*"aa"]
    none = tb.solve(load_N=TABLE["load"].iloc[:0], viscosity_cSt=90, **REST).to_dataframe()
    assert none.empty and none.index.equals(TABLE.index[:0])


@pytest.mark.parametrize(
    "search",
    [
        lambda loads: tb.find("solid_load_fraction", [0.5], "viscosity_cSt", load_N=loads, **REST),
        lambda loads: tb.transitions("viscosity_cSt", load_N=loads, **REST),
    ],
)
def test_searches_have_the_index_of_the_columns(search):
    table = search(TABLE["load"])
    assert set(table.index) == {*"abc"}
    assert table["load_N"].tolist() == TABLE["load"][table.index].tolist()


def test_turning_points_have_the_index_of_the_columns():
    table = tb.turning_point(viscosity_cSt=TABLE["oil"], **REST)
    assert table.index.equals(TABLE.index)
    newtons = table["load"] * tb.load_parameters().newtons_per_load
    np.testing.assert_allclose(table["load_N"], newtons)


def test_the_particle_size_is_a_label_with_its_mean_and_largest(parameters):
    points = tb.solve(**ENGINEERING, parameters=parameters).to_dataset()
    size = points["particle_diameter"].attrs
    assert size["long_name"].startswith("particle size, a label")
    mean, largest = mean_and_largest(1.0, parameters)
    assert f"is {mean:.3g} x_a, the largest, X_max, {largest:.3g} x_a" in size["comment"]
    # by a sum over sizes
    centre, spread = parameters.sizes(1.0)
    sizes = np.linspace(0.0, centre + parameters.truncation * spread, 200_001)
    weights = np.exp(-0.5 * ((sizes - centre) / spread) ** 2)
    assert mean == pytest.approx(np.average(sizes, weights=weights), rel=1e-4)
    assert largest == sizes[-1]


def test_only_quotes_of_the_paper_call_the_particle_size_a_mean():
    root = Path(__file__).resolve().parents[2]
    texts = [*(root / "src").rglob("*.*"), *(root / "docs").glob("*.md")]
    texts += (root / "config").glob("*.yaml")
    kinds = {".py", ".md", ".csv", ".json", ".yaml", ".js", ".html", ".j2"}
    found = {
        path.name
        for path in texts
        if path.suffix in kinds
        and re.search("mean (particle )?diameter", path.read_text(encoding="utf-8"), re.IGNORECASE)
    }
    assert found == {"model.md", "paper_tables.yaml", "results.md"}
