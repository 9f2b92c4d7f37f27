"""The paper's panels for datasets of one's own, however they were made."""

import numpy as np
import pytest

import thirdbody as tb
from thirdbody.figures.registry import CURVE_FIGURES
from thirdbody.figures.scales import SCALES

pytestmark = pytest.mark.filterwarnings("error")

LOADS = np.geomspace(1e-7, 1e-4, 12)
AXES = {
    "load": LOADS,
    "viscosity": [0.0, 5e-5, 9e-5],
    "particle_diameter": 3e-7,
    "roughness": 3e-7,
    "particle_density": 1e11,
}
PANELS = [
    "particle_contact_area_ratio",
    "total_contact_area",
    "solid_load_fraction",
    "film_thickness",
]


@pytest.fixture
def grid(parameters):
    """Function that solves the axes above with other ones."""
    return lambda variables=(*PANELS, "separation"), **given: tb.grid(
        **(AXES | given), parameters=parameters, rtol=1e-3, variables=variables
    )


def panels(figure):
    """The variable of each panel, by its axis."""
    names = {scale.label: name for name, scale in SCALES.items()}
    return [names[panel.get_ylabel()] for panel in figure.axes]


def curves(figure):
    """Heights of the curves of each panel."""
    return [
        [line.get_ydata() for line in panel.lines if len(line.get_xdata()) == LOADS.size]
        for panel in figure.axes
    ]


def test_it_shows_the_values_of_the_dataset(grid):
    data = grid()
    figure = tb.plot(data)
    assert panels(figure) == PANELS
    for name, drawn in zip(PANELS, curves(figure), strict=True):
        assert len(drawn) == 3
        for index, heights in enumerate(drawn):
            np.testing.assert_array_equal(heights, data[name][:, index].values.ravel())


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        ({"viscosity": 0.0}, PANELS[:2]),
        ({"viscosity": 9e-5}, PANELS),
        ({"roughness": [1e-7, 3e-7]}, [name for name in PANELS for _ in range(2)]),
        ({"viscosity": 9e-5, "particle_density": np.linspace(1e10, 1e11, 30)}, PANELS),
        ({"variables": ["solid_load_fraction"]}, ["solid_load_fraction"]),
    ],
    ids=["dry", "one curve", "two surfaces", "many curves", "one variable"],
)
def test_panels_are_those_of_what_the_dataset_holds(grid, given, shown):
    assert panels(tb.plot(grid(**given))) == shown


@pytest.mark.parametrize("name", CURVE_FIGURES)
def test_the_panels_of_each_figure_can_be_had(grid, name):
    shown = panels(tb.plot(grid(particle_diameter=[0.0, 3e-7]), like=name))
    assert shown
    assert set(shown) <= {content.y for content in CURVE_FIGURES[name].contents}


def test_a_piece_of_a_dataset_and_a_file_are_drawn_alike(grid, parameters, tmp_path):
    tb.stream(tmp_path / "grid.nc", **AXES, parameters=parameters, rtol=1e-3)
    whole = curves(tb.plot(tmp_path / "grid.nc"))
    piece = curves(tb.plot(grid().sel(viscosity=5e-5)))
    for some, all_ in zip(piece, whole, strict=True):
        np.testing.assert_allclose(some[0], all_[1], rtol=2e-3)


def test_a_solution_is_drawn(parameters):
    given = AXES | {"load": LOADS[:, None]}
    assert panels(tb.plot(tb.solve(**given, parameters=parameters).to_dataset())) == PANELS


def test_turning_points_are_marked(grid):
    point = {name: AXES[name] for name in ("particle_diameter", "roughness", "particle_density")}
    point |= {"viscosity": 0.0, "load": LOADS[5], "peak_ratio": 0.4}
    ratio = tb.plot(grid(), turning_points=[point]).axes[0]
    (mark,) = (line for line in ratio.lines if line.get_marker() == "*")
    assert mark.get_xdata() == pytest.approx([LOADS[5]])


@pytest.mark.parametrize("count", [2, 3])
def test_a_few_loads_are_enough(grid, parameters, count):
    loads = LOADS[:count]
    assert panels(tb.plot(grid(load=loads))) == PANELS
    solution = tb.solve(**(AXES | {"load": loads, "viscosity": 9e-5}), parameters=parameters)
    assert panels(tb.plot(solution.to_dataset())) == PANELS


@pytest.mark.parametrize(
    ("over", "values", "label"),
    [
        ("viscosity", [0.0, 5e-5, 9e-5], "Viscosity ν (cSt)"),
        ("particle_diameter", [1e-7, 2e-7, 3e-7], "Particle diameter xₐ (nm)"),
        ("particle_density", [1e10, 1e11, 1e12], "Particle density ηₐ (m⁻²)"),
    ],
)
def test_any_axis_can_be_along_x(grid, over, values, label):
    data = grid(**({"viscosity": 9e-5, over: values} | {"load": LOADS[:2]}))
    figure = tb.plot(data, over=over)
    assert panels(figure) == PANELS
    assert {panel.get_xlabel() for panel in figure.axes} == {label}
    for name, panel in zip(PANELS, figure.axes, strict=True):
        for index, line in enumerate(panel.lines[:2]):
            np.testing.assert_array_equal(line.get_xdata(), values)
            np.testing.assert_array_equal(line.get_ydata(), data[name][index].values.ravel())
    texts = [text.get_text() for text in figure.legends[0].get_texts()]
    assert len(texts) == 2 and texts[0].startswith("Fₜ* = ")


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"load": 1e-5}, "data has one load; allowed: two or more"),
        ({"particle_diameter": [1e-7, 3e-7]}, "viscosity and particle_diameter vary; allowed: one"),
        ({"variables": ["separation"]}, "there is nothing to draw; allowed: points with"),
    ],
)
def test_what_cannot_be_drawn_is_refused_in_one_line(grid, given, said):
    with pytest.raises(ValueError, match=said):
        tb.plot(grid(**given))


def test_what_is_no_such_dataset_is_refused_by_name(grid, tmp_path):
    data = grid()
    with pytest.raises(ValueError, match="data is of type int; allowed: a dataset of tb.grid"):
        tb.plot(5)
    with pytest.raises(ValueError, match="like is 'fig01'; allowed: fig03, "):
        tb.plot(data, like="fig01")
    with pytest.raises(ValueError, match="over is 'time'; allowed: load, "):
        tb.plot(data, over="time")
    with pytest.raises(ValueError, match="data has one roughness; allowed: two or more"):
        tb.plot(data, over="roughness")
    with pytest.raises(ValueError, match="data has no roughness; allowed"):
        tb.plot(data.squeeze().drop_vars("roughness"))
    with pytest.raises(ValueError, match="band is of type list; allowed"):
        tb.plot(data, band=[])
    with pytest.raises(ValueError, match="data has the dimension 'day'; allowed: load"):
        tb.plot(data.expand_dims(day=2))
    with pytest.raises(FileNotFoundError, match="data is '.*no.nc', which is no file"):
        tb.plot(tmp_path / "no.nc")
