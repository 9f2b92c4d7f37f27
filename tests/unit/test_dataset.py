"""Datasets exactly as the data contract says, on disk and in memory."""

import hashlib
import json
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray as xr
from numpy.testing import assert_allclose

import thirdbody as tb
from thirdbody.data.conditions import DIMENSIONS
from thirdbody.data.dataset import crossed, scene_dataset
from thirdbody.data.model_attribute import model_attribute
from thirdbody.data.netcdf import read_dataset, write_dataset
from thirdbody.data.quantities import FILL_FLAG, FILL_FLOAT, STATUS_MEANINGS
from thirdbody.data.scene import Scene
from thirdbody.model.regimes import SOLUTION_STATUSES

UNITS = {
    "load": "1",
    "normal_load": "N",
    "viscosity": "m2 s-1",
    "particle_diameter": "m",
    "roughness": "m",
    "particle_density": "m-2",
    "total_contact_area": "1",
    "particle_contact_area_ratio": "1",
    "surface_contact_area_ratio": "1",
    "solid_load_fraction": "1",
    "fluid_load_fraction": "1",
    "separation": "m",
    "film_thickness": "1",
    "error_bound": "1",
}
# symbol and equation
MEANINGS = {
    "total_contact_area": ("A_t*", "5"),
    "particle_contact_area_ratio": ("A_sa,t*", "10"),
    "surface_contact_area_ratio": ("A_ss,t*", "10"),
    "solid_load_fraction": ("L_s", "9"),
    "fluid_load_fraction": ("L_f", "9"),
    "separation": ("d", "4"),
    "film_thickness": ("H_c", "7"),
    "error_bound": ("none", "none"),
}
FLAGS = {
    "lubrication_regime": "boundary mixed full_film",
    "contact_mode": "two_body surface_surface hybrid particle_surface",
    "solution_status": (
        "converged outside_film_formula coverage_exceeded not_converged several_separations "
        "area_exceeded load_exceeded"
    ),
}
GLOBAL_ATTRIBUTES = [
    "title",
    "summary",
    "source",
    "references",
    "license",
    "creator_name",
    "conventions",
    "schema_version",
    "software_version",
    "configuration_sha256",
    "model_parameters",
]
AXES = {
    "load": [1e-6, 1e-5, 1e-4],
    "viscosity": [0.0, 90e-6],
    "particle_diameter": [0.0, 3e-7],
    "roughness": [1e-7, 3e-7],
    "particle_density": [1e11],
}
SCENE = {
    "title": "Two groups",
    "load_axis": {"load_N": [0.04, 80.0], "count": 9},
    "curves": [
        {
            "viscosity_cSt": [0, 90],
            "particle_diameter_nm": [500],
            "roughness_nm": [100],
            "particle_density_per_m2": [1.0e11],
        },
        {
            "viscosity_cSt": [0],
            "particle_diameter_nm": [0, 300],
            "roughness_nm": [300],
            "particle_density_per_m2": [1.0e11],
        },
    ],
}


def hidden(variable):
    """Where the figure shows nothing."""
    return variable.values == (FILL_FLAG if variable.name in FLAGS else FILL_FLOAT)


def grid(parameters, rtol=1e-9, **axes):
    return tb.grid(**(AXES | axes), parameters=parameters, rtol=rtol)


@pytest.fixture(scope="module")
def dataset(parameters):
    return grid(parameters)


@pytest.fixture(scope="module")
def scene(parameters):
    return Scene.of("test", SCENE, parameters.newtons_per_load)


@pytest.fixture(scope="module")
def shown(scene, parameters):
    return scene_dataset(scene, parameters).to_xarray()


@pytest.fixture
def on_disk(shown, tmp_path):
    path = tmp_path / "test.nc"
    write_dataset(shown, path)
    return path


# ---- what is in it


def test_dimensions_are_always_the_five_in_their_order(dataset, shown):
    for one in (dataset, shown):
        for name in (*MEANINGS, *FLAGS):
            assert one[name].dims == DIMENSIONS
        assert list(DIMENSIONS) == [name for name in one.coords if name in one.sizes]


def test_variables_are_those_of_the_contract(dataset):
    assert set(dataset.data_vars) == {*MEANINGS, *FLAGS}
    assert set(dataset.coords) == {*DIMENSIONS, "normal_load"}


def test_quantities_are_doubles_and_flags_bytes(dataset):
    for name in (*MEANINGS, *DIMENSIONS, "normal_load"):
        assert dataset[name].dtype == np.float64
    for name in FLAGS:
        assert dataset[name].dtype == np.int8


def test_units_symbols_and_equations_are_those_of_the_contract(dataset):
    assert {name: dataset[name].attrs["units"] for name in UNITS} == UNITS
    for name, meaning in MEANINGS.items():
        attributes = dataset[name].attrs
        assert (attributes["symbol"], attributes["equation"]) == meaning
    newtons = dataset["load"].values * 112e9 * json.loads(dataset.attrs["model_parameters"])["A_n"]
    assert_allclose(dataset["normal_load"].values, newtons, rtol=4e-16)


@pytest.mark.parametrize("name", FLAGS)
def test_flags_name_each_of_their_values(dataset, name):
    attributes = dataset[name].attrs
    assert attributes["flag_meanings"].startswith(FLAGS[name])
    values = np.asarray(attributes["flag_values"])
    assert values.dtype == np.int8
    assert values.size == len(attributes["flag_meanings"].split())
    assert attributes["equation"]


def test_each_status_is_explained_in_the_file(dataset):
    comment = dataset["solution_status"].attrs["comment"]
    assert all(f"{name}: {meaning}" in comment for name, meaning in STATUS_MEANINGS.items())


# elastic particles that press more than plastic ones
SOFT = {"elastic_modulus_particle": 5e9, "elastic_depth_ratio": 0.5}


def test_a_dataset_with_several_separations_holds_their_number(parameters, tmp_path):
    inputs = replace(parameters, **SOFT)
    given = {"load": np.geomspace(1e-7, 1e-3, 40), "particle_diameter": [0.0, 5e-7]}
    several = grid(inputs, **given)
    count, status = several["separation_count"], several["solution_status"]
    assert (count.dtype, count.dims) == (np.int8, DIMENSIONS)
    assert np.array_equal(count > 1, status == SOLUTION_STATUSES.index("several_separations"))
    solution = tb.solve(**crossed(AXES | given), parameters=inputs)
    assert np.array_equal(count, solution.separation_count)
    write_dataset(several, tmp_path / "several.nc")
    xr.testing.assert_identical(
        read_dataset(tmp_path / "several.nc")[["separation_count"]], several[["separation_count"]]
    )
    tb.stream(tmp_path / "streamed.nc", **AXES | given, parameters=inputs, variables=list(several))
    streamed = read_dataset(tmp_path / "streamed.nc")
    xr.testing.assert_equal(streamed["separation_count"], count)


def test_so_does_that_of_a_figure_and_tells_what_is_not_shown(scene, parameters, shown):
    several = scene_dataset(scene, replace(parameters, **SOFT)).to_xarray()
    count, hidden_ones = several["separation_count"], hidden(several["solution_status"])
    assert (count.values[hidden_ones] == FILL_FLAG).all()
    assert (count.values[~hidden_ones] > 0).all() and (count > 1).any()
    assert f"{FILL_FLAG}: not shown" in count.attrs["comment"]
    assert "separation_count" not in shown


def test_global_attributes_of_the_contract_are_there(dataset, shown):
    for one in (dataset, shown):
        assert all(one.attrs[name] for name in GLOBAL_ATTRIBUTES)


def test_model_parameters_are_those_of_the_inputs(dataset, parameters):
    assert dataset.attrs["model_parameters"] == model_attribute(parameters, np.array([1e-7, 3e-7]))
    model = json.loads(dataset.attrs["model_parameters"])
    assert all(len(model[name]) == 2 for name in ("eta_s", "R", "sigma_s", "y_s"))


def test_attributes_hold_no_time_of_day(shown):
    owners = shown, *shown.variables.values()
    texts = [str(value) for owner in owners for value in owner.attrs.values()]
    assert not [text for text in texts if re.search(r"\d\d:\d\d:\d\d|\dT\d\d", text)]


# ---- the hash of the configuration


def test_equal_requests_have_equal_hashes(parameters, dataset):
    again = grid(replace(parameters), **{name: np.array(axis) for name, axis in AXES.items()})
    assert again.attrs["configuration_sha256"] == dataset.attrs["configuration_sha256"]
    assert re.fullmatch("[0-9a-f]{64}", again.attrs["configuration_sha256"])


@pytest.mark.parametrize("name", AXES)
def test_another_axis_has_another_hash(parameters, dataset, name):
    other = grid(parameters, **{name: [AXES[name][-1] * 1.01]})
    assert other.attrs["configuration_sha256"] != dataset.attrs["configuration_sha256"]


def test_another_input_or_accuracy_has_another_hash(parameters, dataset):
    others = grid(replace(parameters, truncation=2.5)), grid(parameters, rtol=1e-8)
    hashes = {one.attrs["configuration_sha256"] for one in (dataset, *others)}
    assert len(hashes) == 3


# ---- axes


@pytest.mark.parametrize("name", AXES)
@pytest.mark.parametrize(
    "bad", [[2e-7, 1e-7], [1e-7, 1e-7], [[1e-7, 2e-7]], []], ids=["falling", "twice", "2-D", "none"]
)
def test_an_axis_that_is_not_one_increasing_dimension_is_refused_by_name(parameters, name, bad):
    with pytest.raises(ValueError, match=f"^{name} .*allowed: one increasing dimension"):
        grid(parameters, **{name: bad})


@pytest.mark.parametrize("name", AXES)
@pytest.mark.parametrize("bad", [[-1e-9], [np.nan], [np.inf], ["a"]], ids=str)
def test_an_axis_without_meaning_is_refused_by_name(parameters, name, bad):
    with pytest.raises(ValueError, match=f"^{name} is "):
        grid(parameters, **{name: bad})


# ---- combinations that are not shown


def test_what_a_figure_does_not_show_holds_the_fill_value_and_nothing_else(shown, scene):
    expected = np.ones(tuple(shown.sizes.values()), dtype=bool)
    for group in scene.groups:
        expected[scene.placed(group)] = False
    assert expected.any()
    for name in (*MEANINGS, *FLAGS):
        assert np.array_equal(hidden(shown[name]), expected), name


def test_what_a_figure_shows_is_what_the_solver_gives(shown, scene, parameters):
    for group in scene.groups:
        axes = {"load": scene.load} | {name: getattr(group, name) for name in DIMENSIONS[1:]}
        solution = tb.solve(
            **crossed(axes),
            parameters=parameters,
        )
        for name in (*MEANINGS, *FLAGS):
            values = shown[name].values[scene.placed(group)]
            assert np.array_equal(values, getattr(solution, name)), name


# ---- on disk


def test_a_dataset_survives_the_file(shown, on_disk, dataset, tmp_path):
    path = tmp_path / "grid.nc"
    write_dataset(dataset, path)
    assert read_dataset(path).equals(dataset)
    assert read_dataset(path).attrs == dataset.attrs
    again = read_dataset(on_disk)
    for name in (*MEANINGS, *FLAGS):
        kept = ~hidden(shown[name])
        assert np.array_equal(again[name].values[kept], shown[name].values[kept])
        unread = again[name].values[~kept]
        assert (unread == FILL_FLAG if name in FLAGS else np.isnan(unread)).all()


@pytest.mark.parametrize("name", FLAGS)
def test_xarray_opens_flags_as_integers_that_all_have_a_meaning(on_disk, name):
    with xr.open_dataset(on_disk) as opened:
        flag = opened[name].load()
    assert flag.dtype == np.int8
    meanings = dict(
        zip(flag.attrs["flag_values"].tolist(), flag.attrs["flag_meanings"].split(), strict=True)
    )
    assert set(np.unique(flag).tolist()) <= meanings.keys()
    assert meanings[FILL_FLAG] == "not_shown"
    assert (name == "solution_status") or meanings[-1] == "without_values"


def test_the_file_is_netcdf_4_with_the_types_of_the_contract(on_disk):
    with netCDF4.Dataset(on_disk) as stored:
        assert stored.data_model == "NETCDF4"
        assert list(stored.dimensions) == list(DIMENSIONS)
        for name in (*MEANINGS, *FLAGS):
            variable = stored[name]
            assert variable.dimensions == DIMENSIONS
            assert variable.dtype == (np.int8 if name in FLAGS else np.float64)
            assert hasattr(variable, "_FillValue") == (name not in FLAGS)
        for name in (*DIMENSIONS, "normal_load"):
            assert not hasattr(stored[name], "_FillValue")


def test_unsolved_points_of_a_grid_do_not_hold_the_fill_value(parameters, tmp_path):
    path = tmp_path / "grid.nc"
    with pytest.warns(tb.OutOfRangeWarning, match="load is 1;"):
        unsolved = grid(parameters, load=[1e-5, 1.0])
    write_dataset(unsolved, path)
    with netCDF4.Dataset(path) as stored:
        for name in (*MEANINGS, *FLAGS):
            # what a reader that knows the convention takes for missing
            assert not np.ma.getmaskarray(stored[name][:]).any(), name
        exceeded = SOLUTION_STATUSES.index("load_exceeded")
        assert (stored["solution_status"][1, 0] == exceeded).all()


def test_the_same_dataset_gives_the_same_bytes(shown, on_disk, tmp_path):
    other = tmp_path / "elsewhere.nc"
    write_dataset(shown, other)
    assert other.read_bytes() == on_disk.read_bytes()


def test_another_user_place_time_zone_and_hash_seed_give_the_same_bytes(
    parameters, on_disk, tmp_path
):
    code = (
        "import json, sys\n"
        "from thirdbody.data.dataset import scene_dataset\n"
        "from thirdbody.data.netcdf import write_dataset\n"
        "from thirdbody.model.parameters import Parameters\n"
        "from thirdbody.data.scene import Scene\n"
        "given, inputs = map(json.loads, sys.argv[1:])\n"
        "inputs = Parameters(**inputs)\n"
        "scene = Scene.of('test', given, inputs.newtons_per_load)\n"
        "write_dataset(scene_dataset(scene, inputs), 'other.nc')\n"
    )
    stranger = {
        "USER": "stranger",
        "LOGNAME": "stranger",
        "HOME": str(tmp_path),
        "TZ": "Pacific/Kiritimati",
        "LC_ALL": "C",
        "PYTHONHASHSEED": "12345",
    }
    subprocess.run(
        [sys.executable, "-c", code, json.dumps(SCENE), json.dumps(parameters.as_dict())],
        check=True,
        cwd=tmp_path,
        env=os.environ | stranger,
    )
    assert digest(tmp_path / "other.nc") == digest(on_disk)


def test_what_solves_and_draws_figures_loads_no_package_of_tables():
    code = (
        "import extract_curves, render_figure, render_schematic, solve_scene, write_table, sys; "
        "print(*sys.modules)"
    )
    scripts = Path(__file__).parents[2] / "workflow" / "scripts"
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=scripts
    )
    assert "netCDF4" in run.stdout.split()
    assert {"pandas", "pint", "xarray"}.isdisjoint(run.stdout.split())


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


DAMAGES = {
    "half": lambda content: content[: len(content) // 2],
    "its first bytes": lambda content: content[:100],
    "all but its last byte": lambda content: content[:-1],
    "nothing": lambda content: b"",
    "other bytes": lambda content: bytes(range(256)) * (len(content) // 256),
    "text": lambda content: b"not a dataset\n",
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_file_is_named_with_the_command_that_remakes_it(on_disk, damage):
    on_disk.write_bytes(DAMAGES[damage](on_disk.read_bytes()))
    with pytest.raises(OSError) as failed:
        read_dataset(on_disk)
    message = str(failed.value)
    assert message.startswith(f"{on_disk} cannot be read")
    assert message.endswith(f"remake it: snakemake -c2 --force {on_disk}")
    assert "\n" not in message


def test_a_file_with_a_flipped_byte_in_its_values_is_refused(on_disk):
    content = bytearray(on_disk.read_bytes())
    with netCDF4.Dataset(on_disk) as stored:
        assert stored["separation"].filters()["zlib"]
    # the compressed values are the part without structure: the two first bytes of zlib's usual
    starts = [index for index in range(len(content) - 1) if content[index : index + 2] == b"x\x9c"]
    assert starts
    for start in starts:
        content[start + 8] ^= 0xFF
    on_disk.write_bytes(content)
    with pytest.raises(OSError, match="cannot be read"):
        read_dataset(on_disk)


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(OSError, match="missing.nc cannot be read"):
        read_dataset(tmp_path / "missing.nc")


def test_a_dataset_of_something_else_is_named(tmp_path):
    path = tmp_path / "other.nc"
    with netCDF4.Dataset(path, "w") as stored:
        stored.createDimension("x", 3)
        stored.createVariable("y", "f8", ("x",))[:] = 1.0
    with pytest.raises(OSError, match="other.nc"):
        read_dataset(path)


def test_a_grid_of_an_unknown_variable_is_refused(parameters):
    axes = {name: [1e-6] for name in DIMENSIONS}
    with pytest.raises(ValueError, match="variables has 'thickness'"):
        tb.grid(**axes, parameters=parameters, variables=["thickness"])
