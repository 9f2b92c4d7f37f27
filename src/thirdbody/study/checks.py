"""One check for each kind of statement: how far off a claim is, in units of its tolerance."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np

from thirdbody.study.claims import (
    BOUNDS,
    CURVE_QUANTITIES,
    REVERSAL_LOAD,
    STATES,
    TURNING_POINT_QUANTITIES,
    WINDOW_QUANTITIES,
    Claim,
    state_names,
)

MISSING_SCORE = 10.0  # no evidence, and the most that any score reaches
BOUND_TOLERANCE = 0.02  # of ratios that bound a range of loads: a line's width on their axes
SATURATED = 1e-12  # ratios nearer to 0 or 1 have no odds to tell apart
TINY = 1e-300  # floor under logarithms: keeps what has vanished comparable


@dataclass(frozen=True)
class Curve:
    """One curve over increasing load F_t*: 1-D arrays of equal length.

    ``normal_load`` in N, ``separation`` in m, the others dimensionless under the names of the
    datasets' variables; ``film_thickness`` is d/R_x when dry; ``solved``: which points converged.
    """

    load: np.ndarray
    normal_load: np.ndarray
    total_contact_area: np.ndarray
    particle_contact_area_ratio: np.ndarray
    solid_load_fraction: np.ndarray
    fluid_load_fraction: np.ndarray
    film_thickness: np.ndarray
    separation: np.ndarray
    solved: np.ndarray

    @cached_property
    def solid_load(self) -> np.ndarray:
        """Dimensionless load borne by the solid, L_s F_t* [1]."""
        return self.solid_load_fraction * self.load

    @cached_property
    def log_load(self) -> np.ndarray:
        """ln F_t* [1]."""
        return np.log(self.load)

    @cached_property
    def total_contact_area_slope(self) -> np.ndarray:
        """d ln A_t* / d ln F_t* [1]: the slope that logarithmic axes show."""
        return np.gradient(_log(self.total_contact_area), self.log_load)

    @cached_property
    def _samples(self) -> dict[str, tuple[np.ndarray, bool]]:
        return {}

    def samples(self, quantity: str) -> tuple[np.ndarray, bool]:
        """Values of ``quantity`` to interpolate in, nan where unsolved, and whether they are
        logarithms: so they are where all values are positive."""
        if quantity not in self._samples:
            values = getattr(self, quantity)
            logarithmic = bool((values > 0.0).all())
            values = np.log(values) if logarithmic else values
            self._samples[quantity] = np.where(self.solved, values, np.nan), logarithmic
        return self._samples[quantity]


class TurningPoint(NamedTuple):
    """Interior maximum of A_sa,t* over load: F_TPCA*, A_sa,t* and L_s there [1]; nan if none."""

    load: float
    peak_ratio: float
    solid_load_fraction: float
    exists: bool


class Evidence(Protocol):
    """What claims are judged on; arguments in SI, as in ``Condition``."""

    def curve(self, viscosity, particle_diameter, roughness, particle_density) -> Curve:
        """The curve over the whole load range."""

    def turning_point(self, viscosity, particle_diameter, roughness, particle_density):
        """The ``TurningPoint`` of that curve, refined below its grid spacing."""

    def window(self, roughness) -> tuple[float, float]:
        """Ends of the range of x_a/sigma [1] with a turning point in hybrid mode (dry, 1e11)."""


class Verdict(NamedTuple):
    """How a claim fares; ``deviation`` is a fraction where the tolerance is relative.

    ``score`` counts tolerances up to 1 and grows with their logarithm beyond, at most to
    ``MISSING_SCORE``: each miss keeps a slope, none drowns the others; nan if value withheld.
    """

    measured: str
    value: float
    deviation: float
    score: float
    holds: bool


class NotReached(Exception):
    """No load obeys a claim's bounds; the argument is by how much the nearest misses them."""


def judge(claim: Claim, evidence: Evidence) -> Verdict:
    """Measures what the claim speaks of and compares it with what the paper says."""
    try:
        measured, value, deviation, distance = CHECKS[claim.kind](claim, evidence)
    except NotReached as short:
        measured, value, deviation = f"not reached, by {short.args[0]:.3g}", np.nan, np.nan
        distance = 2.0 + short.args[0] / BOUND_TOLERANCE
    score = np.nan if claim.is_withheld else _score(distance)
    return Verdict(measured, float(value), float(deviation), score, score <= 1.0)


def _score(distance: float) -> float:
    if np.isnan(distance):
        return MISSING_SCORE
    within = min(max(float(distance), 0.0), 1.0)
    return min(within + float(np.log(max(distance, 1.0))), MISSING_SCORE)


# --- checks: (measured, value, deviation, distance in tolerances), nan without evidence ---


def check_value(claim: Claim, evidence: Evidence):
    """One number; where several curves share it, the worst of them counts."""
    values = _scalars(claim, evidence)
    return _against_published(claim, values, _shown(claim, evidence, values))


def check_range(claim: Claim, evidence: Evidence):
    """Least and greatest value of the quantity on a curve."""
    (course,) = _courses(claim, evidence)
    ends = np.array([course.min(), course.max()])
    return _against_published(claim, ends, f"{ends[0]:.4g} to {ends[1]:.4g}")


def check_window(claim: Claim, evidence: Evidence):
    """Ends of the turning point's range of x_a/sigma; of several surfaces the worst counts."""
    windows = np.array([evidence.window(condition.roughness) for condition in claim.curves])
    text = ", ".join(f"{low:.3f} to {high:.3f}" for low, high in windows)
    return _against_published(claim, windows, text)


def check_ordering(claim: Claim, evidence: Evidence):
    """Curves one above the other: nowhere against the order, and each pair somewhere apart."""
    sign = -1.0 if claim.direction == "decreasing" else 1.0
    gaps = [sign * gap for gap in _gaps(claim, evidence)]
    against, apart = -np.min([gap.min() for gap in gaps]), np.min([gap.max() for gap in gaps])
    text = f"against the order by {max(against, 0.0):.3g}, apart by {apart:.3g}"
    return _missed(claim, text, np.max([against, 2.0 * claim.step - apart]))


def check_coincidence(claim: Claim, evidence: Evidence):
    """Curves that overlap with their references."""
    widest = np.max([np.abs(gap).max() for gap in _gaps(claim, evidence)])
    return _missed(claim, f"apart by {widest:.3g} at most", widest)


def check_course(claim: Claim, evidence: Evidence):
    """A trend along load on each curve, or from curve to curve; or no interior maximum."""
    along_curves = claim.along == "curves"
    courses = [_scalars(claim, evidence)] if along_curves else _courses(claim, evidence)
    miss = COURSES[claim.direction or claim.kind]
    misses = [miss(_scaled(claim, course), claim.step) for course in courses]
    worst = int(np.argmax(misses))
    course = courses[worst]
    text = f"{course[0]:.4g} to {course[-1]:.4g} within {course.min():.4g} and {course.max():.4g}"
    return _missed(claim, _shown(claim, evidence, course) if along_curves else text, misses[worst])


def check_sequence(claim: Claim, evidence: Evidence):
    """Regimes, modes or both, passed in this order with increasing load."""
    curves = [evidence.curve(*condition) for condition in claim.curves]
    misses = [_sequence_miss(claim, curve) for curve in curves]
    worst = int(np.argmax(misses))
    return _missed(claim, _visited(claim, curves[worst]), misses[worst])


CHECKS = {
    "value": check_value,
    "range": check_range,
    "window": check_window,
    "ordering": check_ordering,
    "coincidence": check_coincidence,
    "trend": check_course,
    "absence": check_course,
    "regime_sequence": check_sequence,
    "mode_sequence": check_sequence,
}


def _against_published(claim, measured, text):
    published = np.nan if claim.published is None else np.asarray(claim.published)
    deviation = measured - published
    distance = np.abs(deviation) / claim.tolerance
    if claim.relative:
        # logarithmic, so that a quantity near zero keeps a slope; 1 at either end of the tolerance
        ratio = np.maximum(measured / published, TINY)
        deviation = ratio - 1.0
        distance = np.log(ratio) / np.log1p(np.copysign(claim.tolerance, deviation))
    worst = int(np.argmax(distance))
    return text, measured.flat[worst], deviation.flat[worst], distance.flat[worst]


def _missed(claim, text, miss):
    deviation = np.expm1(miss) if claim.relative else miss
    return text, np.nan, deviation, miss / claim.step


# --- measuring ---


def _scalars(claim, evidence):
    """The claim's quantity, one number a curve; its relative change where a reference is given."""
    if claim.quantity == REVERSAL_LOAD:
        return np.array([_reversal_load(claim, evidence)])
    if claim.source == "turning_point":
        pick = TURNING_POINT_QUANTITIES[claim.quantity]
        values = np.array([pick(evidence.turning_point(*c)) for c in claim.curves])
        references = [pick(evidence.turning_point(*c)) for c in claim.references]
        return values / references - 1.0 if references else values
    if claim.source == "window":
        end = WINDOW_QUANTITIES[claim.quantity]
        return np.array([evidence.window(c.roughness)[end] for c in claim.curves])
    extreme = np.max if claim.extreme == "maximum" else np.min
    return np.array([extreme(course) for course in _courses(claim, evidence)])


def _courses(claim, evidence):
    """The claim's quantity along each curve; its relative change where a reference is given."""
    if not claim.references:
        return [_table(claim, evidence, [condition])[1][0] for condition in claim.curves]
    pairs = zip(claim.references, claim.curves, strict=True)
    tables = [_table(claim, evidence, pair)[1] for pair in pairs]
    return [curve / reference - 1.0 for reference, curve in tables]


def _gaps(claim, evidence):
    """What each curve shows more than its reference or the one before it, on the scale of step."""
    pairs = zip(claim.references, claim.curves, strict=True)
    for group in pairs if claim.references else [claim.curves]:
        yield from np.diff(_scaled(claim, _table(claim, evidence, group)[1]), axis=0)


def _reversal_load(claim, evidence):
    """Load F_t* [1] above which A_t* keeps the order of the claim's curves."""
    loads, areas = _table(claim, evidence, claim.curves, "total_contact_area")
    gaps = np.diff(_log(areas), axis=0)
    return np.max([_first_fall(loads[::-1], gap[::-1]) for gap in gaps])


def _table(claim, evidence, group, quantity=""):
    """Abscissa and quantity [curve, point] of a group of curves, where the claim speaks of them."""
    curves = [evidence.curve(*condition) for condition in group]
    # bounds speak of the curve itself, not of the reference that it is held against
    x = _loads(claim, curves, curves[bool(claim.references) :])
    if claim.against != "load":
        spans = [getattr(curve, claim.against) for curve in curves]
        x = _sample(curves[-1], claim.against, x)
        x = np.clip(x, np.max(np.min(spans, axis=1)), np.min(np.max(spans, axis=1)))
    values = [_sample(curve, quantity or claim.quantity, x, claim.against) for curve in curves]
    return x, np.array(values)


def _loads(claim, curves, bounded):
    """Loads F_t* [1] that the claim speaks of: one, or all within its bounds on ``bounded``."""
    limits, grid = claim.conditions, curves[-1]
    if "load" in limits:
        return np.array([limits["load"]])
    for name in limits.keys() & set(CURVE_QUANTITIES):
        excess = _log(getattr(grid, name)) - np.log(limits[name])
        return np.array([_first_fall(grid.load, excess)])
    heaviest = np.interp(limits.get("load_max_N", np.inf), grid.normal_load, grid.load)
    low = max(limits.get("load_min", 0.0), max(curve.load[0] for curve in curves))
    high = min(limits.get("load_max", heaviest), min(curve.load[-1] for curve in curves))
    inner = grid.load[(grid.load > low) & (grid.load < high)]
    if not low < high:
        raise NotReached(np.log(low / high))
    loads = np.concatenate([[low], inner, [high]])
    shortfalls = [
        sign * (limits[key] - _sample(curve, name, loads))
        for key, (name, sign) in BOUNDS.items()
        if key in limits
        for curve in bounded
    ]
    if not shortfalls:
        return loads
    shortfall = np.max(shortfalls, axis=0)
    if shortfall.min() > 0.0:
        raise NotReached(shortfall.min())
    return loads[~(shortfall > 0.0)]


def _first_fall(loads, values):
    """Load at which ``values`` first fall to zero, continuous where that leaves the range.

    Values below zero from the start give the first load; values that end above zero are continued
    by their last slope, for a decade at most.
    """
    above = values > 0.0
    if not above[0]:
        return loads[0] if values[0] <= 0.0 else np.nan
    right = above.size - 1 if above.all() else int(np.argmin(above))
    step = np.log(loads[right] / loads[right - 1])
    fall = np.maximum(values[right - 1] - values[right], TINY)
    advance = np.minimum(values[right - 1] / fall, np.log(10.0) / abs(step))
    return loads[right - 1] * np.exp(advance * step)


def _sample(curve, quantity, x, against="load"):
    """``quantity`` where ``against`` is ``x``: linear in logarithms; nan beside unsolved points."""
    if quantity == against:
        return x
    known = curve.log_load if against == "load" else np.log(getattr(curve, against))
    forward = slice(None, None, 1 if known[0] < known[-1] else -1)
    values, logarithmic = curve.samples(quantity)
    found = np.interp(np.log(x), known[forward], values[forward], np.nan, np.nan)
    return np.exp(found) if logarithmic else found


def _rise_miss(values, step):
    """How far ``values`` fall back, or what they lack to rise visibly in all."""
    relapse = np.max(np.maximum.accumulate(values) - values)
    return np.max([relapse, 2.0 * step - (values[-1] - values[0])])


def _peak_height(values):
    """How far the highest interior maximum stands out, over the higher of its two sides' feet."""
    left = values - np.minimum.accumulate(values)
    right = values - np.minimum.accumulate(values[::-1])[::-1]
    return np.max(np.minimum(left, right))


def _peak_miss(values, step):
    """How much higher a maximum must stand out and, where there is none, how far from turning.

    The latter is the gentlest change of the odds, taken over the whole course: unlike the ratio,
    the odds go on changing near 0 and 1.  A ratio stuck there is as far off as odds can tell.
    """
    size = np.abs(values)
    free = (size > SATURATED) & (size < 1.0 - SATURATED)
    odds = np.copysign(np.log(size[free] / (1.0 - size[free])), values[free])
    lack = -np.log(SATURATED)
    if odds.size > 2:
        changes = np.diff(odds) * odds.size
        climb = np.maximum.accumulate(changes)[:-1]
        drop = np.maximum.accumulate(-changes[::-1])[::-1][1:]
        lack = max(-np.max(np.minimum(climb, drop)), 0.0)
    return (2.0 + lack) * step - _peak_height(values)


# how far a course of values is from what its name promises, on the scale of ``step``
COURSES = {
    "increasing": _rise_miss,
    "decreasing": lambda values, step: _rise_miss(-values, step),
    "constant": lambda values, step: np.ptp(values),
    "rising_then_falling": _peak_miss,
    "falling_then_rising": lambda values, step: _peak_miss(-values, step),
    "absence": lambda values, step: _peak_height(values),
}


def _sequence_miss(claim, curve):
    """Least worst excursion from the published steps if each is passed in turn, none skipped."""
    excursions = np.array([_excursion(curve, step) for step in claim.published])
    if np.isnan(excursions).any():
        return np.nan
    enter, reached = -np.inf, [np.inf] * len(excursions)
    # plain numbers: the steps are too few for arrays to pay
    for point in excursions.T.tolist():
        come = enter
        for step, here in enumerate(point):
            stay = reached[step]
            best = stay if stay < come else come
            come, reached[step] = stay, here if here > best else best
        enter = np.inf
    return min(reached[-2:]) if claim.open_end else reached[-1]


def _excursion(curve, step):
    """How far each point is outside the limits of a step such as "mixed hybrid or full_film"."""
    excursions = []
    for alternative in step.split(" or "):
        outside = np.where(curve.solved, 0.0, np.nan)
        for name in alternative.split():
            quantity, low, high = STATES[name]
            values = getattr(curve, quantity)
            outside = np.maximum(outside, np.maximum(low - values, values - high))
        excursions.append(outside)
    return np.min(excursions, axis=0)


def _visited(claim, curve):
    """The states that a curve passes, in the terms of the claim's own sequence."""
    families = {STATES[name][0] for name in state_names(claim.published)}
    inside = {
        name: (getattr(curve, quantity) > low) & (getattr(curve, quantity) <= high)
        for name, (quantity, low, high) in STATES.items()
        if quantity in families
    }
    points = np.column_stack(list(inside.values()))
    changes = np.flatnonzero((points[1:] != points[:-1]).any(axis=1)) + 1
    passed = points[np.insert(changes, 0, 0)].tolist()
    states = (" ".join(name for name, there in zip(inside, row) if there) for row in passed)
    return " > ".join(states).strip()


def _scaled(claim, values):
    return _log(values) if claim.relative else values


def _log(values):
    return np.log(np.maximum(values, TINY))


def _shown(claim, evidence, values):
    """Numbers as text; a load outside those computed is shown as such."""
    texts = [f"{value:.4g}" for value in values]
    if claim.quantity in ("load", REVERSAL_LOAD):
        first, last = evidence.curve(*claim.curves[0]).load[[0, -1]]
        texts = [f"> {last:.4g}" if v >= last else text for v, text in zip(values, texts)]
        texts = [f"< {first:.4g}" if v <= first else text for v, text in zip(values, texts)]
    return ", ".join(texts)
