"""Quantities of other packages and arrays that name their unit: converted, or refused in one line."""

import numpy as np
import pandas as pd
import pint
import pytest
import xarray as xr

import thirdbody as tb
from thirdbody.units import UNITS

POINT = dict(load_N=10, viscosity_cSt=90, particle_diameter_nm=500, roughness_nm=300)
POINT["particle_density_per_m2"] = 1e11
SI = dict(load=1e-5, viscosity=9e-5, particle_diameter=5e-7, roughness=3e-7, particle_density=1e11)
UNIT = pint.UnitRegistry()


def astropy(value, text):
    units = pytest.importorskip("astropy.units")
    return value * units.Unit(text)


def unyt(value, text):
    return pytest.importorskip("unyt").unyt_quantity(value, text)


def quantities(value, text):
    return pytest.importorskip("quantities").Quantity(value, text)


def of_pint(value, text):
    return UNIT.Quantity(value, text)


def of_xarray(value, text):
    return xr.DataArray(np.array([value]), dims="x", attrs={"units": text})


PACKAGES = [astropy, unyt, quantities, of_pint, of_xarray]


@pytest.fixture
def solved(parameters):
    return lambda **given: np.ravel(
        tb.solve(**SI | given, parameters=parameters).particle_contact_area_ratio
    )


@pytest.mark.parametrize("package", PACKAGES)
def test_a_quantity_of_any_package_is_converted(solved, package):
    assert solved(particle_density=package(1e5, "1/mm**2")) == pytest.approx(solved())
    assert solved(particle_diameter=package(0.5, "um")) == pytest.approx(solved())


@pytest.mark.parametrize("package", PACKAGES)
def test_a_force_is_a_load(solved, parameters, package):
    expected = solved(load=10.0 / parameters.newtons_per_load)
    assert solved(load=package(0.01, "kN")) == pytest.approx(expected)


@pytest.mark.parametrize("package", PACKAGES)
def test_a_quantity_of_another_dimension_is_refused_in_one_line(solved, package):
    with pytest.raises(ValueError, match=r"^roughness is in kg; allowed: a length, as in nm$"):
        solved(roughness=package(1.0, "kg"))


@pytest.mark.parametrize(
    ("name", "value", "text"),
    [
        ("viscosity", 90.0, "mm2 s-1"),
        ("viscosity", 90.0, "cSt"),
        ("particle_density", 1e5, "mm-2"),
        ("load", 1e-5, "1"),
        ("load", 1e-5, ""),
    ],
)
def test_units_are_read_as_udunits_writes_them(solved, name, value, text):
    assert solved(**{name: of_xarray(value, text)}) == pytest.approx(solved())


def test_an_unknown_unit_is_refused_in_one_line(solved):
    told = "roughness has the unit 'furlong per fun', which is unknown; allowed: a length"
    with pytest.raises(ValueError, match=told):
        solved(roughness=of_xarray(1.0, "furlong per fun"))


def test_variables_of_datasets_are_taken_with_their_units(parameters):
    dataset = tb.grid(**POINT | {"load_N": [5, 10]}, parameters=parameters)
    others = {name: dataset[name].item() for name in SI if name != "load"}
    found = tb.solve(load=dataset["normal_load"], **others, parameters=parameters)
    np.testing.assert_allclose(found.separation, dataset["separation"].squeeze(), rtol=1e-9)


def test_columns_of_pint_pandas_are_refused_with_what_to_give_instead(solved):
    pytest.importorskip("pint_pandas")
    column = pd.Series([0.3, 0.5], dtype="pint[um]")
    with pytest.raises(ValueError, match=r"Series of pandas; allowed: \.pint\.quantity of it"):
        solved(particle_diameter=column)
    expected = solved(particle_diameter=[3e-7, 5e-7])
    for taken in (column.pint.quantity, column.to_numpy(), column.to_xarray()):
        assert solved(particle_diameter=taken) == pytest.approx(expected)


def test_arrays_of_quantities_are_converted(solved):
    given = np.array([UNIT.Quantity(300, "nm"), UNIT.Quantity(0.5, "um")], dtype=object)
    assert solved(particle_diameter=given) == pytest.approx(solved(particle_diameter=[3e-7, 5e-7]))


def test_an_uncertainty_is_refused_by_name(solved):
    uncertain = pytest.importorskip("uncertainties").ufloat(10, 1)
    with pytest.raises(ValueError, match="^load is a quantity of .*; allowed: plain numbers$"):
        solved(load=UNIT.Quantity(uncertain, "N"))


def test_every_entry_takes_quantities(parameters):
    given = {"load_N": 0.01 * UNIT.kN, "roughness_nm": 0.3 * UNIT.um}
    interface = tb.Interface(**POINT | given)
    assert interface == tb.Interface(**POINT)
    assert interface.described().startswith("load 10 N, viscosity 90 cSt")
    grid = tb.grid(**POINT | given, parameters=parameters)
    xr.testing.assert_identical(grid, tb.grid(**POINT, parameters=parameters))
    search = dict(level=0.9, along="viscosity_cSt", parameters=parameters)
    named = {name: value for name, value in POINT.items() if name != "viscosity_cSt"}
    one, other = (
        tb.find("solid_load_fraction", **search, **each).first for each in (named, named | given)
    )
    assert one == pytest.approx(other, rel=1e-9)


@pytest.mark.parametrize("key", UNITS)
def test_a_unit_turns_into_si_and_back(key):
    unit = UNITS[key]
    assert unit.from_si(unit.to_si(325.0, 1e6), 1e6) == pytest.approx(325.0, rel=1e-12)
