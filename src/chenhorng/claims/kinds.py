"""The ten kinds of claims: the fields that a kind adds to ``Claim``, and its check."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field
from pydantic.dataclasses import dataclass

from chenhorng.claims.between_curves import (
    BETWEEN_CURVES,
    LOADS_BETWEEN_CURVES,
    bend_loads,
    mixed_loads,
)
from chenhorng.claims.claim import TURNING_POINT_QUANTITIES, WINDOW_QUANTITIES, Claim, Verdict
from chenhorng.claims.courses import COURSES, passed_states, peak_height, sequence_miss
from chenhorng.claims.fields import CurveQuantity, Ends, Reference, State, checked
from chenhorng.claims.words import NAMES, beginning, named, number, passed, sentence, size, source
from chenhorng.configuration.model import one_of
from chenhorng.sampling import CURVE_QUANTITIES

if TYPE_CHECKING:
    from chenhorng.claims.evidence import Evidence

Quantity = Annotated[
    str,
    one_of(*CURVE_QUANTITIES, *TURNING_POINT_QUANTITIES, *WINDOW_QUANTITIES, *BETWEEN_CURVES),
]
AGAINST_REFERENCE = "bend_load", "bend_load_over_mixed_load", "departure_sharpness"
ROUNDING = 1e-9  # of the solver: curves against an order by less than this are in order


@dataclass(frozen=True, kw_only=True)
class NumberClaim(Claim):
    """A claim on one number of each curve, or on its relative change from the ``reference``.

    The number is the quantity at a load, its ``extreme`` over loads, or a quantity between curves.
    """

    quantity: Quantity = Field()
    extreme: Literal["", "minimum", "maximum"] = ""
    reference: Annotated[Mapping[str, float], checked(Reference)] = Field(default_factory=dict)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.quantity in AGAINST_REFERENCE and not self.reference:
            raise ValueError(
                f"{self.quantity} without reference; allowed: a curve without the bend"
            )
        is_level = not {*CURVE_QUANTITIES}.isdisjoint(self.conditions)
        is_number = self.along != "load" and self.quantity in CURVE_QUANTITIES
        if is_number and not self.extreme and not is_level:
            raise ValueError(
                f"{self.quantity} of a whole curve; allowed: a condition with the load or with a "
                "level, or extreme: minimum or maximum"
            )

    def numbers(self, evidence: "Evidence") -> NDArray:
        """The quantity as one number per curve, or its relative change from the reference."""
        if self.quantity in BETWEEN_CURVES:
            return np.array(BETWEEN_CURVES[self.quantity](self, evidence))
        if self.source == "turning_point":
            pick = TURNING_POINT_QUANTITIES[self.quantity]
            values = np.array([pick(evidence.turning_points[curve]) for curve in self.curves])
            references = [pick(evidence.turning_points[curve]) for curve in self.references]
            return values / references - 1.0 if references else values
        if self.source == "window":
            end = WINDOW_QUANTITIES[self.quantity]
            return np.array([evidence.windows[curve.roughness][end] for curve in self.curves])
        extreme = np.max if self.extreme == "maximum" else np.min
        return np.array([extreme(course) for course in self.courses(evidence)])

    def texts_of(self, evidence: "Evidence", values: NDArray) -> list[str]:
        """Numbers as texts.  A load beyond the computed loads is written ``> last`` or
        ``< first``."""
        texts = [number(value) for value in values]
        if self.quantity in ("load", "total_contact_area_reversal_load", "bend_load"):
            first, last = evidence.curves[self.curves[0]]["load"][[0, -1]]
            texts = [f"> {number(last)}" if v >= last else t for v, t in zip(values, texts)]
            texts = [f"< {number(first)}" if v <= first else t for v, t in zip(values, texts)]
        return texts

    def finding(self, texts: Sequence[str], published: str = "") -> str:
        """The numbers in a sentence, with the ``published`` number."""
        is_change = bool(self.references) and self.quantity not in BETWEEN_CURVES
        start = beginning(self.quantity, self.extreme, self.limits, is_change)
        found = named(self.curve_names, texts)
        start += ":" if found not in texts else ""
        return sentence(f"{start} {found}", published and source(published, self.stands_for))

    def is_tested(self, evidence: "Evidence") -> bool:
        """Whether the computed loads decide the claim.  Only a claim on loads can be undecided: a
        load beyond the last one is only known to be larger."""
        if self.quantity not in ("load", *LOADS_BETWEEN_CURVES):
            return True
        last = evidence.curves[self.curves[0]]["load"][-1]
        if self.quantity == "bend_load_over_mixed_load":
            return bool(np.max([bend_loads(self, evidence), mixed_loads(self, evidence)]) < last)
        return bool(self.is_decided(self.numbers(evidence), last))

    def is_decided(self, loads: NDArray, last: float) -> bool:
        """Whether the ``loads`` decide the claim, if a load beyond the ``last`` is only known to be
        larger.
        """
        raise NotImplementedError


@dataclass(frozen=True, kw_only=True)
class Value(NumberClaim):
    """The number agrees on each curve, or with ``any_curve`` on one of them."""

    published: float = Field()
    any_curve: bool = False

    def compared(self, values: NDArray) -> NDArray:
        """The ``values`` that are compared with the published one."""
        return values

    def check(self, evidence: "Evidence") -> Verdict:
        values = self.numbers(evidence)
        texts = self.texts_of(evidence, values)
        finding = self.finding(texts, self.published_words)
        verdicts = [
            self.against_published(value, ", ".join(texts), finding)
            for value in self.compared(values)
        ]
        pick = np.argmin if self.any_curve else np.argmax
        chosen = int(pick([verdict.distance for verdict in verdicts]))
        return verdicts[chosen]._replace(numbers=tuple(values.tolist()), worst=chosen)

    @property
    def published_words(self) -> str:
        """The published value as the paper prints it."""
        return number(self.published, 6)

    def is_decided(self, loads: NDArray, last: float) -> bool:
        # a published number is missed if the last load already misses it
        at_most = np.minimum(loads, last)
        return bool((loads < last).all()) or self.against_published(at_most, "").distance > 1.0

    @property
    def printed_numbers(self) -> Sequence[tuple[str, str, float]]:
        is_change = self.reference and self.quantity not in LOADS_BETWEEN_CURVES
        if is_change or self.stands_for:
            return ()
        return [(self.extreme, self.quantity, self.published)]


@dataclass(frozen=True, kw_only=True)
class Reach(Value):
    """The least (greatest) value along each curve reaches the published one or goes beyond it."""

    extreme: Literal["minimum", "maximum"] = Field()
    printed_numbers = ()

    @property
    def published_words(self) -> str:
        return f"{number(self.published)} or {'less' if self.extreme == 'minimum' else 'more'}"

    def compared(self, values: NDArray) -> NDArray:
        beyond = np.maximum if self.extreme == "minimum" else np.minimum
        return beyond(values, self.published)

    def is_decided(self, loads: NDArray, last: float) -> bool:
        return not (loads >= last).all()


@dataclass(frozen=True, kw_only=True)
class Span(Claim):
    """Both ends of the quantity along the curve are the published ones."""

    quantity: CurveQuantity = Field()
    published: Annotated[Sequence[float], Ends] = Field()

    def check(self, evidence: "Evidence") -> Verdict:
        (course,) = self.courses(evidence)
        ends = np.array([course.min(), course.max()])
        (first, last), (low, high) = ends, self.published
        text = f"{number(first)} to {number(last)}"
        printed = source(f"{number(low)} to {number(high)}", self.stands_for)
        finding = sentence(f"{NAMES[self.quantity]} goes from {text}", printed)
        return self.against_published(ends, text, finding)

    @property
    def printed_numbers(self) -> Sequence[tuple[str, str, float]]:
        return list(zip(("minimum", "maximum"), [self.quantity] * 2, self.published, strict=True))


@dataclass(frozen=True, kw_only=True)
class Window(Claim):
    """The ends of the range of x_a/sigma with a turning point agree on each surface."""

    published: Annotated[Sequence[float], Ends] = Field()
    source = "window"

    def check(self, evidence: "Evidence") -> Verdict:
        windows = np.array([evidence.windows[condition.roughness] for condition in self.curves])
        texts = [f"{low:.3f} to {high:.3f}" for low, high in windows]
        low, high = self.published
        found = named(self.curve_names, texts)
        start = "Turning points occur at x_a/sigma" + (" of" if found in texts else ":")
        printed = source(f"{number(low, 4)} to {number(high, 4)}", self.stands_for)
        finding = sentence(f"{start} {found}", printed)
        return self.against_published(windows, ", ".join(texts), finding)

    @property
    def printed_numbers(self) -> Sequence[tuple[str, str, float]]:
        if self.stands_for:
            return ()
        return list(zip(("", ""), WINDOW_QUANTITIES, self.published, strict=True))


@dataclass(frozen=True, kw_only=True)
class Ordering(Claim):
    """Neighbouring curves in the order listed, or each curve and its reference, lie in the
    ``direction``.

    They are nowhere against the direction by more than the tolerance, and somewhere apart in this
    direction by at least the tolerance.
    """

    quantity: CurveQuantity = Field()
    direction: Literal["increasing", "decreasing"] = Field()
    reference: Annotated[Mapping[str, float], checked(Reference)] = Field(default_factory=dict)

    def __post_init__(self) -> None:
        super().__post_init__()
        if len(self.curves) < 2 and not self.references:
            raise ValueError("an order of one curve; allowed: two or more, or a reference")

    def check(self, evidence: "Evidence") -> Verdict:
        sign = -1.0 if self.direction == "decreasing" else 1.0
        gaps = [sign * gap for gap in self.gaps(evidence)]
        against, apart = -np.min([gap.min() for gap in gaps]), np.min([gap.max() for gap in gaps])
        whose = "the two nearest " if len(gaps) > 1 else ""  # neighbours, or curve and reference
        text = f"in order, {whose}apart by up to {apart:.3g}"
        distance = size(max(apart, 0.0), self.relative)
        finding = f"{NAMES[self.quantity]}: in this order, {whose}apart by up to {distance}"
        if against > ROUNDING:
            text = (
                f"with the order by up to {max(apart, 0.0):.3g}, against it by up to {against:.3g}"
            )
            finding += f"; elsewhere against it by up to {size(against, self.relative)}"
        return self.missed(text, np.max([against, 2.0 * self.step - apart]), sentence(finding))


@dataclass(frozen=True, kw_only=True)
class Coincidence(Claim):
    """Curves nowhere differ from their references by more than the tolerance, plotted ``against``
    the load or another quantity."""

    quantity: CurveQuantity = Field()
    reference: Annotated[Mapping[str, float], Field(min_length=1), checked(Reference)] = Field()
    against: CurveQuantity = "load"

    def check(self, evidence: "Evidence") -> Verdict:
        widest = np.max([np.abs(gap).max() for gap in self.gaps(evidence)])
        finding = (
            f"the curves of {NAMES[self.quantity]} are up to {size(widest, self.relative)} apart"
        )
        return self.missed(f"apart by up to {widest:.3g}", widest, sentence(finding))


class CourseClaim(Claim):
    """A claim on the course of a quantity."""

    def miss(self, course: NDArray) -> float:
        """Shortfall of a scaled ``course`` from the course that the claim names."""
        raise NotImplementedError

    def check_courses(self, courses: Sequence[NDArray]) -> tuple[NDArray, Verdict]:
        """The course with the largest miss, and the verdict on it."""
        misses = [self.miss(self.scaled(course)) for course in courses]
        worst = int(np.argmax(misses))
        course = courses[worst]
        points = course[0], course[-1], course.min(), course.max()
        first, last, least, most = map(number, points)
        text = f"from {first} to {last}"
        if not {least, most} <= {first, last}:
            text += f", between {least} and {most}"
        return course, self.missed(text, misses[worst])

    def check_along_load(self, evidence: "Evidence") -> Verdict:
        """The verdict on the quantity along each curve."""
        _, verdict = self.check_courses(self.courses(evidence))
        change = "the change of " if self.references else ""
        text = f"{change}{NAMES[self.quantity]} goes {verdict.computed}"
        return verdict._replace(finding=sentence(text))


@dataclass(frozen=True, kw_only=True)
class Trend(CourseClaim, NumberClaim):
    """Each curve has the course ``direction`` ``along`` the load, or the numbers of the curves have
    this course from curve to curve.

    A total rise or fall, and an interior extreme, must reach the tolerance.  A reversal must not
    exceed the tolerance.  A ``constant`` course may vary by the tolerance.  A course
    ``increasing_at_each_step`` must rise by the tolerance at each step.
    """

    direction: Annotated[str, one_of(*COURSES)] = Field()
    along: Literal["load", "curves"] = Field()

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.along == "load" and self.quantity not in CURVE_QUANTITIES:
            raise ValueError(
                f"{self.quantity} along the load; allowed: {', '.join(CURVE_QUANTITIES)}"
            )
        if self.along == "curves" and len(self.curves) < 2:
            raise ValueError("a trend along one curve; allowed: two curves or more")

    def miss(self, course: NDArray) -> float:
        return COURSES[self.direction](course, self.step)

    def check(self, evidence: "Evidence") -> Verdict:
        if self.along == "load":
            return self.check_along_load(evidence)
        course, verdict = self.check_courses([self.numbers(evidence)])
        texts = self.texts_of(evidence, course)
        return verdict._replace(computed=", ".join(texts), finding=self.finding(texts))

    def is_decided(self, loads: NDArray, last: float) -> bool:
        # the order of two neighbouring loads beyond the last load is unknown
        beyond = loads >= last
        return not (beyond[1:] & beyond[:-1]).any()


@dataclass(frozen=True, kw_only=True)
class Absence(CourseClaim):
    """No interior maximum over load stands out by more than the tolerance."""

    quantity: CurveQuantity = Field()

    def miss(self, course: NDArray) -> float:
        return peak_height(course)

    def check(self, evidence: "Evidence") -> Verdict:
        return self.check_along_load(evidence)


@dataclass(frozen=True, kw_only=True)
class StateSequence(Claim):
    """Exactly the ``published`` regimes, modes or both occur in order on each curve.

    With ``any_curve`` one curve is enough.  With ``open_end`` the last step may lie beyond the
    loads.  Excursions from a step are within the tolerance.  A step may name a regime and a mode,
    and alternatives with "or".
    """

    published: Annotated[Sequence[State], Field(min_length=1)] = Field()
    any_curve: bool = False
    open_end: bool = False

    def check(self, evidence: "Evidence") -> Verdict:
        curves = [evidence.curves[condition] for condition in self.curves]
        how = self.published, self.tolerance, self.open_end
        misses = [sequence_miss(curve, *how) for curve in curves]
        chosen = int(np.argmin(misses) if self.any_curve else np.argmax(misses))
        of_curves = [passed_states(curve, self.published) for curve in curves]
        states = of_curves[chosen]
        texts = [passed(states)] if self.any_curve else [*map(passed, of_curves)]
        printed = passed(self.published, self.open_end)
        beginning = "by curve," if len({*texts}) > 1 else "the states are"
        found = named(self.curve_names, texts, ": ", "; ")
        finding = sentence(f"{beginning} {found}", f"the paper: {printed}")
        return self.missed(" > ".join(states).strip(), misses[chosen], finding)

    @property
    def published_text(self) -> str:
        return " > ".join(self.published)


KINDS: dict[str, type[Claim]] = {
    "value": Value,
    "reach": Reach,
    "span": Span,
    "window": Window,
    "ordering": Ordering,
    "coincidence": Coincidence,
    "trend": Trend,
    "absence": Absence,
    "regime_sequence": StateSequence,
    "mode_sequence": StateSequence,
}
