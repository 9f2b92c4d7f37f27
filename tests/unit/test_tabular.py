"""Every result of a public function is a table: for pandas, for xarray and in notebooks."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import thirdbody as tb

REST = dict(particle_diameter_nm=500, roughness_nm=300, particle_density_per_m2=1e11)
OIL = {"viscosity_cSt": 90}


def interface():
    return tb.Interface(load_N=10, **OIL, **REST)


def data():
    return pd.DataFrame({"load [N]": [5, 10], "solid load fraction": [0.9, 0.7]})


RESULTS = {  # and how many rows each has
    "solve": (lambda: tb.solve(load_N=[5, 10], **OIL, **REST), 2),
    "find": (lambda: tb.find("solid_load_fraction", [0.5, 0.9], "load_N", **OIL, **REST), 2),
    "transitions": (lambda: tb.transitions("viscosity_cSt", load_N=10, **REST), 5),
    "turning_point": (lambda: tb.turning_point(viscosity_cSt=[0, 90], **REST), 2),
    "turning_window": (
        lambda: tb.turning_window(roughness_nm=300, particle_density_per_m2=1e11),
        1,
    ),
    "state": (lambda: interface().state(), 10),
    "curve": (lambda: interface().curve("load", 5, 10, count=3), 3),
    "compare": (lambda: tb.compare(data(), **OIL, **REST), 2),
    "cleanliness": (lambda: tb.cleanliness("18/16/13", gap_nm=1000), 6),
}


@pytest.mark.parametrize("name", RESULTS)
def test_a_result_is_a_table(name):
    function, rows = RESULTS[name]
    found = function()
    table = found.to_dataframe()
    assert isinstance(table, pd.DataFrame) and len(table) == rows
    dataset = found.to_dataset()
    assert isinstance(dataset, xr.Dataset) and list(dataset.sizes.values()) == [rows]
    assert "<table" in found._repr_html_() or "xr-wrap" in found._repr_html_()


def test_no_transition_is_an_empty_table():
    none = tb.transitions("viscosity_cSt", load_N=10, between=(1, 1.1), **REST)
    assert list(none) == [] and "value" in none.to_dataframe().columns


def test_the_load_stands_in_newtons_beside_the_dimensionless_one(defaults):
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
        np.testing.assert_allclose(found.to_dataframe()["normal_load"], expected, rtol=1e-12)
    one = tb.solve(load_N=10, viscosity_cSt=[0, 90], **REST).to_dataset()
    assert one["normal_load"].item() == pytest.approx(10.0)
