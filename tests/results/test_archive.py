"""Datasets as others see them: the data contract, CF and ACDD."""

import json
import re

import netCDF4
import numpy as np
import pytest
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.dataset import scene_dataset

pytestmark = pytest.mark.results

NOT_SHOWN = -127  # what flags hold for combinations that a figure does not show
FLAGS = ("lubrication_regime", "contact_mode", "solution_status")
VARIABLES = (
    "total_contact_area",
    "particle_contact_area_ratio",
    "surface_contact_area_ratio",
    "solid_load_fraction",
    "fluid_load_fraction",
    "separation",
    "film_thickness",
    "error_bound",
    *FLAGS,
)


@pytest.fixture(scope="session")
def path(figure, results):
    return results / "datasets" / f"{figure}.nc"


@pytest.fixture(scope="module")
def stored(path):
    with netCDF4.Dataset(path) as opened:
        yield opened


# ---- the contract


def test_dimensions_and_variables_are_those_of_the_contract(stored):
    assert list(stored.dimensions) == list(DIMENSIONS)
    assert set(stored.variables) == {*DIMENSIONS, "normal_load", *VARIABLES}
    for name in VARIABLES:
        assert stored[name].dimensions == DIMENSIONS
        assert stored[name].dtype == (np.int8 if name in FLAGS else np.float64)


def test_axes_are_those_of_the_scene(stored, scene):
    for name in DIMENSIONS:
        assert np.array_equal(stored[name][:], scene.axis(name)), name
        assert (np.diff(stored[name][:]) > 0.0).all()


def test_named_loads_are_on_the_axis(stored, figure):
    from thirdbody.configuration.plain_yaml import read_yaml
    from thirdbody.configuration.schema import config_directory

    configured = read_yaml(config_directory() / "scenes.yaml")["scenes"][figure]
    loads = stored["load"][:]
    inside = [x for x in configured.get("named_loads", []) if loads[0] <= x <= loads[-1]]
    assert set(inside) <= set(loads)


def test_there_are_at_least_200_loads_over_the_range_of_table_2(stored):
    newtons = np.asarray(stored["normal_load"][:])
    assert newtons.size >= 200
    # the ends are written as F_t* with twelve digits
    assert_allclose(newtons[[0, -1]], [0.04, 80.0], rtol=1e-11)


def test_what_the_scene_does_not_show_holds_the_fill_value_and_nothing_else(stored, scene):
    hidden = np.ones(tuple(dimension.size for dimension in stored.dimensions.values()), dtype=bool)
    for group in scene.groups:
        hidden[scene.placed(group)] = False
    for name in VARIABLES:
        values = stored[name][:]
        # netCDF4 masks -127 in bytes by itself
        found = np.ma.getdata(values) == NOT_SHOWN if name in FLAGS else np.ma.getmaskarray(values)
        assert np.array_equal(found, hidden), name


def test_each_variable_says_what_it_is(stored):
    for name in VARIABLES:
        for attribute in ("units", "long_name", "symbol", "equation"):
            assert str(stored[name].getncattr(attribute)), (name, attribute)
        assert ("_FillValue" in stored[name].ncattrs()) == (name not in FLAGS)
    for name in (*DIMENSIONS, "normal_load"):
        assert stored[name].units
        assert "_FillValue" not in stored[name].ncattrs()


def test_flags_hold_no_value_without_a_name(stored):
    for name in FLAGS:
        values = set(np.unique(np.ma.getdata(stored[name][:])).tolist())
        assert values <= set(np.atleast_1d(stored[name].flag_values).tolist())
        assert len(stored[name].flag_meanings.split()) == stored[name].flag_values.size


def test_model_parameters_have_a_value_for_each_roughness(stored):
    model = json.loads(stored.model_parameters)
    for name in ("eta_s", "R", "sigma_s", "y_s"):
        assert len(model[name]) == stored["roughness"].size


def test_attributes_hold_no_time_of_day_and_no_folder(stored, path):
    owners = [stored, *stored.variables.values()]
    texts = [str(owner.getncattr(name)) for owner in owners for name in owner.ncattrs()]
    for text in texts:
        assert not re.search(r"\d\d:\d\d:\d\d|\dT\d\d", text), text
        assert str(path.parents[2]) not in text


def test_the_dataset_is_that_of_the_default_configuration(stored, scene):
    inputs = tb.load_parameters()
    again = scene_dataset(scene, inputs, float(stored.rtol))
    assert stored.model_parameters == inputs.as_attribute(scene.axis("roughness"))
    assert stored.configuration_sha256 == again.attrs["configuration_sha256"]


# ---- CF and ACDD


@pytest.fixture(scope="session")
def findings(findings_in, path):
    """What each convention's checker has to say."""
    return findings_in(path)


def test_cf_finds_nothing(findings):
    assert findings["CF"] == []


def test_acdd_finds_nothing_but_what_does_not_apply(findings):
    assert findings["ACDD"] == []
