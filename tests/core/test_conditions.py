"""What users give: numbers of every kind become SI; what would be a wrong number in silence is
refused.
"""

import warnings
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from decimal import Decimal

import numpy as np
import pandas as pd
import pint
import pytest
import xarray as xr
from methods import ENGINEERING, POINT
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody import answers
from thirdbody.conditions import from_si, read_conditions
from thirdbody.variables import AXES, FLAGS, QUANTITIES, VARIABLES

UNIT = pint.UnitRegistry()
LOADS = xr.DataArray([1e-6, 1e-5], dims="load", coords={"load": [1e-6, 1e-5]})
OILS = xr.DataArray([0.0, 90e-6], dims="oil", coords={"oil": ["none", "VG 90"]})


@pytest.fixture(scope="module")
def parameters(parameters):
    """The usual inputs, with summits on surfaces of any roughness."""
    return replace(parameters, summit_parameter_exponent=0.0)


@pytest.fixture
def solve(parameters):
    return lambda **given: tb.solve(**POINT | {"parameters": parameters} | given)


@pytest.fixture
def read(parameters):
    """SI values of one condition."""
    return lambda key, value: read_conditions(
        {name: number for name, number in POINT.items() if not key.startswith(name)} | {key: value},
        parameters,
    ).with_load(parameters)[next(name for name in POINT if key.startswith(name))]


def of_xarray(value, text):
    return xr.DataArray(np.array([value]), dims="x", attrs={"units": text})


def assert_same(found, expected):
    for name in QUANTITIES:
        assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-12, err_msg=name)
    for name in FLAGS:
        assert (getattr(found, name) == getattr(expected, name)).all(), name


# ---- the five kinds


@pytest.mark.parametrize(
    "value",
    [
        [300, 500],
        (300.0, np.float32(500.0)),
        [[300], [500]],
        np.array([300, 500], np.int16),
        pd.Series([300, 500]),
        pd.Series([300, 500], dtype="Int64"),
        xr.DataArray([300, 500], dims="x"),
        xr.Variable("x", [300, 500]),
        xr.DataArray([0.3, 0.5], dims="x", attrs={"units": "um"}),
        np.array([0.3, 0.5]) * UNIT.um,
        [3e-7, 5e-7] * UNIT.m,
        xr.DataArray(np.array([0.3, 0.5]) * UNIT.um, dims="x"),
    ],
    ids=lambda value: f"{type(value).__name__}",
)
def test_each_kind_of_numbers_is_the_same_in_si(read, value):
    roughness = read("roughness_nm", value)
    assert roughness.ravel().tolist() == [3e-7, 5e-7]  # the decimal numbers
    assert roughness.dtype == float


@pytest.mark.parametrize("value", [300, 300.0, np.int16(300), np.array(300), 0.3 * UNIT.um])
def test_a_single_number_has_no_dimension(read, value):
    assert read("roughness_nm", value).shape == ()


@pytest.mark.parametrize(
    ("name", "value", "text"),
    [
        ("viscosity", 90.0, "mm2 s-1"),
        ("viscosity", 90.0, "cSt"),
        ("particle_density", 1e5, "mm-2"),
        ("load", 1e-5, "1"),
    ],
)
def test_units_of_xarray_are_read_as_udunits_writes_them(read, name, value, text):
    assert_allclose(read(name, of_xarray(value, text)), POINT[name])


@pytest.mark.parametrize("text", ["N**(9**9**9)", "9**9**9", "__import__('os')", "N;m", ""])
def test_a_unit_is_a_product_of_powers_and_nothing_is_evaluated(read, text):
    with pytest.raises(ValueError, match="^load is in "):
        read("load", of_xarray(1e-5, text))


def test_a_force_is_a_load_under_either_name(read, parameters):
    expected = 10.0 / parameters.newtons_per_load
    for key in ("load", "load_N"):
        assert_allclose(read(key, 0.01 * UNIT.kN), expected)
    assert_allclose(read("load_N", 10.0), expected)


def test_names_and_aliases_are_the_same_place(parameters):
    newtons = parameters.newtons_per_load
    for axis in AXES.values():
        assert from_si(axis.name, 0.5, newtons) == 0.5
    loads = read_conditions(ENGINEERING, parameters).with_load(parameters)["load"]
    assert_allclose(from_si("load_N", loads, newtons), 10.0)


# ---- what is refused by its type


class WithUnit(np.ndarray):
    """An array of a package that keeps a unit beside it."""


OTHER_TYPES = [
    pytest.param(lambda: np.array([300.0]).view(WithUnit), id="array of another class"),
    pytest.param(lambda: np.ma.masked_array([300.0, 500.0], [0, 1]), id="masked"),
    pytest.param(lambda: np.ma.masked_array([300.0, 500.0]) * UNIT.nm, id="masked in pint"),
    pytest.param(lambda: [300 * UNIT.nm, 500 * UNIT.nm], id="list of quantities"),
    pytest.param(lambda: np.timedelta64(300, "ns"), id="timedelta"),
    pytest.param(lambda: np.array(["2020-01-01"], "datetime64[D]"), id="datetimes"),
    pytest.param(lambda: pd.Timedelta("300ns"), id="timedelta of pandas"),
    pytest.param(lambda: pd.Series(pd.to_timedelta([300, 500])), id="column of timedeltas"),
    pytest.param(lambda: pd.Series(["300", "500"]), id="column of texts"),
    pytest.param(lambda: pd.DataFrame({"a": [300.0]}), id="table"),
    pytest.param(lambda: np.array([300, 500], object), id="objects"),
    pytest.param(lambda: [Decimal(300)], id="Decimal"),
    pytest.param(lambda: [True, 300], id="bool"),
    pytest.param(lambda: "300", id="text"),
    pytest.param(lambda: {"a": 300}, id="mapping"),
    pytest.param(lambda: 3j, id="complex"),
]


@pytest.mark.parametrize("make", OTHER_TYPES)
def test_any_other_type_is_refused_and_the_allowed_types_are_named(solve, make):
    with pytest.raises(ValueError, match="^roughness is .*numpy arrays, lists .* pint quantities$"):
        solve(roughness=make())


# ---- what is refused as a number


@pytest.mark.parametrize("name", POINT)
@pytest.mark.parametrize("bad", [-1e-9, np.nan, np.inf])
def test_numbers_that_no_interface_has_are_refused(solve, name, bad):
    with pytest.raises(ValueError, match=f"^{name} is .*; allowed: .*positive finite numbers"):
        solve(**{name: [POINT[name], bad]})


@pytest.mark.parametrize("name", ["load", "roughness"])
def test_load_and_roughness_are_never_zero(solve, name):
    with pytest.raises(ValueError, match=f"^{name} is 0; allowed: positive"):
        solve(**{name: 0})


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("load", "kg"),
        ("viscosity", "Pa * s"),
        ("particle_diameter", "cSt"),
        ("roughness", "nm ** 2"),
        ("particle_density", "1 / m ** 3"),
    ],
)
def test_a_quantity_of_another_dimension_is_refused(solve, name, unit):
    for value in (3.0 * UNIT(unit), of_xarray(3.0, unit)):
        with pytest.raises(ValueError, match=f"^{name} is in "):
            solve(**{name: value})


@pytest.mark.parametrize(
    "given",
    [
        {"load": LOADS, "viscosity": [0.0, 90e-6]},  # in which order?
        {"load": LOADS.assign_attrs(scale_factor=1e-6)},
        {"load": LOADS, "viscosity": LOADS.assign_coords(load=[1.0, 2.0])},
        {
            "load": pd.Series([1e-6, 1e-5], index=[7, 8]),
            "viscosity": pd.Series([0.0, 9e-5], index=[8, 7]),
        },
        {"load": [1e-6, 1e-5], "viscosity": [0.0, 1e-5, 2e-5]},
        {"load_N": 5.0},
        {"roughness": None},
    ],
    ids=[
        "no names",
        "packed numbers",
        "other coordinates",
        "other rows",
        "other shapes",
        "twice",
        "none",
    ],
)
def test_what_does_not_go_together_is_refused(solve, given):
    with pytest.raises(ValueError):
        solve(**given)


def test_unknown_names_are_refused(solve):
    with pytest.raises(TypeError, match="visc"):
        solve(visc=1e-5)
    with pytest.raises(TypeError, match="visc"):
        tb.grid(**POINT, visc=1e-5)
    with pytest.raises(ValueError, match="allowed: one or more of total_contact_area"):
        solve(variables="load")


@pytest.mark.parametrize("rtol", [0.0, -1e-3, 1.0, np.nan])
def test_errors_that_cannot_be_kept_are_refused(solve, rtol):
    with pytest.raises(ValueError, match="^rtol is"):
        solve(rtol=rtol)


# ---- broadcasting


def test_arrays_broadcast_by_the_names_of_their_dimensions(solve):
    found = solve(load=LOADS, viscosity=OILS)
    expected = solve(load=LOADS.values[:, None], viscosity=OILS.values)
    for name in VARIABLES:
        values = getattr(found, name)
        assert (values.dims, values.name) == (("load", "oil"), name)
        assert values["oil"].values.tolist() == ["none", "VG 90"]
        assert values["load"].values.tolist() == [1e-6, 1e-5]
    assert_same(found, expected)
    one = solve(load=LOADS.variable, viscosity=OILS.sel(oil="VG 90")).separation
    assert one.dims == ("load",) and one.oil == "VG 90"
    together = solve(load=LOADS, viscosity=LOADS * 9.0)
    assert_same(together, solve(load=LOADS.values, viscosity=LOADS.values * 9.0))


def test_every_door_reads_the_same_conditions(parameters):
    quantities = {"load_N": 0.01 * UNIT.kN, "roughness_nm": 0.3 * UNIT.um}
    given, named = ENGINEERING | quantities, {"parameters": parameters}
    xr.testing.assert_identical(tb.grid(**given, **named), tb.grid(**ENGINEERING, **named))
    search = {"variable": "solid_load_fraction", "level": 0.9, "along": "viscosity_cSt"}
    one, other = (
        tb.find(**search, **named, **{k: v for k, v in each.items() if k != "viscosity_cSt"})
        for each in (given, ENGINEERING)
    )
    assert_allclose(one["viscosity_cSt"], other["viscosity_cSt"], rtol=1e-9)


def test_ends_of_a_search_take_quantities(parameters):
    ends = 1e-6 * UNIT.m**2 / UNIT.s, 100 * UNIT.cSt
    conditions = {key: value for key, value in ENGINEERING.items() if key != "viscosity_cSt"}
    one, other = (
        tb.transitions("viscosity_cSt", between=between, parameters=parameters, **conditions)
        for between in (ends, (1, 100))
    )
    pd.testing.assert_frame_equal(one, other)


def test_numbers_with_a_unit_in_their_name_take_quantities():
    inputs = tb.bearing(ball_radius_mm=0.5 * UNIT.cm)
    assert inputs.ball_radius == pytest.approx(5e-3)
    steel = dict(elastic_modulus_surfaces=112.0 * UNIT.GPa, hardness_parameter=0.04)
    steel |= dict(material_parameter=2038.0, speed_per_viscosity=4.87e-6)
    assert tb.load_parameters(**steel).elastic_modulus_surfaces == pytest.approx(112e9)
    with pytest.raises(pint.DimensionalityError):
        tb.bearing(ball_radius_mm=1.0 * UNIT.s)


# ---- warnings


def warning(function, *given, **more):
    """The one line that a call warns with."""
    with pytest.warns(tb.OutOfRangeWarning) as warned:
        function(*given, **more)
    (one,) = warned
    return str(one.message)


OUTSIDE = {
    "load": (10.0, "load is 10; usual: 1e-13 to 0.02"),
    "viscosity": (90.0, "viscosity is 90 m2 s-1; usual: 3e-07 to 0.01 m2 s-1"),
    "particle_diameter": (500e-18, "particle_diameter is 5e-16 m; usual: 1e-09 to 0.001 m"),
    "roughness": (300e-18, "roughness is 3e-16 m; usual: 1e-09 to 0.001 m"),
    "particle_density": (11.0, "particle_density is 11 m-2; usual: 1e+06 to 1e+16 m-2"),
    "load_N": (1e5, "load_N is 100000 N; usual: "),
    "viscosity_cSt": (0.08, "viscosity_cSt is 0.08 cSt; usual: 0.3 to 10000 cSt"),
    "particle_diameter_nm": (500e-9, "particle_diameter_nm is 5e-07 nm; usual: 1 to 1e+06 nm"),
    "roughness_nm": (0.3, "roughness_nm is 0.3 nm; usual: 1 to 1e+06 nm"),
    "particle_density_per_m2": (11, "particle_density_per_m2 is 11 m-2; usual: 1e+06 to 1e+16"),
}


@pytest.mark.parametrize("name", OUTSIDE)
def test_a_number_in_another_unit_is_named_once_in_the_unit_that_was_given(parameters, name):
    bad, message = OUTSIDE[name]
    given = (POINT if name in POINT else ENGINEERING) | {name: bad}
    for function in (tb.solve, tb.grid):
        assert warning(function, **given, parameters=parameters).startswith(message)


def test_the_warning_is_for_the_line_of_the_call(solve):
    layer = {name: value for name, value in POINT.items() if name not in ("load", "viscosity")}
    for call in (
        lambda: tb.solve(**POINT | {"load": 10.0}),
        lambda: tb.grid(**POINT | {"load": 10.0}),
        lambda: tb.find("separation", 1e-6, "viscosity", load=10.0, **layer),
        lambda: tb.turning_point(viscosity=0.0, between_N=(1e5, 1e6), **layer),
        lambda: tb.bearing(pressure_viscosity_per_GPa=0.02),
        lambda: tb.Material(205000, 0.29, 5),
    ):
        with pytest.warns(tb.OutOfRangeWarning) as warned:
            call()
        assert warned[0].filename == __file__


def test_all_that_is_outside_is_named_in_one_warning(solve):
    assert warning(solve, load=10.0, viscosity=90.0).count("; usual: ") == 2
    assert warning(solve, load=[10.0, 20.0] * UNIT.MN).startswith("load is 1e+07 N; usual: ")


def test_so_is_a_bearing_in_another_unit(parameters):
    expected = "pressure_viscosity_per_GPa is 0.02 GPa-1; usual: 1 to 100 GPa-1"
    assert warning(tb.bearing, parameters, pressure_viscosity_per_GPa=0.02) == expected


def test_what_interfaces_have_is_solved_without_a_word(solve):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solve(load=[1e-12, 2e-2], viscosity=1e-2, particle_diameter=0.0, roughness=1e-5)


def test_threads_keep_their_warnings():
    """Members are solved without a word on what has been checked; other threads are warned as
    before.
    """
    inputs = tb.load_parameters()
    few = replace(inputs, members=inputs.members[:2])

    def ask(size):
        return answers.state(few, ENGINEERING | {"particle_diameter_nm": size})

    filters = [*warnings.filters]
    with ThreadPoolExecutor(4) as pool:
        [*pool.map(ask, [500.0] * 12)]
    assert warnings.filters == filters
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        with ThreadPoolExecutor(4) as pool:
            [*pool.map(ask, np.linspace(0.1, 0.2, 12))]
    assert [each.category for each in caught] == [tb.OutOfRangeWarning] * 12
