"""What users give that used to be wrong numbers in silence: units, names, ranges; one line for each."""

import inspect
import re
import warnings
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pandas as pd
import pint
import pytest
import xarray as xr
from methods import ENGINEERING, POINT
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.core.state import FLAGS, QUANTITIES, VARIABLES

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


def refusal(function, **given):
    """The one line with which ``function`` refuses."""
    with pytest.raises(ValueError) as refused:
        function(**given)
    message = str(refused.value)
    assert "\n" not in message
    return message


def assert_same(found, expected):
    for name in (*QUANTITIES, *FLAGS):
        assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-12, err_msg=name)


def test_quantities_in_arrays_are_converted(solve, parameters):
    quantities = np.array([300, 500]) * UNIT.nm
    named = solve(roughness=xr.DataArray(quantities, dims="surface"))
    assert named.separation.dims == ("surface",)
    assert_same(named, solve(roughness=[3e-7, 5e-7]))
    grid = tb.grid(**POINT | {"roughness": quantities}, parameters=parameters)
    assert grid.roughness.values.tolist() == [3e-7, 5e-7]  # the decimal numbers
    message = "load has quantities and plain numbers; allowed: either of them"
    assert refusal(solve, load=[10 * UNIT.N, 20.0]) == message
    assert refusal(solve, load=[True, 2]) == "load is [True, 2]; allowed: numbers"


WRONG_UNITS = {
    "load": ("kg", "a dimensionless number or a force, e.g. in N"),
    "viscosity": ("Pa * s", "a kinematic viscosity, e.g. in cSt"),
    "particle_diameter": ("cSt", "a length, e.g. in nm"),
    "roughness": ("nm ** 2", "a length, e.g. in nm"),
    "particle_density": ("1 / m ** 3", "a number per area, e.g. in 1/mm**2"),
}


@pytest.mark.parametrize("name", POINT)
def test_a_quantity_of_another_dimension_is_refused_by_name_and_unit(solve, name):
    given, wanted = WRONG_UNITS[name]
    message = refusal(solve, **{name: 3.0 * UNIT(given)})
    assert message == f"{name} is in {given}; allowed: {wanted}"


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


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"load": LOADS, "viscosity": [0.0, 90e-6]},
            "viscosity is an array without named dimensions; allowed: a number or an xarray.DataArray",
        ),
        (
            {"load": LOADS.assign_attrs(scale_factor=1e-6)},
            "load has the attribute scale_factor, with numbers as a file stores them; allowed: decoded",
        ),
        (
            {"load": LOADS, "viscosity": LOADS.assign_coords(load=[1.0, 2.0])},
            "load, viscosity have different coordinates along one dimension",
        ),
        (
            {
                "load": pd.Series([1e-6, 1e-5], index=[7, 8]),
                "viscosity": pd.Series([0.0, 9e-5], index=[8, 7]),
            },
            "load and viscosity have different indexes; allowed: columns of one table",
        ),
        (
            {"load": pd.DataFrame({"a": [1e-6, 1e-5]})},
            "load is a DataFrame; allowed: numbers",
        ),
        (
            {"load": [1e-6, 1e-5], "viscosity": [0.0, 1e-5, 2e-5]},
            "shapes do not broadcast: load has (2,), viscosity has (3,); allowed: shapes that do",
        ),
    ],
    ids=[
        "no names",
        "packed numbers",
        "other coordinates",
        "two series",
        "a table",
        "other shapes",
    ],
)
def test_arrays_that_do_not_go_together_are_refused(solve, given, message):
    assert refusal(solve, **given).startswith(message)


OUTSIDE = {
    "load": (10.0, "load is 10; usual: 1e-13 to 0.02"),
    "viscosity": (90.0, "viscosity is 90 m2 s-1; usual: 3e-07 to 0.01 m2 s-1"),
    "particle_diameter": (500e-18, "particle_diameter is 5e-16 m; usual: 1e-09 to 0.001 m"),
    "roughness": (300e-18, "roughness is 3e-16 m; usual: 1e-09 to 0.001 m"),
    "particle_density": (11.0, "particle_density is 11 m-2; usual: 1e+06 to 1e+16 m-2"),
}


def warning(function, *given, **more):
    """The one line that a call warns with, where it stands."""
    with pytest.warns(tb.OutOfRangeWarning) as warned:
        function(*given, **more)
    (one,) = warned
    assert one.filename == __file__
    return str(one.message)


@pytest.mark.parametrize("name", POINT)
def test_what_no_interface_has_is_named_once_where_it_is_given(solve, name):
    bad, message = OUTSIDE[name]
    assert warning(solve, **{name: [POINT[name], bad]}) == message


def test_shapes_are_named_as_they_were_typed():
    rest = dict(particle_diameter_nm=300, roughness_nm=300, particle_density_per_m2=1e11)
    sizes = dict(particle_diameter_nm=300, particle_density_per_m2=1e11)
    wrong = dict(load_N=[1.0, 2.0], viscosity_cSt=[1.0, 2.0, 3.0])
    data = pd.DataFrame({"load [N]": [5, 10], "solid load fraction": [0.9, 0.7]})
    labelled = xr.DataArray([1.0, 2.0], dims="day", coords={"day": [1, 2]})
    others = labelled.assign_coords(day=[3, 4])
    for function, message in (
        (lambda: tb.solve(**wrong, **rest), "load_N has (2,), viscosity_cSt has (3,)"),
        (
            lambda: tb.solve(load_N=labelled, viscosity_cSt=[0, 1], **rest),
            "viscosity_cSt is an array",
        ),
        (
            lambda: tb.solve(load_N=labelled, viscosity_cSt=others, **rest),
            "load_N, viscosity_cSt have",
        ),
        (
            lambda: tb.find("solid_load_fraction", 0.5, "roughness", **wrong, **sizes),
            "load_N has (2,), viscosity_cSt has (3,)",
        ),
        (lambda: tb.Interface(**wrong | {"load": 1e-5}, **rest), "load: load is given twice"),
        (
            lambda: tb.Interface(load=[1e-5, 1e-4], viscosity_cSt=0, **rest),
            "load has shape (2,); allowed: one number",
        ),
        (
            lambda: tb.compare(data, viscosity=[1e-6, 2e-6, 3e-6], **rest),
            "viscosity has shape (3,); allowed: one number, or 2",
        ),
    ):
        with pytest.raises(ValueError, match=re.escape(message)):
            function()


TYPED = {
    "load_N": (1e5, "load_N is 100000 N; usual: "),
    "viscosity_cSt": (0.08, "viscosity_cSt is 0.08 cSt; usual: 0.3 to 10000 cSt"),
    "particle_diameter_nm": (500e-9, "particle_diameter_nm is 5e-07 nm; usual: 1 to 1e+06 nm"),
    "roughness_nm": (0.3, "roughness_nm is 0.3 nm; usual: 1 to 1e+06 nm"),
    "particle_density_per_m2": (11, "particle_density_per_m2 is 11 m-2; usual: 1e+06 to 1e+16 m-2"),
}


@pytest.mark.parametrize("name", TYPED)
def test_it_is_named_once_in_the_unit_that_was_typed(parameters, name, tmp_path):
    bad, message = TYPED[name]
    given = ENGINEERING | {name: bad}
    named = {"parameters": parameters}
    search = {"variable": "solid_load_fraction", "level": 0.9, "along": "roughness_nm"}
    surface = {key: value for key, value in given.items() if key != "roughness_nm"}
    curve = {key: value for key, value in given.items() if key != "load_N"}
    entries = [
        lambda: tb.grid(**given, **named),
        lambda: tb.stream(tmp_path / "grid.nc", **given, **named),
        lambda: tb.Interface(**given).state(),
    ]
    if name in surface:
        entries.append(lambda: tb.find(**search, **surface, **named))
    if name in curve:
        entries.append(lambda: tb.turning_point(**curve, **named))
    for function in entries:
        assert warning(function).startswith(message)


def test_all_that_is_outside_is_named_in_one_warning(solve):
    expected = f"{OUTSIDE['load'][1]}, and {OUTSIDE['viscosity'][1]}"
    assert warning(solve, load=10.0, viscosity=90.0) == expected


def test_so_is_a_bearing_in_another_unit(parameters):
    expected = "pressure_viscosity_per_GPa is 0.02 GPa-1; usual: 1 to 100 GPa-1"
    assert warning(tb.bearing, parameters, pressure_viscosity_per_GPa=0.02) == expected
    light = {"speed_m_per_s": 2.0, "oil_density_kg_per_m3": 0.87}
    expected = "oil_density_kg_per_m3 is 0.87 kg m-3; usual: 500 to 3000 kg m-3"
    assert warning(tb.bearing, parameters, **light) == expected


def test_what_interfaces_have_is_solved_without_a_word(solve):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        solve(load=[1e-12, 2e-2], viscosity=1e-2, particle_diameter=0.0, roughness=1e-5)


def test_one_name_is_a_list_of_one(solve):
    found = solve(variables="separation")
    assert [*found.known] == ["separation"] and found == solve(variables=["separation"])


def test_a_near_miss_is_named(solve):
    assert refusal(tb.solve, loadN=1.0).endswith("; did you mean load_N?")


@pytest.mark.parametrize("bad", [5, "load", ["load"], [], (), ""])
def test_variables_that_are_no_collection_of_known_names_are_refused(solve, bad):
    message = refusal(solve, variables=bad)
    assert message.startswith("variables ") and "; allowed: one or more of total_" in message


def test_more_points_than_memory_holds_are_refused_with_their_number(solve, parameters):
    axis = np.linspace(1e-6, 1e-3, 10**6)
    message = (
        "load, viscosity make 1e+12 points; allowed: at most 1e+09 in one call; "
        "thirdbody.stream writes any number to a file"
    )
    assert refusal(solve, load=axis[:, None], viscosity=axis) == message
    named = {name: xr.DataArray(axis, dims=name) for name in ("load", "viscosity")}
    assert refusal(solve, **named) == message
    axes = dict.fromkeys(POINT, axis)
    assert "make 1e+30 points" in refusal(tb.grid, **axes, parameters=parameters)


def test_threads_keep_their_warnings():
    """Interfaces solve without a word what has been checked; other threads are warned as before."""
    layer = dict(viscosity_cSt=90, roughness_nm=300, particle_density_per_m2=1e11)

    def ask(size):
        return tb.Interface(load_N=10, particle_diameter_nm=size, **layer).state()

    filters = [*warnings.filters]
    with ThreadPoolExecutor(4) as pool:
        [*pool.map(ask, [500.0] * 12)]
    assert warnings.filters == filters
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        with ThreadPoolExecutor(4) as pool:
            [*pool.map(ask, np.linspace(0.1, 0.2, 12))]
    assert [each.category for each in caught] == [tb.OutOfRangeWarning] * 12


@pytest.mark.parametrize(
    ("call", "meant"),
    [
        (lambda: tb.solve(load_n=1), "load_N"),
        (lambda: tb.solve(viscosity_CST=1), "viscosity_cSt"),
        (lambda: tb.solve(variable="separation"), "variables"),
        (lambda: tb.solve(variables="seperation"), "separation"),
        (lambda: tb.find("solid_load", 0.5, "load"), "solid_load_fraction"),
        (lambda: tb.find("separation", 1e-6, "roughnes"), "roughness"),
    ],
)
def test_the_name_that_was_meant_is_suggested(call, meant):
    with pytest.raises(ValueError, match=f"; did you mean {meant}\\?$"):
        call()


@pytest.mark.parametrize("function", [tb.solve, tb.grid, tb.find])
def test_signatures_fit_on_a_screen(function):
    assert len(str(inspect.signature(function))) < 320


@pytest.mark.parametrize("kind", [Decimal, Fraction, np.float32, np.int8])
def test_numbers_of_any_type_are_numbers(kind, parameters):
    five = kind(5)
    rest = ENGINEERING | {"parameters": parameters}
    expected = tb.solve(**rest | {"load_N": [5.0, 5.0]}).separation
    for loads in ([five, five], pd.Series([five, five]), np.array([five, five], object)):
        assert_allclose(tb.solve(**rest | {"load_N": loads}).separation, expected)
    assert tb.Interface(**rest | {"load_N": five}).described().startswith("load 5 N, ")
    assert tb.bearing(ball_radius_mm=five) == tb.bearing(ball_radius_mm=5.0)
    assert tb.Material(five, five / 20, five) == tb.Material(5.0, 0.25, 5.0)
    assert tb.oil_viscosity(five, grade=46) == tb.oil_viscosity(5.0, grade=46)


def test_no_flags_are_refused():
    interface = tb.Interface(**ENGINEERING)
    with pytest.raises(ValueError, match=r"^flags is \[\]; allowed: one or more of lubrication_r"):
        interface.transitions(flags=[])
