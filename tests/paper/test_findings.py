"""Titles of figures: what they say is true of the curves, and not said where the curves deny it."""

import re
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
import yaml

from chenhorng.claims.claims import load_claims
from chenhorng.figures.captions import FIGURES
from chenhorng.figures.curve_figures import plot
from chenhorng.figures.findings import headline
from chenhorng.places import part_of_paper
from chenhorng.scenes import scene_dataset

pytestmark = pytest.mark.usefixtures("style")

ROOT = Path(__file__).parents[2]
RATIO, AREA, SOLID = "particle_contact_area_ratio", "total_contact_area", "solid_load_fraction"
OIL = {"viscosity": 9e-5}
DRY = {"viscosity": 0.0}
TITLED = [name for name, words in FIGURES.items() if "finding" in words]
# of the table ``tpca_windows``: limits of x_a/σ by roughness [m]
LIMITS = {1e-7: (0.87, 1.24), 3e-7: (0.79, 1.35), 5e-7: (0.77, 1.36)}
WINDOWS = [
    {"roughness_m": sigma, "end": end, "diameter_over_roughness": ratio}
    for sigma, ratios in LIMITS.items()
    for end, ratio in zip(("low", "high"), ratios, strict=True)
]


@pytest.fixture(scope="module")
def datasets(defaults):
    """The paper's scenes with the default inputs, on a part of the loads."""
    scenes = yaml.safe_load((ROOT / "config" / "scenes.yaml").read_text())["scenes"]
    axis = {"load_axis": {"load_N": [0.04, 80.0], "count": 60}}
    return {
        name: xr.decode_cf(scene_dataset(scenes[name] | axis, defaults.best, 1e-4).to_xarray())
        for name in TITLED
    }


def said(name, datasets):
    """The title of a figure, and the numbers in it."""
    finding, paper = headline(name, datasets[name], WINDOWS)
    assert finding and paper
    return finding, [float(text) for text in re.findall(r"(?<![\w.])\d[\d.]*", finding)]


def shown(data, name, along, **where):
    """A variable over the load and the values of ``along`` that are shown, without two-body
    contact."""
    values = data[name].sel(where, method="nearest", tolerance=1e-12).squeeze()
    values = values.transpose("load", along)
    values = values[:, (data[along].values > 0.0) | (along == "viscosity")]
    return values.where(values < 1e30).dropna(along, how="all")  # without conditions not shown


def stands_out(values):
    """How far the largest value of each curve lies above the higher of both ends."""
    return values.max("load") - np.maximum(values[0], values[-1])


def test_summits_take_over_later_with_larger_particles_and_never_from_a_size_on(datasets):
    _, (size,) = said("fig03", datasets)
    ratio = shown(datasets["fig03"], RATIO, "particle_diameter")
    alone = ratio.min("load") > 0.95
    assert (alone == (ratio["particle_diameter"] > 0.999e-9 * size)).all() and alone.any()
    half = [int((curve < 0.5).argmax()) for curve in ratio.values[:, ratio.values[0] > 0.95].T]
    taken = [place for place in half if place]
    assert taken == sorted(taken) and len(set(taken)) == len(taken) > 1


@pytest.mark.parametrize(
    ("name", "along"), [("fig06", "particle_diameter"), ("fig07", "particle_density")]
)
def test_areas_grow_with_oil_at_high_loads_alone_and_never_dry(name, along, datasets):
    finding, numbers = said(name, datasets)
    assert "the area never grows" in finding and not numbers
    data = datasets[name]
    dry, wet = (shown(data, AREA, along, **medium) for medium in (DRY, OIL))
    assert (dry.diff(along) < 0.02 * dry.min(along)).all()
    low = wet.where(data["load"] < 2e-6, drop=True)
    assert (low.diff(along) < 0.02 * low.min(along)).all()
    assert (wet.diff(along)[-1] > 0.0).all()


def test_oil_changes_no_area_at_low_loads_and_some_surfaces_turn(datasets):
    _, (roughness,) = said("fig08", datasets)
    data = datasets["fig08"]
    particles = {"particle_diameter": 5e-7}
    dry, wet = (shown(data, AREA, "roughness", **medium, **particles) for medium in (DRY, OIL))
    apart = np.abs(wet / dry - 1.0).max("roughness")
    assert (apart[data["load"] < 2e-6] < 0.05).all() and apart[-1] > 0.05
    assert (wet < 1.02 * dry).all()
    for medium in (DRY, OIL):
        ratio = shown(data, RATIO, "roughness", **medium, **particles)
        turns = stands_out(ratio) >= 0.02
        assert (turns == (ratio["roughness"] > 0.999e-9 * roughness)).all()


@pytest.mark.parametrize(("name", "surfaces"), [("fig09", [3e-7]), ("fig10", [1e-7, 5e-7])])
def test_turning_points_occur_between_the_limits_of_the_title(name, surfaces, datasets):
    _, ends = said(name, datasets)
    data = datasets[name]
    assert tuple(ends) == sum((LIMITS[roughness] for roughness in surfaces), ())
    for roughness, (low, high) in zip(surfaces, (ends[:2], ends[2:])[: len(surfaces)], strict=True):
        ratio = shown(data, RATIO, "particle_diameter", roughness=roughness)
        sizes = ratio["particle_diameter"] / roughness
        inside = (sizes > low) & (sizes < high)
        assert ((stands_out(ratio) >= 0.02) == inside).all() and inside.any()


def test_oil_takes_the_turning_point_of_the_smoother_surface_alone(datasets):
    _, (viscosity,) = said("fig12", datasets)
    data = datasets["fig12"]
    smooth, rough = (
        shown(data, RATIO, "viscosity", particle_diameter=size, roughness=size)
        for size in (1e-7, 5e-7)
    )
    turns = stands_out(smooth) >= 0.02
    assert (turns == (smooth["viscosity"] < 0.999e-6 * viscosity)).all()
    places = data["load"][smooth[:, turns.values].argmax("load")]
    assert places.max() > 1.1 * places[0]
    places = data["load"][rough.argmax("load")]
    assert (stands_out(rough) >= 0.02).all() and places.max() < 1.15 * places.min()


def test_the_turning_point_of_the_title_has_the_height_of_the_dry_one_and_a_larger_load(datasets):
    _, (viscosity, factor) = said("fig11", datasets)
    data = datasets["fig11"]
    ratio, solid = (shown(data, name, "viscosity") for name in (RATIO, SOLID))
    dry, oil = (ratio.sel(viscosity=1e-6 * nu, method="nearest").values for nu in (0.0, viscosity))
    place = int(oil.argmax())
    assert abs(oil.max() - dry.max()) < 0.02
    assert (
        3.0
        < factor
        == pytest.approx(data["load"].values[place] / data["load"].values[dry.argmax()], abs=0.3)
    )
    assert 0.03 < solid.sel(viscosity=1e-6 * viscosity, method="nearest")[place] < 0.9


def test_the_load_of_turning_points_rises_with_density_as_often_as_the_title_says(datasets):
    finding, _ = headline("fig13", datasets["fig13"])
    growths = [
        float(each)
        for each in re.search(r"rises ([\d.]+), ([\d.]+) and ([\d.]+) times", finding).groups()
    ]
    assert "From 5×10¹⁰ to 10¹² m⁻²" in finding and growths == sorted(growths)
    data = datasets["fig13"]
    for size, growth in zip((1e-7, 3e-7, 5e-7), growths, strict=True):
        own = data[RATIO].sel(roughness=size, particle_diameter=size, method="nearest")
        ratio = own.where(own < 1e30).max("viscosity")  # of the one that is drawn
        ends = [ratio.sel(particle_density=eta, method="nearest").values for eta in (5e10, 1e12)]
        first, last = (data["load"].values[each.argmax()] for each in ends)
        assert last / first == pytest.approx(growth, rel=0.3)


@pytest.mark.parametrize("name", TITLED)
def test_a_title_is_dropped_where_the_curves_deny_it(name, datasets):
    data = datasets[name]
    flat = data.assign(
        {each: data[each].where(data[each].isnull(), 0.5) for each in (RATIO, AREA, SOLID)}
    )
    finding, paper = headline(name, flat, WINDOWS)
    assert finding == "" and paper.startswith("The paper: ")
    titles = [
        " ".join(plot(name, each, windows=WINDOWS).get_suptitle().split()) for each in (data, flat)
    ]
    assert titles == [headline(name, data, WINDOWS)[0], data.attrs["title"]] and titles[0]


@pytest.mark.parametrize("name", ["fig09", "fig10"])
def test_a_title_is_dropped_where_the_limits_are_not_those_of_the_curves(name, datasets):
    moved = [
        row | {"diameter_over_roughness": row["diameter_over_roughness"] - 0.2} for row in WINDOWS
    ]
    for windows in ([], moved):
        assert headline(name, datasets[name], windows)[0] == ""


def test_what_the_paper_says_has_the_verdict_on_its_statements(datasets):
    claims = {claim.id: claim for claim in load_claims(ROOT / "config" / "claims.yaml")}
    for name in TITLED:
        places = {part_of_paper(claims[each].place) for each in FIGURES[name]["says"]}
        assert places == {f"Figure {int(name[3:])}"}
    first, second, *_ = FIGURES["fig10"]["says"]
    for words, expected in (
        (["holds", "holds"], " (holds)"),
        (["fails", "fails"], " (fails)"),
        (["holds", "fails"], " (in part)"),
        ([], ""),
    ):
        known = {"another": "fails"} | dict(zip((first, second), words))
        rows = [{"id": each, "verdict": word} for each, word in known.items()]
        _, paper = headline("fig10", datasets["fig10"], WINDOWS, rows)
        assert paper.startswith(f"The paper{expected}: turning points")


@pytest.mark.parametrize("name", TITLED)
def test_a_title_fits_the_width_of_its_figure_and_the_paper_stands_below_it(name, datasets):
    figure = plot(name, datasets[name], windows=WINDOWS)
    figure.draw_without_rendering()
    title = figure._suptitle.get_window_extent()
    (paper,) = (each for each in figure.artists if hasattr(each, "get_text"))
    box = paper.get_window_extent()
    assert paper.get_text() == headline(name, datasets[name], WINDOWS)[1]
    assert max(title.x1, box.x1) <= figure.bbox.width
    assert title.y0 <= box.y1 <= title.y1 - 0.4 * title.height
