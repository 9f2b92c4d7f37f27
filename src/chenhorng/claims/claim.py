"""What all kinds of claims have in common.  A *claim* is one statement of the paper.

A claim has conditions, the statement of the paper on them, and a tolerance.
``chenhorng.claims.evidence`` solves the curves on which the claim is checked.  A claim holds if the
model misses the statement by at most one tolerance.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import ConfigDict
from pydantic.dataclasses import dataclass

from chenhorng.claims.fields import Conditions, checked
from chenhorng.claims.words import bound
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
from thirdbody.plotting.scales import note
from thirdbody.variables import CONDITION_AXES

if TYPE_CHECKING:
    from chenhorng.claims.evidence import Evidence

MISSING_SCORE = 10.0  # the largest score, and that of a claim without a number to compare
# Loads may miss the bound of a claim by this before its score grows: a line width.
BOUND_TOLERANCE = 0.02
TURNING_POINT_QUANTITIES = {
    "turning_point_load": lambda point: point.load,
    "turning_point_ratio": lambda point: point.peak_ratio,
    "turning_point_solid_load_fraction": lambda point: point.solid_load_fraction,
    "turning_point_solid_load": lambda point: point.solid_load_fraction * point.load,
}
WINDOW_QUANTITIES = {"window_low": 0, "window_high": 1}
TOLERANCES = {  # the smallest and the largest tolerance of each kind, both excluded
    "absolute": (0.0, np.inf),
    "relative": (0.0, 1.0),
    "factor": (1.0, np.inf),
}
CONDITION_KEYS = tuple(axis.alias for axis in CONDITION_AXES)  # the keys that distinguish curves


class Verdict(NamedTuple):
    """Result of checking a claim.

    ``computed`` is the result of the model as text.  ``distance`` is its distance from the
    published value in tolerances [1].  ``deviation`` is the largest difference, computed minus
    published; it is relative [1] if the tolerance is relative.  ``numbers`` are the compared
    numbers [unit of the quantity], and ``worst`` is the index of the number with the largest
    deviation.  A claim is ``tested`` if the model reaches its condition within the loads.
    ``finding`` states the result as a sentence.
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
        """The score [1]: the distance up to 1, then 1 plus the logarithm of the distance, and at
        most ``MISSING_SCORE``.  So one large miss does not outweigh the other claims."""
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
        """The number with the largest deviation [unit of the quantity]; nan without numbers."""
        return self.numbers[self.worst] if self.numbers else np.nan


CLOSED = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False)


@dataclass(frozen=True, kw_only=True, config=CLOSED)
class Claim:
    """The fields of every entry of ``config/claims.yaml``; the subclasses in ``kinds`` add others.

    Attributes
    ----------
    id, place, statement, quote : str
        The name of the claim; its place in the paper, with figure and panel; the statement in our
        words; and the words of the paper.
    kind : str
        A key of ``chenhorng.claims.kinds.KINDS``.
    conditions : mapping
        Conditions in engineering units, such as ``viscosity_cSt``.  A list has one value for each
        curve.  Particles are 1e11 per m2 if the paper names no density.  ``load`` is a single F_t*.
        A quantity, such as ``solid_load_fraction``, names the load at which it falls to a level.
        ``load_min``, ``load_max``, ``load_max_N`` and ``QUANTITY_min``, ``QUANTITY_max`` bound the
        loads; without bounds the loads are those of Table 2, 0.04 to 80 N.  If a curve does not
        reach the level within the loads, its last slope is extrapolated, and the load is reported
        as > the last load.  The statement is not tested if its verdict depends on the extrapolation
        or if no load is within the bounds.
    tolerance, tolerance_kind, reason : float, str, str
        In the file ``tolerance: {absolute: ..., reason: ...}``.  An "absolute" tolerance has the
        unit of the quantity, a "relative" one is a fraction of the published value [1], and a
        "factor" multiplies and divides the published value [1].  ``reason`` says why the tolerance
        has this size.
    must_be_reached : bool
        Whether the claim fails, instead of being not tested, if no load meets its conditions: the
        paper draws such loads.
    figures : sequence of int
        The figures that a statement of the conclusion or the abstract repeats; of a statement of
        another paper, those that say the same.  The cross-validation leaves out all statements of
        a figure together (see ``config/calibration.yaml``).
    contradicts : sequence of str
        Statements in which the paper says the opposite.  At least one statement of each such pair
        has ``aside``.
    limit : str
        The part of the statement that no inputs can meet: how near algebra on the numbers of the
        paper lets the model come.
    aside : str
        Why the claim is set aside for the statement that it contradicts.  It is listed, but left
        out of all counts and of the calibration.
    cluster : str
        Common name of repeated statements.  They count once, as held if all tested statements among
        them hold.  In the objective of the calibration they share one weight.
    stands_for : str
        The words of the paper that the published number stands for, if the paper prints no number.
    by_definition : str
        Why it holds under any inputs: such statements are told apart beside the score.
    impossible : str
        Why no inputs can meet it.  It is judged and counted, and no search is fitted to it.
    quantity : str
        A variable of the datasets, or one of the following.  ``solid_load`` is L_s F_t*.
        ``total_contact_area_slope`` is d ln A_t*/d ln F_t*.  ``turning_point_load`` is F_TPCA*;
        ``turning_point_ratio``, ``_solid_load_fraction`` and ``_solid_load`` are values at that
        load.  ``bend_load`` is the load at which the slope of A_t* has fallen 0.1 below the slope
        of the reference; ``bend_load_over_mixed_load`` divides it by the load at which L_s falls to
        0.9.  Above ``total_contact_area_reversal_load``, A_t* rises from curve to curve in the
        order listed.  ``departure_sharpness`` is the greatest change of the slope of ln(H_c/H_c of
        the reference) over ln F_t* within a tenth of a decade, divided by the greatest slope: 1 at
        a kink.
    reference : mapping
        Conditions that differ on the reference curve.  A value or trend with a reference is the
        relative change from the reference.
    extreme : str
        ``minimum`` or ``maximum`` of the quantity over the load.
    against : str
        Abscissa on which curves are compared.

    A turning point is visible if the maximum of A_sa,t* has a prominence of 0.02.  That is the
    width of a line on an axis from 0 to 1.
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
    stands_for: str = ""
    by_definition: str = ""
    impossible: str = ""

    # The values of the optional fields for the kinds that lack them.  Annotations would make them
    # fields of all kinds.  A kind that requires such a field declares it by Field(); otherwise
    # the value below would be its default.
    quantity = direction = along = extreme = ""
    against = "load"
    published = None  # type: Any
    any_curve = open_end = False
    reference = {}  # type: Mapping[str, float]

    def __post_init__(self) -> None:
        low, high = TOLERANCES[self.tolerance_kind]
        if not low < self.tolerance < high:
            raise ValueError(
                f"the {self.tolerance_kind} tolerance is {self.tolerance:g}; "
                f"allowed: between {low:g} and {high:g}"
            )
        # a window belongs to a surface, every other number to a curve
        required = ("roughness_nm",) if self.source == "window" else CONDITION_KEYS
        if missing := [key for key in required if key not in self.conditions]:
            raise ValueError(f"conditions have no {missing[0]}; allowed: {', '.join(required)}")
        if self.aside and not self.contradicts:
            raise ValueError(
                "aside without contradicts; allowed: the statements that it contradicts"
            )

    def check(self, evidence: "Evidence") -> Verdict:
        """Compare the model with the statement, whether or not the statement is tested."""
        raise NotImplementedError

    def is_tested(self, evidence: "Evidence") -> bool:
        """Whether the computed loads decide the statement; called after ``check``."""
        return True

    def verdict(self, evidence: "Evidence") -> Verdict:
        """Compare the model with the statement; ``evidence`` must have the curves of the claim."""
        try:
            verdict = self.check(evidence)._replace(tested=self.is_tested(evidence))
        except NotReached as short:
            (lack,) = short.args
            text, distance = f"not reached, by {lack:.3g}", 2.0 + lack / BOUND_TOLERANCE
            asked = " and ".join(bound(*limit) for limit in self.limits.items())
            drawn = ", though the paper draws one" if self.must_be_reached else ""
            verdict = Verdict(
                computed=text,
                distance=distance,
                deviation=np.nan,
                tested=self.must_be_reached,
                finding=(
                    f"No load of the paper has {asked}{drawn}; "
                    f"the nearest misses this by {lack:.3g}."
                ),
            )
        return self._if_visible(verdict, evidence) if self.source == "turning_point" else verdict

    def _if_visible(self, verdict, evidence):
        """The verdict on turning points, which fails if a turning point does not stand out."""
        # with any_curve, only the curve that agrees best needs a turning point
        curves = [self.curves[verdict.worst]] if self.any_curve else self.curves
        points = (evidence.turning_points[curve] for curve in (*curves, *self.references))
        least = np.min([point.prominence for point in points])
        height = least / evidence.effort.window.prominence
        # the faintness is 1 for a maximum that is just visible, and 0 from twice its height on
        faintness = max(2.0 - height, 0.0) if height > 1.0 else 1.0 / np.maximum(height, TINY)
        distance = float(np.maximum(verdict.distance, faintness))
        if height < 1.0:
            verdict = verdict._replace(
                computed=f"{verdict.computed}; stands out by {least:.2g}",
                finding=f"{verdict.finding} One maximum of A_sa,t* stands out by {least:.2g} only.",
            )
        return verdict._replace(distance=distance)

    @cached_property
    def curves(self) -> tuple[Condition, ...]:
        """Conditions of the compared curves, SI: a list has one value for each curve."""
        columns = [np.atleast_1d(self.conditions.get(key, np.nan)) for key in CONDITION_KEYS]
        rows = zip(*np.broadcast_arrays(*columns), strict=True)
        return tuple(Condition.of(dict(zip(CONDITION_KEYS, row, strict=True))) for row in rows)

    @cached_property
    def references(self) -> tuple[Condition, ...]:
        """Conditions of the reference of each curve, SI; empty without a reference."""
        changes = {
            axis.name: float(axis.to_si(self.reference[axis.alias]))
            for axis in CONDITION_AXES
            if axis.alias in self.reference
        }
        return tuple(condition._replace(**changes) for condition in self.curves if changes)

    @cached_property
    def all_figures(self) -> frozenset[int]:
        """Numbers of the figures that ``place`` names, and of the figures that the claim
        repeats."""
        return figures_named(self.place).union(self.figures)

    @cached_property
    def limits(self) -> dict[str, float]:
        """The conditions on the loads, by key: loads, levels and bounds."""
        return {key: value for key, value in self.conditions.items() if key not in CONDITION_KEYS}

    @property
    def curves_text(self) -> str:
        """The curves, the bounds of the loads, and the reference as text."""
        loads = [bound(*limit) for limit in self.limits.items()]
        text = "; ".join([*_condition_texts(self.conditions), *loads])
        against = ", ".join(_condition_texts(self.reference))
        return f"{text}; held against {against}" if against else text

    @property
    def curve_names(self) -> list[str]:
        """What tells each curve from the others, 90 cSt or sigma = 100 nm; empty for one curve."""
        if len(self.curves) == 1:
            return [""]
        columns = dict(zip(Condition._fields, zip(*self.curves, strict=True), strict=True))
        counts = {name: np.unique(column).size for name, column in columns.items()}
        # one condition if it alone tells the curves apart
        enough = [name for name, count in counts.items() if count == len(self.curves)]
        names = enough[-1:] or [name for name, count in counts.items() if count > 1]
        rows = zip(*([note(name, value) for value in columns[name]] for name in names), strict=True)
        return [", ".join(row).removeprefix("ν = ") for row in rows]

    @property
    def published_text(self) -> str:
        """The published value as text; empty if no numbers and no states are published."""
        return "" if self.published is None else ", ".join(map(str, np.atleast_1d(self.published)))

    @property
    def printed_numbers(self) -> Sequence[tuple[str, str, float]]:
        """Extreme, quantity and value of each printed number that is a point in a figure."""
        return ()

    @property
    def counted_as(self) -> str:
        """The name under which the claim is counted: its cluster, or else its id."""
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
        """The tolerance [unit of the quantity]; if logarithms are compared, the logarithm of its
        upper end [1].
        """
        return float(np.log(self.interval(1.0)[1])) if self.relative else self.tolerance

    def interval(self, value: float) -> tuple[float, float]:
        """The ends of the tolerance about a published ``value`` [unit of the quantity]."""
        if self.tolerance_kind == "factor":
            return value / self.tolerance, value * self.tolerance
        margin = abs(value) * self.tolerance if self.relative else self.tolerance
        return value - margin, value + margin

    def table(
        self, evidence: "Evidence", group: Sequence[Condition], quantity: str
    ) -> tuple[NDArray, NDArray]:
        """Abscissa (points,) and quantity (curves, points) of the curves of ``group``, at the loads
        of the claim."""
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
        """Pairs of each reference and its curve."""
        for reference, condition in zip(self.references, self.curves, strict=True):
            yield evidence.curves[reference], evidence.curves[condition]

    def courses(self, evidence: "Evidence") -> list[NDArray]:
        """The quantity along each curve, or its relative change from the reference."""
        if not self.references:
            return [self.table(evidence, [curve], self.quantity)[1][0] for curve in self.curves]
        pairs = zip(self.references, self.curves, strict=True)
        tables = [self.table(evidence, pair, self.quantity)[1] for pair in pairs]
        return [curve / reference - 1.0 for reference, curve in tables]

    def gaps(self, evidence: "Evidence") -> Iterator[NDArray]:
        """Excess of each curve over its reference, or over the curve before it, in the scale of
        ``step``."""
        pairs = zip(self.references, self.curves, strict=True)
        for group in pairs if self.references else [self.curves]:
            yield from np.diff(self.scaled(self.table(evidence, group, self.quantity)[1]), axis=0)

    def scaled(self, values: NDArray) -> NDArray:
        """The ``values``, or their logarithms if the tolerance is relative."""
        return logarithm(values) if self.relative else values

    def offsets(self, computed: ArrayLike) -> NDArray:
        """How far ``computed`` numbers lie above the published ones, in tolerances [1]."""
        published = np.asarray(self.published)
        if not self.relative:
            return np.ravel(computed - published) / self.tolerance
        # The offset is a ratio of logarithms, 1 at both ends of the tolerance.  It keeps growing as
        # a quantity falls far below the published one, so a calibration has a slope.
        ratio = np.maximum(np.ravel(computed / published), TINY)
        low, high = self.interval(1.0)
        return np.log(ratio) / np.abs(np.log(np.where(ratio < 1.0, low, high)))

    def against_published(self, computed: ArrayLike, text: str, finding: str = "") -> Verdict:
        """The verdict on ``computed`` numbers against the published ones."""
        published = np.asarray(self.published)
        deviation = np.ravel(computed - published)
        if self.relative:
            deviation = np.maximum(np.ravel(computed / published), TINY) - 1.0
        distance = np.abs(self.offsets(computed))
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
        """The verdict on a course or an order missed by ``miss``, in the scale of ``step``."""
        return Verdict(
            computed=text,
            distance=float(np.maximum(miss / self.step, 0.0)),
            deviation=float(np.expm1(miss) if self.relative else miss),
            finding=finding,
        )


def _condition_texts(conditions: Mapping[str, Any]) -> list[str]:
    """The ``conditions`` that distinguish curves, as text: ``nu = 0, 90 cSt``."""
    return [
        f"{axis.symbol} = {', '.join(f'{value:g}' for value in np.atleast_1d(values))} "
        f"{axis.alias_unit}"
        for axis in CONDITION_AXES
        if (values := conditions.get(axis.alias)) is not None
    ]
