"""Datasets exactly as the data contract says, on disk and in memory."""

import re
import runpy
from dataclasses import replace
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray as xr
from numpy.testing import assert_allclose
from small_release import KEYS

import thirdbody as tb
from chenhorng.scenes import scene_dataset, scene_groups
from thirdbody.core.regimes import SOLUTION_STATUSES
from thirdbody.grids import crossed
from thirdbody.netcdf import FILL_FLAG, FILL_FLOAT, read_plain, write_dataset
from thirdbody.variables import FLAGS, NUMBERS

ROOT = Path(__file__).parents[2]
AXES = {
    "load": [1e-6, 1e-5, 1e-4],
    "viscosity": [0.0, 90e-6],
    "particle_diameter": [0.0, 3e-7],
    "roughness": [1e-7, 3e-7],
    "particle_density": [1e11],
}
SCENE = {
    "title": "Two groups",
    "load_axis": {"load_N": [0.04, 80.0], "count": 9},
    "curves": [
        dict(zip(KEYS, group, strict=True))
        for group in (([0, 90], [500], [100], [1e11]), ([0], [0, 300], [300], [1e11]))
    ],
}


def hidden(variable):
    """Where the figure shows nothing."""
    return variable.values == (FILL_FLAG if variable.name in FLAGS else FILL_FLOAT)


def grid(parameters, rtol=1e-9, **axes):
    return tb.grid(**(AXES | axes), parameters=parameters, rtol=rtol)


@pytest.fixture(scope="module")
def dataset(parameters):
    return grid(parameters)


@pytest.fixture(scope="module")
def shown(parameters):
    return scene_dataset(SCENE, parameters).to_xarray()


@pytest.fixture
def on_disk(shown, tmp_path):
    write_dataset(shown, tmp_path / "test.nc")
    return tmp_path / "test.nc"


def test_files_have_the_names_types_units_and_attributes_of_the_contract(
    on_disk, parameters, tmp_path
):
    contract = runpy.run_path(str(ROOT / "verification" / "contract.py"))
    tb.stream(tmp_path / "grid.nc", **AXES, parameters=parameters)
    # products of the workflow name no version, so the contract does not know that of a grid
    of_grid = ["unknown attribute software_version"]
    for path, findings in ((on_disk, []), (tmp_path / "grid.nc", of_grid)):
        with netCDF4.Dataset(path) as stored:
            assert list(contract["form_findings"](stored)) == findings


def test_values_are_those_of_the_solver(dataset, parameters):
    assert dict(dataset.sizes) == {name: len(values) for name, values in AXES.items()}
    solution = tb.solve(**crossed(AXES), parameters=parameters)
    for name in NUMBERS:
        assert_allclose(dataset[name].values, getattr(solution, name), rtol=2e-9)
    for name in FLAGS:
        assert (dataset[name].values == getattr(solution, name)).all()


def test_the_hash_is_that_of_axes_inputs_and_accuracy(parameters, dataset):
    again = grid(replace(parameters), **{name: np.array(axis) for name, axis in AXES.items()})
    assert again.attrs["configuration_sha256"] == dataset.attrs["configuration_sha256"]
    others = [grid(parameters, **{name: [AXES[name][-1] * 1.01]}) for name in AXES]
    others += [grid(replace(parameters, truncation=2.5)), grid(parameters, rtol=1e-8)]
    hashes = {one.attrs["configuration_sha256"] for one in (dataset, *others)}
    assert len(hashes) == 1 + len(others)


@pytest.mark.parametrize("name", AXES)
@pytest.mark.parametrize(
    "bad", [[2e-7, 1e-7], [1e-7, 1e-7], [[1e-7, 2e-7]], []], ids=["falling", "twice", "2-D", "none"]
)
def test_an_axis_that_is_not_one_increasing_dimension_is_refused_by_name(parameters, name, bad):
    with pytest.raises(ValueError, match=f"^{name} .*allowed: one increasing dimension"):
        grid(parameters, **{name: bad})


def test_a_dataset_survives_the_file(shown, on_disk, dataset, tmp_path):
    path = tmp_path / "grid.nc"
    dataset.to_netcdf(path)
    assert read_plain(path).to_xarray().equals(dataset)
    assert read_plain(path).to_xarray().attrs == dataset.attrs
    again = read_plain(on_disk).to_xarray()
    for name in (*NUMBERS, *FLAGS):
        kept = ~hidden(shown[name])
        assert np.array_equal(again[name].values[kept], shown[name].values[kept])
        unread = again[name].values[~kept]
        assert (unread == FILL_FLAG if name in FLAGS else np.isnan(unread)).all()


def test_unsolved_points_of_a_grid_do_not_hold_the_fill_value(parameters, tmp_path):
    path = tmp_path / "grid.nc"
    with pytest.warns(tb.OutOfRangeWarning, match="load is 1;"):
        tb.stream(path, **AXES | {"load": [1e-5, 1.0]}, parameters=parameters)
    with netCDF4.Dataset(path) as stored:
        for name in (*NUMBERS, *FLAGS):
            # what a reader that knows the convention takes for missing
            assert not np.ma.getmaskarray(stored[name][:]).any(), name
        exceeded = SOLUTION_STATUSES.index("load_exceeded")
        assert (stored["solution_status"][1, 0] == exceeded).all()


def flipped(content):
    """Other bytes among the compressed values: behind the first bytes of zlib's usual."""
    return re.sub(
        rb"(?s)(x\x9c.{6})(.)", lambda found: found[1] + bytes([found[2][0] ^ 255]), content
    )


DAMAGES = {
    "half": lambda content: content[: len(content) // 2],
    "all but its last byte": lambda content: content[:-1],
    "flipped bytes in its values": flipped,
    "nothing": lambda content: b"",
    "text": lambda content: b"not a dataset\n",
    "missing": None,
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_file_is_named(on_disk, damage):
    content = on_disk.read_bytes()
    on_disk.unlink()
    if DAMAGES[damage]:
        on_disk.write_bytes(DAMAGES[damage](content))
    with pytest.raises(OSError, match=rf"^{on_disk} cannot be read \(.*\)$"):
        read_plain(on_disk).to_xarray()


def test_a_figure_holds_what_the_solver_gives_and_elsewhere_the_fill_value(shown, parameters):
    without = np.ones(tuple(shown.sizes.values()), dtype=bool)
    for group in scene_groups(SCENE, parameters.newtons_per_load):
        place = np.ix_(*(np.isin(shown[name].values, values) for name, values in group.items()))
        without[place] = False
        solution = tb.solve(**crossed(group), parameters=parameters)
        for name in (*NUMBERS, *FLAGS):
            expected = getattr(solution, name).astype(shown[name].dtype)  # of states the codes
            assert np.array_equal(shown[name].values[place], expected), name
    assert without.any()
    for name in (*NUMBERS, *FLAGS):
        assert np.array_equal(hidden(shown[name]), without), name


def test_the_summary_says_how_many_curves_there_are_and_selects_one(shown, dataset, on_disk):
    summary = shown.attrs["summary"]
    curves = (~hidden(shown["separation"])).any(axis=0)
    assert f"shows {curves.sum()} of {curves.size} combinations" in summary
    (text,) = re.findall(r"(?<=dataset\.)sel\(.*?\)", summary)
    with xr.open_dataset(on_disk) as read:
        curve = eval(f"read.{text}")
        assert curve["separation"].dims == ("load",) and curve["separation"].notnull().all()
        assert read["separation"].isnull().any()
    assert "Select" not in dataset.attrs["summary"]  # a grid has all combinations
