"""The axes of a panel: scales, ticks, labels and zones."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator, NullFormatter, NullLocator

from thirdbody.plotting.scales import SCALES, ZONES, axis_label
from thirdbody.symbols import power_text

ABOVE_NEWTONS = 19.0  # points between the axes and their title
NEARLY = 0.99  # of the first load, so that it has its tick
ZONE = "0.955"  # grey of the middle zone


def set_scales(
    axes: Axes, x: str, y: str, newtons_per_load: float | None = None, least: float = 0.0
) -> None:
    """Set scales, ticks, labels and limits of axes after all data have been drawn.

    With ``newtons_per_load``, F_t/F_t* [N], a load axis shows newtons at the upper edge.  With
    ``least``, a fraction is logarithmic from there on."""
    axes.margins(x=0.02, y=0.04)
    limits = axes.dataLim
    for axis, name, (low, high) in (
        (axes.xaxis, x, limits.intervalx),
        (axes.yaxis, y, limits.intervaly),
    ):
        variable = SCALES[name]
        axis.set_label_text(axis_label(name))
        spread = 3.0 if variable.is_logarithmic else 10.0
        logarithmic = (variable.is_logarithmic or axis is axes.xaxis) and 0.0 < spread * low < high
        if logarithmic:
            axes.set(**{f"{axis.axis_name}scale": "log"})
            axis.set_major_formatter(lambda value, _: power_text(value))
            if axis is axes.xaxis:
                axis.set_major_locator(_Beside(low, high))
                axis.set_minor_locator(_Beside(low, high, subs="auto"))
        if variable.scale != 1.0:
            axis.set_major_formatter(_in_unit(axis, variable.scale))
            if logarithmic:
                axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
                axis.set_minor_locator(NullLocator())
    if SCALES[y].zones:
        over_sizes = x == "diameter_ratio"  # where tolerances are shaded
        top = limits.y1 if 0.0 < limits.y1 < 0.5 and not over_sizes else 1.0
        axes.set_ylim(-0.08 * top, 1.08 * top)
        if least:
            axes.set(yscale="log", ylim=(least, 1.4))
        _draw_zones(axes, SCALES[y], shaded=not over_sizes)
    if x == "load" and newtons_per_load is not None:
        ends = lambda load: load * newtons_per_load, lambda newtons: newtons / newtons_per_load
        upper = axes.secondary_xaxis("top", functions=ends)
        upper.xaxis.set_major_formatter("{x:g} N")
        upper.xaxis.set_major_locator(_Beside(*(newtons_per_load * limits.intervalx)))
        upper.tick_params(direction="out")  # not through names at the upper edge
        upper.xaxis.set_minor_locator(NullLocator())
        upper.set_zorder(1.0)  # ticks are seen on zones
        upper.set_in_layout(False)  # the title leaves room for it
        axes.set_title(axes.get_title(loc="left"), loc="left", y=1.0, pad=ABOVE_NEWTONS)


class _Beside(LogLocator):
    """Ticks beside the curves, from ``low`` to ``high`` alone: beyond these, names may stand."""

    def __init__(self, low, high, **options):
        super().__init__(**options)
        self.low, self.high = NEARLY * low, high / NEARLY

    def tick_values(self, vmin, vmax):
        ticks = super().tick_values(vmin, vmax)
        return ticks[(self.low <= ticks) & (ticks <= self.high)]


def _in_unit(axis, unit):
    """Write all ticks in a unit, with the same number of decimals."""

    def text(value, _):
        ticks = [f"{tick:.6g}" for tick in axis.get_majorticklocs() / unit]
        decimals = 0 if axis.get_scale() == "log" else max(len(t.partition(".")[2]) for t in ticks)
        return f"{value / unit:.{decimals}f}" if decimals else f"{value / unit:g}"

    return text


def _draw_zones(axes, scale, shaded):
    """Shade the middle regime or mode behind the curves, and name all of them on the right."""
    low, high = axes.get_ylim()
    limits, names = ZONES[scale.zones]
    if shaded:
        axes.axhspan(limits[0], min(limits[1], high), color=ZONE, linewidth=0.0, zorder=0.5)
    inside = [limit for limit in limits if limit < high]
    edges = axes.transScale.transform([(1.0, each) for each in (low, *inside, high)])[:, 1]
    middles = axes.transScale.inverted().transform(
        [(0.0, each) for each in 0.5 * (edges[1:] + edges[:-1])]
    )[:, 1]
    heights = np.diff(edges) / (edges[-1] - edges[0])
    zones = zip(middles, names, heights, strict=False)
    named = [(middle, name) for middle, name, height in zones if height > 0.05]
    right = axes.secondary_yaxis("right")
    right.set_yticks(*zip(*named, strict=True))
    right.set_yticks(limits, minor=True)
    right.yaxis.set_minor_formatter(NullFormatter())
    right.tick_params(length=0)
