"""The speed as a condition: U in Eq. 8 has the product of viscosity and speed alone."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from methods import ENGINEERING
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody import answers
from thirdbody.ensembles import PAPER_SETUP, Ensemble
from thirdbody.variables import QUANTITIES

pytestmark = pytest.mark.filterwarnings("error")
LAYER = dict(particle_diameter_nm=500.0, roughness_nm=300.0, particle_density_per_m2=1e11)


@pytest.fixture(scope="module")
def parameters(parameters):
    """The usual inputs, in an oil whose density is known."""
    return Ensemble((parameters,), PAPER_SETUP)


@pytest.fixture(scope="module")
def speed(parameters):
    """The speed of the inputs [m/s]."""
    return parameters.speed


def test_a_speed_is_the_product_with_the_viscosity(parameters, speed):
    ratios = np.array([0.25, 1.0, 4.0])
    one = tb.solve(**ENGINEERING, speed_m_per_s=ratios * speed, parameters=parameters)
    viscosities = {"viscosity_cSt": ratios * ENGINEERING["viscosity_cSt"]}
    other = tb.solve(**ENGINEERING | viscosities, parameters=parameters)
    for name in QUANTITIES:
        assert_allclose(getattr(one, name), getattr(other, name), rtol=1e-9)
    table = one.to_dataframe()
    assert table["speed_m_per_s"].tolist() == (ratios * speed).tolist()
    assert set(table["viscosity_cSt"]) == {90.0}
    assert one.to_dataset()["speed"].attrs["units"] == "m s-1"


def test_a_speed_of_the_bearing_is_that_of_its_oil(parameters):
    inputs = tb.bearing(parameters, speed_m_per_s=2.0, oil_density_kg_per_m3=870.0)
    assert inputs.speed == pytest.approx(2.0)
    one = tb.solve(**ENGINEERING, parameters=inputs).separation
    assert_allclose(tb.solve(**ENGINEERING, speed_m_per_s=2.0, parameters=inputs).separation, one)
    faster = tb.bearing(parameters, speed_m_per_s=3.0, oil_density_kg_per_m3=870.0)
    other = tb.solve(**ENGINEERING, speed_m_per_s=3.0, parameters=inputs).separation
    assert_allclose(tb.solve(**ENGINEERING, parameters=faster).separation, other)


def test_members_of_a_bearing_have_its_oil():
    inputs = tb.bearing(speed_m_per_s=2.0, oil_density_kg_per_m3=870.0).changed(truncation=3.0)
    assert inputs.members
    for member in inputs:
        assert member.speed == pytest.approx(2.0)
    without = answers.state(inputs, ENGINEERING)
    at_speed = answers.state(inputs, ENGINEERING | {"speed_m_per_s": 2.0})
    for column in ("low", "high"):
        assert_allclose(at_speed[column], without[column], rtol=1e-9)


def test_a_grid_over_speeds_has_six_axes(parameters, speed):
    axes = dict(load_N=[1.0, 10.0], viscosity_cSt=[0.0, 45.0, 90.0], **LAYER)
    speeds = speed * np.array([1.0, 2.0])
    dataset = tb.grid(**axes, speed_m_per_s=speeds, parameters=parameters)
    assert dict(dataset.sizes) == {
        **dict(load=2, viscosity=3, speed=2, particle_diameter=1, roughness=1, particle_density=1)
    }
    loads = np.array([1.0, 10.0])[:, None, None]
    viscosities = np.array([0.0, 45.0, 90.0])[:, None]
    solution = tb.solve(
        **axes | {"load_N": loads, "viscosity_cSt": viscosities},
        speed_m_per_s=speeds,
        parameters=parameters,
    )
    assert_allclose(dataset["separation"].squeeze(), solution.separation, rtol=2e-9)
    one = dataset.sel(viscosity=45e-6, speed=speeds[1])["separation"]
    assert_allclose(one, dataset.sel(viscosity=90e-6, speed=speeds[0])["separation"])


def test_searches_along_the_speed_are_those_along_the_viscosity(parameters, speed):
    loads = dict(load_N=[5.0, 10.0], parameters=parameters)
    ends = np.array([0.1, 40.0])
    one = tb.transitions("speed_m_per_s", between=ends, viscosity_cSt=90.0, **loads, **LAYER)
    other = tb.transitions("viscosity_cSt", between=90.0 * ends / speed, **loads, **LAYER)
    assert len(one) and (one[["before", "after"]] == other[["before", "after"]]).all().all()
    assert_allclose(one["speed_m_per_s"] * 90.0, other["viscosity_cSt"] * speed, rtol=1e-7)
    faster = tb.find(
        "solid_load_fraction", 0.5, "viscosity_cSt", speed_m_per_s=2.0 * speed, **loads, **LAYER
    )
    slower = tb.find("solid_load_fraction", 0.5, "viscosity_cSt", **loads, **LAYER)
    assert_allclose(2.0 * faster["viscosity_cSt"], slower["viscosity_cSt"], rtol=1e-7)


@pytest.mark.parametrize("viscosity", [0.0, [50.0, 90.0]])
def test_a_speed_is_sought_for_one_oil(parameters, viscosity):
    with pytest.raises(ValueError, match="viscosity_cSt is not one positive number"):
        tb.transitions(
            "speed_m_per_s", viscosity_cSt=viscosity, load_N=10, parameters=parameters, **LAYER
        )


def test_a_speed_is_one_of_the_five_kinds(parameters, speed):
    speeds = [speed, 2.0 * speed]
    expected = tb.solve(**ENGINEERING, speed_m_per_s=speeds, parameters=parameters).separation
    for values in (pd.Series(speeds), xr.DataArray(speeds, dims="run")):
        solution = tb.solve(**ENGINEERING, speed_m_per_s=values, parameters=parameters)
        assert_allclose(solution.separation, expected)
    with pytest.raises(ValueError, match="speed_m_per_s is -1; allowed: zero or positive"):
        tb.solve(**ENGINEERING, speed_m_per_s=-1.0, parameters=parameters)


def test_at_rest_there_is_no_film(parameters):
    dry = tb.solve(**ENGINEERING | {"viscosity_cSt": 0.0}, parameters=parameters)
    at_rest = tb.solve(**ENGINEERING, speed_m_per_s=0.0, parameters=parameters)
    assert at_rest.separation == dry.separation and at_rest.fluid_load_fraction == 0.0


def test_friction_falls_as_the_film_takes_the_load(parameters):
    """The Stribeck curve, with constant coefficients of the solids and of the film."""
    speeds = np.geomspace(0.01, 100.0, 40)
    solution = tb.solve(**ENGINEERING, speed_m_per_s=speeds, parameters=parameters)
    friction = 0.12 * solution.solid_load_fraction + 0.03 * solution.fluid_load_fraction
    assert friction[0] == pytest.approx(0.12, rel=1e-3) and (np.diff(friction) < 1e-6).all()
    assert friction[-1] == pytest.approx(0.03, rel=0.05)
