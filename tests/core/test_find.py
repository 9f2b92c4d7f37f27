"""``find`` and ``transitions`` against curves that are solved at many more points."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.conditions import axis_of, from_si, read_conditions, searched_ends
from thirdbody.core.transitions import LIMITS
from thirdbody.variables import AXES

pytestmark = pytest.mark.filterwarnings("error")

GIVEN = {
    "load_N": np.array([0.5, 10.0, 40.0]),
    "viscosity_cSt": np.array([0.0, 90.0, 130.0]),
    "particle_diameter_nm": np.array([375.0, 500.0, 300.0]),
    "roughness_nm": np.array([300.0, 300.0, 150.0]),
    "particle_density_per_m2": np.array([1e11, 1e11, 4e11]),
}
DENSE = 6001


def others(key):
    return {name: values for name, values in GIVEN.items() if name != key}


def dense(key, variable, level, parameters):
    """Query of every crossing of a dense curve, the points on both sides, and its direction."""
    ends = searched_ends(axis_of(key), parameters).with_load(parameters)
    samples = np.geomspace(*ends, DENSE)
    points = from_si(key, samples, parameters.newtons_per_load)
    given = others(key) | {key: points[:, None]}
    values = getattr(tb.solve(**given, parameters=parameters), variable) - level
    known = np.isfinite(values[:-1]) & np.isfinite(values[1:])
    step, query = np.nonzero(known & ((values[:-1] > 0.0) != (values[1:] > 0.0)))
    order = np.lexsort((step, query))
    rises = values[step + 1, query] > 0.0
    return query[order], points[step[order]], points[step[order] + 1], rises[order]


@pytest.mark.parametrize(("variable", "level"), [*LIMITS, ("total_contact_area", 1e-4)])
@pytest.mark.parametrize("key", [axis.alias for axis in AXES.values()])
def test_crossings_are_those_of_a_dense_curve(parameters, key, variable, level):
    found = tb.find(variable, level, key, parameters=parameters, **others(key))
    query, low, high, rises = dense(key, variable, level, parameters)
    assert found.index.tolist() == query.tolist()
    assert found["rises"].tolist() == rises.tolist()
    assert (low <= found[key] + found["error"]).all()
    assert (found[key] - found["error"] <= high).all()


@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_the_error_bounds_the_error_made(parameters, rtol):
    best = tb.find(*LIMITS[0], "load_N", parameters=parameters, rtol=1e-11, **others("load_N"))
    found = tb.find(*LIMITS[0], "load_N", parameters=parameters, rtol=rtol, **others("load_N"))
    apart = np.abs(found["load_N"] - best["load_N"])
    assert (apart <= found["error"] + best["error"]).all()
    assert (found["error"] < 100.0 * rtol * found["load_N"]).all()


def test_both_crossings_of_a_peak_between_values_of_the_sweep_are_found(parameters):
    given = {name: values[0] for name, values in others("load_N").items()}
    ratio = "particle_contact_area_ratio"
    peak = tb.turning_point(parameters=parameters, **given)["peak_ratio"].item()
    found = tb.find(ratio, peak - 1e-5, "load_N", count=24, parameters=parameters, **given)
    assert found["rises"].tolist() == [True, False]
    assert found["load_N"].iloc[1] / found["load_N"].iloc[0] < 1.1
    assert tb.find(ratio, peak + 1e-5, "load_N", parameters=parameters, **given).empty


def test_a_full_film_has_no_changes_of_the_contact_mode():
    """Where the film carries all of the load, whatever touches does not matter."""
    layer = dict(particle_diameter_nm=300, particle_density_per_m2=1e11, roughness_nm=300)
    found = tb.transitions("viscosity_cSt", load_N=[1, 10], between=(20, 2000), **layer)
    ends = found.loc[found["after"] == "full_film", "viscosity_cSt"]
    assert ends.index.tolist() == [0, 1]
    modes = found[found["flag"] == "contact_mode"]
    assert len(modes) and (modes["viscosity_cSt"] < ends[modes.index]).all()


def test_transitions_along_the_load_are_those_of_every_limit(parameters):
    changes = tb.transitions("load_N", parameters=parameters, **others("load_N"))
    expected = []
    for limit in LIMITS:
        found = tb.find(*limit, "load_N", parameters=parameters, **others("load_N"))
        for query, value in found["load_N"].items():
            state = tb.solve(load_N=value, parameters=parameters, **others("load_N"))
            is_full = state.lubrication_regime[query] == "full_film"
            if limit[0] == "solid_load_fraction" or not is_full:
                expected.append((query, value))
    assert changes.index.tolist() == [query for query, _ in sorted(expected)]
    assert_allclose(changes["load_N"], [value for _, value in sorted(expected)])


@pytest.mark.parametrize(
    "change",
    [
        {"along": "load"},
        {"viscosity": 1e-6},
        {"load_N": None},
        {"between": (0.0, 1.0)},
        {"between": (2.0, 1.0)},
        {"count": 1},
        {"load_N": -5.0},
        {"level": 90},
        {"load_N": xr.DataArray([1.0])},
    ],
)
def test_what_would_find_nothing_in_silence_is_refused(parameters, change):
    asked = {"variable": "solid_load_fraction", "level": 0.9, "along": "roughness_nm"}
    asked |= others("roughness_nm") | change
    with pytest.raises(ValueError):
        tb.find(**{k: v for k, v in asked.items() if v is not None}, parameters=parameters)


def test_levels_of_a_table_keep_its_index(parameters):
    levels = pd.Series([0.9, 0.8, 0.7], index=["a", "b", "c"])
    given = dict(parameters=parameters, **others("viscosity_cSt"))
    found = tb.find("solid_load_fraction", levels, "viscosity_cSt", **given)
    assert len(found) and found["level"].tolist() == levels[found.index].tolist()


def test_each_row_has_the_conditions_and_the_level_of_its_query(parameters):
    layer = dict(particle_diameter_nm=500.0, roughness_nm=300.0, particle_density_per_m2=1e11)
    loads = [5.0, 10.0, 20.0]
    given = dict(parameters=parameters, load_N=loads, **layer)
    for table in (
        tb.find("solid_load_fraction", 0.9, "viscosity_cSt", **given),
        tb.transitions("viscosity_cSt", **given),
    ):
        assert table.index.name == "query"
        assert table["load_N"].tolist() == [loads[query] for query in table.index]
        assert (table[[*layer]] == pd.Series(layer)).all().all()
    levels = [[0.9], [0.5]]
    table = tb.find("solid_load_fraction", levels, "viscosity_cSt", **given)
    assert table["level"].tolist() == [0.9] * 3 + [0.5] * 3
    assert table["load_N"].tolist() == loads * 2


def test_nothing_found_is_a_table_without_rows(parameters):
    given = dict(parameters=parameters, between=(1, 2), **others("viscosity_cSt"))
    for table in (
        tb.transitions("viscosity_cSt", **given),
        tb.find("solid_load_fraction", 0.5, "viscosity_cSt", **given),
    ):
        assert table.empty and {"viscosity_cSt", "load_N", "solution_status"} <= {*table}


def test_engineering_units_and_SI_are_the_same_place(parameters):
    given = others("viscosity_cSt")
    one = tb.find(*LIMITS[0], "viscosity_cSt", parameters=parameters, **given)
    si = read_conditions(given, parameters, without="viscosity").with_load(parameters)
    other = tb.find(*LIMITS[0], "viscosity", parameters=parameters, **si)
    assert_allclose(one["viscosity_cSt"], 1e6 * other["viscosity"], rtol=1e-12)
    assert set(one["solution_status"]) == {"converged"}
