"""Bands: they enclose the curves they belong to, by as much as the members reach and no more."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from small_release import KEYS

from thirdbody import solve
from thirdbody.data.conditions import Condition
from thirdbody.data.dataset import scene_dataset
from thirdbody.data.netcdf import read_plain, write_dataset
from thirdbody.data.quantities import FILL_FLAG
from thirdbody.study.band import BAND_RTOL, band
from thirdbody.variables import DIMENSIONS, QUANTITIES

DENSITY = 1e11
GROUPS = ([0, 90], [500], [300], [DENSITY]), ([0], [0], [300], [DENSITY])
SCENE = {
    "title": "A few curves",
    "load_axis": {"load_N": [0.04, 80.0], "count": 12},
    "curves": [dict(zip(KEYS, group, strict=True)) for group in GROUPS],
}
MEMBERS = [{"participation": 0.03}, {"spread_ratio": 1.5, "summit_radius": 25e-6}]


@pytest.fixture(scope="module")
def dataset(parameters, tmp_path_factory):
    path = tmp_path_factory.mktemp("band") / "scene.nc"
    write_dataset(scene_dataset(SCENE, parameters), path)
    return read_plain(path).to_xarray()


@pytest.fixture(scope="module")
def envelope(dataset, parameters):
    return band(dataset, parameters, MEMBERS)


def test_band_reaches_from_the_lowest_to_the_highest_member(dataset, parameters, envelope):
    load = dataset["load"].values
    conditions = 90e-6, 500e-9, 300e-9, DENSITY
    place = [int(np.argmax(dataset[n].values == v)) for n, v in zip(DIMENSIONS[1:], conditions)]
    members = [parameters, *(replace(parameters, **member) for member in MEMBERS)]
    for name in QUANTITIES:
        solved = [
            getattr(solve(load=load, **Condition(*conditions)._asdict(), parameters=one), name)
            for one in members
        ]
        for end, reduced in (("low", np.min(solved, axis=0)), ("high", np.max(solved, axis=0))):
            found = envelope[f"{name}_{end}"].values[(slice(None), *place)]
            assert_allclose(found, reduced, rtol=2 * BAND_RTOL)


def test_members_are_compared_at_the_same_dimensionless_load(dataset, parameters):
    # dry contact knows F_t* alone; a film also knows the apparent area
    other = band(dataset, parameters, [{"apparent_area": 0.3 * parameters.apparent_area}])
    width = other["separation_high"].values - other["separation_low"].values
    dry, lubricated = (width[:, index, 1, 0, 0] for index in (0, 1))
    separation = dataset["separation"].values[:, 0, 1, 0, 0]
    assert (dry <= 2 * BAND_RTOL * separation).all()
    assert lubricated.max() > 0.01 * separation.min()
    assert_array_equal(other["normal_load"].values, dataset["normal_load"].values)


def test_member_without_a_solution_leaves_the_band_as_it_is(dataset, parameters):
    # large particles that all take part cover more than there is
    blind = {"participation": 1.0, "spread_ratio": 10.0, "truncation": 5.0}
    conditions = dict(zip(DIMENSIONS, (dataset["load"].values, 0.0, 500e-9, 300e-9, DENSITY)))
    assert np.isnan(solve(**conditions, parameters=replace(parameters, **blind)).separation).all()
    found = band(dataset, parameters, [blind])["separation_high"].values[:, 0, 1, 0, 0]
    assert_array_equal(found, dataset["separation"].values[:, 0, 1, 0, 0])


def test_band_encloses_its_curves_and_keeps_their_units(dataset, parameters, envelope, tmp_path):
    write_dataset(envelope, tmp_path / "band.nc")
    again, alone = read_plain(tmp_path / "band.nc").to_xarray(), band(dataset, parameters, [])
    shown = dataset["solution_status"].values != FILL_FLAG
    for name in QUANTITIES:
        low, high = again[f"{name}_low"], again[f"{name}_high"]
        values = dataset[name].values[shown]
        assert (low.values[shown] <= values).all() and (values <= high.values[shown]).all()
        for variable in (low, high):
            assert_array_equal(alone[variable.name].values[shown], values)  # without members
            assert variable.dims == DIMENSIONS
            assert variable.attrs["units"] == dataset[name].attrs["units"]
            assert_array_equal(np.isfinite(variable.values), shown)
    assert again.attrs["configuration_sha256"] != dataset.attrs["configuration_sha256"]
