"""Figures: what each shows, that its file of data says the same, and that its bytes are stable."""

import csv
import re
from pathlib import Path

import matplotlib.style
import numpy as np
import pytest
import xarray as xr
import yaml
from matplotlib.colors import to_rgb
from matplotlib.transforms import Bbox

from thirdbody.data.conditions import CONDITION_AXES, DIMENSIONS
from thirdbody.data.dataset import scene_dataset
from thirdbody.data.quantities import QUANTITIES
from thirdbody.data.scene import Scene
from thirdbody.data.section import sections
from thirdbody.figures import charts
from thirdbody.figures.captions import CAPTIONS, caption_text
from thirdbody.figures.marks import condition_key
from thirdbody.figures.registry import CURVE_FIGURES, SCHEMATICS, curve_figure
from thirdbody.figures.sheet.saving import SUFFIXES, drawn_points, save
from thirdbody.figures.shown import shown_curves
from thirdbody.study.claims import load_claims
from thirdbody.study.printed import printed_rows

ROOT = Path(__file__).parents[2]
STYLE = ROOT / "src/thirdbody/figures/paper.mplstyle"
LOAD_AXIS = {"load_N": [0.04, 80.0], "count": 25}
RATIO, AREA, SOLID, FILM, OVER = (
    "particle_contact_area_ratio",
    "total_contact_area",
    "solid_load_fraction",
    "film_thickness",
    "total_contact_area_over_two_body",
)
ENDS = ("low", "high")
CAPTION = "What it shows.\n"
AT_A_LOAD = ("turning_point_solid_load", "bend_load_over_mixed_load")
WINDOW = ("diameter_ratio", "turning_point_ratio")
GREY = (0.299, 0.587, 0.114)  # weights of the colours, ITU-R BT.601
# x and y of panels A, B, ... as the text of the paper describes them
PANELS = {
    "fig03": [("load", RATIO), ("load", AREA), ("load", OVER)],
    "fig04": [("load", RATIO), ("load", AREA), ("load", SOLID), ("load", FILM)],
    "fig05": [("load", SOLID), ("load", SOLID)],
    "fig06": [("load", AREA), ("load", SOLID), ("load", RATIO), ("load", OVER)],
    "fig07": [("load", AREA), ("load", SOLID), ("load", RATIO), ("load", OVER)],
    "fig08": [("load", AREA), ("load", SOLID), ("load", RATIO), ("load", OVER)],
    "fig09": [("load", RATIO), ("load", AREA), ("load", OVER), WINDOW],
    "fig10": [("load", RATIO), ("load", RATIO), WINDOW, WINDOW],
    "fig11": [("load", RATIO), ("load", SOLID), (FILM, RATIO)],
    "fig12": [("load", RATIO), ("load", SOLID), ("load", RATIO)],
    "fig13": [("load", RATIO)] * 3,
}
# curves in each panel
COUNTS = {
    "fig03": [8] * 3,
    "fig04": [8] * 4,
    "fig05": [8, 8],
    "fig06": [22] * 4,
    "fig07": [16] * 4,
    "fig08": [10] * 4,
    "fig09": [11, 11, 11, 0],
    "fig10": [10, 10, 0, 0],
    "fig11": [7] * 3,
    "fig12": [5, 5, 7],
    "fig13": [7] * 3,
}
MODES = [
    {"load_N": 2.0, "viscosity_cSt": 0, "particle_diameter_nm": diameter, "roughness_nm": 300,
     "particle_density_per_m2": 1e11}
    for diameter in (100, 1000, 300)
]  # fmt: skip
INTERFACE = [
    {"load_N": 50.0, "viscosity_cSt": 90, "particle_diameter_nm": 500, "roughness_nm": 300,
     "particle_density_per_m2": 1e11}
]  # fmt: skip


def decoded(scene, parameters):
    """The dataset of ``scene``, as it is read from a file."""
    return xr.decode_cf(scene_dataset(scene, parameters, 1e-4))


@pytest.fixture(scope="module")
def datasets(parameters):
    """The paper's scenes on a few loads."""
    scenes = yaml.safe_load((ROOT / "config" / "scenes.yaml").read_text())["scenes"]
    shown = [
        Scene.of(name, scenes[name] | {"load_axis": LOAD_AXIS}, parameters.newtons_per_load)
        for name in PANELS
    ]
    return {scene.name: decoded(scene, parameters) for scene in shown}


@pytest.fixture(autouse=True)
def style():
    with matplotlib.style.context(STYLE, after_reset=True):
        yield


@pytest.fixture(scope="module")
def schematics(parameters):
    with matplotlib.style.context(STYLE, after_reset=True):
        return {
            "fig01": SCHEMATICS["fig01"](sections("fig01", INTERFACE, parameters)),
            "fig02": SCHEMATICS["fig02"](sections("fig02", MODES, parameters)),
        }


@pytest.fixture(scope="module")
def printed():
    """Rows of the paper's numbers by figure."""
    claims = load_claims(ROOT / "config" / "claims.yaml")
    rows = printed_rows(claims)
    return {name: [row for row in rows if row["figure"] == name] for name in PANELS}


def turning_points_in(data):
    """The highest point of each curve, where it lies within the loads."""
    found = []
    for curve in shown_curves(data):
        ratio = curve.values(data, RATIO)
        top = int(np.argmax(ratio))
        if 0 < top < ratio.size - 1:
            conditions = {name: getattr(curve.condition, name) for name in DIMENSIONS[1:]}
            load = float(data["load"].values[top])
            found.append(conditions | {"load": load, "peak_ratio": float(ratio[top])})
    return found


def saved(figure, stem):
    save(figure, stem, CAPTION)
    return {suffix: Path(f"{stem}{suffix}").read_bytes() for suffix in SUFFIXES}


def drawn_rows(path):
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def data_lines(panel):
    return [line for line in panel.lines if not line.get_label().startswith("_")]


def test_every_figure_of_the_paper_is_drawn():
    names = [f"fig{number:02d}" for number in range(1, 14)]
    assert sorted(SCHEMATICS | CURVE_FIGURES) == names


@pytest.mark.parametrize("name", PANELS)
def test_panels_and_their_curves(name, datasets):
    figure = CURVE_FIGURES[name].plot(datasets[name])
    assert [panel.letter for panel in figure.axes] == list("ABCD"[: len(PANELS[name])])
    assert [(panel.x_name, panel.y_name) for panel in figure.axes] == PANELS[name]
    assert [len(data_lines(panel)) for panel in figure.axes] == COUNTS[name]
    for panel in figure.axes:
        (left, right), (bottom, top) = panel.get_xlim(), panel.get_ylim()
        for line in data_lines(panel):
            x, y = line.get_data()
            assert ((left < x) & (x < right) & (bottom < y) & (y < top)).all()
        assert len({line.get_label() for line in data_lines(panel)}) == len(data_lines(panel))


@pytest.mark.parametrize("name", PANELS)
def test_key_explains_every_curve(name, datasets):
    figure = CURVE_FIGURES[name].plot(datasets[name], turning_points_in(datasets[name]))
    entries = {look(line) for line in figure.artists}
    drawn = {look(line) for panel in figure.axes for line in data_lines(panel)}
    if name in ("fig06", "fig07", "fig08"):  # dry curves go by their lubricated counterparts
        drawn = {each for each in drawn if each[0] != "--"}
    # a curve is bare where it lies on another: its entry has the marker that it shows elsewhere
    bare = {each for each in drawn if each[1] == "none"}
    assert drawn - bare <= entries
    assert {(line, colour) for line, _, colour in bare} <= {(e[0], e[2]) for e in entries}
    assert len(figure.texts) == 1 + len(figure.artists)


def look(line):
    return line.get_linestyle(), marker_of(line), to_rgb(line.get_color())


def marker_of(line):
    return "none" if line.get_marker() in ("None", "none", "", None) else line.get_marker()


@pytest.mark.parametrize("name", PANELS)
def test_key_shows_no_marker_that_no_panel_shows(name, datasets):
    figure = CURVE_FIGURES[name].plot(datasets[name], turning_points_in(datasets[name]))
    shown = {marker_of(line) for panel in figure.axes for line in data_lines(panel)}
    assert {marker_of(line) for line in figure.artists} <= shown | {"none"}


def test_curves_have_markers_only_where_they_part(datasets):
    # at 500 nm all lubricated curves lie on the dry one, at 100 nm they leave it
    parted, together = CURVE_FIGURES["fig05"].plot(datasets["fig05"]).axes
    assert {marker_of(line) for line in data_lines(together)} == {"none"}
    assert len({marker_of(line) for line in data_lines(parted)}) > 2
    heights = np.array([line.get_ydata() for line in data_lines(parted)])
    for line in data_lines(parted):
        if marker_of(line) != "none":
            places = line.get_markevery()
            others = np.abs(heights - line.get_ydata())[:, places]
            assert (np.sort(others, axis=0)[1] > 1e-3).all()


@pytest.mark.parametrize("name", ["fig03", "fig09", "fig10"])
def test_figures_of_dry_contact_alone_are_drawn_solid(name, datasets):
    for panel in CURVE_FIGURES[name].plot(datasets[name]).axes:
        assert {line.get_linestyle() for line in data_lines(panel)} <= {"-"}


@pytest.mark.parametrize("name", ["fig04", "fig05", "fig06", "fig07", "fig08", "fig11", "fig12"])
def test_dry_curves_lie_on_top_of_lubricated_ones(name, datasets):
    for panel in CURVE_FIGURES[name].plot(datasets[name]).axes:
        heights = {True: [], False: []}
        for line in data_lines(panel):
            heights["nu = 0 cSt" in line.get_label()].append(line.get_zorder())
        assert min(heights[True]) > max(heights[False])


def test_points_that_are_not_plainly_converged_are_marked(datasets):
    data = datasets["fig11"].load().copy(deep=True)
    plain = CURVE_FIGURES["fig11"].plot(data)
    assert not any("formula" in text.get_text() for text in plain.texts)
    attributes = data["solution_status"].attrs
    flags = dict(zip(attributes["flag_meanings"].split(), attributes["flag_values"], strict=True))
    data["solution_status"][5:8, -1] = flags["outside_film_formula"]
    data["solution_status"][20, -1] = flags["several_separations"]
    figure = CURVE_FIGURES["fig11"].plot(data)
    texts = " ".join(text.get_text() for text in figure.texts)
    assert "formula" in texts
    assert "several" in texts
    for panel in figure.axes:
        marked = {}
        for label, points in drawn_points(panel):
            meaning = label.split("; ")[0]
            if meaning in flags:
                assert "nu = 150 cSt" in label
                marked.setdefault(meaning, []).append(points[0])
        curve = shown_curves(data)[-1]
        x, y = (curve.values(data, name) for name in (panel.x_name, panel.y_name))
        ends = [(x[place], y[place]) for place in (5, 7)]
        np.testing.assert_array_equal(marked["outside_film_formula"], ends)
        np.testing.assert_array_equal(marked["several_separations"], [(x[20], y[20])])


@pytest.mark.parametrize("status", ["coverage_exceeded", "load_exceeded"])
def test_a_curve_that_ends_without_a_solution_is_marked_at_its_end(datasets, status):
    data = datasets["fig11"].load().copy(deep=True)
    attributes = data["solution_status"].attrs
    flags = dict(zip(attributes["flag_meanings"].split(), attributes["flag_values"], strict=True))
    missing = np.s_[-4:, -1]  # the last loads of the last viscosity
    data["solution_status"][missing] = flags[status]
    for name in QUANTITIES:
        data[name][missing] = np.nan
    figure = CURVE_FIGURES["fig11"].plot(data)
    assert "none beyond" in " ".join(text.get_text() for text in figure.texts)
    curve = shown_curves(data)[-1]
    for panel in figure.axes:
        marked = [points for label, points in drawn_points(panel) if label.startswith(status)]
        x, y = (curve.values(data, name) for name in (panel.x_name, panel.y_name))
        np.testing.assert_array_equal(marked, [[(x[-5], y[-5])]])
    assert "none beyond" in caption_text("fig11", figure, data)


@pytest.mark.parametrize("name", PANELS)
def test_nothing_leaves_the_sheet_or_covers_another(name, datasets, printed):
    data = datasets[name]
    windows = [{"roughness_m": 3e-7, "end": "low", "diameter_over_roughness": 0.9}]
    band = xr.Dataset({f"{y}_{end}": data[y] for _, y in PANELS[name] if y in data for end in ENDS})
    points = turning_points_in(data)
    figure = CURVE_FIGURES[name].plot(data, points, band, printed[name], windows)
    figure.draw_without_rendering()
    boxes = [text.get_window_extent() for text in figure.texts]
    for panel in figure.axes:
        boxes += [text.get_window_extent() for text in panel.texts]
        boxes += [symbol.get_window_extent() for symbol in panel.patches]
        boxes.append(panel.bbox)
    for index, box in enumerate(boxes):
        assert figure.bbox.x0 <= box.x0 and box.x1 <= figure.bbox.x1
        assert figure.bbox.y0 <= box.y0 and box.y1 <= figure.bbox.y1
        # type has air around it in its box: a tenth of the smaller box may overlap
        overlaps = [shared_area(box, other) for other in boxes[:index]]
        assert max(overlaps, default=0.0) < 0.1


def shared_area(box, other):
    """Area that two boxes share over the smaller one's."""
    shared = Bbox.intersection(box, other)
    area = shared.width * shared.height if shared else 0.0
    return area / min(box.width * box.height, other.width * other.height)


@pytest.mark.parametrize(("name", "limits"), [(RATIO, {0.05, 0.95}), (SOLID, {0.03, 0.9})])
def test_limits_of_modes_and_regimes_are_drawn(name, limits, datasets):
    panels = CURVE_FIGURES["fig06"].plot(datasets["fig06"]).axes
    (panel,) = (panel for panel in panels if panel.y_name == name)
    thin = [line for line in panel.lines if line.get_linestyle() == ":"]
    assert {line.get_ydata()[0] for line in thin} == limits


def test_loads_stand_in_newtons_at_the_upper_edge(datasets):
    data = datasets["fig11"]
    *over_load, over_film = CURVE_FIGURES["fig11"].plot(data).axes
    newtons = data["normal_load"].values
    for panel in over_load:
        ticks = {text.get_text(): text.get_position()[0] for text in panel.texts}
        for label, value in (("0.1 N", 0.1), ("1 N", 1.0), ("10 N", 10.0)):
            load = np.interp(np.log(value), np.log(newtons), np.log(data["load"].values))
            assert ticks[label] == pytest.approx(np.exp(load), rel=1e-9)
    assert not any(text.get_text().endswith(" N") for text in over_film.texts)


def test_dry_is_dashed_in_the_colour_of_its_lubricated_counterpart(datasets):
    panel = CURVE_FIGURES["fig06"].plot(datasets["fig06"]).axes[0]
    lines = {line.get_label(): line for line in data_lines(panel)}
    for label, line in lines.items():
        assert line.get_linestyle() == ("--" if "nu = 0 cSt" in label else "-")
        if "nu = 0 cSt" in label:
            lubricated = lines[label.replace("nu = 0 cSt", "nu = 90 cSt")]
            assert line.get_color() == lubricated.get_color()


@pytest.mark.parametrize("name", PANELS)
def test_curves_are_told_apart_in_grey(name, datasets):
    panel = CURVE_FIGURES[name].plot(datasets[name]).axes[0]
    looks = [
        (line.get_linestyle(), marker_of(line), round(np.dot(to_rgb(line.get_color()), GREY), 3))
        for line in data_lines(panel)
    ]
    assert len(set(looks)) == len(looks)


@pytest.mark.parametrize("name", ["fig04", "fig11", "fig13"])
def test_csv_holds_the_values_of_the_dataset(name, datasets, tmp_path):
    data = datasets[name]
    save(CURVE_FIGURES[name].plot(data), tmp_path / name, CAPTION)
    rows = drawn_rows(tmp_path / f"{name}.csv")
    for letter, (x_name, y_name) in zip("ABCD", PANELS[name], strict=False):
        panel = [row for row in rows if row["panel"] == letter]
        assert {(row["x_name"], row["y_name"]) for row in panel} == {(x_name, y_name)}
        for curve in shown_curves(data):
            drawn = [(float(r["x"]), float(r["y"])) for r in panel if r["curve"] == curve.label]
            if drawn:
                expected = np.column_stack([curve.values(data, n) for n in (x_name, y_name)])
                np.testing.assert_allclose(drawn, expected, rtol=1e-9)  # %.10g
    assert {row["curve"] for row in rows} == {curve.label for curve in shown_curves(data)}


def test_csv_format(datasets, tmp_path):
    files = saved(CURVE_FIGURES["fig05"].plot(datasets["fig05"]), tmp_path / "fig05")
    lines = files[".csv"].splitlines()
    assert lines[0] == b"panel,curve,x_name,x,y_name,y"
    assert all(line.count(b",") == 5 for line in lines)


def test_csv_keeps_a_label_with_commas_in_one_column(datasets, tmp_path):
    figure = CURVE_FIGURES["fig05"].plot(datasets["fig05"])
    data_lines(figure.axes[0])[0].set_label("dry, 300 nm")
    save(figure, tmp_path / "labelled", CAPTION)
    rows = drawn_rows(tmp_path / "labelled.csv")
    assert "dry, 300 nm" in {row["curve"] for row in rows}
    assert all(None not in row for row in rows)


@pytest.mark.parametrize("name", ["fig04", "fig09"])
def test_same_bytes_every_time(name, datasets, tmp_path):
    points = turning_points_in(datasets[name])
    first, second = (
        saved(CURVE_FIGURES[name].plot(datasets[name], points), tmp_path / stem) for stem in "ab"
    )
    assert first == second


def test_text_stays_text_and_fonts_are_embedded_as_outlines(datasets, tmp_path):
    figure = CURVE_FIGURES["fig05"].plot(datasets["fig05"])
    files = saved(figure, tmp_path / "fig05")
    written = re.findall(r"<text[^>]*>([^<]*)</text>", files[".svg"].decode())
    expected = [text.get_text() for owner in (figure, *figure.axes) for text in owner.texts]
    assert sorted(written) == sorted(expected)
    assert b"/FontFile2" in files[".pdf"]
    assert b"/Type3" not in files[".pdf"]


def test_turning_points_are_marked_on_their_curves(datasets):
    data = datasets["fig09"]
    points = turning_points_in(data)
    assert points
    ratio, area, over, window = CURVE_FIGURES["fig09"].plot(data, points).axes
    (marks,) = (line for line in ratio.lines if line.get_label() == "turning points")
    expected = sorted((point["load"], point["peak_ratio"]) for point in points)
    np.testing.assert_allclose(sorted(marks.get_xydata().tolist()), expected, rtol=1e-12)
    (locus,) = (line for line in area.lines if line.get_label().startswith("locus"))
    diameters = [point["particle_diameter"] for point in points]
    in_order = [points[i]["load"] for i in np.argsort(diameters)]
    np.testing.assert_allclose(locus.get_xdata(), in_order, rtol=1e-12)
    assert any(line.get_label().startswith("locus") for line in over.lines)
    expected = sorted((p["particle_diameter"] / p["roughness"], p["peak_ratio"]) for p in points)
    (marks,) = (line for line in window.lines if line.get_label() == "turning points")
    np.testing.assert_allclose(sorted(marks.get_xydata().tolist()), expected, rtol=1e-9)


@pytest.mark.parametrize("name", ["fig03", "fig06", "fig07", "fig08", "fig09"])
def test_areas_are_held_against_dry_two_body_contact(name, datasets):
    data = datasets[name]
    curves = shown_curves(data)
    references = {
        curve.condition.roughness: curve.values(data, AREA)
        for curve in curves
        if curve.condition.is_dry and curve.condition.is_two_body
    }
    by_label = {curve.label: curve for curve in curves}
    (panel,) = (p for p in CURVE_FIGURES[name].plot(data).axes if p.y_name == OVER)
    for line in data_lines(panel):
        curve = by_label[line.get_label()]
        expected = curve.values(data, AREA) / references[curve.condition.roughness]
        np.testing.assert_allclose(line.get_ydata(), expected, rtol=1e-14)


def test_a_scene_without_dry_two_body_contact_has_no_panel_of_what_is_held_against_it(datasets):
    data = datasets["fig08"].where(datasets["fig08"]["particle_diameter"] > 0.0)
    panels = CURVE_FIGURES["fig08"].plot(data).axes
    assert [panel.y_name for panel in panels] == [AREA, SOLID, RATIO]


@pytest.mark.parametrize("name", PANELS)
def test_every_printed_number_is_drawn_with_its_tolerance(name, datasets, printed):
    data = datasets[name]
    shown = {condition_key(curve.condition) for curve in shown_curves(data)}
    rows = [
        row
        for row in printed[name]
        if row["quantity"].startswith("window")
        or condition_key(row[axis.column] for axis in CONDITION_AXES) in shown
    ]
    surfaces = data["roughness"].values
    rows = [row for row in rows if np.isclose(row["roughness_m"], surfaces, rtol=1e-9).any()]
    figure = CURVE_FIGURES[name].plot(data, turning_points_in(data), printed=rows)
    drawn = {}
    for panel in figure.axes:
        for label, points in drawn_points(panel):
            drawn.setdefault(label, []).append(points)
    assert {f"printed; {row['id']}" for row in rows} <= set(drawn)
    assert {f"tolerance; {row['id']}" for row in rows} <= set(drawn)
    assert any(t.get_text().startswith("printed") for t in figure.texts) == bool(rows)
    for row in rows:
        if row["quantity"] in AT_A_LOAD:  # drawn over the load, or at a multiple of one
            continue
        places = np.concatenate(drawn[f"printed; {row['id']}"])
        assert np.isclose(places, row["value"], rtol=1e-9, atol=0.0).any(), row
        ends = np.concatenate(drawn[f"tolerance; {row['id']}"])
        assert np.isclose(ends, row["low"]).any() or row["low"] < 0.0, row
        assert np.isclose(ends, row["high"]).any() or row["high"] > 1.0, row


def test_both_numbers_of_a_turning_point_meet_in_one_place(datasets, printed):
    data = datasets["fig11"]
    figure = CURVE_FIGURES["fig11"].plot(data, turning_points_in(data), printed=printed["fig11"])
    values = {row["id"]: row["value"] for row in printed["fig11"]}
    drawn = {label: points[0] for label, points in drawn_points(figure.axes[0])}
    load = values["fig11a-turning-point-load-at-120cst"]
    expected = load, values["fig11a-peak-ratio"]
    assert tuple(drawn["printed; fig11a-turning-point-load-at-120cst"]) == expected


def test_what_holds_up_to_a_load_is_marked_at_that_load(datasets, printed):
    data = datasets["fig05"]
    rows = [row for row in printed["fig05"] if row["load_max"]]
    assert rows
    flat = data.assign({SOLID: data[SOLID] * 0.0 + 1.0})
    drawn = dict(drawn_points(CURVE_FIGURES["fig05"].plot(flat, printed=rows).axes[1]))
    ((load, _),) = drawn[f"printed; {rows[0]['id']}"]
    assert load == rows[0]["load_max"]


def test_windows_are_drawn_beside_the_printed_ones(datasets, printed):
    windows = [
        {"roughness_m": 3e-7, "end": "low", "diameter_over_roughness": 0.9},
        {"roughness_m": 3e-7, "end": "high", "diameter_over_roughness": 1.2},
        {"roughness_m": 1e-7, "end": "high", "diameter_over_roughness": 1.1},
        {"roughness_m": 3e-7, "end": "high", "diameter_over_roughness": np.nan},
    ]
    figure = CURVE_FIGURES["fig09"].plot(
        datasets["fig09"], printed=printed["fig09"], windows=windows
    )
    drawn = dict(drawn_points(figure.axes[-1]))
    np.testing.assert_array_equal(drawn["window"], [(0.9, 0.5), (1.2, 0.5)])
    assert "printed; fig09-window" in drawn


def test_each_figure_that_shows_windows_gets_them():
    rules = (ROOT / "workflow/rules/render.smk").read_text(encoding="utf-8")
    names = [name for name, figure in CURVE_FIGURES.items() if figure.shows_windows]
    assert f"in {tuple(names)}".replace("'", '"') in rules


def test_no_mark_in_the_key_without_one_in_a_panel(datasets):
    figure = CURVE_FIGURES["fig05"].plot(datasets["fig05"], turning_points_in(datasets["fig05"]))
    assert not any("TPCA" in text.get_text() for text in figure.texts)


def test_a_band_is_drawn(datasets, tmp_path):
    data = datasets["fig05"]
    band = xr.Dataset({f"{SOLID}_low": 0.9 * data[SOLID], f"{SOLID}_high": 1.1 * data[SOLID]})
    figure = CURVE_FIGURES["fig05"].plot(data, band=band)
    names = [
        [label for label, _ in drawn_points(panel) if label.startswith("band; ")]
        for panel in figure.axes
    ]
    assert [len(labels) for labels in names] == COUNTS["fig05"]
    assert any("ensemble" in text.get_text() for text in figure.texts)
    plain = saved(CURVE_FIGURES["fig05"].plot(data), tmp_path / "plain")
    banded = saved(figure, tmp_path / "banded")
    assert all(plain[suffix] != banded[suffix] for suffix in SUFFIXES if suffix != ".md")
    rows = drawn_rows(tmp_path / "banded.csv")
    highest = max(float(row["y"]) for row in rows if row["curve"].startswith("band; "))
    assert highest == pytest.approx(1.1 * float(data[SOLID].max()))


def test_schematics_show_surfaces_and_particles(schematics):
    assert [panel.letter for panel in schematics["fig02"].axes] == list("ABC")
    for figure in schematics.values():
        for panel in figure.axes:
            labels = [label for label, _ in drawn_points(panel)]
            assert labels[:2] == ["surface 1", "surface 2"]
            assert any(label.startswith("particle") for label in labels)
            width, height = panel.bbox.size
            (left, right), (bottom, top) = panel.get_xlim(), panel.get_ylim()
            assert (right - left) / width == pytest.approx((top - bottom) / height)


def test_modes_show_what_bears_the_load(schematics):
    shown = [{label for label, _ in drawn_points(panel)} for panel in schematics["fig02"].axes]
    touching = ["contact of summits" in labels for labels in shown]
    bearing = [any("bears load" in label for label in labels) for labels in shown]
    assert touching == [True, False, True]
    assert bearing == [False, True, True]


def test_a_condition_in_another_mode_is_refused(parameters):
    with pytest.raises(ValueError, match="figure 2A shows the surface_surface mode"):
        SCHEMATICS["fig02"](sections("fig02", MODES[::-1], parameters))
    with pytest.raises(ValueError, match="figure 1 shows particles in a lubricant"):
        SCHEMATICS["fig01"](sections("fig01", MODES[:1], parameters))


def test_schematics_have_the_same_bytes_every_time(schematics, parameters, tmp_path):
    again = SCHEMATICS["fig02"](sections("fig02", MODES, parameters))
    assert saved(schematics["fig02"], tmp_path / "a") == saved(again, tmp_path / "b")


def own(parameters, **varied):
    """Dataset of a scene of one's own."""
    given = {"viscosity_cSt": [0, 90], "particle_diameter_nm": [300], "roughness_nm": [300]}
    group = given | {"particle_density_per_m2": [1e11]} | varied
    scene = {"title": "Mine", "load_axis": LOAD_AXIS, "curves": [group]}
    made = Scene.of("mine", scene, parameters.newtons_per_load)
    return decoded(made, parameters)


@pytest.mark.parametrize(
    "parameter, varied, panels, curves",
    [
        ("viscosity", {}, 4, 2),
        ("particle_diameter", {"particle_diameter_nm": [0, 200, 400]}, 4, 6),
        ("particle_density", {"particle_density_per_m2": [1e10, 1e11]}, 4, 4),
        ("particle_diameter", {"viscosity_cSt": [0], "particle_diameter_nm": [200, 400]}, 2, 2),
        ("roughness", {"viscosity_cSt": [90], "roughness_nm": [100, 300]}, 4, 2),
        ("viscosity", {"viscosity_cSt": [50, 90], "roughness_nm": [100, 300]}, 8, 2),
    ],
)
def test_a_scene_of_ones_own_is_drawn_by_what_varies(
    parameter, varied, panels, curves, parameters, tmp_path
):
    data = own(parameters, **varied)
    chosen = curve_figure("mine", data)
    assert chosen.parameter == parameter
    figure = chosen.plot(data)
    assert [len(data_lines(panel)) for panel in figure.axes] == [curves] * panels
    text = caption_text("mine", figure, data)
    assert text.startswith("**Mine.** (A) ")
    save(figure, tmp_path / "mine", text)


def test_what_one_figure_cannot_tell_apart_is_refused_in_one_line(parameters):
    data = own(parameters, viscosity_cSt=[50, 90], particle_diameter_nm=[200, 400])
    with pytest.raises(
        ValueError, match="mine: viscosity and particle_diameter vary; allowed: one"
    ):
        curve_figure("mine", data)


def test_figures_never_import_pyplot():
    modules = (ROOT / "src" / "thirdbody" / "figures").rglob("*.py")
    assert not any("pyplot" in module.read_text(encoding="utf-8") for module in modules)


def test_every_figure_has_a_caption():
    others = {"fronts", "claims", "sensitivity", "accuracy", "largest_particle", "least_viscosity"}
    assert set(CAPTIONS) == others | set(SCHEMATICS) | set(CURVE_FIGURES)
    for name, caption in CAPTIONS.items():
        # curves are told from what is drawn, all else has words of its own
        assert bool(caption.seen) == (name not in CURVE_FIGURES)


@pytest.mark.parametrize("name", PANELS)
def test_captions_tell_what_is_drawn(name, datasets, printed):
    data = datasets[name]
    points = turning_points_in(data)
    figure = CURVE_FIGURES[name].plot(data, points, printed=printed[name])
    caption, seen = caption_text(name, figure, data).split("\n\n")
    assert caption.startswith(f"**Figure {int(name[3:])}. ")
    for panel, count in zip(figure.axes, COUNTS[name], strict=True):
        assert f"({panel.letter}) " in caption
        assert (f"Panel {panel.letter}: {count} curves of" in seen) == bool(count)
    for roughness in data["roughness"].values:
        assert f"{1e9 * roughness:.10g}" in caption
    shown = {line.get_label() for panel in figure.axes for line in panel.lines}
    assert ("Stars: " in caption) == ("turning points" in shown)
    assert ("Open squares: " in caption) == ("printed" in shown)
    assert "Shaded" not in caption


def test_the_alternative_text_gives_the_numbers_of_the_curves(datasets):
    data = datasets["fig03"]
    figure = CURVE_FIGURES["fig03"].plot(data)
    *_, last = data_lines(figure.axes[1])
    first, end = (f"{last.get_ydata()[place]:.2g}" for place in (0, -1))
    assert f"x_a = 1000 nm runs from {first} to {end}" in caption_text("fig03", figure, data)


def test_the_caption_stands_beside_the_figure(datasets, tmp_path):
    files = saved(CURVE_FIGURES["fig05"].plot(datasets["fig05"]), tmp_path / "fig05")
    assert files[".md"].decode() == CAPTION


def test_captions_are_restructured_text_too(datasets):
    from docutils.core import publish_parts

    for name in ("fig06", "fig09"):
        text = caption_text(name, CURVE_FIGURES[name].plot(datasets[name]), datasets[name])
        settings = {"report_level": 1, "halt_level": 1, "warning_stream": False}
        body = publish_parts(text, writer="html", settings_overrides=settings)["body"]
        assert body.count("<strong>") == 2


def test_a_chart_draws_what_is_within_the_atlas_and_frames_what_is_not():
    load, surfaces = np.geomspace(1e-7, 1e-4, 5), np.array([1e-7, 3e-7])
    limit = np.array(
        [[3e-7, 0.0], [4e-7, 5e-7], [np.inf, 6e-7], [np.inf, np.nan], [np.inf, np.inf]]
    )
    spread = np.stack([0.9 * limit, limit, 1.1 * limit])
    shown = xr.Dataset(
        {
            "limit": (("load", "roughness"), limit),
            "range": (("quantile", "load", "roughness"), spread),
        },
        {
            "load": load,
            "roughness": surfaces,
            "normal_load": ("load", 4e5 * load),
            "viscosity": 0.0,
            "particle_density": 1e11,
        },
        {"ends": np.array([2e-8, 1e-6])},
    )
    empty = shown.assign(
        limit=np.inf * shown["load"] + 0.0 * shown["roughness"], range=shown["range"] * np.nan
    )
    figure = charts.plot("largest_particle_diameter", [shown, empty])
    first, second = figure.axes
    drawn = dict(drawn_points(first))
    assert np.allclose(drawn["sigma = 100 nm"][:, 1], [3e-7, 4e-7])
    assert np.allclose(drawn["sigma = 300 nm"][:, 1], [5e-7, 6e-7])
    band = drawn["sigma = 300 nm; 90 % of the ensemble"]
    assert band[:, 1].min() == pytest.approx(4.5e-7) and band[:, 1].max() == pytest.approx(6.6e-7)
    assert first.get_xlim() == second.get_xlim()
    assert second.get_ylim()[0] < 2e-8 and second.get_ylim()[1] > 1e-6
