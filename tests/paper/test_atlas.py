"""The atlas holds what the library gives point by point, for the default and for each member."""

import shutil

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.core.regimes import CONTACT_MODES, LUBRICATION_REGIMES
from chenhorng.atlas.catalogue import open_atlas
from chenhorng.atlas.chunk import atlas_axes, write_chunk
from thirdbody.variables import DIMENSIONS

RTOL = 1e-3
ENDS = {  # of the axes, how many values they have, and which besides
    "load_N": (0.04, 80, 12, "logarithmic", []),
    "viscosity_cSt": (5, 150, 18, "logarithmic", [0]),
    "particle_diameter_nm": (50, 1000, 24, "logarithmic", [0]),
    "roughness_nm": (100, 300, 3, "linear", []),
    "particle_density_per_m2": (1e10, 1e12, 3, "logarithmic", []),
}
AXES = {
    name: dict(zip(("from", "to", "count", "scale", "also"), ends, strict=True))
    for name, ends in ENDS.items()
}


@pytest.fixture(scope="module")
def members(defaults):
    """The default, and two others of the ensemble."""
    return defaults.members[:3]


@pytest.fixture(scope="module")
def written(defaults, members, tmp_path_factory):
    """The folder of two chunks."""
    folder = tmp_path_factory.mktemp("atlas")
    grid = atlas_axes(AXES)
    usual = defaults.best.as_dict().items()
    changes = [dict(each.as_dict().items() - usual) for each in members]
    for number in (2, 1):
        kept = ["particle_contact_area_ratio", "solid_load_fraction"]
        some = np.array_split(grid["roughness"], 2)[number - 1]
        write_chunk(
            folder / f"{number}-of-2.nc",
            {**grid, "roughness": some},
            defaults.best,
            changes,
            kept,
            RTOL,
        )
    return folder


@pytest.fixture
def atlas(written):
    with open_atlas(written) as dataset:
        yield dataset


def solved(parameters, newtons, atlas):
    axes = {name: atlas[name].values for name in DIMENSIONS[1:]}
    return tb.grid(load=newtons / parameters.newtons_per_load, **axes, parameters=parameters)


def test_it_is_the_grid_of_the_default(atlas, defaults):
    expected = solved(defaults, atlas["normal_load"].values, atlas)
    assert dict(expected.sizes).items() <= dict(atlas.sizes).items()
    for name in ("particle_contact_area_ratio", "solid_load_fraction"):
        np.testing.assert_allclose(atlas[name], expected[name], rtol=2 * RTOL, err_msg=name)
        assert atlas[name].attrs["symbol"] == expected[name].attrs["symbol"]
    differs = (atlas["contact_mode"] != expected["contact_mode"]).values
    assert differs.mean() < 1e-3  # those next to a limit
    assert atlas.attrs["model_parameters"] == expected.attrs["model_parameters"]


def test_probabilities_are_shares_of_the_members_at_the_same_normal_load(atlas, members):
    grids = [solved(each, atlas["normal_load"].values, atlas) for each in members]
    flags = {"lubrication_regime": LUBRICATION_REGIMES, "contact_mode": CONTACT_MODES}
    for flag, states in flags.items():
        total = sum(atlas[f"{state}_probability"] for state in states)
        np.testing.assert_allclose(total, 1.0)
        for index, state in enumerate(states):
            share = np.mean([each[flag].values == index for each in grids], axis=0)
            found = atlas[f"{state}_probability"].values
            assert (np.abs(found - share) > 1e-9).mean() < 2e-3, state


def test_a_damaged_chunk_is_named(written, tmp_path):
    copy = shutil.copytree(written, tmp_path / "atlas")
    chunk = copy / "1-of-2.nc"
    chunk.write_bytes(chunk.read_bytes()[:1000])
    with pytest.raises(OSError, match=r"1-of-2\.nc"):
        open_atlas(copy)


def test_an_atlas_is_whole_and_one(written, tmp_path):
    """A part of the roughnesses, or files of two atlases, would be taken for the whole."""
    copy = shutil.copytree(written, tmp_path / "atlas")
    shutil.copyfile(copy / "1-of-2.nc", copy / "1-of-3.nc")
    with pytest.raises(FileNotFoundError, match="all files of one atlas"):
        open_atlas(copy)
    for name in ("1-of-2.nc", "1-of-3.nc"):
        (copy / name).unlink()
    with pytest.raises(FileNotFoundError, match="all files of one atlas"):
        open_atlas(copy)


def test_the_same_chunk_has_the_same_bytes(defaults, members, tmp_path):
    grid = atlas_axes({name: axis | {"count": 2} for name, axis in AXES.items()})
    changes = [{"apparent_area": members[1].apparent_area}]
    for name in ("one", "other"):
        write_chunk(tmp_path / name, grid, defaults.best, changes, ["separation"], RTOL)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "other").read_bytes()
