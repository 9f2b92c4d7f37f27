"""What the curves of each figure of the paper show, in a sentence: checked on the data, whatever
the inputs, with the numbers of the data.  The words are in ``captions.yaml``."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from chenhorng.claims.courses import peak_height
from chenhorng.figures.captions import FIGURES, SENTENCES
from chenhorng.figures.printed import window_limits
from chenhorng.sampling import first_fall, logarithm
from thirdbody.core.regimes import BOUNDARY_LIMIT, PARTICLE_LIMIT
from thirdbody.netcdf import Dataset
from thirdbody.plotting.load_curves import curves_in
from thirdbody.plotting.marks import AREA, PROMINENCE, RATIO, peak_load
from thirdbody.plotting.panels import Curve
from thirdbody.symbols import power_text, unicode
from thirdbody.variables import AXES

SOLID = "solid_load_fraction"
IN_PART = "in part"  # the verdict on what the paper says, where its statements have several
LINE = 0.02  # a line's width, of a fraction or relative
SIMILAR = 0.05  # relative difference of areas that overlap
SHIFT = 1.1  # factor between loads of turning points that differ

Curves = Sequence[Curve]
Found = Mapping[str, str] | None  # what a sentence names; None if the data deny it


def headline(
    name: str,
    data: Dataset,
    windows: Sequence[Mapping] = (),
    verdicts: Sequence[Mapping] = (),
) -> tuple[str, str]:
    """What the ``data`` of a figure of the paper show, empty if they deny it, and what the paper
    says, in a sentence that stands alone, with the verdict on it; both are empty for any other
    figure.  ``windows`` and ``verdicts`` are rows of the tables ``tpca_windows`` and
    ``verdicts``."""
    words = FIGURES.get(name, {})
    if "paper" not in words:
        return "", ""
    curves = [one for one in curves_in(data) if AREA in one.values]
    if name in WITH_WINDOWS:
        found = _windows(curves, windows, WITH_WINDOWS[name])
    else:
        found = FOUND[name](curves)
    known = {row["verdict"] for row in verdicts if row["id"] in words["says"]}
    verdict = f" ({known.pop() if len(known) == 1 else IN_PART})" if known else ""
    paper = unicode(f"{SENTENCES['paper'].format(verdict)} {words['paper']}")
    if found is None:
        return "", paper
    return unicode(words["finding"].format(**found)), paper


def _along(curves: Curves, parameter: str, is_dry: bool | None = None) -> list[Curve]:
    """The three-body curves in the order of a ``parameter``: all, or those that are dry or not."""
    chosen = [
        one
        for one in curves
        if not one.condition.is_two_body and is_dry in (None, one.condition.is_dry)
    ]
    return sorted(chosen, key=lambda one: getattr(one.condition, parameter))


def _surfaces(curves: Curves) -> list[list[Curve]]:
    """The three-body curves of each surface, the smoothest first, by viscosity and size."""
    every = sorted({one.condition.roughness for one in curves})
    ordered = sorted(_along(curves, "viscosity"), key=lambda one: one.condition.particle_diameter)
    return [[one for one in ordered if one.condition.roughness == sigma] for sigma in every]


def _number(curve: Curve, parameter: str) -> str:
    """The value of a condition of a curve, in its unit."""
    return f"{AXES[parameter].from_si(getattr(curve.condition, parameter)):g}"


def _falls_to(curve: Curve, name: str, level: float) -> float:
    """The load at which a variable falls to a level; infinite if it does not."""
    values, load = curve.values[name], curve.values["load"]
    if values.min() > level:
        return np.inf
    return first_fall(load, logarithm(values) - np.log(level))


def _turns(curve: Curve) -> bool:
    return bool(peak_height(curve.values[RATIO]) >= PROMINENCE)


def _top(curve: Curve, name: str) -> float:
    """The value of a variable where A_sa,t* is largest."""
    return float(curve.values[name][np.argmax(curve.values[RATIO])])


def _top_load(curve: Curve) -> float:
    return peak_load(curve.values["load"], curve.values[RATIO])


def _rise(values: Sequence[float], by: float = 0.0) -> bool:
    """Whether each of the ``values`` is larger than the one before, by a relative amount."""
    return all(later > (1.0 + by) * one for one, later in zip(values, values[1:]))


def _modes_by_size(curves: Curves) -> Found:
    """Summits take over later with larger particles; the largest carry each load alone."""
    by_size = _along(curves, "particle_diameter")
    began = [one for one in by_size if one.values[RATIO][0] > PARTICLE_LIMIT]
    loads = [_falls_to(one, RATIO, PARTICLE_LIMIT) for one in began]
    finite = [load for load in loads if np.isfinite(load)]
    if not 1 < len(finite) < len(loads) or loads != sorted(loads) or not _rise(finite):
        return None
    return {"size": _number(began[len(finite)], "particle_diameter")}


def _mixed_by_viscosity(curves: Curves) -> Found:
    """From a viscosity on the lubricant carries part of the load, and the area stays behind."""
    every = _along(curves, "viscosity")
    dry, wet = every[:1], every[1:]
    mixed = [one for one in wet if one.values[SOLID].min() < BOUNDARY_LIMIT]
    ends = [one.values[AREA][-1] for one in (*mixed[::-1], *dry)]
    if not mixed or mixed != wet[-len(mixed) :] or not _rise(ends, LINE):
        return None
    return {"viscosity": _number(mixed[0], "viscosity")}


def _mixed_by_surface(curves: Curves) -> Found:
    """The least viscosities that give mixed lubrication on two surfaces."""
    least = []
    for on_surface in _surfaces(curves):
        mixed = [one for one in on_surface if one.values[SOLID].min() < BOUNDARY_LIMIT]
        least += mixed[:1]
    if len(least) != 2 or least[0].condition.viscosity >= least[1].condition.viscosity:
        return None
    smoother, rougher = (_number(one, "viscosity") for one in least)
    return {"smoother": smoother, "rougher": rougher}


def _reversal(curves: Curves, parameter: str) -> Found:
    """The dry area never rises from curve to curve; with oil it does so at high loads alone."""
    dry, wet = (_along(curves, parameter, is_dry=is_dry) for is_dry in (True, False))
    if len(dry) < 2 or len(wet) < 2:
        return None
    rise_dry, rise = (
        np.diff(np.log([one.values[AREA] for one in each]), axis=0) for each in (dry, wet)
    )
    low = rise[:, : rise.shape[1] // 2]
    if max(rise_dry.max(), low.max()) > LINE or rise[:, -1].min() <= 0.0:
        return None
    return {}


def _small_loads_and_surfaces(curves: Curves) -> Found:
    """Oil changes no area at low loads, and lessens some at high ones; from a roughness on there is
    a turning point, dry and lubricated."""
    dry, wet = (_along(curves, "roughness", is_dry=is_dry) for is_dry in (True, False))
    if not dry or len(dry) != len(wet):
        return None
    areas = [np.log([one.values[AREA] for one in each]) for each in (dry, wet)]
    change = areas[1] - areas[0]
    apart = np.abs(change).max(axis=0)
    turning = [one for one, other in zip(dry, wet, strict=True) if _turns(one) and _turns(other)]
    low = apart[: apart.size // 2]
    if low.max() > SIMILAR or apart[-1] < SIMILAR or change.max() > LINE:
        return None
    if not turning or turning != dry[-len(turning) :]:
        return None
    return {"roughness": _number(turning[0], "roughness")}


def _windows(curves: Curves, windows: Sequence[Mapping], count: int) -> Found:
    """The computed limits of x_a/σ with turning points on each of so many surfaces, if just the
    curves between them have one."""
    found: dict[str, str] = {}
    surfaces = _surfaces(curves)
    if len(surfaces) != count:
        return None
    for place, on_surface in enumerate(surfaces):
        ends = window_limits(windows, on_surface[0].condition.roughness)
        if ends.size != 2:
            return None
        low, high = np.sort(ends)
        turning = [one for one in on_surface if _turns(one)]
        between = [one for one in on_surface if low < one.condition.diameter_ratio < high]
        if not turning or turning != between:
            return None
        found |= {f"low_{place}": f"{low:.2f}", f"high_{place}": f"{high:.2f}"}
    return found


def _shift_by_viscosity(curves: Curves) -> Found:
    """Where lubrication is mixed the turning point takes a larger load, at the same height."""
    turning = [one for one in _along(curves, "viscosity") if _turns(one)]
    mixed = [one for one in turning[1:] if _top(one, SOLID) < BOUNDARY_LIMIT]
    heights = [_top(one, RATIO) for one in turning]
    loads = [_top_load(one) for one in (*turning[:1], *mixed)]
    if not mixed or np.ptp(heights) > LINE or not _rise(loads, LINE):
        return None
    factor = f"{loads[-1] / loads[0]:.1g}"
    return {"viscosity": _number(mixed[-1], "viscosity"), "factor": factor}


def _turning_by_surface(curves: Curves) -> Found:
    """On the smoother surface the turning point moves with viscosity until it is gone; on the
    rougher one it stays."""
    surfaces = _surfaces(curves)
    if len(surfaces) < 2:
        return None
    smoother, rougher = surfaces[0], surfaces[-1]
    has = [one for one in smoother if _turns(one)]
    gone = smoother[len(has) :]
    moved = [_top_load(one) for one in has]
    stays = [_top_load(one) for one in rougher]
    if not has or not gone or has != smoother[: len(has)] or max(moved) < SHIFT * moved[0]:
        return None
    if not all(map(_turns, rougher)) or max(stays) > SHIFT * min(stays):
        return None
    return {"viscosity": _number(gone[0], "viscosity")}


def _shift_by_density(curves: Curves) -> Found:
    """The load of the turning point grows more with particle density on rougher surfaces, over the
    densities at which all surfaces have one."""
    surfaces = [_along(one, "particle_density") for one in _surfaces(curves)]
    common = [all(map(_turns, each)) for each in zip(*surfaces, strict=True)]
    if sum(common) < 2:
        return None
    growths = []
    for surface in surfaces:
        loads = [_top_load(one) for one, is_in in zip(surface, common, strict=True) if is_in]
        growths.append(loads[-1] / loads[0])
    if not _rise(growths, LINE):
        return None
    ends = [one for one, is_in in zip(surfaces[0], common, strict=True) if is_in]
    low, high = (power_text(ends[place].condition.particle_density) for place in (0, -1))
    *first, last = (f"{each:.2g}" for each in growths)
    return {"low": low, "high": high, "growths": f"{', '.join(first)} and {last}"}


WITH_WINDOWS = {"fig09": 1, "fig10": 2}  # numbers of surfaces that their titles name
FOUND: dict[str, Callable[[Curves], Found]] = {
    "fig03": _modes_by_size,
    "fig04": _mixed_by_viscosity,
    "fig05": _mixed_by_surface,
    "fig06": lambda curves: _reversal(curves, "particle_diameter"),
    "fig07": lambda curves: _reversal(curves, "particle_density"),
    "fig08": _small_loads_and_surfaces,
    "fig11": _shift_by_viscosity,
    "fig12": _turning_by_surface,
    "fig13": _shift_by_density,
}
