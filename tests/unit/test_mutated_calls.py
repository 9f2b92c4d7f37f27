"""Calls of the library that went wrong: refused in one line that names the argument, or answered."""

import collections
import fractions
import warnings

import numpy as np
import pandas as pd
import pint
import pytest
import xarray as xr
from methods import ENGINEERING
from methods import POINT as SI
from numpy.lib.stride_tricks import as_strided

import thirdbody as tb
from thirdbody.answers.bearing import MATERIALS, Material, derived
from thirdbody.measured.estimates import Assumed

UNIT = pint.UnitRegistry()
# 10^12 numbers in 8 bytes: an array that may be counted, and not looked at
ENDLESS = as_strided(np.ones(1), (10**6, 10**6), (0, 0))
WRONG = (
    *(None, True, object, "word", b"bytes", "", "a\nb", "a\0b"),
    *(float("nan"), float("inf"), -1.0, 1.5, 1j, 10**12, 10**400, -(10**400)),
    *(np.float32(-3.0), fractions.Fraction(-1, 3), np.array("2020-01-01", "datetime64[D]")),
    *([], [None], [["a"]], [2.0, 1.0], [1.0, [2.0]], [10**400, 1.0], (1.0, 2.0, 3.0), range(3)),
    *({"a": 1}, {"separation"}, np.array([1.0, np.nan]), np.ma.masked_array([1.0, 2.0], [0, 1])),
    *(ENDLESS, pd.Series([1.0, 2.0]), xr.DataArray([-1.0], dims="x")),
    *(3 * UNIT.kg, [3 * UNIT.kg], np.array([3.0, 4.0]) * UNIT.mol),
)
WITHOUT_LOAD = {name: value for name, value in ENGINEERING.items() if name != "load_N"}
LAYER = {"roughness_nm": 300.0, "particle_density_per_m2": 1e11}
# what else a line may call an argument
CALLED = dict(zip(ENGINEERING, SI)) | {
    "along": "axis",
    "path": "inputs",
    "oil_density_kg_per_m3": "the oil's density",
    "hardness_surface_1": "load_parameters",
}


def generator():
    yield 1.0


def method(name):
    """A question of an interface, with as few inputs as there are."""

    def ask(parameters, **given):
        interface = tb.Interface(**ENGINEERING, parameters=parameters)
        object.__setattr__(interface, "members", ())
        return getattr(interface, name)(**given)

    return ask


def compare_data(load, **given):
    """A comparison of one measurement."""
    data = {"load [N]": [load], "speed [m/s]": [2.0], "solid load fraction": [0.5]}
    return tb.compare(pd.DataFrame(data), **given)


def calls(parameters):
    """A call of each public function that works, by its name."""
    inputs = {"parameters": parameters}
    search = {"variable": "solid_load_fraction", "level": 0.9, "along": "load_N", "count": 4}
    search |= {"between": (1.0, 50.0), "rtol": 1e-3}
    choice = {"rtol": 1e-6, "variables": ["separation"]}
    curve = {"along": "load", "low": 1.0, "high": 50.0, "count": 3}
    bodies = dict.fromkeys(("ball", "flat", "particle"), MATERIALS["steel"])
    bodies |= {"ball_radius_mm": 5.0, "speed_m_per_s": 2.0, "oil_density_kg_per_m3": 850.0}
    return {
        "solve": (tb.solve, SI | inputs | choice),
        "grid": (tb.grid, SI | inputs | choice),
        "stream": (tb.stream, SI | inputs | choice | {"path": "a.nc", "compression": 0}),
        "find": (tb.find, search | WITHOUT_LOAD | inputs),
        "transitions": (
            tb.transitions,
            {"along": "load_N", "between": (1.0, 50.0), "count": 4} | WITHOUT_LOAD | inputs,
        ),
        "turning_point": (
            tb.turning_point,
            {"between_N": (1.0, 50.0), "count": 4, "rtol": 1e-3} | WITHOUT_LOAD | inputs,
        ),
        "turning_window": (tb.turning_window, {"between_N": (1.0, 50.0)} | LAYER | inputs),
        "bearing": (tb.bearing, inputs | bodies),
        "Material": (Material, {"modulus_GPa": 200.0, "poisson_ratio": 0.3, "hardness_GPa": 5.0}),
        "derived": (derived, inputs | {"viscosity_cSt": 90.0}),
        "Interface": (tb.Interface, ENGINEERING | inputs),
        "curve": (method("curve"), curve | inputs),
        "changes": (
            method("transitions"),
            {"along": "load", "flags": ["contact_mode"], "between": (1.0, 50.0)} | inputs,
        ),
        "turning": (method("turning_point"), {"between_N": (1.0, 50.0)} | inputs),
        "compare": (method("compare"), {"other": tb.Interface(**ENGINEERING)} | inputs),
        "grade": (tb.oil_viscosity, {"temperature_C": 60.0, "grade": 46, "viscosity_index": 95}),
        "points": (tb.oil_viscosity, {"temperature_C": 60.0, "points": {40: 46, 100: 7}}),
        "cleanliness": (tb.cleanliness, {"code": "18/16/13", "gap_nm": 500.0, "enrichment": 1.0}),
        "Assumed": (Assumed, {"boundary_friction": 0.1, "resistivity_ohm_m": 1e-7}),
        "compare_data": (
            compare_data,
            WITHOUT_LOAD | inputs | {"speed_m_per_s": 4.0, "load": 5.0, "assumed": Assumed()},
        ),
        "open_atlas": (tb.open_atlas, {"path": "catalogue.json"}),
        "plot": (
            tb.plot,
            {"data": tb.grid(**SI | {"load": [1e-6, 1e-5]}, **inputs), "over": "load"}
            | {"variables": ["film_thickness"], "like": "fig04", "turning_points": [], "band": None}
            | {"ax": None},
        ),
        "load_parameters": (tb.load_parameters, {"path": None, "hardness_surface_1": 5e9}),
    }


def message_of(function, given):
    """How a call ends: nothing where it is answered, the line of its refusal, or what else went up."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", tb.OutOfRangeWarning)
            function(**given)
    except (ValueError, OSError) as error:
        return str(error)
    except Exception as error:  # the fault that is looked for
        return f"{type(error).__name__}\n{error}"
    return ""


@pytest.mark.parametrize("name", calls(tb.load_parameters()))
def test_each_call_is_answered_or_refused_in_one_line_that_names_the_argument(
    name, parameters, tmp_path, monkeypatch, tell
):
    monkeypatch.chdir(tmp_path)
    function, given = calls(parameters)[name]
    count = collections.Counter()
    for argument in given:
        for wrong in (*WRONG, generator()):
            message = message_of(function, given | {argument: wrong})
            count["refused" if message else "answered"] += 1
            words = argument, CALLED.get(argument, argument), repr(wrong).strip("'")
            assert not message or any(word in message for word in words), message
            assert "\n" not in message and len(message) < 700, (argument, message)
    tell(f"{name}: {dict(count)}")
    assert count["refused"] >= 20
