"""Scenes: axes, named loads, and which combinations are shown."""

import math
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from chenhorng.scenes import scene_groups
from thirdbody.files import read_yaml
from thirdbody.variables import CONDITION_AXES

NEWTONS = 7.0e5
AXIS = {"load_N": [0.04, 80.0], "count": 240}
SURFACES = {
    "viscosity_cSt": [90, 0],
    "particle_density_per_m2": [1.0e11],
    "roughness_nm": [100, 300],
}
CURVES = SURFACES | {"particle_diameter_nm": [300]}
RELATIVE = SURFACES | {"particle_diameter_per_roughness": [0.7, 1.1]}
SCENES = Path(__file__).parents[2] / "config" / "scenes.yaml"


def test_loads_are_log_spaced_and_named_ones_are_on_the_axis_exactly():
    (group,) = scene_groups({"load_axis": AXIS, "curves": [CURVES]}, NEWTONS)
    values = group["load"]
    ends = [float(f"{newtons / NEWTONS:.12g}") for newtons in (0.04, 80.0)]
    assert values.size == 240 and values[[0, -1]].tolist() == ends
    assert_allclose(np.diff(np.log(values)), math.log(2000.0) / 239.0, rtol=1e-10)
    named = [3.27e-6, 1.49e-5, 1.0e-4]
    scene = {"load_axis": AXIS, "named_loads": [*named, 1.0], "curves": [CURVES]}
    (group,) = scene_groups(scene, NEWTONS)
    assert group["load"].tolist() == sorted([*values, *named])


def test_relative_diameters_make_a_group_of_each_roughness():
    small, large = scene_groups({"load_axis": AXIS, "curves": [RELATIVE]}, NEWTONS)
    assert (small["roughness"].tolist(), large["roughness"].tolist()) == ([100e-9], [300e-9])
    assert small["particle_diameter"].tolist() == [70e-9, 110e-9]
    # 1.1 x 300 is 330.00000000000006 in binary
    assert large["particle_diameter"].tolist() == [210e-9, 330e-9]


# what each figure of the paper shows, in the units of the configuration; densities in 1e11 m-2
SHOWN = {
    "fig03": ({0}, {0, 100, 200, 300, 400, 500, 700, 1000}, {100}, {1}),
    "fig04": ({0, 10, 25, 50, 70, 90, 120}, {0, 500}, {300}, {1}),
    "fig05": ({0, 10, 25, 50, 70, 90, 120, 150}, {0, 500}, {100, 500}, {1}),
    "fig06": ({0, 90}, set(range(0, 1001, 100)), {300}, {1}),
    # beside them, in figures 8 and 9, dry contact of two bodies: what areas are held against
    "fig08": ({0, 90}, {0, 500}, {100, 200, 300, 400, 500}, {1}),
    "fig09": ({0}, {0, 200, 225, 250, 275, 300, 325, 350, 375, 400, 450, 500}, {300}, {1}),
    "fig11": ({0, 25, 50, 70, 90, 120, 150}, {300}, {300}, {1}),
}


@pytest.mark.parametrize("figure", [f"fig{number:02d}" for number in range(3, 14)])
def test_each_figure_shows_the_loads_and_conditions_of_the_paper(defaults, figure):
    configured = read_yaml(SCENES)
    entry = {"load_axis": configured["load_axis"]} | configured["scenes"][figure]
    groups = scene_groups(entry, defaults.newtons_per_load)
    load = groups[0]["load"]
    assert load.size >= 200
    assert set(entry.get("named_loads", [])) <= set(load)
    assert_allclose(load[[0, -1]] * defaults.newtons_per_load, [0.04, 80.0], rtol=1e-11)
    if figure in SHOWN:
        *others, densities = SHOWN[figure]
        expected = (*others, {1e11 * density for density in densities})
        for axis, values in zip(CONDITION_AXES, expected, strict=True):
            shown = np.unique(np.concatenate([group[axis.name] for group in groups]))
            assert shown.tolist() == axis.values(values).tolist()
