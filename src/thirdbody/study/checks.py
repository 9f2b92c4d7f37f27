"""How far a statement of the paper is from holding: one check for each kind of statement.

``judge`` asks the ``Evidence`` for the curves, turning points and windows that a claim speaks of,
measures on them what the claim is about, and expresses the distance from what the paper says in
tolerances of the claim.  A claim holds if this distance is at most 1.

Every check returns ``(measured, value, deviation, low, high)``: what was measured as text and as a
number, how much it deviates, and the least and the greatest distance in tolerances, below 0 where less
is measured than is published; nan where there is nothing to measure.
Kinds of statements are explained at the head of ``config/claims.yaml``.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.model.regimes import BOUNDARY_LIMIT
from thirdbody.study.claims import (
    BEND_LOAD,
    BEND_OVER_MIXED,
    BETWEEN_CURVES,
    BOUNDS,
    CURVE_QUANTITIES,
    REVERSAL_LOAD,
    STATES,
    TURNING_POINT_QUANTITIES,
    WINDOW_QUANTITIES,
    Claim,
    state_names,
)

MISSING_SCORE = 10.0  # the greatest score, given also where there is nothing to measure
# A claim may bound its range of loads by a ratio: this much of it is a line's width in the figures.
BOUND_TOLERANCE = 0.02
BEND = 0.1  # by how much a curve's slope must have fallen for a bend that a reader sees [1]
SATURATED = 1e-12  # nearer to 0 or 1, a ratio has lost the digits that tell its odds
TINY = 1e-300  # least argument of logarithms, so that vanished quantities can be compared
# what a check returns: text, numbers, the place of the worst, its deviation, both ends of the distances
Measured = tuple[str, Iterable[float], int, float, float, float]


@dataclass(frozen=True)
class Curve:
    """A curve over the load: arrays of one shape (loads,).

    Attributes
    ----------
    load : array
        F_t* [1], increasing.
    normal_load : array
        F_t [N].
    total_contact_area : array
        A_t* [1].
    particle_contact_area_ratio : array
        A_sa,t* [1].
    solid_load_fraction, fluid_load_fraction : array
        L_s and L_f [1].
    film_thickness : array
        d/R_x [1], whether there is a film or not.
    separation : array
        d [m].
    solved : array of bool
        Which points have a solution; the values of others are nan.
    """

    load: NDArray[np.float64]
    normal_load: NDArray[np.float64]
    total_contact_area: NDArray[np.float64]
    particle_contact_area_ratio: NDArray[np.float64]
    solid_load_fraction: NDArray[np.float64]
    fluid_load_fraction: NDArray[np.float64]
    film_thickness: NDArray[np.float64]
    separation: NDArray[np.float64]
    solved: NDArray[np.bool_]

    @cached_property
    def solid_load(self) -> NDArray[np.float64]:
        """Dimensionless load that the solids bear, L_s F_t* [1]."""
        return self.solid_load_fraction * self.load

    @cached_property
    def log_load(self) -> NDArray[np.float64]:
        """ln F_t* [1]."""
        return np.log(self.load)

    @cached_property
    def total_contact_area_slope(self) -> NDArray[np.float64]:
        """d ln A_t*/d ln F_t* [1]: the slope of the curve on logarithmic axes."""
        return np.gradient(_log(self.total_contact_area), self.log_load)

    @cached_property
    def _samples(self) -> dict[str, tuple[NDArray[np.float64], bool]]:
        return {}

    def samples(self, quantity: str) -> tuple[NDArray[np.float64], bool]:
        """Values to interpolate between.

        Parameters
        ----------
        quantity : str
            Name of an attribute.

        Returns
        -------
        values : array
            The quantity, or its logarithm if it is positive everywhere; nan at unsolved points.
        logarithmic : bool
            Whether they are logarithms.
        """
        if quantity not in self._samples:
            values = getattr(self, quantity)
            logarithmic = bool((values > 0.0).all())
            values = np.log(values) if logarithmic else values
            self._samples[quantity] = np.where(self.solved, values, np.nan), logarithmic
        return self._samples[quantity]


class TurningPoint(NamedTuple):
    """The interior maximum of A_sa,t* over the load that stands out most on a curve.

    Attributes
    ----------
    load : float
        F_TPCA* [1]; nan, as the other numbers, if there is no interior maximum.
    peak_ratio : float
        A_sa,t* there [1].
    solid_load_fraction : float
        L_s there [1].
    prominence : float
        By how much A_sa,t* stands out there of its least values on both sides [1].
    """

    load: float
    peak_ratio: float
    solid_load_fraction: float
    prominence: float

    @property
    def exists(self) -> bool:
        """Whether it stands out enough for a turning point, by ``PROMINENCE``."""
        return self.prominence >= PROMINENCE


class Evidence(Protocol):
    """What claims are judged on.

    Conditions are those of ``thirdbody.data.conditions.Condition``: nu [m2/s], x_a [m], sigma [m]
    and eta_a [m-2].
    """

    def curve(
        self,
        viscosity: float,
        particle_diameter: float,
        roughness: float,
        particle_density: float,
    ) -> Curve:
        """The curve at these conditions over the whole range of loads."""

    def turning_point(
        self,
        viscosity: float,
        particle_diameter: float,
        roughness: float,
        particle_density: float,
    ) -> TurningPoint:
        """The turning point of that curve, found more closely than its loads are spaced."""

    def window(self, roughness: float) -> tuple[float, float]:
        """Ends of the range of x_a/sigma [1] within which dry curves have a turning point.

        They are curves at ``roughness`` [m] and eta_a = 1e11 m-2.
        """


class Verdict(NamedTuple):
    """What comes of judging a claim.

    Attributes
    ----------
    measured : str
        What was measured, as text.
    numbers : tuple of float
        The numbers that were compared with published ones [unit of the quantity]; none where other
        than numbers are compared.
    worst : int
        Which of them is farthest off.
    deviation : float
        Measured minus published [unit of the quantity], or the relative deviation [1] if the
        claim's tolerance is relative.
    score : float
        Distance from what is published, in tolerances [1].  Beyond 1 it grows with the logarithm
        of the distance only, up to ``MISSING_SCORE``, so that one bad miss does not outweigh
        everything else in a sum.  nan if the paper keeps the value back.
    ends : tuple of float
        The least and the greatest score of the numbers that are compared, below 0 where less is measured
        than is published [1]; ``score`` is the greater of their sizes.  Where other than numbers are
        compared, both are the score.
    tested : bool
        Whether the model comes to the condition that the claim speaks of within its loads.
    holds : bool
        Whether it is tested and the score is at most 1.
    """

    measured: str
    numbers: tuple[float, ...]
    worst: int
    deviation: float
    score: float
    ends: tuple[float, float]
    tested: bool
    holds: bool

    @property
    def value(self) -> float:
        """The number that is farthest off [unit of the quantity]; nan if there are none."""
        return self.numbers[self.worst] if self.numbers else np.nan


class NotReached(Exception):
    """No load of a curve is within the bounds that a claim sets.

    The argument is by how much the nearest load misses them, in the unit of the bound; or the
    logarithm of the ratio of two loads.
    """


def judge(claim: Claim, evidence: Evidence) -> Verdict:
    """Measure what a claim speaks of and compare it with what the paper says.

    Parameters
    ----------
    claim : Claim
        A statement of the paper.
    evidence : Evidence
        Curves, turning points and windows of the model, at least at the conditions of the claim.

    Returns
    -------
    Verdict
        What was measured and whether the claim holds.

    Examples
    --------
    >>> from thirdbody import load_parameters
    >>> from thirdbody.study.claims import referenced_conditions
    >>> from thirdbody.study.evidence import QUICK_EFFORT, SolvedEvidence
    >>> claim = Claim(
    ...     id="fig03a-ratio-zero-without-particles",
    ...     place="Figure 3A, section 3.3",
    ...     statement="Without particles the particle contact ratio is 0 at each load.",
    ...     kind="value",
    ...     role="calibration",
    ...     quantity="particle_contact_area_ratio",
    ...     extreme="maximum",
    ...     conditions={
    ...         "viscosity_cSt": 0,
    ...         "particle_diameter_nm": 0,
    ...         "roughness_nm": 100,
    ...         "particle_density_per_m2": 1e11,
    ...     },
    ...     published=0.0,
    ...     tolerance=0.001,
    ...     relative=False,
    ...     reason="true by definition of the ratio",
    ... )
    >>> asked = referenced_conditions([claim])
    >>> evidence = SolvedEvidence(load_parameters(), asked, (0.04, 80.0), QUICK_EFFORT)
    >>> verdict = judge(claim, evidence)
    >>> verdict.value, verdict.score, bool(verdict.holds)
    (0.0, 0.0, True)
    """
    try:
        measured, numbers, worst, deviation, low, high = CHECKS[claim.kind](claim, evidence)
        tested = _is_within_the_loads(claim, evidence)
    except NotReached as short:
        tested = False
        measured, numbers, worst = f"not reached, by {short.args[0]:.3g}", (), 0
        deviation = np.nan
        low = high = 2.0 + short.args[0] / BOUND_TOLERANCE
    if claim.source == "turning_point":
        curves = claim.curves + claim.references
        prominence = np.min([evidence.turning_point(*curve).prominence for curve in curves])
        if not prominence >= PROMINENCE:
            measured += f"; stands out by {prominence:.2g}"
        high = np.maximum(high, _faintness(prominence))
    ends = (np.nan, np.nan) if claim.is_withheld else (_score(low), _score(high))
    score = max(map(abs, ends))
    holds = bool(tested and score <= 1.0)
    numbers = tuple(map(float, numbers))
    return Verdict(measured, numbers, worst, float(deviation), score, ends, tested, holds)


def _score(distance: float) -> float:
    """Score of a distance in tolerances, with its sign: the distance up to 1, 1 + its logarithm beyond."""
    if np.isnan(distance):
        return MISSING_SCORE
    size = abs(float(distance))
    score = min(min(size, 1.0) + float(np.log(max(size, 1.0))), MISSING_SCORE)
    return float(np.copysign(score, distance))


def _is_within_the_loads(claim: Claim, evidence: Evidence) -> bool:
    """Whether a claim on loads can be decided by those that were computed.

    A load beyond the last one is known to be larger, and no more: a number that is published is
    missed if the last load misses it already, and curves are in no known order if the loads of two
    neighbours lie beyond.
    """
    if claim.quantity not in ("load", *BETWEEN_CURVES):
        return True
    last = evidence.curve(*claim.curves[0]).load[-1]
    if claim.quantity == BEND_OVER_MIXED:
        return bool(np.max([_bend_loads(claim, evidence), _mixed_loads(claim, evidence)]) < last)
    loads = _scalars(claim, evidence)
    beyond = loads >= last
    if claim.along:
        return not (beyond[1:] & beyond[:-1]).any()
    if claim.published is None or not beyond.any():
        return not beyond.any()
    *_, low, high = _against_published(claim, np.minimum(loads, last), "")
    return bool(low < -1.0 or high > 1.0)


def _faintness(prominence: float) -> float:
    """Distance of a turning point from standing out, in tolerances: 1 where it just does.

    It falls to 0 where it stands out twice as much, with no bend: so that a calibration finds its
    way to turning points.
    """
    share = prominence / PROMINENCE
    return max(2.0 - share, 0.0) if share > 1.0 else 1.0 / np.maximum(share, TINY)


# --- one check for each kind of claim ---


def check_value(claim: Claim, evidence: Evidence) -> Measured:
    """Check one number; if several curves are to have it, the one farthest off counts."""
    values = _scalars(claim, evidence)
    return _against_published(claim, values, _shown(claim, evidence, values))


def check_reach(claim: Claim, evidence: Evidence) -> Measured:
    """Check that a number is reached; the curve that stays farthest from it counts."""
    values = _scalars(claim, evidence)
    sign = 1.0 if claim.extreme == "minimum" else -1.0
    lacks = np.maximum(sign * (values - claim.published), 0.0)
    worst = int(np.argmax(lacks))
    distance = lacks[worst] / claim.tolerance
    text = _shown(claim, evidence, values)
    return text, values, worst, sign * lacks[worst], distance, distance


def check_range(claim: Claim, evidence: Evidence) -> Measured:
    """Check the least and the greatest value of the quantity on a curve."""
    (course,) = _courses(claim, evidence)
    ends = np.array([course.min(), course.max()])
    return _against_published(claim, ends, f"{ends[0]:.4g} to {ends[1]:.4g}")


def check_window(claim: Claim, evidence: Evidence) -> Measured:
    """Check the ends of the range of x_a/sigma with a turning point.

    Of several surfaces the one farthest off counts.
    """
    windows = np.array([evidence.window(condition.roughness) for condition in claim.curves])
    text = ", ".join(f"{low:.3f} to {high:.3f}" for low, high in windows)
    return _against_published(claim, windows, text)


def check_ordering(claim: Claim, evidence: Evidence) -> Measured:
    """Check that curves lie one above the other.

    No two neighbours may be in the opposite order anywhere, and they must be apart somewhere.
    """
    sign = -1.0 if claim.direction == "decreasing" else 1.0
    gaps = [sign * gap for gap in _gaps(claim, evidence)]
    against, apart = -np.min([gap.min() for gap in gaps]), np.min([gap.max() for gap in gaps])
    text = f"against the order by {max(against, 0.0):.3g}, apart by {apart + 0.0:.3g}"
    return _missed(claim, text, np.max([against, 2.0 * claim.step - apart]))


def check_coincidence(claim: Claim, evidence: Evidence) -> Measured:
    """Check that curves overlap with their references."""
    widest = np.max([np.abs(gap).max() for gap in _gaps(claim, evidence)])
    return _missed(claim, f"apart by {widest:.3g} at most", widest)


def check_course(claim: Claim, evidence: Evidence) -> Measured:
    """Check a trend over the load, or from curve to curve; or that there is no interior maximum."""
    along_curves = claim.along == "curves"
    courses = [_scalars(claim, evidence)] if along_curves else _courses(claim, evidence)
    miss = COURSES[claim.direction or claim.kind]
    misses = [miss(_scaled(claim, course), claim.step) for course in courses]
    worst = int(np.argmax(misses))
    course = courses[worst]
    text = f"{course[0]:.4g} to {course[-1]:.4g} within {course.min():.4g} and {course.max():.4g}"
    return _missed(claim, _shown(claim, evidence, course) if along_curves else text, misses[worst])


def check_sequence(claim: Claim, evidence: Evidence) -> Measured:
    """Check that regimes, modes or both are passed in the published order as the load grows."""
    curves = [evidence.curve(*condition) for condition in claim.curves]
    misses = [_sequence_miss(claim, curve) for curve in curves]
    worst = int(np.argmax(misses))
    return _missed(claim, _visited(claim, curves[worst]), misses[worst])


CHECKS = {
    "value": check_value,
    "reach": check_reach,
    "range": check_range,
    "window": check_window,
    "ordering": check_ordering,
    "coincidence": check_coincidence,
    "trend": check_course,
    "absence": check_course,
    "regime_sequence": check_sequence,
    "mode_sequence": check_sequence,
}


def _against_published(claim, measured, text) -> Measured:
    """Result of a check whose ``measured`` numbers are to equal the published ones."""
    published = np.nan if claim.published is None else np.asarray(claim.published)
    deviation = measured - published
    distance = deviation / claim.tolerance
    if claim.relative:
        # The distance is a ratio of logarithms, 1 at either end of the tolerance: so it goes on
        # growing where a quantity is far too small, and a calibration can follow its slope.
        ratio = np.maximum(measured / published, TINY)
        deviation = ratio - 1.0
        width = np.log1p(np.copysign(claim.tolerance, deviation))
        distance = np.copysign(np.log(ratio) / width, deviation)
    worst = int(np.argmax(np.abs(distance)))
    ends = np.min(distance), np.max(distance)
    return text, measured.flat, worst, deviation.flat[worst], *ends


def _missed(claim, text, miss) -> Measured:
    """Result of a check that found by how much a course or an order is missed."""
    deviation = np.expm1(miss) if claim.relative else miss
    distance = np.maximum(miss / claim.step, 0.0)
    return text, (), 0, deviation, distance, distance


# --- measuring ---


def _scalars(claim, evidence):
    """The claim's quantity as one number for each curve.

    If the claim has a reference, it is the relative change from that.
    """
    if claim.quantity == REVERSAL_LOAD:
        return np.array([_reversal_load(claim, evidence)])
    if claim.quantity == BEND_LOAD:
        return _bend_loads(claim, evidence)
    if claim.quantity == BEND_OVER_MIXED:
        return _bend_loads(claim, evidence) / _mixed_loads(claim, evidence)
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
    """The claim's quantity along each curve.

    If the claim has a reference, it is the relative change from that.
    """
    if not claim.references:
        return [_table(claim, evidence, [condition])[1][0] for condition in claim.curves]
    pairs = zip(claim.references, claim.curves, strict=True)
    tables = [_table(claim, evidence, pair)[1] for pair in pairs]
    return [curve / reference - 1.0 for reference, curve in tables]


def _gaps(claim, evidence):
    """By how much each curve is above its reference, or above the curve before it.

    Differences are logarithmic if the tolerance is relative, as ``claim.step`` is.
    """
    pairs = zip(claim.references, claim.curves, strict=True)
    for group in pairs if claim.references else [claim.curves]:
        yield from np.diff(_scaled(claim, _table(claim, evidence, group)[1]), axis=0)


def _reversal_load(claim, evidence):
    """Load F_t* [1] above which A_t* increases from curve to curve, in the order of the claim."""
    loads, areas = _table(claim, evidence, claim.curves, "total_contact_area")
    gaps = np.diff(_log(areas), axis=0)
    return np.max([_first_fall(loads[::-1], gap[::-1]) for gap in gaps])


def _bend_loads(claim, evidence):
    """Loads F_t* [1] at which the slope of A_t* has fallen by ``BEND`` below the reference's."""
    pairs = [
        (evidence.curve(*reference), evidence.curve(*condition))
        for reference, condition in zip(claim.references, claim.curves, strict=True)
    ]
    drops = [
        reference.total_contact_area_slope - curve.total_contact_area_slope
        for reference, curve in pairs
    ]
    return np.array(
        [_first_fall(curve.load, BEND - drop) for (_, curve), drop in zip(pairs, drops)]
    )


def _mixed_loads(claim, evidence):
    """Loads F_t* [1] at which mixed lubrication begins."""
    curves = [evidence.curve(*condition) for condition in claim.curves]
    excess = [_log(curve.solid_load_fraction / BOUNDARY_LIMIT) for curve in curves]
    return np.array([_first_fall(curve.load, each) for curve, each in zip(curves, excess)])


def _table(claim, evidence, group, quantity=""):
    """Abscissa [points] and quantity [curves, points] of curves, where the claim speaks of them."""
    curves = [evidence.curve(*condition) for condition in group]
    # Bounds of the load hold on a curve itself, not on the reference that it is compared with.
    x = _loads(claim, curves, curves[bool(claim.references) :])
    if claim.against != "load":
        spans = [getattr(curve, claim.against) for curve in curves]
        x = _sample(curves[-1], claim.against, x)
        x = np.clip(x, np.max(np.min(spans, axis=1)), np.min(np.max(spans, axis=1)))
    values = [_sample(curve, quantity or claim.quantity, x, claim.against) for curve in curves]
    return x, np.array(values)


def _loads(claim, curves, bounded):
    """Loads F_t* [1] that the claim speaks of.

    There is one load if the claim names it, or the level of a quantity that is reached there; else
    they are all loads within the claim's bounds on the curves ``bounded``.
    """
    limits, grid = claim.limits, curves[-1]
    if not limits and all(curve.load is grid.load for curve in curves):
        return grid.load
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
    """Load at which ``values`` first fall to zero.

    If they are not above zero at the start, it is the first load.  If they never fall to zero, they
    are continued beyond the last load by their last slope, for a decade at most: so the result
    does not jump when inputs change.
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
    """Values of a quantity of a curve where the quantity ``against`` has the values ``x``.

    Interpolated linearly in logarithms; nan beside unsolved points.
    """
    if quantity == against:
        return x
    if x is curve.load:  # nothing lies between
        return np.where(curve.solved, getattr(curve, quantity), np.nan)
    known = curve.log_load if against == "load" else np.log(getattr(curve, against))
    forward = slice(None, None, 1 if known[0] < known[-1] else -1)
    values, logarithmic = curve.samples(quantity)
    found = np.interp(np.log(x), known[forward], values[forward], np.nan, np.nan)
    return np.exp(found) if logarithmic else found


def _rise_miss(values, step):
    """By how much ``values`` miss a rise.

    That is the deepest fall within the course, or what it lacks to rise by two steps in all.
    """
    relapse = np.max(np.maximum.accumulate(values) - values)
    return np.max([relapse, 2.0 * step - (values[-1] - values[0])])


def _peak_height(values):
    """Height of the most prominent interior maximum.

    It is taken above the lowest values on the two sides, of which the higher one counts.
    """
    left = values - np.minimum.accumulate(values)
    right = values - np.minimum.accumulate(values[::-1])[::-1]
    return np.max(np.minimum(left, right))


def _peak_miss(values, step):
    """By how much a course of ratios misses an interior maximum of two steps.

    Where there is no maximum at all, its height gives a calibration no slope to follow.  Therefore
    the miss also counts how far the course is from turning, by the slope of ln(v/(1 - v)), which
    unlike v itself goes on changing near 0 and 1: a course turns where the slope falls from above
    to below zero.  If too few values are distinct from 0 and 1, the miss is the greatest.
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


# By how much a course of values misses what its name says, from (values, step).
COURSES = {
    "increasing": _rise_miss,
    "decreasing": lambda values, step: _rise_miss(-values, step),
    "constant": lambda values, step: np.ptp(values),
    "rising_then_falling": _peak_miss,
    "falling_then_rising": lambda values, step: _peak_miss(-values, step),
    "absence": lambda values, step: _peak_height(values),
}


def _sequence_miss(claim, curve):
    """How far a curve leaves the published states, passed in turn.

    The points of the curve are given to the steps in turn, each step at least one point; the miss
    is the largest excursion of a point from its step, and the division with the least miss counts.
    """
    excursions = np.array([_excursion(curve, step) for step in claim.published])
    if np.isnan(excursions).any():
        return np.nan
    enter, reached = -np.inf, [np.inf] * len(excursions)
    # reached[step]: least miss so far if the point before belongs to this step.  Plain numbers are
    # quicker here than arrays, as there are few steps.
    for point in excursions.T.tolist():
        come = enter
        for step, here in enumerate(point):
            stay = reached[step]
            best = stay if stay < come else come
            come, reached[step] = stay, here if here > best else best
        enter = np.inf
    return min(reached[-2:]) if claim.open_end else reached[-1]


def _excursion(curve, step):
    """How far each point is outside a step.

    A step names alternatives ("mixed hybrid or full_film"), each a regime, a mode or both.
    """
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
    """Text of the states that a curve passes: regimes, modes or both, as the claim names them."""
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
    """Numbers as text; a load beyond those computed is shown as ``> last`` or ``< first``."""
    texts = [f"{value:.4g}" for value in values]
    if claim.quantity in ("load", REVERSAL_LOAD, BEND_LOAD):
        first, last = evidence.curve(*claim.curves[0]).load[[0, -1]]
        texts = [f"> {last:.4g}" if v >= last else text for v, text in zip(values, texts)]
        texts = [f"< {first:.4g}" if v <= first else text for v, text in zip(values, texts)]
    return ", ".join(texts)
