"""A streamed grid is the grid, in whatever blocks, and there is no half of a file."""

import warnings

import netCDF4
import numpy as np
import pytest
import xarray as xr

import thirdbody as tb
from thirdbody import grids
from thirdbody.core.solve import solve_points
from thirdbody.core.sweep import sweep
from thirdbody.netcdf import read_plain
from thirdbody.variables import FLAGS

pytestmark = pytest.mark.filterwarnings("error")

AXES = {
    "load": np.geomspace(1e-6, 1e-3, 7),
    "viscosity": [0.0, 9e-5],
    "particle_diameter": [0.0, 3e-7, 5e-7],
    "roughness": [1e-7, 3e-7],
    "particle_density": [1e10, 1e11, 1e12],
}


@pytest.mark.parametrize("points", [1, 4, 36, 40, 100, 10**6])
def test_a_streamed_grid_is_the_grid(parameters, tmp_path, monkeypatch, capsys, points):
    monkeypatch.setattr(grids, "POINTS_PER_BLOCK", points)
    given = AXES | {"parameters": parameters}
    tb.stream(tmp_path / "grid.nc", **given)
    assert capsys.readouterr() == ("", "")
    streamed, grid = read_plain(tmp_path / "grid.nc").to_xarray(), tb.grid(**given)
    assert streamed.attrs == grid.attrs
    assert dict(streamed.sizes) == dict(grid.sizes)
    assert {*streamed.coords} == {*grid.coords}
    for name, expected in grid.variables.items():
        values = expected.values.astype(int if name in FLAGS else float)  # of states the codes
        # points in other company: sums in another order
        np.testing.assert_allclose(streamed[name].values, values, rtol=1e-12, err_msg=name)
        for attribute in expected.attrs:
            assert np.all(streamed[name].attrs[attribute] == expected.attrs[attribute])


@pytest.mark.parametrize("points", [600, 3000, 10**6])
def test_at_three_digits_it_is_interpolated_as_the_grid_is(
    parameters, tmp_path, monkeypatch, points
):
    axes = AXES | {"load": np.geomspace(1e-6, 1e-3, 50)}
    axes |= {"viscosity": np.append(0.0, np.geomspace(2e-6, 1.5e-4, 10))}
    swept = []

    def counted(sides, *more):
        swept.append(np.prod([side.size for side in sides.values()]))
        return sweep(sides, *more)

    monkeypatch.setattr(grids, "POINTS_PER_BLOCK", points)
    monkeypatch.setattr(grids, "sweep", counted)
    tb.stream(tmp_path / "grid.nc", **axes, parameters=parameters, rtol=1e-3)
    streamed = xr.load_dataset(tmp_path / "grid.nc")
    assert sum(swept) == streamed["separation"].size and max(swept) <= points
    grid = tb.grid(**axes, parameters=parameters, rtol=1e-3)
    solution = tb.solve(**grids.crossed(axes), parameters=parameters)
    flags = {name: grid[name].values.astype(int) for name in FLAGS}
    np.testing.assert_array_equal(streamed["solution_status"], flags["solution_status"])
    for name in ("lubrication_regime", "contact_mode"):  # may differ next to a limit
        assert (streamed[name] != flags[name]).mean() < 1e-3
    assert ((streamed["error_bound"] >= 0.0) & (streamed["error_bound"] <= 1e-3)).all()
    assert streamed["error_bound"].attrs == grid["error_bound"].attrs
    for name in ("separation", "solid_load_fraction", "particle_contact_area_ratio"):
        for expected in (grid[name].values, solution.variables[name]):
            np.testing.assert_allclose(streamed[name], expected, rtol=1e-3, err_msg=name)


def test_a_failure_leaves_no_file(parameters, tmp_path, monkeypatch):
    calls = iter(range(3))

    def failing(*given, **more):
        if next(calls) == 2:
            raise OSError("no room")
        return solve_points(*given, **more)

    monkeypatch.setattr(grids, "POINTS_PER_BLOCK", 50)
    monkeypatch.setattr(grids, "solve_points", failing)
    with pytest.raises(OSError, match="no room"):
        tb.stream(tmp_path / "grid.nc", **AXES, parameters=parameters)
    assert not list(tmp_path.iterdir())


def test_more_than_there_is_room_for_is_refused_before_anything_is_solved(parameters, tmp_path):
    axis = np.linspace(1e-6, 1e-3, 10**6)
    axes = AXES | {"load": axis, "viscosity": axis, "roughness": 3e-7}
    message = r"grid.nc would hold .e\+1. points in .*e\+1. bytes; allowed"
    with pytest.raises(OSError, match=message):
        tb.stream(tmp_path / "grid.nc", **axes, parameters=parameters)
    assert list(tmp_path.iterdir()) == []


def test_compressed_on_request_it_holds_the_variables_asked_for(parameters, tmp_path):
    wanted = ["separation", "error_bound"]
    given = AXES | {"parameters": parameters, "rtol": 1e-6, "variables": wanted}
    for level in (0, 4):
        tb.stream(tmp_path / f"{level}.nc", **given, compression=level)
    plain, packed = (xr.load_dataset(tmp_path / f"{level}.nc") for level in (0, 4))
    xr.testing.assert_identical(plain, packed)
    assert set(plain.data_vars) == set(tb.grid(**given).data_vars) == {*wanted, "solution_status"}
    with netCDF4.Dataset(tmp_path / "4.nc") as file:
        assert file["separation"].filters()["zlib"]
    with pytest.raises(ValueError, match="compression is 12; allowed: 0 to 9"):
        tb.stream(tmp_path / "no.nc", **given, compression=12)


def test_fill_values_belong_to_the_file(parameters, tmp_path):
    grid = tb.grid(**AXES, parameters=parameters)
    assert not any("_FillValue" in variable.attrs for variable in grid.variables.values())
    packed = {"dtype": "int16", "scale_factor": 1e-9, "_FillValue": -1}
    for encoding in ({"_FillValue": np.nan}, packed):
        grid[["separation"]].to_netcdf(tmp_path / "own.nc", encoding={"separation": encoding})
    grid.to_netcdf(tmp_path / "grid.nc")
    xr.testing.assert_identical(xr.load_dataset(tmp_path / "grid.nc"), grid)


def test_coordinates_in_a_file_have_no_fill_value(parameters, tmp_path):
    tb.grid(**AXES, parameters=parameters).to_netcdf(tmp_path / "grid.nc")
    line = {name: values if name == "load" else values[-1] for name, values in AXES.items()}
    tb.solve(**line).to_dataset().to_netcdf(tmp_path / "solution.nc")
    few = tb.Ensemble(tb.load_parameters().members[:2], tb.load_parameters().setup)
    given = dict(load_N=[1, 2], viscosity_cSt=90, particle_diameter_nm=300, roughness_nm=300)
    given |= dict(particle_density_per_m2=1e11, parameters=few)
    tb.stream(tmp_path / "stream.nc", **given)
    given |= dict(speed_m_per_s=[1, 2], members=True)
    tb.grid(**given).to_netcdf(tmp_path / "members.nc")
    for name in ("grid", "solution", "stream", "members"):
        with netCDF4.Dataset(tmp_path / f"{name}.nc") as file:
            aliases = {"load_N", "viscosity_cSt", "speed_m_per_s"} & {*file.variables}
            assert len(aliases) == {"stream": 2, "members": 3}.get(name, 0)
            for each in {*AXES, "normal_load", *file.dimensions, *aliases} & {*file.variables}:
                assert "_FillValue" not in file[each].ncattrs()


def test_packed_numbers_are_decoded(parameters, tmp_path):
    grid = tb.grid(**AXES, parameters=parameters)
    packed = {"dtype": "int32", "scale_factor": 1e-9, "_FillValue": -2147483647}
    along = {"dtype": "int64", "scale_factor": 1e-13, "add_offset": 1e-6}
    encoding = {"particle_contact_area_ratio": packed, "load": along}
    with warnings.catch_warnings(action="ignore"):  # of xarray before 2026.9
        grid.to_netcdf(tmp_path / "packed.nc", encoding=encoding)
    expected, found = xr.load_dataset(tmp_path / "packed.nc"), read_plain(tmp_path / "packed.nc")
    for name in encoding:
        np.testing.assert_allclose(found[name].values, expected[name].values, rtol=1e-12)
        assert not {"scale_factor", "add_offset"} & found[name].attrs.keys()


def test_a_grid_in_memory_and_in_a_file_say_the_version(tmp_path, parameters):
    axes = dict(load_N=[1, 10], viscosity_cSt=0, roughness_nm=300, parameters=parameters)
    axes |= dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    tb.stream(tmp_path / "grid.nc", **axes)
    with xr.open_dataset(tmp_path / "grid.nc") as streamed:
        assert streamed.attrs["software_version"] == tb.__version__
    assert tb.grid(**axes).attrs["software_version"] == tb.__version__
