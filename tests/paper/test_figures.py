"""Figures: what each shows, that its files say the same, and that their bytes are stable."""

import csv
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
import yaml
from collisions import collisions
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.text import Text

import thirdbody as tb
from chenhorng.claims.between_curves import BEND
from chenhorng.claims.claims import load_claims, printed_rows
from chenhorng.claims.words import CONTRADICTED
from chenhorng.figures.captions import caption, inputs_sentence, labels_sentences
from chenhorng.figures.curve_figures import CURVE_FIGURES, plot
from chenhorng.figures.findings import headline
from chenhorng.figures.numbers import Number
from chenhorng.figures.printed import ALONG_X, COMPUTED, EVERY_LOAD, LOCUS, PRINTED, WINDOW
from chenhorng.figures.products import SUFFIXES, figure_record, save, save_pictures, write_wide
from chenhorng.figures.schematics import SCHEMATICS
from chenhorng.figures.sections import STRETCH, sections, state_of
from chenhorng.sampling import area_slope
from chenhorng.scenes import scene_dataset
from thirdbody.core.particles import mean_and_largest
from thirdbody.curves import Condition, condition_key
from thirdbody.ensembles import RANGE
from thirdbody.plotting.crowding import name_ends
from thirdbody.plotting.load_curves import curve_figure, curves_in
from thirdbody.plotting.marks import BAND, SLIGHT
from thirdbody.plotting.marks import TURNING_POINTS as STARS
from thirdbody.plotting.panels import CURVE
from thirdbody.plotting.styles import DRY, HAIRLINE, level_styles
from thirdbody.symbols import power_text
from thirdbody.variables import CONDITION_AXES, QUANTITIES

pytestmark = pytest.mark.usefixtures("style")

ROOT = Path(__file__).parents[2]
LOAD_AXIS = {"load_N": [0.04, 80.0], "count": 25}
RATIO, AREA, SOLID, FILM, OVER = (
    "particle_contact_area_ratio",
    "total_contact_area",
    "solid_load_fraction",
    "film_thickness",
    "total_contact_area_over_two_body",
)
AT_A_LOAD = ("turning_point_solid_load",)
WINDOWS = ("diameter_ratio", "turning_point_ratio")
GREY = (0.299, 0.587, 0.114)  # weights of the colours, ITU-R BT.601
# x and y of panels A, B, ... as the text of the paper describes them, and how many curves each has
PANELS = {
    "fig03": (8, [("load", RATIO), ("load", AREA), ("load", OVER)]),
    "fig04": (8, [("load", RATIO), ("load", AREA), ("load", SOLID), ("load", FILM)]),
    "fig05": (9, [("load", SOLID), ("load", SOLID)]),
    "fig06": (22, [("load", AREA), ("load", SOLID), ("load", RATIO), ("load", OVER)]),
    "fig07": (16, [("load", AREA), ("load", SOLID), ("load", RATIO), ("load", OVER)]),
    "fig08": (10, [("load", AREA), ("load", SOLID), ("load", RATIO), ("load", OVER)]),
    "fig09": (11, [("load", RATIO), ("load", AREA), ("load", OVER), WINDOWS]),
    "fig10": (10, [("load", RATIO), ("load", RATIO), WINDOWS, WINDOWS]),
    "fig11": (7, [("load", RATIO), ("load", SOLID), (FILM, RATIO)]),
    "fig12": (5, [("load", RATIO), ("load", SOLID), ("load", RATIO)]),
    "fig13": (7, [("load", RATIO)] * 3),
}


@pytest.fixture(scope="module")
def datasets(parameters):
    """The paper's scenes on a few loads, as they are read from files."""
    scenes = yaml.safe_load((ROOT / "config" / "scenes.yaml").read_text())["scenes"]
    few = {name: scenes[name] | {"load_axis": LOAD_AXIS} for name in PANELS}
    return {name: dataset_of(scene, parameters) for name, scene in few.items()}


def dataset_of(scene, parameters):
    return xr.decode_cf(scene_dataset(scene, parameters, 1e-4).to_xarray())


@pytest.fixture(scope="module")
def printed():
    """Rows of the paper's numbers by figure."""
    rows = printed_rows(load_claims(ROOT / "config" / "claims.yaml"))
    return {name: [row for row in rows if row["figure"] == name] for name in PANELS}


def turning_points_in(data):
    """The highest point of each curve, where it lies within the loads."""
    found = []
    for curve in curves_in(data):
        ratio = curve.values[RATIO]
        top = int(np.argmax(ratio))
        if 0 < top < ratio.size - 1:
            place = {"load": float(data["load"].values[top]), "peak_ratio": float(ratio[top])}
            found.append(curve.condition._asdict() | place)
    return found


def plotted(name, datasets, **given):
    return plot(name, datasets[name], turning_points_in(datasets[name]), **given)


def saved(drawing, stem, text=None):
    save(drawing, stem, text or caption("fig03", drawing.panels))
    return {suffix: Path(f"{stem}{suffix}").read_bytes() for suffix in SUFFIXES}


def drawn_rows(path):
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def key_of(figure):
    return [text.get_text() for text in figure.legends[0].get_texts() if text.get_text().strip()]


@pytest.mark.parametrize("name", PANELS)
def test_panels_have_their_curves_and_nothing_leaves_the_sheet(name, datasets, printed):
    data = datasets[name]
    count, expected = PANELS[name]
    drawn = {y: data[y] for _, y in expected if y in data}
    band = {f"{y}_low": values for y, values in drawn.items()}
    band |= {f"{y}_high": 2.0 * values for y, values in drawn.items()}
    windows = [{"roughness_m": 3e-7, "end": "low", "diameter_over_roughness": 0.9}]
    drawing = plotted(
        name, datasets, ensemble_range=xr.Dataset(band), printed=printed[name], windows=windows
    )
    assert [panel.letter for panel in drawing.panels] == list("ABCD"[: len(expected)])
    assert [(panel.x, panel.y) for panel in drawing.panels] == expected
    over_load = [panel for panel in drawing.panels if panel.x == "load" and panel.y in data]
    for panel in over_load:
        curves, ranges = panel.of_kind(CURVE), panel.of_kind(BAND)
        is_beside = panel.y == AREA and ("load", OVER) in expected
        highest = [2.0 * max(*one.y[::2], one.y[-1]) for one in curves if not is_beside]
        assert [one.y.max() for one in ranges] == highest
    assert "range of the ensemble" in key_of(drawing)
    assert f"Shaded in colour, for some curves: the {RANGE}." in caption(name, drawing.panels).shows
    drawing.draw_without_rendering()
    width, height = drawing.bbox.size
    box = drawing.get_tightbbox().extents * drawing.dpi  # [inches]
    assert box[0] >= 0 and box[1] >= 0 and box[2] <= width and box[3] <= height
    boxes = [axes.get_tightbbox() for axes in drawing.axes] + [drawing.legends[0].get_tightbbox()]
    assert not any(one.overlaps(other) for one in boxes for other in boxes if one is not other)
    for axes, panel in zip(drawing.axes, drawing.panels, strict=True):
        curves = panel.of_kind(CURVE)
        expected = {("fig12", "C"): 7}.get((name, panel.letter), count)
        assert len({curve.name for curve in curves}) == len(curves)
        assert len(curves) == (0 if panel.x == "diameter_ratio" else expected)
        (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
        for curve in curves:
            assert left < curve.x.min() and curve.x.max() < right
            assert bottom < curve.y.min() or panel.least
            assert curve.y.max() < top


@pytest.mark.parametrize("width_mm", [84.0, 174.0])
@pytest.mark.parametrize("name", PANELS)
def test_no_text_is_over_an_axis_a_tick_a_rule_or_another_text(name, width_mm, defaults, printed):
    scene = yaml.safe_load((ROOT / "config" / "scenes.yaml").read_text())["scenes"][name]
    data = dataset_of(scene | {"load_axis": LOAD_AXIS}, defaults.best)
    windows = [
        {"roughness_m": roughness, "end": end, "diameter_over_roughness": at}
        for roughness in data["roughness"].values
        for end, at in (("low", 0.79), ("high", 1.35))
    ]
    given = {"printed": printed[name], "windows": windows, "width": width_mm / 25.4}
    figure = plot(name, data, turning_points_in(data), **given)
    assert figure.bbox.width / figure.dpi == pytest.approx(width_mm / 25.4)
    assert not collisions(figure)


@pytest.mark.parametrize("name", PANELS)
def test_curves_and_entries_of_the_key_are_told_apart_in_grey(name, datasets):
    figure = plotted(name, datasets)
    entries = [line for line in figure.legends[0].get_lines() if line.get_label().strip()]
    looks = [look(line) for line in entries]
    assert len(set(looks)) == len(looks)
    marked = [(marker, face) for _, marker, face, *_ in looks if marker not in ("None", "none")]
    assert len(set(marked)) == len(marked)  # markers alone tell the levels apart
    lines = [line for line in figure.axes[0].lines if len(line.get_xdata()) > 2]
    count = PANELS[name][0]
    if name in ("fig06", "fig07", "fig08"):  # half of them dry, which their names tell apart
        count = count // 2 + 1
    assert len({look(line) for line in lines}) >= count


@pytest.mark.parametrize("count", [1, 2, 5, 11])
def test_every_colour_is_seen_on_white_paper(count):
    for each in level_styles(count):
        red, green, blue = (  # WCAG 2.2, relative luminance
            one / 12.92 if one <= 0.04045 else ((one + 0.055) / 1.055) ** 2.4
            for one in to_rgb(each["color"])
        )
        assert 1.05 / (0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05) >= 3.0


# Linear RGB as a deuteranope sees it, who lacks the cones for medium wavelengths.  Machado et al.
# (2009) print the matrix.
DEUTERANOPE = np.array(
    [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ]
)
TO_XYZ = np.array(  # of sRGB, IEC 61966-2-1
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.119192, 0.9503041],
    ]
)


def lab(colour, seen_by=DEUTERANOPE):
    """CIELAB of a colour under D65, as it is seen."""
    red_green_blue = np.array(to_rgb(colour))
    linear = np.where(
        red_green_blue <= 0.04045, red_green_blue / 12.92, ((red_green_blue + 0.055) / 1.055) ** 2.4
    )
    x, y, z = TO_XYZ @ np.clip(seen_by @ linear, 0.0, 1.0) / (0.95047, 1.0, 1.08883)
    fx, fy, fz = (np.cbrt(v) if v > 0.008856 else 7.787 * v + 16.0 / 116.0 for v in (x, y, z))
    return np.array([116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)])


@pytest.mark.parametrize("name", ["fig04", "fig06", "fig07", "fig08", "fig11", "fig12"])
@pytest.mark.parametrize("seen_by", [np.eye(3), DEUTERANOPE], ids=["normal", "deuteranope"])
def test_dry_and_lubricated_contact_are_told_apart_by_colour_and_dashes(name, seen_by, datasets):
    panel = plotted(name, datasets).panels[0]
    dry = [one.look for one in panel.of_kind(CURVE) if one.curve.is_dry]
    wet = [one.look for one in panel.of_kind(CURVE) if not one.curve.is_dry]
    assert dry and wet
    assert {look["linestyle"] for look in dry}.isdisjoint(
        look.get("linestyle", "-") for look in wet
    )
    for look in wet:
        if look["color"] != "black":  # two-body contact, solid
            distance = lab(look["color"], seen_by) - lab(DRY["color"], seen_by)
            assert np.linalg.norm(distance) > 35.0  # grey and the lightest level: 6


def test_some_levels_are_strong_and_the_others_are_hairlines_with_one_entry(datasets):
    figure = plotted("fig06", datasets)
    widths = {}
    for one in figure.panels[0].of_kind(CURVE):
        widths.setdefault(one.curve.particle_diameter, set()).add(one.look.get("linewidth"))
    thin = {size for size, found in widths.items() if found == {HAIRLINE["linewidth"]}}
    assert thin == {1e-7, 2e-7, 4e-7, 6e-7, 8e-7, 9e-7}
    assert "100, 200, 400, 600, 800, 900" in key_of(figure)
    names = {text.get_text() for text in figure.axes[3].texts}
    assert {"500", "1000", "dry 600"} <= names and "600" not in names  # where there is room


@pytest.mark.parametrize("name", ["fig03", "fig09", "fig10", "fig13"])
def test_curves_are_named_beside_their_ends(name, datasets):
    figure = plotted(name, datasets)
    axes = figure.axes[0]
    assert axes.texts
    ends = [
        axes.transData.transform(line.get_xydata())
        for line in axes.lines
        if len(line.get_xdata()) > 2
    ]
    first, last = min(points[0, 0] for points in ends), max(points[-1, 0] for points in ends)
    for text in axes.texts:
        box = type(axes.title).get_window_extent(text)
        assert box.x0 > last or box.x1 < first


@pytest.mark.parametrize("name", ["fig06", "fig07", "fig08"])
def test_a_name_is_of_dry_or_of_lubricated_curves(name, datasets):
    figure = plotted(name, datasets)
    for axes, panel in zip(figure.axes, figure.panels, strict=True):
        names = {text.get_text(): text.get_color() for text in axes.texts}
        assert {text.startswith("dry") for text in names} == {True, False}
        for text, colour in names.items():
            assert text.startswith("dry") == (colour == "black"), (panel.letter, text)


def test_of_dashed_curves_that_coincide_one_is_drawn(datasets):
    figure = plotted("fig08", datasets)
    axes, (panel, *_) = figure.axes[0], figure.panels
    lines = dict(zip(panel.of_kind(CURVE), axes.lines, strict=False))
    dashed = [line for one, line in lines.items() if one.look["linestyle"] == DRY["linestyle"]]
    drawn = [np.isfinite(line.get_ydata()) for line in dashed]
    assert drawn[0].all() and not np.all(drawn)
    for later, seen in zip(dashed[1:], drawn[1:], strict=True):
        heights = axes.transData.transform(later.get_xydata())[:, 1]
        first = axes.transData.transform(dashed[0].get_xydata())[:, 1]
        assert (np.abs(heights - first)[seen] > 0.5).all()


def test_values_below_a_logarithmic_axis_are_not_drawn(datasets):
    figure = plotted("fig13", datasets)
    for axes, panel in zip(figure.axes, figure.panels, strict=True):
        curves = panel.of_kind(CURVE)
        unseen = np.concatenate([curve.y < panel.least for curve in curves])
        drawn = np.concatenate([line.get_ydata() for line in axes.lines[: len(curves)]])
        assert unseen.any() and (drawn[unseen] < axes.get_ylim()[0]).all()
        text = caption("fig13", figure.panels).shows
        assert f"Values below {panel.least:g} are not drawn" in text


@pytest.mark.parametrize("name", PANELS)
def test_type_is_at_least_7_points(name, datasets, printed):
    figure = plotted(name, datasets, printed=printed[name])
    figure.draw_without_rendering()
    assert min(text.get_fontsize() for text in figure.findobj(type(figure.axes[0].title))) >= 7.0


def test_panels_that_the_paper_lacks_say_so(datasets):
    ours = {
        f"{name[3:]}{panel.letter}"
        for name in PANELS
        for panel in plotted(name, datasets).panels
        if "not in the paper" in panel.title
    }
    assert ours == {"03C", "06D", "07D", "08D", "09C", "09D", "10C", "10D"}


@pytest.mark.parametrize("name", PANELS)
def test_the_title_of_each_panel_says_what_differs(name, datasets):
    titles = [axes.get_title(loc="left")[12:] for axes in plotted(name, datasets).axes]
    assert len(set(titles)) == len(titles) and all(titles)


def test_a_panel_alone_is_as_wide_as_a_column_and_shows_the_same(datasets, printed, tmp_path):
    given = {"printed": printed["fig11"]}
    whole, alone = (
        plotted("fig11", datasets, **given),
        plotted("fig11", datasets, **given, panel="B"),
    )
    assert alone.bbox.width / alone.dpi == pytest.approx(84.0 / 25.4)
    (panel,) = alone.panels
    assert (panel.letter, panel.y) == ("B", SOLID)
    for one, other in zip(panel.series, whole.panels[1].series, strict=True):
        np.testing.assert_array_equal((one.x, one.y), (other.x, other.y))
    save_pictures(alone, tmp_path / "a", caption("fig11", alone.panels))
    assert {path.suffix for path in tmp_path.iterdir()} == {".svg", ".pdf", ".png"}
    assert b"<title>Panel B: " in (tmp_path / "a.svg").read_bytes()


@pytest.mark.parametrize("name", ["fig06", "fig07", "fig09"])
def test_the_panel_of_areas_is_narrow_beside_that_of_their_ratios(name, datasets):
    figure = plotted(name, datasets)
    figure.draw_without_rendering()
    boxes = {
        panel.y: axes.get_position() for panel, axes in zip(figure.panels, figure.axes, strict=True)
    }
    area, ratio = boxes[AREA], boxes[OVER]
    assert area.width < 0.75 * ratio.width and area.x1 < ratio.x0
    assert area.y0 == pytest.approx(ratio.y0, abs=0.01)


def test_titles_of_axes_that_repeat_are_shown_once(datasets):
    def titles(name):
        figure = plotted(name, datasets)
        return [
            (axes.xaxis.label.get_visible(), axes.yaxis.label.get_visible()) for axes in figure.axes
        ]

    assert titles("fig04") == [(False, True), (False, True), (True, True), (True, True)]
    assert titles("fig11") == [(True, True), (True, True), (True, True)]  # C is over the film
    assert titles("fig13") == [(False, True), (True, False), (True, True)]


def test_the_range_of_two_body_contact_is_drawn_with_others_of_areas(datasets):
    data = datasets["fig04"]
    ends = {
        f"{y}_{end}": part * data[y]
        for y in (RATIO, AREA)
        for end, part in (("low", 0.9), ("high", 1.2))
    }
    figure = plotted("fig04", datasets, ensemble_range=xr.Dataset(ends))
    highest = max(one.y.max() for one in figure.panels[1].of_kind(BAND) if one.curve.is_two_body)
    for place, expected in ((0, False), (1, True)):
        outlines = figure.axes[place].collections
        assert outlines
        greys = [one for one in outlines if len({*one.get_facecolor()[0][:3]}) == 1]
        assert (
            bool([one for one in greys if one.get_label() == "range of the ensemble"]) == expected
        )
    tops = [path.vertices[:, 1].max() for one in greys for path in one.get_paths()]
    assert highest in tops


def test_the_range_of_areas_is_drawn_in_the_panel_of_ratios(datasets):
    data = datasets["fig03"]
    ends = {f"{y}_{end}": 0.9 * data[AREA] for y in (AREA, OVER) for end in ("low", "high")}
    _, areas, ratios = plotted("fig03", datasets, ensemble_range=xr.Dataset(ends)).panels
    assert not areas.of_kind(BAND)
    assert [one.curve for one in ratios.of_kind(BAND)] == [
        one.curve for one in ratios.of_kind(CURVE)
    ]


def test_a_panel_alone_has_no_hairlines_and_the_colours_of_the_figure(datasets):
    strong = CURVE_FIGURES["fig06"].strong
    whole, alone = plotted("fig06", datasets), plotted("fig06", datasets, panel="D")
    (panel,) = alone.panels
    (of_whole,) = (each for each in whole.panels if each.letter == "D")
    looks = {each.curve: each.look for each in of_whole.of_kind(CURVE)}
    sizes = {each.curve.particle_diameter for each in panel.of_kind(CURVE)}
    assert np.allclose(sorted(sizes), [0.0, *strong])
    assert all(each.look["color"] == looks[each.curve]["color"] for each in panel.of_kind(CURVE))
    assert not any("100, 200" in text for text in key_of(alone))


def test_a_figure_says_how_many_of_its_statements_hold(datasets):
    words = ["holds"] * 7 + ["fails"] + [CONTRADICTED] * 2
    given = [{"id": "", "place": f"Figure {n}B", "verdict": word} for n in (4, 5) for word in words]
    counts = f"7 hold, 1 fails, 2 {CONTRADICTED}."
    text = f"Of the paper's 10 statements here, with repeats and within tolerances, {counts}"
    for verdicts, expected in ((given, [text]), ([], [])):
        figure = plotted("fig04", datasets, verdicts=verdicts)
        texts = [" ".join(each.get_text().split()) for each in figure.findobj(Text)]
        found = [each.partition("Of the paper's") for each in texts]
        assert [start + rest for _, start, rest in found if start] == expected


@pytest.mark.parametrize("width_mm", [84.0, 174.0])
def test_the_count_of_statements_stays_on_the_sheet(width_mm, datasets):
    words = ["holds"] * 30 + ["fails"] * 2 + [CONTRADICTED, "not tested"] * 11
    verdicts = [{"id": "", "place": "Figure 4", "verdict": word} for word in words]
    figure = plotted("fig04", datasets, verdicts=verdicts, width=width_mm / 25.4)
    figure.draw_without_rendering()
    (above,) = (each for each in figure.artists if isinstance(each, Text))
    assert "30 hold" in above.get_text() and above.get_window_extent().x1 < figure.bbox.x1


@pytest.mark.parametrize(
    ("ends", "names"),
    [([0, 0, 0, 1], {"1 … 3", "4"}), ([0, 1, 0, 0, 2], {"1", "2", "3, 4", "5"})],
)
def test_only_curves_that_follow_each_other_share_a_name(ends, names):
    axes = Figure().subplots()
    lines = {axes.plot([1, 2], [3, end])[0]: f"{n}" for n, end in enumerate(ends, 1)}
    name_ends(axes, lines, [], {})
    assert {each.get_text() for each in axes.texts} == names


def look(line):
    grey = round(float(np.dot(to_rgb(line.get_color()), GREY)), 3)
    is_hollow = line.get_markerfacecolor() == "white"
    width = float(line.get_linewidth())
    return str(line.get_linestyle()), str(line.get_marker()), is_hollow, grey, width


def test_loads_stand_in_newtons_at_the_upper_edge(datasets):
    drawing = plotted("fig11", datasets)
    drawing.draw_without_rendering()
    newtons_per_load = float(datasets["fig11"]["normal_load"][0] / datasets["fig11"]["load"][0])
    for axes in drawing.axes[:2]:
        upper = axes.child_axes[-1]
        places = {text.get_text(): text.get_position()[0] for text in upper.get_xticklabels()}
        assert places["10 N"] == 10.0
        np.testing.assert_allclose(upper.get_xlim(), newtons_per_load * np.array(axes.get_xlim()))
    assert len(drawing.axes[2].child_axes) == 1  # over the film there is only the edge with modes


@pytest.mark.parametrize("name", ["fig04", "fig11"])
def test_files_hold_the_values_of_the_dataset_in_the_same_bytes_every_time(
    name, datasets, tmp_path
):
    data, drawing = datasets[name], plotted(name, datasets)
    files = saved(drawing, tmp_path / "first")
    assert files == saved(plotted(name, datasets), tmp_path / "second")
    # text stays text, and fonts are embedded
    assert "ν = 0 cSt".encode() not in files[".svg"] and b"</text>" in files[".svg"]
    assert b"<title>Panel A: " in files[".svg"]  # the alternative text
    assert b"/FontFile2" in files[".pdf"] and b"/ToUnicode" in files[".pdf"]
    rows = drawn_rows(tmp_path / "first.csv")
    assert list(rows[0]) == ["panel", "curve", "x_name", "x", "y_name", "y"]
    drawn = {}
    for row in rows:
        point = float(row["x"]), float(row["y"])
        drawn.setdefault((row["panel"], row["curve"]), []).append(point)
    for panel in drawing.panels:
        for curve in curves_in(data):
            if (panel.letter, curve.label) in drawn and panel.y != OVER:
                expected = np.column_stack([curve.values[n] for n in (panel.x, panel.y)])
                found = drawn[panel.letter, curve.label]
                np.testing.assert_allclose(found, expected, rtol=1e-9)  # %.10g
    assert {row["curve"] for row in rows} >= {c.name for c in drawing.panels[0].of_kind(CURVE)}


def test_a_wide_table_has_a_column_for_each_curve(datasets, tmp_path):
    data, drawing = datasets["fig11"], plotted("fig11", datasets)
    write_wide(drawing.panels, tmp_path / "wide.csv")
    rows = drawn_rows(tmp_path / "wide.csv")
    name = "nu = 90 cSt; x_a = 300 nm; sigma = 300 nm; eta_a = 1e+11 m-2"
    (curve,) = (one for one in curves_in(data) if one.label == name)
    # panels over the load share it; the film over which panel C stands is that of each curve
    headings = {
        "A: load [1]": "load",
        f"A: {RATIO} [1], {name}": RATIO,
        f"C: {FILM} [1], {name}": FILM,
    }
    for heading, quantity in headings.items():
        found = [float(row[heading]) for row in rows]
        np.testing.assert_allclose(found, curve.values[quantity], rtol=1e-9)


@pytest.mark.parametrize(
    ("status", "places", "meaning"),
    [
        ("outside_film_formula", np.s_[-4:], "outside film formula"),
        ("load_exceeded", [-5], "load exceeded"),
    ],
)
def test_points_that_are_not_plainly_converged_are_marked(status, places, meaning, datasets):
    data = datasets["fig11"].load().copy(deep=True)
    attributes = data["solution_status"].attrs
    flags = dict(zip(attributes["flag_meanings"].split(), attributes["flag_values"], strict=True))
    last = np.s_[-4:, -1]  # the last loads of the last viscosity
    data["solution_status"][last] = flags[status]
    for name in QUANTITIES if status == "load_exceeded" else ():
        data[name][last] = np.nan
    drawing = CURVE_FIGURES["fig11"].plot(data)
    curve = curves_in(data)[-1]
    for panel in drawing.panels:
        (marked,) = panel.of_kind(status)
        assert marked.name == curve.label
        for drawn, name in ((marked.x, panel.x), (marked.y, panel.y)):
            np.testing.assert_array_equal(drawn, curve.values[name][places])
    first = drawing.axes[0].lines[len(curves_in(data)) - 1]
    left_out = np.isnan(first.get_ydata())
    assert left_out[-4:].all() and not left_out[:-4].any()
    assert meaning in key_of(drawing)
    assert meaning in caption("fig11", drawing.panels).shows
    assert meaning not in key_of(plotted("fig11", datasets))


def test_turning_points_and_windows_are_marked(datasets, printed):
    windows = [
        {"roughness_m": 3e-7, "end": "low", "diameter_over_roughness": 0.9},
        {"roughness_m": 3e-7, "end": "high", "diameter_over_roughness": 1.2},
        {"roughness_m": 1e-7, "end": "high", "diameter_over_roughness": 1.1},
        {"roughness_m": 3e-7, "end": "high", "diameter_over_roughness": np.nan},
    ]
    points = turning_points_in(datasets["fig09"])
    drawing = plotted("fig09", datasets, printed=printed["fig09"], windows=windows)
    ratio, area, over, last = drawing.panels
    at_load = sorted((point["load"], point["peak_ratio"]) for point in points)
    at_size = sorted((p["particle_diameter"] / p["roughness"], p["peak_ratio"]) for p in points)
    for panel, expected in ((ratio, at_load), (last, at_size)):
        (stars,) = panel.of_kind(STARS)
        np.testing.assert_allclose(sorted(zip(stars.x, stars.y)), expected, rtol=1e-8)
    (locus,) = area.of_kind(LOCUS)
    by_size = sorted(points, key=lambda point: point["particle_diameter"])
    np.testing.assert_allclose(locus.x, [point["load"] for point in by_size], rtol=1e-9)
    assert points and over.of_kind(LOCUS)
    (ends,) = last.of_kind(WINDOW)
    assert ends.x.tolist() == [0.9, 1.2]
    assert {"printed position along x", "tolerance of a printed line"} <= {*key_of(drawing)}
    # 0.83 and 0.8333 are one number; strips that overlap are seen through
    strips = drawing.axes[3].patches
    assert len(strips) == 4 and len({strip.get_bbox().x0 for strip in strips}) == 4
    assert all(0.0 < strip.get_facecolor()[3] < 1.0 for strip in strips)
    assert "fig09-window" in [series.name for series in last.of_kind(ALONG_X)]
    left_out = points[len(points) // 2]
    some = [point for point in points if point is not left_out]
    (slight,) = CURVE_FIGURES["fig09"].plot(datasets["fig09"], some).panels[0].of_kind(SLIGHT)
    assert left_out["load"] in slight.x and left_out["peak_ratio"] in slight.y


def test_a_printed_turning_point_is_one_mark(datasets, printed):
    panel = plotted("fig11", datasets, printed=printed["fig11"]).panels[0]
    places = {(series.x[0], series.y[0]) for series in panel.of_kind(PRINTED)}
    assert {(3.27e-6, 0.2), (1.49e-5, 0.2)} <= places and len(places) <= 4


def test_marks_that_coincide_are_one_with_one_bar_in_each_direction(datasets, printed):
    axes = plotted("fig11", datasets, printed=printed["fig11"]).axes[0]
    diamonds = [line for line in axes.lines if line.get_marker() == "D"]
    shown = [line for line in diamonds if line.get_markevery() == [True]]
    assert len(diamonds) > len(shown) == 2
    bars = [line for line in axes.lines if line.get_marker() in ("|", "_") and line.get_visible()]
    assert len(bars) == 4
    for bar in bars:
        middle = np.sqrt(bar.get_xdata().prod()), bar.get_ydata().mean()
        assert any(np.allclose(middle, line.get_xydata()[0], rtol=0.1) for line in shown)


@pytest.mark.parametrize(
    ("name", "place", "values"),
    [
        ("fig04", 1, [1.5e-5]),
        ("fig06", 0, [5.96e-5]),
        ("fig07", 0, [5e-5]),
        ("fig11", 2, [1.15e-4, 1.63e-4, 2.23e-4, 2.34e-4]),
        ("fig13", 1, [1.5e-5, 3e-5]),
    ],
)
def test_what_is_printed_along_x_alone_stands_across_the_panel(
    name, place, values, datasets, printed
):
    drawing = plotted(name, datasets, printed=printed[name])
    series = drawing.panels[place].of_kind(ALONG_X)
    assert sorted(one.x[0] for one in series) == values
    brackets = {tuple(one.tolerance[0]) for one in series}
    rows = [row for row in printed[name] if row["value"] in values]
    assert brackets == {(row["low"], row["high"]) for row in rows}
    spans = [
        patch.get_extents().transformed(drawing.axes[place].transData.inverted())
        for patch in drawing.axes[place].patches
    ]
    for low, high in brackets:
        is_drawn = any(np.allclose((span.x0, span.x1), (low, high)) for span in spans)
        assert is_drawn == (name != "fig11")  # there strips are as narrow as lines


@pytest.mark.parametrize(("name", "place", "words"), [
    ("fig09", 3, {"printed", "printed for all surfaces", "computed"}),
    ("fig11", 2, {"printed for 70", "printed for 120"}),
])  # fmt: skip
def test_a_bracket_joins_both_ends_of_a_range(name, place, words, datasets, printed):
    windows = [{"roughness_m": 3e-7, "end": end, "diameter_over_roughness": at}
               for end, at in (("low", 0.79), ("high", 1.35))]  # fmt: skip
    drawing = plotted(name, datasets, printed=printed[name], windows=windows)
    axes = drawing.axes[place]
    assert {text.get_text() for text in axes.texts} == words
    brackets = {tuple(line.get_xdata()[1:3]) for line in axes.lines if len(line.get_xdata()) == 4}
    uprights = {line.get_xdata()[0] for line in axes.lines if len({*line.get_xdata()}) == 1}
    expected = {
        "fig09": {(0.79, 1.35), (0.8, 1.3), (0.83, 1.33)},
        "fig11": {(1.15e-4, 2.23e-4), (1.63e-4, 2.34e-4)},
    }
    assert brackets == expected[name]
    assert {end for bracket in brackets for end in bracket} <= uprights


def test_bends_are_marked_where_the_slope_falls(datasets, printed):
    panel = plotted("fig04", datasets, printed=printed["fig04"]).panels[1]
    curves = {one.curve: one for one in panel.of_kind(CURVE)}
    found = panel.of_kind(COMPUTED)
    assert {9e-5, 1.2e-4} <= {one.curve.viscosity for one in found}
    for one in found:
        curve, dry = curves[one.curve], curves[one.curve._replace(viscosity=0.0)]
        lag = area_slope(dry.x, dry.y) - area_slope(curve.x, curve.y)
        assert np.interp(np.log(one.x[0]), np.log(curve.x), lag) == pytest.approx(BEND, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "level"), [("fig06", "particle_diameter"), ("fig07", "particle_density")]
)
def test_above_the_crossing_that_is_marked_areas_rise_from_curve_to_curve(
    name, level, datasets, printed
):
    panel = plotted(name, datasets, printed=printed[name]).panels[0]
    (mark,) = panel.of_kind(COMPUTED)
    compared = {condition_key(row[axis.column] for axis in CONDITION_AXES)
                for row in printed[name] if row["id"] == mark.name}  # fmt: skip
    curves = [one for one in panel.of_kind(CURVE) if condition_key(one.curve) in compared]
    curves.sort(key=lambda one: getattr(one.curve, level))
    assert len(curves) > 2
    rises = (np.diff([one.y for one in curves], axis=0) > 0.0).all(axis=0)
    assert rises[curves[0].x > mark.x[0]].all() and not rises[curves[0].x < mark.x[0]][-1]


def test_a_curve_outside_its_own_range_is_told_with_its_distance(datasets):
    data = datasets["fig11"]
    ends = {f"{SOLID}_low": data[SOLID] - 0.2, f"{SOLID}_high": data[SOLID] - 0.03}
    drawing = plotted("fig11", datasets, ensemble_range=xr.Dataset(ends))
    assert "outside its own range does so by 3 % in B." in caption("fig11", drawing.panels).shows
    inside = xr.Dataset(ends | {f"{SOLID}_high": data[SOLID]})
    drawing = plotted("fig11", datasets, ensemble_range=inside)
    assert "outside its own range" not in caption("fig11", drawing.panels).shows


def test_a_number_printed_up_to_a_load_is_drawn_up_to_it(datasets, printed):
    (panel,) = (
        p for p in plotted("fig08", datasets, printed=printed["fig08"]).panels if p.y == SOLID
    )
    lines = panel.of_kind(EVERY_LOAD)
    assert lines and all(5e-7 < line.x[-1] <= 1e-6 for line in lines)


@pytest.mark.parametrize("name", ["fig03", "fig08"])
def test_areas_are_compared_with_dry_two_body_contact(name, datasets):
    data = datasets[name]
    curves = {curve.label: curve for curve in curves_in(data)}
    references = {
        curve.condition.roughness: curve.values[AREA]
        for curve in curves.values()
        if curve.condition.is_dry and curve.condition.is_two_body
    }
    for series in plotted(name, datasets).panels[-1].of_kind(CURVE):
        area = curves[series.name].values[AREA]
        expected = area / references[series.curve.roughness]
        np.testing.assert_allclose(series.y, expected, rtol=1e-14)
    without = data.where(data["particle_diameter"] > 0.0)
    assert OVER not in [panel.y for panel in CURVE_FIGURES[name].plot(without).panels]


@pytest.mark.parametrize("name", PANELS)
def test_every_printed_number_is_drawn_with_its_tolerance(name, datasets, printed):
    data = datasets[name]
    computed = {condition_key(curve.condition) for curve in curves_in(data)}
    surfaces = data["roughness"].values

    def is_shown(row):
        if row["quantity"].startswith("window"):
            return np.isclose(row["roughness_m"], surfaces, rtol=1e-9).any()
        return condition_key(row[axis.column] for axis in CONDITION_AXES) in computed

    # a ratio of two loads has no place over one load
    ratio = "bend_load_over_mixed_load"
    rows = [row for row in printed[name] if is_shown(row) and row["quantity"] != ratio]
    drawing = plotted(name, datasets, printed=rows)
    numbers, tolerances = {}, {}
    for series in (series for panel in drawing.panels for series in panel.series):
        if isinstance(series, Number) and series.tolerance:
            numbers.setdefault(series.name, []).extend([*series.x, *series.y])
            tolerances.setdefault(series.name, []).extend(np.ravel(series.tolerance))
    assert any(text.startswith("printed") for text in key_of(drawing)) == bool(rows)
    for row in rows:
        places, ends = numbers[row["id"]], tolerances[row["id"]]
        if row["quantity"] not in AT_A_LOAD:  # drawn over the load, or at a multiple of one
            assert np.isclose(places, row["value"], rtol=1e-9, atol=0.0).any(), row
            assert np.isclose(ends, row["low"]).any() or row["low"] < 0.0, row
            assert np.isclose(ends, row["high"]).any() or row["high"] > 1.0, row


def schematic_state(condition, load_N, parameters):
    load = load_N / parameters.newtons_per_load
    solution = tb.solve(**condition._asdict(), load=load, parameters=parameters)
    return state_of(condition, load_N, solution.variables)


@pytest.mark.parametrize("name", SCHEMATICS)
def test_no_text_of_a_schematic_is_over_a_line_or_another_text(defaults, name):
    panels = yaml.safe_load((ROOT / "config/config.yaml").read_text())["schematics"][name]
    states = [schematic_state(Condition.of(each), each["load_N"], defaults) for each in panels]
    schematic = SCHEMATICS[name](sections(name, states, defaults))
    schematic.draw_without_rendering()
    for axes, panel in zip(schematic.axes, schematic.panels, strict=True):
        boxes = [Text.get_window_extent(text) for text in axes.texts if text.get_text()]
        for box, other in combinations(boxes, 2):
            assert not box.overlaps(other)
        for line in panel.series:
            points = axes.transData.transform(np.column_stack([line.x, line.y]))
            for box in boxes:
                assert not any(box.contains(*point) for point in points), line.name


def test_schematics_show_what_carries_the_load(parameters, tmp_path):
    def state(diameter, load, viscosity):
        return schematic_state(Condition(viscosity, diameter, 3e-7, 1e11), load, parameters)

    states = [state(diameter, 2.0, 0.0) for diameter in (1e-7, 1e-6, 3e-7)]
    lubricated = sections("fig01", [state(5e-7, 50.0, 9e-5)], parameters)
    interface = SCHEMATICS["fig01"](lubricated)
    drawing, again = (SCHEMATICS["fig02"](sections("fig02", states, parameters)) for _ in range(2))
    labels = [[series.name for series in panel.series] for panel in drawing.panels]
    assert ["contact of summits" in each for each in labels] == [True, False, True]
    assert ["carries load" in "".join(each) for each in labels] == [False, True, True]
    for each in (interface, drawing, again):
        each.draw_without_rendering()
        for axes in each.axes:
            box, (width,), (height,) = axes.bbox, *map(np.diff, (axes.get_xlim(), axes.get_ylim()))
            shape = STRETCH * height / width
            assert shape == pytest.approx(box.height / box.width)
    written = caption("fig02")
    assert saved(drawing, tmp_path / "a", written) == saved(again, tmp_path / "b", written)
    for name, wrong, message in (
        ("fig02", states[::-1], "figure 2A shows the surface_surface mode"),
        ("fig01", states[:1], "figure 1 shows particles in a lubricant"),
    ):
        with pytest.raises(ValueError, match=message):
            SCHEMATICS[name](sections(name, wrong, parameters))


@pytest.mark.parametrize(
    "parameter, varied, panels, curves",
    [
        ("viscosity", {}, 4, 2),
        ("particle_diameter", {"particle_diameter_nm": [0, 200, 400]}, 4, 6),
        ("particle_density", {"particle_density_per_m2": [1e10, 1e11]}, 4, 4),
        ("particle_diameter", {"viscosity_cSt": [0], "particle_diameter_nm": [200, 400]}, 2, 2),
        ("roughness", {"viscosity_cSt": [90], "roughness_nm": [100, 300]}, 4, 2),
        ("viscosity", {"viscosity_cSt": [50, 90], "roughness_nm": [100, 300]}, 8, 2),
        # two-body contact is in the panels of each size
        (
            "viscosity",
            {"viscosity_cSt": [0, 46, 120], "particle_diameter_nm": [0, 300, 600]},
            8,
            6,
        ),
    ],
)
def test_a_scene_of_the_user_is_drawn_by_what_varies(parameter, varied, panels, curves, parameters):
    usual = {"viscosity_cSt": [0, 90], "particle_diameter_nm": [300], "roughness_nm": [300]}
    group = usual | {"particle_density_per_m2": [1e11]} | varied
    scene = {"title": "Mine", "load_axis": LOAD_AXIS, "curves": [group]}
    data = dataset_of(scene, parameters)
    chosen = curve_figure(data)
    assert chosen.parameter == parameter
    drawing = chosen.plot(data)
    assert [len(panel.of_kind(CURVE)) for panel in drawing.panels] == [curves] * panels
    written = caption("mine", drawing.panels, "a *b* <script>\n# c")
    assert written.markdown().startswith(
        "**a \\*b\\* \\<script\\> # c.**\n\n(A) "
    )  # a title is no markup


@pytest.mark.parametrize("name", ["fig06", "fig09", "fig11"])
def test_the_record_of_a_figure_has_its_conditions_and_printed_numbers(name, datasets, printed):
    panels = plotted(name, datasets, printed=printed[name]).panels
    record = figure_record(panels, caption(name, panels, "A title"))
    assert record["place"] == f"Figure {int(name[3:])}"
    for panel, written in zip(panels, record["panels"], strict=True):
        conditions = [tuple(curve.values()) for curve in written["curves"]]
        assert conditions == [tuple(each.curve) for each in panel.of_kind(CURVE) if each.curve]
        marks = {PRINTED: "printed", EVERY_LOAD: "levels", ALONG_X: "limits"}
        for kind, key in marks.items():
            drawn = panel.of_kind(kind)
            assert [mark["id"] for mark in written[key]] == [series.name for series in drawn]
            for mark, series in zip(written[key], drawn, strict=True):
                points = np.array([mark["at"], *mark["ends"]], float).T  # nan without y
                expected = np.column_stack(([series.x[0], series.y[0]], series.tolerance))
                np.testing.assert_allclose(points, expected, rtol=1e-4)


def test_a_record_tells_which_of_the_printed_points_that_coincide_is_drawn(datasets, printed):
    panels = plotted("fig11", datasets, printed=printed["fig11"]).panels
    ratio, *_ = figure_record(panels, caption("fig11", panels, "A title"))["panels"]
    points = [mark for mark in ratio["printed"] if mark["is_point_drawn"]]
    assert [mark["at"] for mark in points] == [[3.27e-6, 0.2], [1.49e-5, 0.2]]
    assert [mark["curve"]["viscosity"] for mark in points] == [0.0, 120e-6]
    bars = [mark["ends"] for mark in ratio["printed"] if mark["is_tolerance_drawn"]]
    assert len(bars) < len(ratio["printed"])


@pytest.mark.parametrize("name", ["fig03", "fig06", "fig09", "fig11", "fig12"])
def test_captions_describe_what_is_drawn(name, datasets, printed):
    from docutils.core import publish_parts

    drawing = plotted(name, datasets, printed=printed[name])
    title = datasets[name].attrs["title"]
    said = headline(name, datasets[name])
    text = caption(name, drawing.panels, title, headline=said).markdown()
    message = " ".join(filter(None, said))
    assert text.startswith(f"**Figure {int(name[3:])}. {title}.** {message}")
    assert text.count(said[1]) == 1
    for panel in drawing.panels:
        curves = panel.of_kind(CURVE)
        assert f"({panel.letter}) " in text
        assert (f"Panel {panel.letter}: {len(curves)} curves of" in text) == bool(curves)
    for roughness in datasets[name]["roughness"].values:
        assert f"{1e9 * roughness:.10g}" in text
    kinds = {series.kind for panel in drawing.panels for series in panel.series}
    assert ("Stars: " in text) == (STARS in kinds)
    assert ("that the paper prints" in text) == bool(kinds & {PRINTED, EVERY_LOAD, ALONG_X})
    assert ("Diamonds: " in text) == ("printed, with tolerance" in key_of(drawing))
    if name == "fig12":
        assert "xₐ/σ = 1;" in text
        assert text.count("xₐ = 100 nm, dry and ν = 10, 25, 50, 70 cSt") == 2
        assert text.count("xₐ = 500 nm, dry and ν = 25, 50, 70, 90, 120, 150 cSt") == 1
    assert "Shaded in colour" not in text
    if name == "fig03":
        last = drawing.panels[1].of_kind(CURVE)[-1]
        first = power_text(float(f"{last.y[0]:.1e}"))
        assert f"xₐ = 1000 nm runs from {first} to {last.y[-1]:.2g}" in text
        assert "printed for loads between strokes: 2, " in text
    if name == "fig11":
        assert "the curve at dry runs from 100 % to 100 %" in text and "×10⁻⁴" in text
    settings = {"report_level": 1, "halt_level": 1, "warning_stream": False}
    body = publish_parts(text, writer="html", settings_overrides=settings)["body"]
    assert body.count("<strong>") == 2


def test_a_caption_says_of_which_inputs_the_curves_are(defaults):
    curves = [{"viscosity_cSt": [90], "particle_diameter_nm": [300], "roughness_nm": [300]}]
    curves[0]["particle_density_per_m2"] = [1e11]
    scene = {"title": "Any", "load_axis": LOAD_AXIS | {"count": 3}, "curves": curves}
    changes = dict.fromkeys(("hardness_surface_1", "hardness_surface_2"), 3e9)
    soft = replace(defaults.best, **changes, particle_plane="surface")
    said = [inputs_sentence(scene_dataset(scene, each)) for each in (defaults.best, soft)]
    assert said[0] == "The curves are of the default inputs."
    assert said[1].startswith(
        "The curves are of inputs that differ from the default: Hₛ₁ = 3×10⁹ Pa"
    )
    assert said[1].endswith("particle_plane = surface.")
    area, sizes = labels_sentences(scene_dataset(scene, soft)).split(". The particle size ")
    assert area.endswith(
        f"for A_n = {1e6 * soft.apparent_area:.3g} mm², which the paper does not print"
    )
    mean, largest = mean_and_largest(1.0, soft)
    assert (
        f"the mean of the sizes is {mean:.3g} x_a, the largest, X_max, {largest:.3g} x_a" in sizes
    )
