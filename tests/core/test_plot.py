"""The paper's panels for datasets of one's own, however they were made."""

from dataclasses import replace

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from collisions import collisions
from matplotlib.text import Text

import thirdbody as tb
from thirdbody.core import turning_points
from thirdbody.plotting import marks
from thirdbody.plotting.drawing import FORMATS, save_figure
from thirdbody.plotting.plot import plot_curve
from thirdbody.plotting.scales import SCALES, axis_label
from thirdbody.symbols import mathtext
from thirdbody.variables import AXES as CONDITIONS

pytestmark = pytest.mark.filterwarnings("error")

LOADS = np.geomspace(1e-7, 1e-4, 12)
AXES = {
    "load": LOADS,
    "viscosity": [0.0, 5e-5, 9e-5],
    "particle_diameter": 3e-7,
    "roughness": 3e-7,
    "particle_density": 1e11,
}
PANELS = ["particle_contact_area_ratio", "total_contact_area"]
PANELS += ["solid_load_fraction", "film_thickness"]


@pytest.fixture
def grid(parameters):
    """Function that solves the axes above with other ones."""
    return lambda variables=(*PANELS, "separation"), **given: tb.grid(
        **(AXES | given), parameters=parameters, rtol=1e-3, variables=variables
    )


def panels(figure):
    """The variable of each panel, by its axis."""
    names = {axis_label(name): name for name in SCALES}
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
        np.testing.assert_array_equal(np.transpose(drawn), data[name].values.reshape(-1, 3))


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({"viscosity": 0.0}, PANELS[:2]),
        ({"viscosity": 9e-5}, PANELS),
        ({"load": [1e-6, 1e-5]}, PANELS),
        ({"roughness": [1e-7, 3e-7]}, [name for name in PANELS for _ in range(2)]),
        ({"viscosity": 9e-5, "particle_density": np.linspace(1e10, 1e11, 30)}, PANELS),
        ({"variables": ["solid_load_fraction"]}, ["solid_load_fraction"]),
    ],
    ids=["dry", "one curve", "two loads", "two surfaces", "many curves", "one variable"],
)
def test_panels_are_those_of_what_the_dataset_holds(grid, given, expected):
    assert panels(tb.plot(grid(**given))) == expected


def test_a_piece_of_a_dataset_and_a_file_are_drawn_alike(grid, parameters, tmp_path):
    tb.stream(tmp_path / "grid.nc", **AXES, parameters=parameters, rtol=1e-3)
    whole = curves(tb.plot(tmp_path / "grid.nc"))
    piece = curves(tb.plot(grid().sel(viscosity=5e-5)))
    for some, all_ in zip(piece, whole, strict=True):
        np.testing.assert_allclose(some[0], all_[1], rtol=2e-3)


@pytest.mark.parametrize(
    ("over", "values", "label"),
    [
        ("viscosity", [0.0, 5e-5, 9e-5], "Viscosity $ν$ (cSt)"),
        ("particle_density", [1e10, 1e11, 1e12], "Particle density $η_{a}$ (m⁻²)"),
    ],
)
def test_any_axis_can_be_along_x(grid, over, values, label):
    data = grid(**({"viscosity": 9e-5, over: values} | {"load": [1e-7, 1e-6]}))
    figure = tb.plot(data.isel({over: np.s_[::-1]}), over=CONDITIONS[over].alias)  # from its end
    assert panels(figure) == PANELS
    assert {panel.get_xlabel() for panel in figure.axes} == {label}
    for name, panel in zip(PANELS, figure.axes, strict=True):
        for index, line in enumerate(panel.lines[:2]):
            np.testing.assert_array_equal(line.get_xdata(), values)
            np.testing.assert_array_equal(line.get_ydata(), data[name][index].values.ravel())
    texts = [text.get_text() for text in figure.legends[0].get_texts()]
    assert texts[0].startswith("$F_{t}^*$ = 10⁻⁷ (") and len(texts) == 2


def test_one_curve_over_another_axis_has_no_key(grid):
    data = grid(load=[1e-6])
    figure = tb.plot(data, over="viscosity")
    assert not figure.legends
    np.testing.assert_array_equal(figure.axes[0].lines[0].get_xdata(), AXES["viscosity"])


def test_what_would_be_drawn_wrongly_or_not_at_all_is_refused(grid):
    for data, options in (
        (grid(load=1e-5), {"over": "load"}),  # a curve of one point
        (grid(), {"over": "roughness"}),
        (grid(roughness=np.linspace(1e-7, 5e-7, 7)), {}),  # more panels than letters
        (grid(["separation"]), {}),
    ):
        with pytest.raises(ValueError, match="allowed"):
            tb.plot(data, **options)


def test_a_solution_is_drawn_as_its_dataset_and_some_variables_alone(parameters):
    loads = np.geomspace(1e-7, 1e-4, 5)
    given = {"particle_diameter": 3e-7, "roughness": 3e-7, "particle_density": 1e11}
    found = tb.solve(load=loads[:, None], viscosity=[0.0, 9e-5], **given, parameters=parameters)
    figure, other = tb.plot(found), tb.plot(found.to_dataset())
    assert len(figure.axes) == len(other.axes)
    one = tb.plot(found, variables="solid_load_fraction")
    assert [panel.y for panel in one.panels] == ["solid_load_fraction"]


def test_packed_numbers_are_decoded_wherever_a_dataset_is_from(grid, tmp_path):
    data, path = grid(), tmp_path / "packed.nc"
    packing = {"dtype": "i2", "scale_factor": 1e-4, "add_offset": 0.5, "_FillValue": -32768}
    data.to_netcdf(path, encoding={"solid_load_fraction": packing})
    packed = xr.open_dataset(path, mask_and_scale=False)
    assert packed["solid_load_fraction"].attrs["scale_factor"] == 1e-4
    expected = curves(tb.plot(path))
    for chosen in (packed, packed.stack(point=["load", "viscosity"])):
        for drawn, lines in zip(curves(tb.plot(chosen)), expected, strict=True):
            np.testing.assert_array_equal(drawn, lines)


def test_other_shapes_of_the_same_data_are_drawn_alike(grid):
    data = grid()
    expected = curves(tb.plot(data))
    table = data.to_dataframe()
    for other in (
        table.to_xarray(),
        table,
        table.reset_index(),
        data.squeeze(),
        data.transpose(),
        data.stack(point=["load", "viscosity"]),
        data.stack(point=["load", "viscosity"]).reset_index("point"),
        data.swap_dims(load="normal_load"),
    ):
        found = curves(tb.plot(other))
        for drawn, lines in zip(found, expected, strict=True):
            np.testing.assert_allclose(drawn, lines)


def test_pairs_of_conditions_are_no_curves(parameters):
    given = {"particle_diameter": 3e-7, "roughness": 3e-7, "particle_density": 1e11}
    pairs = tb.solve(load=[1e-6, 1e-5], viscosity=[0.0, 9e-5], **given, parameters=parameters)
    with pytest.raises(ValueError, match="data has the dimension 'point', with points that are"):
        tb.plot(pairs)


def test_a_load_in_newtons_is_drawn_in_newtons(grid):
    rest = dict(viscosity_cSt=90, particle_diameter_nm=300, roughness_nm=300)
    loads = [1.0, 2.0, 5.0]
    found = tb.solve(load_N=loads, **rest, particle_density_per_m2=1e11)
    for figure in (tb.plot(found), tb.plot(found.to_dataset(), over="load_N")):
        for axes in figure.axes:
            assert axes.get_xlabel() == axis_label("normal_load")
            np.testing.assert_allclose(axes.lines[0].get_xdata(), loads)
    assert tb.plot(found, over="load").axes[0].get_xlabel() == axis_label("load")
    with pytest.raises(ValueError, match="nothing to draw"):
        tb.plot(found.to_dataset().drop_vars("normal_load"), over="load_N")


def test_a_grid_of_loads_in_newtons_is_drawn_in_newtons(tmp_path):
    rest = dict(viscosity_cSt=90, particle_diameter_nm=300, roughness_nm=300)
    rest |= dict(particle_density_per_m2=1e11, load_N=[1.0, 2.0, 5.0])
    data = tb.grid(**rest)
    tb.stream(tmp_path / "grid.nc", **rest)
    for given in (
        data,
        data.isel(load=[0, 2]),
        tmp_path / "grid.nc",
        tb.solve(**rest).to_dataset(),
    ):
        axes = tb.plot(given).axes[0]
        assert axes.get_xlabel() == axis_label("normal_load")
        np.testing.assert_allclose(axes.lines[0].get_xdata()[[0, -1]], [1.0, 5.0])
    assert tb.plot(data, over="load").axes[0].get_xlabel() == axis_label("load")


@pytest.mark.parametrize(("along", "unit"), [("load_N", 1.0), ("viscosity_cSt", 1e-6)])
def test_a_curve_of_one_interface_is_drawn_with_its_range(along, unit):
    x = np.geomspace(1.0, 100.0, 5)
    ratio = np.linspace(0.2, 0.6, 5)
    table = pd.DataFrame({along: x} | dict.fromkeys(PANELS, ratio))
    table = table.assign(solid_load_fraction_low=ratio - 0.1, solid_load_fraction_high=ratio + 0.1)
    others = {"load_N": 5.0, "viscosity_cSt": 90.0, "roughness_nm": 300.0}
    others.pop(along)
    figure = plot_curve(table, along, others)
    other = "ν = 90 cSt" if along == "load_N" else "Fₜ = 5 N"
    assert figure.legends[0].get_title().get_text() == mathtext(f"{other}, σ = 300 nm")
    assert panels(figure) == PANELS
    first, second = figure.axes[PANELS.index("solid_load_fraction") :]
    np.testing.assert_allclose(first.lines[0].get_xdata(), unit * x, rtol=1e-12)
    np.testing.assert_array_equal(first.lines[0].get_ydata(), ratio)
    (outline,) = first.collections[0].get_paths()
    assert outline.vertices[:, 1].max() == pytest.approx(0.7)
    np.testing.assert_array_equal(second.lines[0].get_ydata(), ratio)
    assert not second.collections


def test_the_load_of_a_peak_lies_between_those_that_are_solved():
    load = np.geomspace(1e-7, 1e-4, 40)
    ratio = np.exp(-(np.log(load / 3e-6) ** 2))
    assert marks.peak_load(load, ratio) == pytest.approx(3e-6, rel=1e-3)
    assert marks.peak_load(load[:10], ratio[:10]) == load[9]
    assert marks.peak_load(load, np.ones(40)) == load[0]
    plateau = np.minimum(ratio, 0.5)
    assert load[0] < marks.peak_load(load, plateau) < load[-1]


@pytest.mark.parametrize("solver", [tb.grid, tb.solve])
@pytest.mark.parametrize("over", ["load", "load_N", "viscosity"])
def test_data_of_members_are_drawn_as_the_best_with_the_range(defaults, over, solver):
    inputs = replace(defaults, members=defaults.members[:3])
    interface = dict(particle_diameter=3e-7, particle_density=1e11, roughness=3e-7)
    along = np.array([2.0, 10.0, 50.0]), np.array([9e-5, 12e-5, 15e-5])
    load, viscosity = (along[0], 9e-5) if over != "viscosity" else (10.0, along[1])
    data = solver(load_N=load, viscosity=viscosity, **interface, parameters=inputs, members=True)
    (axes,) = tb.plot(data, over=over, variables="solid_load_fraction").axes
    (curve,) = [line for line in axes.lines if line.get_xdata().size == 3]
    shares = [
        tb.solve(load_N=load, viscosity=viscosity, **interface, parameters=each).solid_load_fraction
        for each in inputs
    ]
    np.testing.assert_allclose(curve.get_ydata(), shares[0], rtol=1e-6)
    (outline,) = axes.collections[-1].get_paths()
    expected = np.quantile(shares, (0.05, 0.95), axis=0)
    for place in (0, -1):  # every second load has an edge
        at = np.isclose(outline.vertices[:, 0], curve.get_xdata()[place])
        drawn = outline.vertices[at, 1]
        assert (drawn.min(), drawn.max()) == pytest.approx(expected[:, place], rel=1e-6)


def test_a_range_of_another_interface_cannot_be_given(grid):
    with pytest.raises(TypeError, match="band"):
        tb.plot(grid(), band=grid(roughness=1e-7))


def test_a_solution_without_its_status_is_drawn(parameters):
    given = {"particle_diameter": 3e-7, "roughness": 3e-7, "particle_density": 1e11}
    chosen = dict(variables="solid_load_fraction", parameters=parameters)
    found = tb.solve(load=LOADS, viscosity=9e-5, **given, **chosen)
    assert panels(tb.plot(found)) == ["solid_load_fraction"]


def test_it_draws_on_axes_of_ones_own(grid):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    data = grid()
    own, (left, right) = pyplot.subplots(1, 2)
    assert tb.plot(data, variables="solid_load_fraction", ax=right) is own
    assert not left.lines and len(right.lines) == 3
    assert [text.get_text() for text in right.get_legend().get_texts()] == ["dry", "50", "90"]
    tb.plot(data, variables=PANELS[:2], over="viscosity", ax=pyplot.subplots(1, 2)[1])
    with pytest.raises(ValueError):  # two panels on one
        tb.plot(data, variables=PANELS[:2], ax=left)
    pyplot.close("all")


@pytest.mark.parametrize("over", ["load", "particle_diameter"])
def test_a_key_of_many_curves_is_within_the_figure(parameters, over):
    axes = {
        "load": dict(viscosity=np.linspace(1e-5, 1e-4, 27), particle_diameter=3e-7),
        "particle_diameter": dict(
            viscosity=np.linspace(1e-5, 1e-4, 8), particle_diameter=[3e-7, 5e-7]
        ),
    }
    loads = LOADS if over == "load" else LOADS[:3]
    given = AXES | {"load": loads} | axes[over]
    figure = tb.plot(tb.grid(**given, parameters=parameters, rtol=1e-3), over=over)
    figure.canvas.draw()
    (key,) = figure.legends
    assert len(key.get_texts()) > 20
    inner, outer = key.get_window_extent(), figure.bbox
    assert inner.x0 >= outer.x0 and inner.x1 <= outer.x1 and inner.y0 >= outer.y0


@pytest.fixture(scope="module")
def plane(defaults):
    """A grid over load and viscosity."""
    loads, oils = np.geomspace(0.04, 80.0, 60), np.linspace(10.0, 160.0, 40)
    rest = dict(particle_diameter_nm=300, roughness_nm=300, particle_density_per_m2=1e11)
    return tb.grid(load_N=loads, viscosity_cSt=oils, **rest, parameters=defaults)


WORDS = {
    "surface-surface": "surface_surface",
    "s-s": "surface_surface",
    "p-s": "particle_surface",
    "particle-surface": "particle_surface",
    "hybrid": "hybrid",
    "boundary": "boundary",
    "B.L.": "boundary",
    "mixed": "mixed",
    "M.L.": "mixed",
    "full film": "full_film",
    "F.L.": "full_film",
}


@pytest.mark.parametrize("over", [("load_N", "viscosity_cSt"), ("viscosity", "load")])
@pytest.mark.parametrize("width_mm", [84, 174])
def test_names_on_a_map_are_those_of_the_solution_there(plane, defaults, over, width_mm):
    figure = tb.plot(plane, over=over, width_mm=width_mm)
    assert not collisions(figure)
    (axes,) = figure.axes
    seen = set()
    for text in axes.texts:
        at = axes.transData.inverted().transform(
            axes.transAxes.transform(text.get_unitless_position())
        )
        given = dict(zip(over, at, strict=True))
        rest = dict(particle_diameter_nm=300, roughness_nm=300, particle_density_per_m2=1e11)
        if "viscosity_cSt" in given:
            given["viscosity_cSt"] *= 1e6  # axes are in SI
        found = tb.solve(**given, **rest, parameters=defaults)
        words = [WORDS[word] for word in text.get_text().split("\n")]
        regime = found.lubrication_regime
        assert words == ([found.contact_mode] if regime != "full_film" else []) + [regime]
        seen.add(tuple(words))
    assert {("hybrid", "mixed"), ("hybrid", "boundary")} <= seen
    assert ("full_film",) in seen or over[0] == "viscosity"  # where it is narrow


def test_the_line_on_a_map_is_that_of_the_turning_points(plane, defaults):
    (axes,) = tb.plot(plane, over=["load_N", "viscosity_cSt"]).axes
    (line,) = axes.lines
    loads, viscosities = line.get_data()
    rest = dict(particle_diameter_nm=300, roughness_nm=300, particle_density_per_m2=1e11)
    found = tb.turning_point(viscosity=viscosities, **rest, parameters=defaults)
    np.testing.assert_allclose(loads, found["load_N"], rtol=0.02)
    assert len(axes.figure.legends) == 1
    assert marks.PROMINENCE == turning_points.PROMINENCE
    for part in (plane.isel(load=np.s_[:5]), plane.isel(viscosity=[0, -1])):  # no line
        assert not tb.plot(part, over=["load_N", "viscosity_cSt"]).legends


def test_what_has_no_map_is_refused(plane, grid):
    for data, over in (
        (plane[["total_contact_area"]], ["load", "viscosity"]),
        (grid(roughness=[1e-7, 3e-7]), ["load", "viscosity"]),
        (plane, ["load", "load_N"]),
        (plane.isel(load=[0]), ["load", "viscosity"]),
    ):
        with pytest.raises(ValueError, match="allowed"):
            tb.plot(data, over=over)


def collided(**given):
    """Texts that are over something, in a figure of dry and lubricated contact."""
    points = tb.grid(
        load_N=np.geomspace(0.04, 80, 100),
        viscosity_cSt=[0, 90],
        roughness_nm=300,
        particle_diameter_nm=[300, 500, 700, 1000],
        particle_density_per_m2=1e11,
    )
    return collisions(tb.plot(points, **given))


@pytest.mark.parametrize("width_mm", [84, 174])
@pytest.mark.parametrize("variable", PANELS)
def test_a_figure_of_one_panel_has_room_for_names(variable, width_mm):
    assert not collided(variables=variable, width_mm=width_mm)


def test_the_width_is_that_of_the_figure_and_of_its_columns(grid):
    data = grid()
    for width_mm, variables, expected, columns in (
        (None, PANELS, 174, 2),
        (None, PANELS[0], 84, 1),
        (84, PANELS, 84, 1),
        (140, PANELS, 140, 2),
    ):
        figure = tb.plot(data, variables=variables, width_mm=width_mm)
        assert figure.bbox.width / figure.dpi == pytest.approx(expected / 25.4)
        assert len({round(axes.get_position().x0, 2) for axes in figure.axes}) == columns
        texts = figure.findobj(type(figure.axes[0].title))
        assert min(text.get_fontsize() for text in texts) >= 7.0


def test_names_leave_the_room_of_the_curves_and_ticks_to_them(grid):
    axes = tb.plot(grid(), variables="solid_load_fraction").axes[0]
    axes.figure.draw_without_rendering()
    assert axes.texts
    end = axes.transData.transform((LOADS[-1], 0.0))[0]
    frame = axes.get_window_extent()
    for text in axes.texts:
        box = Text.get_window_extent(text)
        assert end < box.x0 and box.x1 < frame.x1
    ticks = [*axes.get_xticks(), *axes.get_xticks(minor=True)]
    assert min(ticks) > 0.9 * LOADS[0] and max(ticks) < 1.1 * LOADS[-1]


def test_points_outside_the_film_formula_are_dotted_over_any_axis():
    oils = [0.0, *np.geomspace(1e-3, 100.0, 12)]
    rest = dict(particle_diameter_nm=300, roughness_nm=300, particle_density_per_m2=1e11)
    with pytest.warns(tb.OutOfRangeWarning):
        points = tb.solve(load_N=80, viscosity_cSt=oils, **rest)
    outside = points.to_dataset()["solution_status"].values.ravel() == "outside_film_formula"
    assert 1 < outside.sum() < len(oils) and points.solid_load_fraction[1] < 0.99
    figure = tb.plot(points, over="viscosity_cSt", variables="solid_load_fraction")
    curve, dotted = figure.axes[0].lines
    np.testing.assert_array_equal(np.isnan(curve.get_ydata()), outside)
    np.testing.assert_array_equal(dotted.get_ydata(), points.solid_load_fraction[outside])
    assert dotted.get_linestyle() == ":"
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["outside film formula"]


def test_a_stribeck_curve_is_drawn_over_the_speed():
    layer = dict(particle_diameter_nm=500, roughness_nm=300, particle_density_per_m2=1e11)
    speeds = np.geomspace(0.1, 20.0, 12)
    solution = tb.solve(load_N=10, viscosity_cSt=90, speed_m_per_s=speeds, **layer)
    axes = tb.plot(solution, variables="solid_load_fraction").axes[0]
    assert "$u$ (m/s)" in axes.get_xlabel() and axes.get_xscale() == "log"
    x, y = axes.lines[0].get_data()
    np.testing.assert_allclose(x, speeds)
    np.testing.assert_allclose(y, solution.solid_load_fraction)
    grid = tb.grid(load_N=10, viscosity_cSt=[45, 90], speed_m_per_s=speeds, **layer)
    assert len(tb.plot(grid, over="speed_m_per_s", variables="film_thickness").axes[0].lines) == 2
    loads = tb.grid(load_N=[1, 10], viscosity_cSt=90, speed_m_per_s=speeds, **layer)
    with pytest.raises(ValueError, match="vary with the speed"):
        tb.plot(loads)


@pytest.mark.parametrize(
    ("name", "factor", "unit"),
    [("viscosity", 1e6, "cSt"), ("solid_load_fraction", 100.0, "percent"), ("load", 1.0, "N")],
)
def test_other_units_are_converted_or_refused(name, factor, unit):
    layer = dict(particle_diameter_nm=300, roughness_nm=300, particle_density_per_m2=1e11)
    grid = tb.grid(load=np.geomspace(1e-6, 1e-4, 5), viscosity_cSt=[50, 90], **layer)
    changed = grid.assign({name: (factor * grid[name]).assign_attrs(units=unit)})
    if name == "load":
        with pytest.raises(ValueError, match="^load is in N; allowed: "):
            tb.plot(changed)
        return
    lines = (
        tb.plot(data, variables="solid_load_fraction").axes[0].lines for data in (grid, changed)
    )
    for one, other in zip(*lines, strict=True):
        np.testing.assert_allclose(one.get_xydata(), other.get_xydata(), rtol=1e-9)


@pytest.mark.parametrize("kind", FORMATS)
def test_want_of_room_names_the_picture_and_leaves_nothing(grid, tmp_path, kind):
    resource = pytest.importorskip("resource")  # POSIX
    figure = tb.plot(grid())
    usual = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, usual[1]))  # bytes of a file
    try:
        with pytest.raises(OSError, match=f"a.{kind} cannot be written .File too large"):
            save_figure(figure, tmp_path / f"a.{kind}")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, usual)
    assert not list(tmp_path.iterdir())
