"""Checks of the statements of the paper: one for each kind of statement.

``judge`` computes the number or course in question from ``evidence``, and its distance from the
statement in tolerances of the claim, which holds if this is at most 1.  The head of
``config/claims.yaml`` explains the kinds of statements.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np

from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.model.parameters import Parameters
from thirdbody.model.regimes import BOUNDARY_LIMIT
from thirdbody.study.claims import (
    BETWEEN_CURVES,
    BOUNDS,
    CURVE_QUANTITIES,
    STATES,
    TURNING_POINT_QUANTITIES,
    WINDOW_QUANTITIES,
    Claim,
    referenced_conditions,
)
from thirdbody.study.evidence import FULL_EFFORT, Effort, Evidence, solve_evidence

MISSING_SCORE = 10.0  # the largest score, also used if there is nothing to compare
# Loads may miss the bound of a claim by this before its score grows: a line width.
BOUND_TOLERANCE = 0.02
MAXIMA = {"absence", "rising_then_falling"}  # kind or direction of statements on a maximum
BEND = 0.1  # decrease of the slope of a curve at a visible bend [1]
SATURATED = 1e-12  # closer to 0 or 1, the odds of a ratio have lost their digits
TINY = 1e-300  # least argument of logarithms, so that vanishing quantities can be compared


class Verdict(NamedTuple):
    """Result of judging a claim: the result of the model as text, its distance from the published value in
    tolerances [1], and the largest deviation, computed minus published, relative [1] if the tolerance is.

    ``numbers`` are those compared [unit of the quantity], ``worst`` the index of that with the deviation.
    A claim is ``tested`` if the model reaches its condition within the loads.
    """

    computed: str
    distance: float
    deviation: float
    numbers: tuple[float, ...] = ()
    worst: int = 0
    tested: bool = True

    @property
    def score(self) -> float:
        """The distance, 1 + its logarithm beyond 1, and at most ``MISSING_SCORE``, so that one large
        miss does not outweigh the rest."""
        if np.isnan(self.distance):
            return MISSING_SCORE
        logarithm = float(np.log(max(self.distance, 1.0)))
        return min(min(self.distance, 1.0) + logarithm, MISSING_SCORE)

    @property
    def holds(self) -> bool:
        """Whether the claim is tested and met within its tolerance."""
        return self.tested and self.score <= 1.0

    @property
    def value(self) -> float:
        """The number with the largest deviation [unit of the quantity]; nan if there are none."""
        return self.numbers[self.worst] if self.numbers else np.nan


class NotReached(Exception):
    """No load of a curve is within the bounds of a claim, by the shortfall in the argument."""


@dataclass(frozen=True)
class Judge:
    """Evaluates the same statements for any inputs: ``base`` has inputs missing in a set, fields of
    ``Parameters`` in SI; ``newtons`` are the first and last normal load of every curve [N]."""

    claims: Sequence[Claim]
    base: Mapping[str, Any]
    newtons: tuple[float, float]

    def __call__(
        self,
        inputs: Mapping[str, Any],
        effort: Effort = FULL_EFFORT,
        claims: Sequence[Claim] | None = None,
    ) -> dict[str, Verdict]:
        """Evaluate all statements, or some ``claims``, for ``inputs``, fields of ``Parameters`` in SI:
        verdicts by the ids of the statements, in order.  Unphysical inputs raise ``ValueError``."""
        some = self.claims if claims is None else claims
        prominence = effort.window.prominence
        if prominence != PROMINENCE:  # it is also the tolerance of statements on maxima
            some = [
                replace(claim, tolerance=prominence)
                if MAXIMA & {claim.kind, claim.direction}
                else claim
                for claim in some
            ]
        parameters = Parameters(**{**self.base, **inputs})
        evidence = solve_evidence(parameters, referenced_conditions(some), self.newtons, effort)
        return {claim.id: judge(claim, evidence) for claim in some}


def judge(claim: Claim, evidence: Evidence) -> Verdict:
    """Compare the model with a statement of the paper; ``evidence`` must have its curves."""
    try:
        found = CHECKS[claim.kind](claim, evidence)
        found = found._replace(tested=_is_within_the_loads(claim, evidence))
    except NotReached as short:
        (lack,) = short.args
        text, distance = f"not reached, by {lack:.3g}", 2.0 + lack / BOUND_TOLERANCE
        found = Verdict(text, distance, np.nan, tested=claim.must_be_reached)
    if claim.source == "turning_point":
        # of any curve, the one that agrees best must have a turning point
        curves = [claim.curves[found.worst]] if claim.any_curve else claim.curves
        every = (evidence.turning_points[each] for each in (*curves, *claim.references))
        least = np.min([point.prominence for point in every])
        height = least / evidence.effort.window.prominence
        # smooth: 1 where it is just visible, 0 from twice that height on
        faintness = max(2.0 - height, 0.0) if height > 1.0 else 1.0 / np.maximum(height, TINY)
        remark = "" if height >= 1.0 else f"; stands out by {least:.2g}"
        distance = float(np.maximum(found.distance, faintness))
        found = found._replace(computed=found.computed + remark, distance=distance)
    return found


def _is_within_the_loads(claim: Claim, evidence) -> bool:
    """Whether a claim on loads can be decided: a load beyond the last one is only known to be larger."""
    if claim.quantity not in ("load", *BETWEEN_CURVES):
        return True
    last = evidence.curves[claim.curves[0]]["load"][-1]
    if claim.quantity == "bend_load_over_mixed_load":
        return bool(np.max([_bend_loads(claim, evidence), _mixed_loads(claim, evidence)]) < last)
    loads = _scalars(claim, evidence)
    beyond = loads >= last
    if claim.along:  # the order of two neighbours beyond the last load is unknown
        return not (beyond[1:] & beyond[:-1]).any()
    if claim.kind == "reach":
        return not beyond.all()
    if claim.published is None or not beyond.any():
        return not beyond.any()
    # a published number is missed if the last load already misses it
    return _against_published(claim, np.minimum(loads, last), "").distance > 1.0


def check_value(claim: Claim, evidence) -> Verdict:
    """One number agrees, or is reached, on all curves, or with ``any_curve`` on one of them."""
    values = compared = _scalars(claim, evidence)
    text = _text_of(claim, evidence, values)
    if claim.kind == "reach":
        beyond = np.maximum if claim.extreme == "minimum" else np.minimum
        compared = beyond(values, claim.published)
    each = [_against_published(claim, value, text) for value in compared]
    pick = np.argmin if claim.any_curve else np.argmax
    chosen = int(pick([found.distance for found in each]))
    return each[chosen]._replace(numbers=tuple(values.tolist()), worst=chosen)


def check_span(claim: Claim, evidence) -> Verdict:
    """Both published numbers occur on a curve; the text has their loads."""
    (curve,) = (evidence.curves[condition] for condition in claim.curves)
    (course,) = _courses(claim, evidence)
    ends = course.min(), course.max()
    order = np.argsort(course)
    newtons = np.interp(claim.published, course[order], curve["normal_load"][order])
    loads = " and ".join(f"{newton:.3g} N" for newton in newtons)
    text = f"{ends[0]:.4g} to {ends[1]:.4g}; nearest to the printed ends at {loads}"
    found = _against_published(claim, np.clip(claim.published, *ends), text)
    return found._replace(numbers=tuple(map(float, ends)))


def check_window(claim: Claim, evidence) -> Verdict:
    """The range of x_a/sigma with a turning point; the worst of several surfaces is used."""
    windows = np.array([evidence.windows[condition.roughness] for condition in claim.curves])
    text = ", ".join(f"{low:.3f} to {high:.3f}" for low, high in windows)
    return _against_published(claim, windows, text)


def check_ordering(claim: Claim, evidence) -> Verdict:
    """Neighbouring curves are nowhere in the opposite order, and somewhere apart."""
    sign = -1.0 if claim.direction == "decreasing" else 1.0
    gaps = [sign * gap for gap in _gaps(claim, evidence)]
    against, apart = -np.min([gap.min() for gap in gaps]), np.min([gap.max() for gap in gaps])
    text = f"against the order by {max(against, 0.0):.3g}, apart by {apart + 0.0:.3g}"
    return _missed(claim, text, np.max([against, 2.0 * claim.step - apart]))


def check_coincidence(claim: Claim, evidence) -> Verdict:
    """Curves overlap with their references."""
    widest = np.max([np.abs(gap).max() for gap in _gaps(claim, evidence)])
    return _missed(claim, f"apart by {widest:.3g} at most", widest)


def check_course(claim: Claim, evidence) -> Verdict:
    """A trend over the load, or from curve to curve; or that there is no interior maximum."""
    along_curves = claim.along == "curves"
    courses = [_scalars(claim, evidence)] if along_curves else _courses(claim, evidence)
    miss = COURSES[claim.direction or claim.kind]
    misses = [miss(_scaled(claim, course), claim.step) for course in courses]
    worst = int(np.argmax(misses))
    course = courses[worst]
    text = f"{course[0]:.4g} to {course[-1]:.4g} within {course.min():.4g} and {course.max():.4g}"
    if along_curves:
        text = _text_of(claim, evidence, course)
    return _missed(claim, text, misses[worst])


def check_sequence(claim: Claim, evidence) -> Verdict:
    """Regimes, modes or both occur in order on all curves, or with ``any_curve`` on one."""
    curves = [evidence.curves[condition] for condition in claim.curves]
    misses = [_sequence_miss(claim, curve) for curve in curves]
    chosen = int(np.argmin(misses) if claim.any_curve else np.argmax(misses))
    return _missed(claim, _passed_states(claim, curves[chosen]), misses[chosen])


CHECKS = {
    "value": check_value,
    "reach": check_value,
    "span": check_span,
    "window": check_window,
    "ordering": check_ordering,
    "coincidence": check_coincidence,
    "trend": check_course,
    "absence": check_course,
    "regime_sequence": check_sequence,
    "mode_sequence": check_sequence,
}


def _against_published(claim, computed, text) -> Verdict:
    """Result of a check of ``computed`` numbers against the published ones."""
    published = np.nan if claim.published is None else np.asarray(claim.published)
    deviation = np.ravel(computed - published)
    distance = np.abs(deviation) / claim.tolerance
    if claim.relative:
        # A ratio of logarithms, 1 at both ends of the tolerance: it keeps growing where a quantity
        # is far too small, so that a calibration has a slope.
        ratio = np.maximum(np.ravel(computed / published), TINY)
        deviation = ratio - 1.0
        low, high = claim.interval(1.0)
        distance = np.log(ratio) / np.log(np.where(ratio < 1.0, low, high))
    worst = int(np.argmax(distance))
    numbers = tuple(np.ravel(computed).tolist())
    return Verdict(text, float(distance[worst]), float(deviation[worst]), numbers, worst)


def _missed(claim, text, miss) -> Verdict:
    """Result of a check that a course or an order is missed by ``miss``."""
    deviation = np.expm1(miss) if claim.relative else miss
    return Verdict(text, float(np.maximum(miss / claim.step, 0.0)), float(deviation))


def _scalars(claim, evidence):
    """The quantity of the claim as one number per curve, or its relative change from the reference."""
    if claim.quantity in BETWEEN:
        return np.array(BETWEEN[claim.quantity](claim, evidence))
    if claim.source == "turning_point":
        pick = TURNING_POINT_QUANTITIES[claim.quantity]
        values = np.array([pick(evidence.turning_points[c]) for c in claim.curves])
        references = [pick(evidence.turning_points[c]) for c in claim.references]
        return values / references - 1.0 if references else values
    if claim.source == "window":
        end = WINDOW_QUANTITIES[claim.quantity]
        return np.array([evidence.windows[c.roughness][end] for c in claim.curves])
    extreme = np.max if claim.extreme == "maximum" else np.min
    return np.array([extreme(course) for course in _courses(claim, evidence)])


def _courses(claim, evidence):
    """The quantity of the claim along each curve, or its relative change from the reference."""
    if not claim.references:
        return [_table(claim, evidence, [condition])[1][0] for condition in claim.curves]
    pairs = zip(claim.references, claim.curves, strict=True)
    tables = [_table(claim, evidence, pair)[1] for pair in pairs]
    return [curve / reference - 1.0 for reference, curve in tables]


def _gaps(claim, evidence):
    """Excess of each curve over its reference, or over the curve before it, scaled as ``step``."""
    pairs = zip(claim.references, claim.curves, strict=True)
    for group in pairs if claim.references else [claim.curves]:
        yield from np.diff(_scaled(claim, _table(claim, evidence, group)[1]), axis=0)


def _pairs(claim, evidence):
    """The reference of each curve, and the curve."""
    for reference, condition in zip(claim.references, claim.curves, strict=True):
        yield evidence.curves[reference], evidence.curves[condition]


def _reversal_load(claim, evidence):
    """Load F_t* [1] above which A_t* increases from curve to curve, in the order of the claim."""
    loads, areas = _table(claim, evidence, claim.curves, "total_contact_area")
    gaps = np.diff(_log(areas), axis=0)
    return [np.max([_first_fall(loads[::-1], gap[::-1]) for gap in gaps])]


def _bend_loads(claim, evidence):
    """Loads F_t* [1] at which the slope of A_t* has fallen by ``BEND`` below that of the reference."""
    slope = "total_contact_area_slope"
    pairs = _pairs(claim, evidence)
    return [
        _first_fall(curve["load"], BEND - (other[slope] - curve[slope])) for other, curve in pairs
    ]


def _mixed_loads(claim, evidence):
    """Loads F_t* [1] at which mixed lubrication begins."""
    curves = [evidence.curves[condition] for condition in claim.curves]
    excess = [_log(curve["solid_load_fraction"] / BOUNDARY_LIMIT) for curve in curves]
    return [_first_fall(curve["load"], each) for curve, each in zip(curves, excess)]


def _departure_sharpness(claim, evidence):
    """Sharpness of the departure of H_c from the reference [1]: the largest change of the slope of their
    ratio on logarithmic axes within a tenth of a decade, over the largest slope; 1 at a kink."""
    found = []
    for dry, wet in _pairs(claim, evidence):
        log_load = np.log(wet["load"])
        slope = np.diff(_log(wet["film_thickness"] / dry["film_thickness"])) / np.diff(log_load)
        middle = 0.5 * (log_load[1:] + log_load[:-1])
        later = np.interp(middle + 0.1 * np.log(10.0), middle, slope)
        found.append(np.max(later - slope) / np.maximum(np.max(slope), TINY))
    return found


# Quantities that compare whole curves: functions of the claim and the evidence.
BETWEEN = {
    "total_contact_area_reversal_load": _reversal_load,
    "bend_load": _bend_loads,
    "bend_load_over_mixed_load": lambda claim, evidence: np.divide(
        _bend_loads(claim, evidence), _mixed_loads(claim, evidence)
    ),
    "departure_sharpness": _departure_sharpness,
}


def _table(claim, evidence, group, quantity=""):
    """Abscissa [points] and quantity [curves, points] of curves, in the range of the claim."""
    curves = [evidence.curves[condition] for condition in group]
    # Bounds of the load apply to a curve, not to its reference.
    x = _loads(claim, curves[-1], curves[bool(claim.references) :])
    if claim.against != "load":
        spans = [curve[claim.against] for curve in curves]
        x = _sample(curves[-1], claim.against, x)
        x = np.clip(x, np.max(np.min(spans, axis=1)), np.min(np.max(spans, axis=1)))
    values = [_sample(curve, quantity or claim.quantity, x, claim.against) for curve in curves]
    return x, np.array(values)


def _loads(claim, grid, bounded):
    """Loads F_t* [1] of a curve, ``grid``: one if the claim gives it or a level, otherwise all
    within its bounds on ``bounded`` curves."""
    limits, load = claim.limits, grid["load"]
    if not limits:
        return load
    if "load" in limits:
        return np.array([limits["load"]])
    for name in limits.keys() & set(CURVE_QUANTITIES):
        return np.array([_first_fall(load, _log(grid[name]) - np.log(limits[name]))])
    heaviest = np.interp(limits.get("load_max_N", np.inf), grid["normal_load"], load)
    low = max(limits.get("load_min", 0.0), load[0])
    high = min(limits.get("load_max", heaviest), load[-1])
    if not low < high:
        raise NotReached(np.log(low / high))
    loads = np.concatenate([[low], load[(load > low) & (load < high)], [high]])
    shortfall = np.full(loads.size, -np.inf)
    for key in limits.keys() & BOUNDS.keys():
        name, sign = BOUNDS[key]
        for curve in bounded:
            shortfall = np.maximum(shortfall, sign * (limits[key] - _sample(curve, name, loads)))
    if shortfall.min() > 0.0:
        raise NotReached(shortfall.min())
    return loads[~(shortfall > 0.0)]


def _first_fall(loads, values):
    """Load at which ``values`` first fall to zero, or the first load if they start below; extrapolated with
    the last slope, over a decade at most, so that nothing jumps when inputs change."""
    above = values > 0.0
    if not above[0]:
        return loads[0] if values[0] <= 0.0 else np.nan
    right = above.size - 1 if above.all() else int(np.argmin(above))
    step = np.log(loads[right] / loads[right - 1])
    fall = np.maximum(values[right - 1] - values[right], TINY)
    advance = np.minimum(values[right - 1] / fall, np.log(10.0) / abs(step))
    return loads[right - 1] * np.exp(advance * step)


def _sample(curve, quantity, x, against="load"):
    """A quantity where ``against`` equals ``x``, interpolated in logarithms; nan if unsolved."""
    if quantity == against:
        return x
    values = curve[quantity]
    if x is curve["load"]:  # no interpolation needed
        return values
    known = np.log(curve[against])
    forward = slice(None, None, 1 if known[0] < known[-1] else -1)
    if (values <= 0.0).any():
        return np.interp(np.log(x), known[forward], values[forward], np.nan, np.nan)
    return np.exp(np.interp(np.log(x), known[forward], np.log(values[forward]), np.nan, np.nan))


def _rise_miss(values, step):
    """The deepest fall within a course, or its shortfall from a total rise of two steps."""
    relapse = np.max(np.maximum.accumulate(values) - values)
    return np.max([relapse, 2.0 * step - (values[-1] - values[0])])


def _peak_height(values):
    """Height of the most prominent interior maximum over the higher of the minima on both sides."""
    left = values - np.minimum.accumulate(values)
    right = values - np.minimum.accumulate(values[::-1])[::-1]
    return np.max(np.minimum(left, right))


def _peak_miss(values, step):
    """Shortfall of a course of ratios from an interior maximum of two steps; without a maximum also its
    distance from turning, by the slope of ln(v/(1 - v)), so that a calibration has a slope."""
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


# Shortfall of a course of values from the named course, from (values, step).
COURSES = {
    "increasing": _rise_miss,
    "decreasing": lambda values, step: _rise_miss(-values, step),
    "increasing_at_each_step": lambda values, step: 2.0 * step - np.min(np.diff(values)),
    "constant": lambda values, step: np.ptp(values),
    "rising_then_falling": _peak_miss,
    "falling_then_rising": lambda values, step: _peak_miss(-values, step),
    "absence": lambda values, step: _peak_height(values),
}


def _sequence_miss(claim, curve):
    """Largest excursion of a curve from the published sequence of states, if its points are assigned to the
    steps in order so that it is minimal.  Each step must have a point that is inside by a tolerance."""
    excursions = np.array([_excursion(curve, step) for step in claim.published])
    if np.isnan(excursions).any():
        return np.nan
    required = excursions[:-1] if claim.open_end else excursions
    unmet = max(np.max(np.min(required, axis=1)) + claim.tolerance, 0.0)
    # the least miss up to a point, if it belongs to each step
    reached = np.append(-np.inf, np.full(len(excursions), np.inf))
    for here in np.maximum(excursions, 0.0).T:
        reached[1:] = np.maximum(np.minimum(reached[1:], reached[:-1]), here)
        reached[0] = np.inf
    return max(reached[-2:].min() if claim.open_end else reached[-1], unmet)


def _excursion(curve, step):
    """Distance of each point outside a step, such as "mixed hybrid or full_film"; negative inside."""
    excursions = []
    for alternative in step.split(" or "):
        outside = []
        for name in alternative.split():
            quantity, low, high = STATES[name]
            outside += [low - curve[quantity], curve[quantity] - high]
        excursions.append(np.max(outside, axis=0))
    return np.min(excursions, axis=0)


def _passed_states(claim, curve):
    """Text of the states along a curve: regimes, modes or both, as in the claim."""
    names = " ".join(claim.published).replace(" or ", " ").split()
    families = {STATES[name][0] for name in names}
    inside = {
        name: (curve[quantity] > low) & (curve[quantity] <= high)
        for name, (quantity, low, high) in STATES.items()
        if quantity in families
    }
    passed = groupby(zip(*(values.tolist() for values in inside.values())))
    states = (" ".join(name for name, there in zip(inside, row) if there) for row, _ in passed)
    return " > ".join(states).strip()


def _scaled(claim, values):
    return _log(values) if claim.relative else values


def _log(values):
    return np.log(np.maximum(values, TINY))


def _text_of(claim, evidence, values):
    """Numbers as text; a load beyond the computed ones is written ``> last`` or ``< first``."""
    texts = [f"{value:.4g}" for value in values]
    if claim.quantity in ("load", "total_contact_area_reversal_load", "bend_load"):
        first, last = evidence.curves[claim.curves[0]]["load"][[0, -1]]
        texts = [f"> {last:.4g}" if v >= last else text for v, text in zip(values, texts)]
        texts = [f"< {first:.4g}" if v <= first else text for v, text in zip(values, texts)]
    return ", ".join(texts)
