"""Ranges of the ensemble: 5 to 95 % of the members at each point, wherever the curve is."""

import json
import warnings
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from small_release import KEYS

from chenhorng.ensemble_range import MEMBER_RTOL, ensemble_range
from chenhorng.scenes import scene_dataset
from thirdbody.curves import Condition
from thirdbody.netcdf import FILL_FLAG, read_plain, write_dataset
from thirdbody.points import solve
from thirdbody.variables import DIMENSIONS, QUANTITIES

DENSITY = 1e11
GROUPS = ([0, 90], [500], [300], [DENSITY]), ([0], [0], [300], [DENSITY])
SCENE = {
    "title": "A few curves",
    "load_axis": {"load_N": [0.04, 80.0], "count": 12},
    "curves": [dict(zip(KEYS, group, strict=True)) for group in GROUPS],
}
MEMBERS = [{"participation": each} for each in (0.015, 0.02, 0.025, 0.03)]
MEMBERS += [{"spread_ratio": 1.5, "summit_radius": 25e-6}]


@pytest.fixture(scope="module")
def dataset(parameters, tmp_path_factory):
    path = tmp_path_factory.mktemp("range") / "scene.nc"
    write_dataset(scene_dataset(SCENE, parameters), path)
    return read_plain(path).to_xarray()


@pytest.fixture(scope="module")
def around(dataset, parameters):
    return ensemble_range(dataset, parameters, MEMBERS)


PLACE = 90e-6, 500e-9, 300e-9, DENSITY
DRY = (0.0, *PLACE[1:])


def at_place(dataset, name, place=PLACE):
    """A variable along the load where the conditions are those of ``place``."""
    axes = zip(DIMENSIONS[1:], place, strict=True)
    index = [int(np.argmax(dataset[axis].values == value)) for axis, value in axes]
    return dataset[name].values[(slice(None), *index)]


def test_the_range_reaches_from_5_to_95_percent_of_the_members(dataset, parameters, around):
    load = dataset["load"].values
    solved = [
        solve(load=load, **Condition(*PLACE)._asdict(), parameters=replace(parameters, **member))
        for member in MEMBERS
    ]
    for name in QUANTITIES:
        ordered = np.sort([getattr(each, name) for each in solved], axis=0)
        # of five members the quantiles are a fifth of the way from the ends to those next to them
        low = 0.8 * ordered[0] + 0.2 * ordered[1]
        high = 0.8 * ordered[-1] + 0.2 * ordered[-2]
        assert_allclose(at_place(around, f"{name}_low"), low, rtol=2 * MEMBER_RTOL)
        assert_allclose(at_place(around, f"{name}_high"), high, rtol=2 * MEMBER_RTOL)


def test_the_curve_itself_takes_no_part_in_its_range(dataset, parameters):
    found = ensemble_range(dataset, parameters, [{"participation": 0.03}, {"participation": 0.04}])
    high = at_place(found, "surface_contact_area_ratio_high")
    curve = at_place(dataset, "surface_contact_area_ratio")
    assert (high < (1.0 - 10 * MEMBER_RTOL) * curve).all()


def test_members_are_compared_at_the_same_dimensionless_load(dataset, parameters):
    # dry contact knows F_t* alone; a film also knows the apparent area
    smaller = {"apparent_area": 0.3 * parameters.apparent_area}
    other = ensemble_range(dataset, parameters, [{}, smaller])
    width = other["separation_high"].values - other["separation_low"].values
    dry, lubricated = (width[:, index, 1, 0, 0] for index in (0, 1))
    separation = dataset["separation"].values[:, 0, 1, 0, 0]
    assert (dry <= 2 * MEMBER_RTOL * separation).all()
    assert lubricated.max() > 0.01 * separation.min()
    assert_array_equal(other["normal_load"].values, dataset["normal_load"].values)


def test_a_member_without_a_solution_does_not_count(dataset, parameters):
    # large particles that all take part cover more than there is
    blind = {"participation": 1.0, "spread_ratio": 10.0, "truncation": 5.0}
    conditions = dict(zip(DIMENSIONS, (dataset["load"].values, *DRY)))
    assert np.isnan(solve(**conditions, parameters=replace(parameters, **blind)).separation).all()
    found = ensemble_range(dataset, parameters, [blind, {}])
    for end in ("low", "high"):
        separation = at_place(found, f"separation_{end}", DRY)
        assert_allclose(separation, at_place(dataset, "separation", DRY), rtol=2 * MEMBER_RTOL)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        alone = ensemble_range(dataset, parameters, [blind])
    assert np.isnan(at_place(alone, "separation_low", DRY)).all()


def test_a_band_lies_around_the_shown_points_and_keeps_their_units(dataset, around, tmp_path):
    write_dataset(around, tmp_path / "range.nc")
    again = read_plain(tmp_path / "range.nc").to_xarray()
    shown = dataset["solution_status"].values != FILL_FLAG
    for name in QUANTITIES:
        low, high = again[f"{name}_low"], again[f"{name}_high"]
        assert (low.values[shown] <= high.values[shown]).all()
        for variable in (low, high):
            assert variable.dims == DIMENSIONS
            assert variable.attrs["units"] == dataset[name].attrs["units"]
            assert_array_equal(np.isfinite(variable.values), shown)
    sentences = dataset.attrs["summary"].split(". ")[0], "For each quantity, at the points of"
    assert [again.attrs["summary"].find(each) == 0 for each in sentences] == [True, False]
    assert sentences[1] in again.attrs["summary"]
    assert "0.05 quantile" in again["separation_low"].attrs["long_name"]
    assert "0.95 quantile" in again["separation_high"].attrs["long_name"]
    assert json.loads(again.attrs["ensemble"]) == MEMBERS
    assert again.attrs["configuration_sha256"] != dataset.attrs["configuration_sha256"]
    assert again.attrs["id"] != dataset.attrs["id"]


def test_an_area_over_that_of_two_body_contact_is_one_ratio_of_each_member(dataset, parameters):
    name, place = "total_contact_area_over_two_body", (0.0, 0.0, *PLACE[2:])
    solved = [
        solve(load=dataset["load"].values, **Condition(*each)._asdict(), parameters=inputs)
        for inputs in (replace(parameters, **member) for member in MEMBERS[:2])
        for each in (PLACE, place)
    ]
    one, two_body, other, other_two_body = (each.total_contact_area for each in solved)
    ratios = np.sort([one / two_body, other / other_two_body], axis=0)
    found = ensemble_range(dataset, parameters, MEMBERS[:2])
    low, high = (at_place(found, f"{name}_{end}") for end in ("low", "high"))
    assert_allclose(low, 0.95 * ratios[0] + 0.05 * ratios[1], rtol=4 * MEMBER_RTOL)
    assert_allclose(high, 0.05 * ratios[0] + 0.95 * ratios[1], rtol=4 * MEMBER_RTOL)
    assert_allclose(at_place(found, f"{name}_high", place), 1.0, rtol=1e-12)


def test_without_two_body_contact_no_area_is_compared_with_it(parameters, tmp_path):
    scene = SCENE | {"curves": SCENE["curves"][:1]}
    write_dataset(scene_dataset(scene, parameters), tmp_path / "scene.nc")
    alone = read_plain(tmp_path / "scene.nc")
    found = ensemble_range(alone, parameters, MEMBERS[:1]).variables
    assert not any("over_two_body" in name for name in found)
