"""One statement of the paper, called a *claim*, and its verdict: what all kinds of claims have in
common.

A claim has conditions, the statement of the paper on them, and a tolerance.  It is checked on
curves solved by ``chenhorng.claims.evidence``, and holds if it is off by at most one tolerance.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import ConfigDict
from pydantic.dataclasses import dataclass

from chenhorng.claims.fields import Conditions, checked
from chenhorng.configuration.model import one_of
from chenhorng.places import figures_named
from chenhorng.sampling import (
    TINY,
    NotReached,
    SolvedCurve,
    loads_within,
    logarithm,
    sample,
)
from thirdbody.curves import Condition
from thirdbody.variables import CONDITION_AXES

if TYPE_CHECKING:
    from chenhorng.claims.evidence import Evidence

MISSING_SCORE = 10.0  # the largest score, also used if there is nothing to compare
# Loads may miss the bound of a claim by this before its score grows: a line width.
BOUND_TOLERANCE = 0.02
TURNING_POINT_QUANTITIES = {
    "turning_point_load": lambda point: point.load,
    "turning_point_ratio": lambda point: point.peak_ratio,
    "turning_point_solid_load_fraction": lambda point: point.solid_load_fraction,
    "turning_point_solid_load": lambda point: point.solid_load_fraction * point.load,
}
WINDOW_QUANTITIES = {"window_low": 0, "window_high": 1}
TOLERANCES = {  # what each kind is between
    "absolute": (0.0, np.inf),
    "relative": (0.0, 1.0),
    "factor": (1.0, np.inf),
}
CONDITION_KEYS = tuple(axis.alias for axis in CONDITION_AXES)  # they distinguish curves


class Verdict(NamedTuple):
    """Result of checking a claim: the result of the model as text, its distance from the published
    value in tolerances [1], and the largest deviation, computed minus published, relative [1] if
    the tolerance is.

    ``numbers`` are those compared [unit of the quantity], ``worst`` the index of that with the
    deviation. A claim is ``tested`` if the model reaches its condition within the loads.
    ``finding`` is a sentence.
    """

    computed: str
    distance: float
    deviation: float
    numbers: tuple[float, ...] = ()
    worst: int = 0
    tested: bool = True
    finding: str = ""

    @property
    def score(self) -> float:
        """The distance, 1 + its logarithm beyond 1, and at most ``MISSING_SCORE``, so that one
        large miss does not outweigh the rest."""
        if np.isnan(self.distance):
            return MISSING_SCORE
        growth = float(np.log(max(self.distance, 1.0)))
        return min(min(self.distance, 1.0) + growth, MISSING_SCORE)

    @property
    def holds(self) -> bool:
        """Whether the claim is tested and met within its tolerance."""
        return self.tested and self.score <= 1.0

    @property
    def value(self) -> float:
        """The number with the largest deviation [unit of the quantity]; nan if there are none."""
        return self.numbers[self.worst] if self.numbers else np.nan


CLOSED = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


@dataclass(frozen=True, kw_only=True, config=CLOSED)
class Claim:
    """What every entry of ``config/claims.yaml`` has; the subclasses in ``kinds`` add the rest.

    Attributes
    ----------
    id, place, statement, quote : str
        A name; where the paper says it, with figure and panel; our words; and the words of the
        paper.
    kind : str
        A key of ``chenhorng.claims.kinds.KINDS``.
    conditions : mapping
        Conditions in engineering units, such as ``viscosity_cSt``; lists give the curves, element
        by element.  Particles are 1e11 per m2 if the paper names no density.  ``load`` is a single
        F_t*; a quantity, such as ``solid_load_fraction``, names the load at which it falls to a
        level.  ``load_min``, ``load_max``, ``load_max_N`` and ``QUANTITY_min``, ``QUANTITY_max``
        bound the loads, which otherwise are those of Table 2, 0.04 to 80 N.  A level not reached
        within the loads is extrapolated with the last slope, and reported as > the last load.  If
        the verdict depends on this, or if no load is within the bounds, the statement is not
        tested.
    tolerance, tolerance_kind, reason : float, str, str
        In the file ``tolerance: {absolute: ..., reason: ...}``: in the unit of the quantity if
        "absolute", a fraction of it [1] if "relative", and a factor on both sides [1] if "factor";
        and the reason for it.
    must_be_reached : bool
        Whether it fails, instead of being not tested, if no load meets its conditions, because the
        paper draws them.
    figures : sequence of int
        Of a conclusion or the abstract: the figures that it repeats; of a statement of another
        paper, those that say the same.  A statement is left out of a search together with all
        others of its figures (cross-validation, see ``config/calibration.yaml``).
    contradicts : sequence of str
        Statements in which the paper says the opposite; of each such pair at least one has
        ``aside``.
    limit : str
        What no inputs can meet: how near algebra on the numbers of the paper lets the model come.
    aside : str
        Why the other one of a pair is used: it is left out of all counts and of the calibration,
        and is listed.
    cluster : str
        Common name of repeated statements: they count once, as held if all tested ones hold, and
        share a weight in the objective of the calibration.
    quantity : str
        A variable of the datasets; ``solid_load``, L_s F_t*; ``total_contact_area_slope``, d ln
        A_t*/d ln F_t*; ``turning_point_load``, F_TPCA*, and ``turning_point_ratio``,
        ``_solid_load_fraction``, ``_solid_load`` at that load; ``bend_load``, at which the slope
        has fallen 0.1 below that of the reference, and ``bend_load_over_mixed_load``, the same over
        the load at which L_s falls to 0.9; ``total_contact_area_reversal_load``, above which A_t*
        rises from curve to curve in the order listed; ``departure_sharpness``, the greatest change
        of the slope of ln(H_c/H_c of the reference) over ln F_t* within a tenth of a decade, over
        the greatest slope: 1 at a kink.
    reference : mapping
        Conditions that differ on the reference curve; a value or trend is then the relative change
        from it.
    extreme : str
        ``minimum`` or ``maximum`` over the load.
    against : str
        Abscissa of the comparison.

    A turning point is visible if the maximum of A_sa,t* has a prominence of 0.02, a line
    width on an axis from 0 to 1.
    """

    id: str
    place: str
    statement: str
    quote: str
    kind: str
    conditions: Annotated[Mapping[str, Any], checked(Conditions)]
    tolerance: float
    tolerance_kind: Annotated[str, one_of(*TOLERANCES)]
    reason: str
    must_be_reached: bool = False
    figures: Sequence[int] = ()
    contradicts: Sequence[str] = ()
    limit: str = ""
    aside: str = ""
    cluster: str = ""

    # fields of some kinds: what the other kinds have in their place; annotations would make them
    # fields of all. A kind that must have one says so by field(), or this would be its default.
    quantity = direction = along = extreme = ""
    against = "load"
    published = None  # type: Any
    any_curve = open_end = False
    reference = {}  # type: Mapping[str, float]

    def __post_init__(self) -> None:
        low, high = TOLERANCES[self.tolerance_kind]
        if not low < self.tolerance < high:
            raise ValueError(
                f"the {self.tolerance_kind} tolerance is {self.tolerance:g}; allowed: between "
                f"{low:g} and {high:g}"
            )
        # a window is that of a surface, all else is that of a curve
        required = ("roughness_nm",) if self.source == "window" else CONDITION_KEYS
        if missing := [key for key in required if key not in self.conditions]:
            raise ValueError(f"conditions have no {missing[0]}; allowed: {', '.join(required)}")
        if self.aside and not self.contradicts:
            raise ValueError(
                "aside without contradicts; allowed: the statements that it contradicts"
            )

    def check(self, evidence: "Evidence") -> Verdict:
        """Compare the model with the statement, whether or not it is tested."""
        raise NotImplementedError

    def is_tested(self, evidence: "Evidence") -> bool:
        """Whether the statement, once checked, is decided within the loads."""
        return True

    def verdict(self, evidence: "Evidence") -> Verdict:
        """Compare the model with the statement; ``evidence`` must have its curves."""
        try:
            found = self.check(evidence)._replace(tested=self.is_tested(evidence))
        except NotReached as short:
            (lack,) = short.args
            text, distance = f"not reached, by {lack:.3g}", 2.0 + lack / BOUND_TOLERANCE
            condition = (
                "the condition, which the paper draws" if self.must_be_reached else "the condition"
            )
            found = Verdict(
                computed=text,
                distance=distance,
                deviation=np.nan,
                tested=self.must_be_reached,
                finding=(
                    f"No load of the paper meets {condition}; the nearest misses it by {lack:.3g}."
                ),
            )
        return self._if_visible(found, evidence) if self.source == "turning_point" else found

    def _if_visible(self, found, evidence):
        """The verdict on turning points, which fails where they do not stand out."""
        # of any curve, the one that agrees best must have a turning point
        curves = [self.curves[found.worst]] if self.any_curve else self.curves
        every = (evidence.turning_points[each] for each in (*curves, *self.references))
        least = np.min([point.prominence for point in every])
        height = least / evidence.effort.window.prominence
        # smooth: 1 where it is just visible, 0 from twice that height on
        faintness = max(2.0 - height, 0.0) if height > 1.0 else 1.0 / np.maximum(height, TINY)
        distance = float(np.maximum(found.distance, faintness))
        if height < 1.0:
            found = found._replace(
                computed=f"{found.computed}; stands out by {least:.2g}",
                finding=f"{found.finding} One maximum of A_sa,t* stands out by {least:.2g} only.",
            )
        return found._replace(distance=distance)

    @cached_property
    def curves(self) -> tuple[Condition, ...]:
        """Conditions of the compared curves, SI: lists are combined element by element."""
        given = [np.atleast_1d(self.conditions.get(key, np.nan)) for key in CONDITION_KEYS]
        rows = zip(*np.broadcast_arrays(*given), strict=True)
        return tuple(Condition.of(dict(zip(CONDITION_KEYS, row, strict=True))) for row in rows)

    @cached_property
    def references(self) -> tuple[Condition, ...]:
        """Conditions of the reference of each curve, SI; empty without reference."""
        changes = {
            axis.name: float(axis.to_si(self.reference[axis.alias]))
            for axis in CONDITION_AXES
            if axis.alias in self.reference
        }
        return tuple(condition._replace(**changes) for condition in self.curves if changes)

    @cached_property
    def all_figures(self) -> frozenset[int]:
        """Numbers of the figures in its place, and of those it repeats."""
        return figures_named(self.place).union(self.figures)

    @cached_property
    def limits(self) -> dict[str, float]:
        """The conditions that bound or give the loads, by key."""
        return {key: each for key, each in self.conditions.items() if key not in CONDITION_KEYS}

    @property
    def curves_text(self) -> str:
        """The curves, the bounds of the loads, and the reference as text."""
        loads = [f"{key} = {value:g}" for key, value in self.limits.items()]
        text = "; ".join([*_condition_texts(self.conditions), *loads])
        against = ", ".join(_condition_texts(self.reference))
        return f"{text}; held against {against}" if against else text

    @property
    def published_text(self) -> str:
        """The published value as text; empty if it is neither numbers nor a sequence of states."""
        return "" if self.published is None else ", ".join(map(str, np.atleast_1d(self.published)))

    @property
    def printed_numbers(self) -> Sequence[tuple[str, str, float]]:
        """Extreme, quantity and value of each printed number that is a point of a figure."""
        return ()

    @property
    def counted_as(self) -> str:
        """The name under which it is counted: its cluster, or its id."""
        return self.cluster or self.id

    @property
    def source(self) -> str:
        """The part of ``chenhorng.claims.evidence.Evidence`` that the claim uses."""
        if self.quantity in WINDOW_QUANTITIES:
            return "window"
        return "turning_point" if self.quantity in TURNING_POINT_QUANTITIES else "curve"

    @property
    def relative(self) -> bool:
        """Whether logarithms are compared."""
        return self.tolerance_kind != "absolute"

    @property
    def step(self) -> float:
        """The tolerance [unit of the quantity]; the logarithm of its upper end [1] if logarithms
        are compared.
        """
        return float(np.log(self.interval(1.0)[1])) if self.relative else self.tolerance

    def interval(self, value: float) -> tuple[float, float]:
        """Both ends of the tolerance about a published ``value`` [unit of the quantity]."""
        if self.tolerance_kind == "factor":
            return value / self.tolerance, value * self.tolerance
        margin = abs(value) * self.tolerance if self.relative else self.tolerance
        return value - margin, value + margin

    def table(
        self, evidence: "Evidence", group: Sequence[Condition], quantity: str
    ) -> tuple[NDArray, NDArray]:
        """Abscissa [points] and quantity [curves, points] of curves, in the range of the claim."""
        curves = [evidence.curves[condition] for condition in group]
        # Bounds of the load apply to a curve, not to its reference.
        x = loads_within(self.limits, curves[-1], curves[bool(self.references) :])
        if self.against != "load":
            spans = [curve[self.against] for curve in curves]
            x = sample(curves[-1], self.against, x)
            x = np.clip(x, np.max(np.min(spans, axis=1)), np.min(np.max(spans, axis=1)))
        values = [sample(curve, quantity, x, self.against) for curve in curves]
        return x, np.array(values)

    def pairs(self, evidence: "Evidence") -> Iterator[tuple[SolvedCurve, SolvedCurve]]:
        """The reference of each curve, and the curve."""
        for reference, condition in zip(self.references, self.curves, strict=True):
            yield evidence.curves[reference], evidence.curves[condition]

    def courses(self, evidence: "Evidence") -> list[NDArray]:
        """The quantity along each curve, or its relative change from the reference."""
        if not self.references:
            return [self.table(evidence, [each], self.quantity)[1][0] for each in self.curves]
        pairs = zip(self.references, self.curves, strict=True)
        tables = [self.table(evidence, pair, self.quantity)[1] for pair in pairs]
        return [curve / reference - 1.0 for reference, curve in tables]

    def gaps(self, evidence: "Evidence") -> Iterator[NDArray]:
        """Excess of each curve over its reference, or over the curve before it, scaled as
        ``step``."""
        pairs = zip(self.references, self.curves, strict=True)
        for group in pairs if self.references else [self.curves]:
            yield from np.diff(self.scaled(self.table(evidence, group, self.quantity)[1]), axis=0)

    def scaled(self, values: NDArray) -> NDArray:
        """Values as they are compared: their logarithms if the tolerance is relative."""
        return logarithm(values) if self.relative else values

    def against_published(self, computed: ArrayLike, text: str, finding: str = "") -> Verdict:
        """The verdict on ``computed`` numbers against the published ones."""
        published = np.asarray(self.published)
        deviation = np.ravel(computed - published)
        distance = np.abs(deviation) / self.tolerance
        if self.relative:
            # A ratio of logarithms, 1 at both ends of the tolerance: it keeps growing where a
            # quantity is far too small, so that a calibration has a slope.
            ratio = np.maximum(np.ravel(computed / published), TINY)
            deviation = ratio - 1.0
            low, high = self.interval(1.0)
            distance = np.log(ratio) / np.log(np.where(ratio < 1.0, low, high))
        worst = int(np.argmax(distance))
        numbers = tuple(np.ravel(computed).tolist())
        return Verdict(
            computed=text,
            distance=float(distance[worst]),
            deviation=float(deviation[worst]),
            numbers=numbers,
            worst=worst,
            finding=finding,
        )

    def missed(self, text: str, miss: float, finding: str = "") -> Verdict:
        """The verdict if a course or an order is missed by ``miss``, scaled as ``step``."""
        return Verdict(
            computed=text,
            distance=float(np.maximum(miss / self.step, 0.0)),
            deviation=float(np.expm1(miss) if self.relative else miss),
            finding=finding,
        )


def _condition_texts(conditions: Mapping[str, Any]) -> list[str]:
    """The ``conditions`` that distinguish curves, as text: ``nu = 0, 90 cSt``."""
    return [
        f"{axis.symbol} = {', '.join(f'{value:g}' for value in np.atleast_1d(given))} "
        f"{axis.alias_unit}"
        for axis in CONDITION_AXES
        if (given := conditions.get(axis.alias)) is not None
    ]
