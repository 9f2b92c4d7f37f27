"""Quantities of other packages and arrays that name their unit: converted, or refused in one line."""

from functools import partial
from types import SimpleNamespace

import numpy as np
import pint
import pytest
import xarray as xr
from methods import ENGINEERING, POINT

import thirdbody as tb
from thirdbody.measured.estimates import Assumed

UNIT = pint.UnitRegistry()


def of_xarray(value, text):
    return xr.DataArray(np.array([value]), dims="x", attrs={"units": text})


PACKAGES = {
    "astropy.units": lambda module, value, text: value * module.Unit(text),
    "unyt": lambda module, value, text: module.unyt_quantity(value, text),
    "quantities": lambda module, value, text: module.Quantity(value, text),
    "pint": lambda module, value, text: UNIT.Quantity(value, text),
    "xarray": lambda module, value, text: of_xarray(value, text),
}


@pytest.fixture
def solved(parameters):
    return lambda **given: np.ravel(
        tb.solve(**POINT | given, parameters=parameters).particle_contact_area_ratio
    )


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


def test_an_unknown_unit_and_an_uncertainty_are_refused_by_name(solved):
    message = "roughness has the unknown unit 'furlong per fun'; allowed: a length"
    with pytest.raises(ValueError, match=message):
        solved(roughness=of_xarray(1.0, "furlong per fun"))
    uncertain = pytest.importorskip("uncertainties").ufloat(10, 1)
    message = "^load is a quantity of .*; allowed: plain numbers, such as the nominal value$"
    with pytest.raises(ValueError, match=message):
        solved(load=UNIT.Quantity(uncertain, "N"))
    uncertain = pytest.importorskip("quantities").UncertainQuantity(10, "N", 1)
    for given in (uncertain, SimpleNamespace(unit="N", mask=[True])):  # as Masked of astropy
        with pytest.raises(ValueError, match="^load has uncertainties or masked values; allowed: "):
            solved(load=given)


def test_every_entry_takes_quantities(parameters):
    given = {"load_N": 0.01 * UNIT.kN, "roughness_nm": 0.3 * UNIT.um}
    interface = tb.Interface(**ENGINEERING | given)
    assert interface == tb.Interface(**ENGINEERING)
    assert interface.described().startswith("load 10 N, viscosity 90 cSt")
    assert tb.Interface(**POINT, parameters=parameters).changed(load_N=10).viscosity_cSt == 90.0
    grid = tb.grid(**ENGINEERING | given, parameters=parameters)
    xr.testing.assert_identical(grid, tb.grid(**ENGINEERING, parameters=parameters))
    search = dict(level=0.9, along="viscosity_cSt", parameters=parameters)
    named = {name: value for name, value in ENGINEERING.items() if name != "viscosity_cSt"}
    one, other = (
        tb.find("solid_load_fraction", **search, **each).first for each in (named, named | given)
    )
    assert one == pytest.approx(other, rel=1e-9)


def test_several_quantities_are_converted_once(parameters):
    loads = [10.0 * UNIT.N, 0.02 * UNIT.kN]
    array = np.array([10.0, 20.0]) * UNIT.N
    of_pandas = SimpleNamespace(quantity=array)  # an array of pint-pandas
    given = {key: value for key, value in ENGINEERING.items() if key != "load_N"}
    expected = tb.solve(**given, load_N=[10.0, 20.0], parameters=parameters).solid_load_fraction
    for each in (loads, [loads], np.array(loads, object), xr.DataArray(array, dims="x"), of_pandas):
        for name in ("load", "load_N"):
            found = tb.solve(**given, **{name: each}, parameters=parameters).solid_load_fraction
            np.testing.assert_allclose(np.ravel(found), expected, rtol=1e-9)


def test_ends_of_a_search_take_quantities_and_warn_in_the_unit_typed(parameters):
    ends = 1e-6 * UNIT.m**2 / UNIT.s, 100 * UNIT.cSt
    interface = tb.Interface(**ENGINEERING)
    assert interface.transitions("viscosity", between=ends).notes[0].endswith("1 to 100 cSt")
    assert interface.curve("load", 10 * UNIT.N, 20 * UNIT.N, count=2).points.tolist() == [10, 20]
    search = {"variable": "separation", "along": "viscosity_cSt", **ENGINEERING}
    del search["viscosity_cSt"]
    with pytest.warns(tb.OutOfRangeWarning, match="^between is 1e-06 cSt; usual: 0.3 to 10000 cSt"):
        tb.find(level=1e-6, between=(1e-6, 1e-4), parameters=parameters, **search)
    with pytest.raises(ValueError, match="^level of separation is 900; allowed: 0 to 0.01 m$"):
        tb.find(level=900, parameters=parameters, **search)
    with pytest.warns(tb.OutOfRangeWarning, match="^load is 10 MN; usual: .* MN$"):
        tb.solve(**POINT | {"load": [10.0 * UNIT.MN, 20.0 * UNIT.MN]}, parameters=parameters)


@pytest.mark.parametrize("package", PACKAGES)
def test_a_quantity_of_any_package_is_converted_or_refused_in_one_line(solved, parameters, package):
    make = partial(PACKAGES[package], pytest.importorskip(package))
    assert solved(particle_density=make(1e5, "1/mm**2")) == pytest.approx(solved())
    assert solved(particle_diameter=make(0.5, "um")) == pytest.approx(solved())
    expected = solved(load=10.0 / parameters.newtons_per_load)
    assert solved(load=make(0.01, "kN")) == pytest.approx(expected)
    with pytest.raises(ValueError, match=r"^roughness is in kg; allowed: a length, e.g. in nm$"):
        solved(roughness=make(1.0, "kg"))


KELVIN = 333.15


@pytest.mark.parametrize("package", [each for each in PACKAGES if each != "xarray"])
def test_numbers_with_a_unit_in_their_name_take_quantities(package):
    make = partial(PACKAGES[package], pytest.importorskip(package))
    inputs = tb.bearing(ball_radius_mm=make(0.5, "cm"))
    assert inputs.ball_radius == pytest.approx(5e-3)
    steel = dict(elastic_modulus_surfaces=make(112.0, "GPa"), hardness_parameter=0.04)
    steel |= dict(material_parameter=2038.0, speed_per_viscosity=4.87e-6)
    assert tb.load_parameters(**steel).elastic_modulus_surfaces == pytest.approx(112e9)
    in_um, in_nm = (
        tb.cleanliness("18/16/13", gap_nm=gap).value("most_above_4_um")
        for gap in (make(1.0, "um"), 1000.0)
    )
    assert in_um == pytest.approx(in_nm)
    assert Assumed(resistivity_ohm_m=make(2e-7, "ohm*m")) == Assumed(resistivity_ohm_m=2e-7)
    warm = tb.oil_viscosity(make(KELVIN, "K"), grade=46)
    assert warm == pytest.approx(tb.oil_viscosity(60, grade=46))
    with pytest.raises(ValueError, match="^ball_radius_mm is .*; allowed: a quantity in mm$"):
        tb.bearing(ball_radius_mm=make(1.0, "s"))


def test_degrees_of_any_package_are_celsius():
    astropy = pytest.importorskip("astropy.units")
    warm = tb.oil_viscosity(np.array([60.0, 80.0]) * astropy.deg_C, grade=46)
    assert warm == pytest.approx(tb.oil_viscosity([60, 80], grade=46))
