"""The atlas holds what the library gives point by point, and its keys are checked at the start."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import thirdbody as tb
from chenhorng.atlas import open_atlas
from chenhorng.configuration.settings import read_settings
from thirdbody.variables import FLAGS

RTOL = 1e-3
CONFIG = Path(__file__).parents[2] / "config"
AXES = {
    "load_N": np.geomspace(0.04, 80, 30),
    "viscosity_cSt": [0, *np.geomspace(5, 150, 18)],
    "particle_diameter_nm": [0, 50, 200, 1000],
    "particle_density_per_m2": [1e10, 1e12],
}
SURFACES = 100, 300, 500


def write_chunk(folder, roughness, parameters, **changes):
    given = AXES | {"rtol": RTOL, "parameters": parameters} | changes
    tb.stream(folder / f"{roughness}nm.nc", roughness_nm=roughness, **given)


@pytest.fixture
def folder(defaults, tmp_path):
    for roughness in SURFACES:
        write_chunk(tmp_path, roughness, defaults)
    return tmp_path


def test_it_is_the_grid_over_all_roughnesses(folder, defaults):
    grid = tb.grid(**AXES, roughness_nm=SURFACES, parameters=defaults, rtol=RTOL)
    with open_atlas(folder) as atlas:
        assert dict(atlas.sizes) == dict(grid.sizes)
        assert atlas.attrs["model_parameters"] == grid.attrs["model_parameters"]
        for name in ("particle_contact_area_ratio", "solid_load_fraction", "separation"):
            np.testing.assert_allclose(atlas[name], grid[name], rtol=RTOL, err_msg=name)
            assert atlas[name].attrs["symbol"] == grid[name].attrs["symbol"]
        np.testing.assert_array_equal(atlas["solution_status"], grid["solution_status"])


def test_xarray_reads_it_without_the_library(folder):
    read = xr.open_mfdataset(folder.glob("*.nc"), combine_attrs="drop_conflicts")
    with open_atlas(folder) as atlas, read as plain:
        for name, codes in plain[[*FLAGS]].items():
            names = np.array(codes.flag_meanings.split())[codes.values]
            np.testing.assert_array_equal(atlas[name], names)
        xr.testing.assert_equal(atlas.drop_vars(FLAGS), plain.drop_vars(FLAGS))


@pytest.mark.parametrize(
    "changes",
    [{"rtol": 1e-6}, {"variables": "separation"}, {"load_N": [1, 10]}],
    ids=["rtol", "variables", "axis"],
)
def test_files_of_two_configurations_are_no_atlas(folder, defaults, changes):
    write_chunk(folder, 400, defaults, **changes)
    with pytest.raises(ValueError):
        open_atlas(folder)


def test_files_of_other_inputs_are_no_atlas(folder):
    write_chunk(folder, 400, tb.load_parameters(participation=0.3))
    with pytest.raises(ValueError, match="roughness 4e-07 m in .* was solved with other inputs"):
        open_atlas(folder)


def test_a_damaged_or_missing_file_is_said(folder, tmp_path_factory):
    chunk = folder / "300nm.nc"
    chunk.write_bytes(chunk.read_bytes()[:1000])
    with pytest.raises(OSError, match=r"300nm\.nc"):
        open_atlas(folder)
    with pytest.raises(FileNotFoundError, match="has no files; make them: snakemake -c2 atlas"):
        open_atlas(tmp_path_factory.mktemp("empty"))


BAD = [  # a key, its value, and what the line says
    ("chunks", 5, "atlas.chunks is 5"),
    ("roughness_nm", [300, 100], "atlas.roughness_nm is [300, 100]"),
    ("roughness_nm", [100, 100], "allowed: numbers that increase"),
    ("roughness_nm", [0, 100], "atlas.roughness_nm.0 is 0"),
    ("roughness_nm", 300, "atlas.roughness_nm is 300"),
    ("load_N", [], "atlas.load_N is []"),
    ("viscosity_cSt", [0.1], "atlas.viscosity_cSt.0"),
    ("rtol", 0, "atlas.rtol is 0"),
    ("variables", ["roughness"], "atlas.variables.0 is 'roughness'; allowed: total_contact_area"),
]


@pytest.mark.parametrize(("key", "value", "said"), BAD)
def test_a_bad_key_is_refused_in_one_line_before_anything_is_computed(key, value, said):
    with pytest.raises(ValueError) as refused:
        read_settings({"atlas": {key: value}}, CONFIG)
    assert said in str(refused.value) and "\n" not in str(refused.value)
