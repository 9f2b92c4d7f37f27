"""Maps of contact modes and lubrication regimes over two conditions, with names in the regions."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import scipy  # scipy.ndimage is loaded on first use
import xarray as xr
from matplotlib import rcParams
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from thirdbody.core.regimes import BOUNDARY_LIMIT, FULL_FILM_LIMIT, PARTICLE_LIMIT, SURFACE_LIMIT
from thirdbody.plotting.axes import set_scales
from thirdbody.plotting.drawing import ONE_COLUMN, empty_panels
from thirdbody.plotting.keys import add_key, key_height, key_title, text_width
from thirdbody.plotting.marks import (
    LOOKS,
    PROMINENCE,
    RATIO,
    TURNING_POINTS,
    highest_point,
    peak_load,
)
from thirdbody.plotting.panels import Panel

SOLID = "solid_load_fraction"
HEIGHT = 3.1  # of a map with its labels [inches]
RASTER = 240  # places along each axis, between which regions end
# as in the explorer; with names in the regions, no reader needs them
COLOURS, OF_FILM, OF_REGIME = ("#cfe0f0", "#f6dfc2", "#efc0a5"), "#dcdee0", "#1a5a96"
MODES = ("surface-surface", "s-s"), ("hybrid", "hybrid"), ("particle-surface", "p-s")
REGIMES = ("full film", "F.L."), ("mixed", "M.L."), ("boundary", "B.L.")
AROUND, TICKS = 4.0, 4.5  # a name within its region, beside its ticks [points]
LINE = {"color": "C1", "linewidth": 2.0, "label": LOOKS[TURNING_POINTS]["label"]}


def plot_map(
    data: xr.Dataset,
    x: str,
    y: str,
    common: Sequence[str],
    axes: Sequence[Axes] = (),
    width: float | None = None,
) -> Figure:
    """Draw modes and regimes of ``data``, along ``x`` and ``y`` alone, with the ``common``
    conditions in the title; ``ValueError`` without A_sa,t* and L_s.  Over the load, turning points
    are a line."""
    if not {RATIO, SOLID} <= {*data}:
        raise ValueError(f"data have no map; allowed: data with {RATIO} and {SOLID}")
    dims = [str(data[name].dims[0]) for name in (y, x)]
    ratio, solid = (data[name].transpose(*dims).values for name in (RATIO, SOLID))
    places = data[x].values, data[y].values
    turning = [*_turning_points(*places, ratio, [name.endswith("load") for name in (x, y)])]
    turning = turning if len(turning) > 1 else []  # a line
    width = width or ONE_COLUMN
    title = "Contact mode and lubrication regime"
    if not len(axes):
        key = [[LINE]] if turning else []
        title = f"{title}\n{key_title('', common, width)}".strip()
        size = width, HEIGHT + (key_height(key, "", width) if key else 0.0)
        figure = empty_panels([Panel(title, x, y, [])], size, columns=1)
        axes = figure.axes
        if key:
            add_key(figure, key, "", beside=False)
    (one,) = axes
    one.update_datalim([*zip(*((each[0], each[-1]) for each in places), strict=True)])
    set_scales(one, x, y)
    one.set(xlim=places[0][[0, -1]], ylim=places[1][[0, -1]])
    scales = [axis.get_transform() for axis in (one.xaxis, one.yaxis)]
    edges = [scale.transform(each) for scale, each in zip(scales, places, strict=True)]
    fine = [np.linspace(each[0], each[-1], RASTER) for each in edges]
    mesh = np.meshgrid(*(scale.inverted().transform(each) for scale, each in zip(scales, fine)))
    between = scipy.interpolate.RegularGridInterpolator(edges[::-1], np.stack([ratio, solid], -1))
    raster = between(np.stack(np.meshgrid(*fine)[::-1], -1))
    ratio, solid = raster[..., 0], raster[..., 1]
    one.contourf(*mesh, ratio, [-1.0, SURFACE_LIMIT, PARTICLE_LIMIT, 2.0], colors=COLOURS)
    for level in (SURFACE_LIMIT, PARTICLE_LIMIT):
        _draw_border(one, mesh, ratio, level, colors="0.35", linewidths=0.6)
    above: Any = {"zorder": 2.2}  # a full film has no mode
    one.contourf(*mesh, solid, [-1.0, FULL_FILM_LIMIT], colors=OF_FILM, **above)
    _draw_border(one, mesh, solid, FULL_FILM_LIMIT, colors="0.35", linewidths=0.6, **above)
    look = {"colors": OF_REGIME, "linewidths": 1.2, "linestyles": "dashed"}
    _draw_border(one, mesh, solid, BOUNDARY_LIMIT, **look)
    if turning:
        one.plot(*zip(*turning, strict=True), **LINE)
    if engine := one.figure.figure.get_layout_engine():
        engine.execute(one.figure.figure)  # names need the size of the map
    state = 3 * np.digitize(ratio, [SURFACE_LIMIT, PARTICLE_LIMIT])
    regime = np.digitize(solid, [FULL_FILM_LIMIT, BOUNDARY_LIMIT])
    state = np.where(regime == 0, 0, state + regime)  # a full film has no mode
    state[np.isnan(ratio)] = -1
    if turning:
        state[_near(one, turning)] = -1
    has_particles = all(data[f"particle_{each}"].values.any() for each in ("diameter", "density"))
    for code in np.unique(state[state >= 0]):
        mode, regime = divmod(int(code), 3)
        modes = MODES[mode] if has_particles else ("two-body", "two-body")
        full, short = (
            "\n".join([modes[k], REGIMES[regime][k]] if regime else [REGIMES[0][k]]) for k in (0, 1)
        )
        _write_names(one, state == code, (full, short))
    return one.figure.figure


def _draw_border(axes, mesh, values, level, **look):
    if np.nanmin(values) < level < np.nanmax(values):
        axes.contour(*mesh, values, [level], **look)


def _turning_points(x, y, ratio, is_load) -> Iterator[tuple[float, float]]:
    """The turning point along each row or column over the load, where there is one."""
    if not any(is_load):
        return
    load, others, rows = (x, y, ratio) if is_load[0] else (y, x, ratio.T)
    for other, row in zip(others, rows, strict=True):
        if np.isnan(row).all():
            continue
        top, rise = highest_point(row)
        if 0 < top < load.size - 1 and rise >= PROMINENCE:
            at = peak_load(load, row)
            yield (at, float(other)) if is_load[0] else (float(other), at)


def _near(axes, points) -> NDArray[np.bool_]:
    """The places of the raster beside a line."""
    line = (axes.transData - axes.transAxes).transform(points) * (RASTER - 1)
    steps = np.linspace(line[:-1], line[1:], RASTER).reshape(-1, 2)
    columns, rows = np.rint(np.vstack([line, steps])).astype(int).T
    near = np.zeros((RASTER, RASTER), bool)
    near[rows.clip(0, RASTER - 1), columns.clip(0, RASTER - 1)] = True
    return near


def _write_names(axes, region, texts):
    """Write the first of ``texts`` that fits into each part of a ``region`` of the raster, where it
    is widest."""
    points = 72.0 / axes.figure.dpi
    frame = axes.get_window_extent()
    cells = RASTER / (points * np.array([frame.height, frame.width]))
    letter = rcParams["font.size"]
    rows, columns = np.ceil(TICKS * cells).astype(int)
    free = np.zeros_like(region)
    free[rows:, columns:] = region[rows:, columns:]
    parts, count = scipy.ndimage.label(free)
    for part in (parts == number for number in range(1, count + 1)):
        inside = scipy.ndimage.distance_transform_edt(np.pad(part, 1), 1.0 / cells)[1:-1, 1:-1]
        for text in texts:
            lines = text.splitlines()
            size = 1.25 * letter * len(lines), max(text_width(line, letter) for line in lines)
            box = np.ceil(cells * (np.array(size) + AROUND)).astype(int)
            fits = scipy.ndimage.minimum_filter(part, box, mode="constant", cval=False)
            if fits.any():
                place = np.argmax(np.where(fits, inside, -1.0))
                row, column = np.unravel_index(place, part.shape)
                at = (column + 0.5) / RASTER, (row + 0.5) / RASTER
                axes.text(*at, text, transform=axes.transAxes, ha="center", va="center")
                break
