"""The paper's statements as data, and the checks that judge them, on synthetic evidence."""

from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml

from thirdbody.curves.turning_point import PROMINENCE
from thirdbody.data.conditions import Condition
from thirdbody.study import checks, claims
from thirdbody.study.checks import judge
from thirdbody.study.claims import Claim
from thirdbody.study.evidence import Curve, TurningPoint

CONFIG = Path(__file__).parents[2] / "config" / "claims.yaml"
LOADS = np.geomspace(1e-7, 1e-4, 61)
DECADES = np.log10(LOADS / LOADS[0])  # 0 to 3


class Synthetic:
    """Evidence from functions of a ``Condition``; remembers what it was asked."""

    def __init__(self, curve=None, turning_point=None, window=None):
        self.answers = {"curve": curve, "turning_point": turning_point, "window": window}
        self.asked = {"curve": set(), "turning_point": set(), "window": set()}

    def curve(self, *condition):
        self.asked["curve"].add(condition)
        return self.answers["curve"](Condition(*condition))

    def turning_point(self, *condition):
        self.asked["turning_point"].add(condition)
        return self.answers["turning_point"](Condition(*condition))

    def window(self, roughness):
        self.asked["window"].add(roughness)
        return self.answers["window"](roughness)


def make_curve(area=LOADS, ratio=0.5, solid=1.0, film=None, solved=True):
    """A curve over ``LOADS``; single numbers hold at every load."""
    film = 2e-4 * 10 ** (-0.1 * DECADES) if film is None else film
    area, ratio, solid, film, solved = (
        np.broadcast_to(values, LOADS.shape) for values in (area, ratio, solid, film, solved)
    )
    normal_load = LOADS * 8e5
    return Curve(LOADS, normal_load, area, ratio, solid, film, film * 6.35e-3, solved)


def make_claim(kind, size=0.1, relative=False, conditions=None, **fields):
    """A claim on a dry curve of 300 nm particles and roughness, unless ``conditions`` differ."""
    usual = dict.fromkeys(claims.KEYS, 0) | {"particle_diameter_nm": 300, "roughness_nm": 300}
    usual |= conditions or {}
    return Claim("id", "Figure 4A", "statement", kind, usual, size, relative, "reason", **fields)


def judged(claim, curve=None, **answers):
    """Verdict on a claim; ``curve`` is a curve, or a function of the condition."""
    answer = curve if callable(curve) else lambda condition: curve
    return judge(claim, Synthetic(answer, **answers))


def by_viscosity(*curves):
    """Curves for 0, 10, 20, ... cSt."""
    return lambda condition: curves[round(condition.viscosity * 1e5)]


def viscosities(count):
    return {"viscosity_cSt": [10 * index for index in range(count)]}


# --- value ---


def test_value_compares_the_extreme_of_a_curve():
    claim = make_claim(
        "value", quantity="solid_load_fraction", extreme="minimum", published=0.9, size=0.05
    )
    right = judged(claim, make_curve(solid=np.linspace(1.0, 0.92, LOADS.size)))
    wrong = judged(claim, make_curve(solid=np.linspace(1.0, 0.70, LOADS.size)))
    assert right.holds and right.value == pytest.approx(0.92)
    assert right.deviation == pytest.approx(0.02) and right.score == pytest.approx(0.4)
    assert not wrong.holds and wrong.score == pytest.approx(1.0 + np.log(4.0))


def test_value_of_several_curves_is_that_of_the_worst():
    claim = make_claim(
        "value",
        quantity="solid_load_fraction",
        extreme="minimum",
        published=1.0,
        size=0.02,
        conditions=viscosities(3),
    )
    curves = make_curve(), make_curve(solid=0.95), make_curve(solid=0.99)
    verdict = judged(claim, by_viscosity(*curves))
    assert verdict.value == pytest.approx(0.95) and not verdict.holds
    assert verdict.computed == "1, 0.95, 0.99"
    assert verdict.score == pytest.approx(1.0 + np.log(2.5))


def test_relative_tolerance_ends_on_both_sides():
    claim = make_claim("value", quantity="turning_point_load", published=1e-5, relative=True)
    for load, holds in ((0.901e-5, True), (0.899e-5, False), (1.099e-5, True), (1.101e-5, False)):
        point = TurningPoint(load, 0.2, 1.0, 0.1)
        assert judged(claim, turning_point=lambda condition, p=point: p).holds is holds


@pytest.mark.parametrize(
    ("quantity", "value"),
    [
        ("turning_point_load", 1e-5),
        ("turning_point_ratio", 0.2),
        ("turning_point_solid_load_fraction", 0.3),
        ("turning_point_solid_load", 3e-6),
    ],
)
def test_turning_point_quantities(quantity, value):
    claim = make_claim("value", quantity=quantity, published=value, relative=True)
    point = TurningPoint(1e-5, 0.2, 0.3, 0.1)
    assert judged(claim, turning_point=lambda condition: point).score == pytest.approx(0, abs=1e-9)


def test_load_where_a_quantity_falls_to_a_level():
    solid = 10 ** (-0.3 * DECADES)
    claim = make_claim(
        "value",
        quantity="load",
        published=1e-6,
        size=1e-6,
        relative=True,
        conditions={"solid_load_fraction": 10**-0.3},
    )
    assert judged(claim, make_curve(solid=solid)).holds
    assert judged(claim, make_curve(solid=solid**0.5)).value == pytest.approx(1e-5)


def test_load_outside_the_range_is_continued_and_shown_as_such():
    claim = make_claim(
        "value", quantity="load", published=1e-4, conditions={"solid_load_fraction": 0.9}
    )
    never = judged(claim, make_curve(solid=np.linspace(1.0, 0.91, LOADS.size)))
    always = judged(claim, make_curve(solid=np.linspace(0.8, 0.1, LOADS.size)))
    flat = judged(claim, make_curve(solid=1.0))
    assert never.computed == "> 0.0001" and LOADS[-1] < never.value < 3e-4
    assert always.computed == "< 1e-07" and always.value == LOADS[0]
    assert flat.value == pytest.approx(1e-3, rel=0.15)


def test_value_against_a_reference_is_a_relative_change():
    claim = make_claim(
        "value",
        quantity="total_contact_area",
        published=-0.2,
        size=0.01,
        conditions={"viscosity_cSt": 10, "load": 1e-6},
        reference={"viscosity_cSt": 0},
    )
    curves = by_viscosity(make_curve(area=LOADS), make_curve(area=0.8 * LOADS))
    assert judged(claim, curves).value == pytest.approx(-0.2)
    assert not judged(claim, make_curve()).holds


def test_reversal_load():
    claim = make_claim(
        "value",
        quantity="total_contact_area_reversal_load",
        published=1e-5,
        relative=True,
        conditions=viscosities(2),
    )
    falling = make_curve(area=1e-3 * LOADS)
    crossing = make_curve(area=1e-3 * LOADS * (LOADS / 1e-5) ** 0.2)
    assert judged(claim, by_viscosity(falling, crossing)).value == pytest.approx(1e-5)
    against = judged(claim, by_viscosity(crossing, falling))
    assert not against.holds and against.computed == "> 0.0001"


def bending(at):
    """A curve whose slope on logarithmic axes falls from 1 to 0.5 at the load ``at``."""
    return make_curve(area=1e-3 * np.where(at > LOADS, LOADS, np.sqrt(at * LOADS)))


def test_bend_load_is_where_the_slope_leaves_that_of_the_reference():
    claim = make_claim(
        "value",
        quantity="bend_load",
        published=1e-5,
        size=0.15,  # one step between loads
        relative=True,
        conditions={"viscosity_cSt": 10},
        reference={"viscosity_cSt": 0},
    )
    straight = make_curve(area=1e-3 * LOADS)
    for at, holds in ((1e-5, True), (3e-6, False), (3e-5, False)):
        assert judged(claim, by_viscosity(straight, bending(at))).holds is holds
    # a bend that the reference has too is none
    both = judged(claim, by_viscosity(bending(1e-5), bending(1e-5)))
    assert both.computed == "> 0.0001" and not both.holds


def test_bend_load_over_that_at_which_mixed_lubrication_begins():
    claim = make_claim(
        "value",
        quantity="bend_load_over_mixed_load",
        published=1.0,
        size=0.3,
        relative=True,
        conditions={"viscosity_cSt": 10},
        reference={"viscosity_cSt": 0},
    )

    def bends(at, mixed_from):
        solid = np.where(mixed_from > LOADS, 1.0, 0.8)
        curve = make_curve(area=bending(at).total_contact_area, solid=solid)
        return by_viscosity(make_curve(area=1e-3 * LOADS), curve)

    assert judged(claim, bends(1e-5, 1e-5)).holds
    assert judged(claim, bends(1e-5, 4e-6)).value == pytest.approx(2.5, rel=0.3)
    assert not judged(claim, bends(1e-5, 4e-6)).holds
    never = judged(claim, bends(1e-5, 1.0))
    assert not never.tested and not never.holds


def test_reach_holds_where_a_number_is_passed():
    claim = make_claim(
        "reach", quantity="solid_load_fraction", extreme="minimum", published=0.5, size=0.02
    )
    for least, holds in ((0.1, True), (0.5, True), (0.51, True), (0.53, False)):
        verdict = judged(claim, make_curve(solid=np.linspace(1.0, least, LOADS.size)))
        assert verdict.holds is holds and verdict.value == pytest.approx(least)
    highest = make_claim(
        "reach", quantity="particle_contact_area_ratio", extreme="maximum", published=0.9, size=0.02
    )
    assert judged(highest, make_curve(ratio=0.95)).holds
    assert not judged(highest, make_curve(ratio=0.85)).holds


# --- not tested ---


def loads_of_mixing(direction="increasing", count=3):
    return make_claim(
        "trend",
        quantity="load",
        along="curves",
        direction=direction,
        relative=True,
        conditions=viscosities(count) | {"solid_load_fraction": 0.9},
    )


def mixing(*loads):
    return by_viscosity(*(make_curve(solid=1.0 - 0.1 * LOADS / load) for load in loads))


def test_one_load_beyond_the_last_is_known_to_be_larger():
    verdict = judged(loads_of_mixing(), mixing(1e-6, 1e-5, 2e-4))
    assert verdict.tested and verdict.holds and verdict.computed.endswith("> 0.0001")
    wrong = judged(loads_of_mixing(), mixing(1e-6, 2e-4, 1e-5))
    assert wrong.tested and not wrong.holds


def test_the_order_of_two_loads_beyond_the_last_is_not_tested():
    for loads in ((1e-6, 2e-4, 3e-4), (1e-6, 3e-4, 2e-4)):
        verdict = judged(loads_of_mixing(), mixing(*loads))
        assert not verdict.tested and not verdict.holds


@pytest.mark.parametrize(("load", "tested"), [(1e-5, True), (5e-5, True), (9e-5, False)])
def test_a_load_beyond_the_last_fails_where_the_last_is_too_large_already(load, tested):
    conditions = {"solid_load_fraction": 0.9}
    claim = make_claim("value", 0.3, True, conditions, quantity="load", published=load)
    verdict = judged(claim, make_curve(solid=1.0 - 0.1 * LOADS / 1.2e-4))
    assert verdict.tested is tested and not verdict.holds


def test_a_condition_that_no_load_meets_is_not_tested():
    claim = make_claim(
        "value",
        quantity="particle_contact_area_ratio",
        extreme="minimum",
        published=0.5,
        conditions={"solid_load_fraction_max": 0.5},
    )
    assert judged(claim, make_curve(ratio=0.5, solid=0.4)).holds
    verdict = judged(claim, make_curve(ratio=0.5, solid=0.6))
    assert not verdict.tested and not verdict.holds and verdict.score > 1.0
    drawn = judged(replace(claim, must_be_reached=True), make_curve(ratio=0.5, solid=0.6))
    assert drawn.tested and not drawn.holds


# --- range and window ---


def test_window_compares_both_ends_on_each_surface():
    claim = make_claim(
        "window", published=[0.8, 1.3], size=0.05, conditions={"roughness_nm": [100, 500]}
    )
    assert judged(claim, window=lambda roughness: (0.82, 1.27)).holds
    one_off = judged(claim, window=lambda roughness: (0.8, 1.3 if roughness < 2e-7 else 1.5))
    assert not one_off.holds and one_off.deviation == pytest.approx(0.2)
    assert one_off.score == pytest.approx(1.0 + np.log(4.0))
    assert judged(claim, window=lambda roughness: (np.nan, np.nan)).score == checks.MISSING_SCORE


def test_span_asks_for_both_numbers_somewhere_on_the_curve():
    claim = make_claim(
        "span", quantity="film_thickness", published=[1e-4, 2e-4], size=0.01, relative=True
    )
    wide = judged(claim, make_curve(film=4e-4 * 8 ** (-DECADES / 3)))
    assert wide.holds and wide.computed.endswith("at 8 N and 0.8 N")
    narrow = judged(claim, make_curve(film=1.9e-4 * 8 ** (-DECADES / 3)))
    assert not narrow.holds and narrow.value == pytest.approx(1.9e-4)


def test_one_of_several_curves_may_be_enough():
    value = make_claim(
        *("value", 0.02),
        quantity="solid_load_fraction",
        extreme="minimum",
        published=0.9,
        conditions=viscosities(2),
    )
    states = sequence(["boundary", "mixed", "full_film"], conditions=viscosities(2))
    curves = by_viscosity(make_curve(), make_curve(solid=np.linspace(1.0, 0.9, LOADS.size)))
    assert not judged(value, curves).holds
    assert judged(replace(value, any_curve=True), curves).holds
    assert not judged(states, by_viscosity(make_curve(), FALLING)).holds
    assert judged(replace(states, any_curve=True), by_viscosity(make_curve(), FALLING)).holds


# --- ordering and coincidence ---


def ordering(**fields):
    return make_claim(
        "ordering",
        size=0.02,
        relative=True,
        quantity="total_contact_area",
        direction=fields.pop("direction", "increasing"),
        conditions=fields.pop("conditions", viscosities(3)),
        **fields,
    )


def test_ordering_of_curves():
    curves = [make_curve(area=factor * LOADS) for factor in (1.0, 1.2, 1.5)]
    assert judged(ordering(), by_viscosity(*curves)).holds
    assert not judged(ordering(), by_viscosity(*curves[::-1])).holds
    assert judged(ordering(direction="decreasing"), by_viscosity(*curves[::-1])).holds
    assert not judged(ordering(), by_viscosity(curves[0], curves[2], curves[1])).holds


def test_identical_curves_are_in_no_order():
    verdict = judged(ordering(), make_curve())
    assert not verdict.holds and verdict.score == pytest.approx(1.0 + np.log(2.0))


def test_bounds_on_other_quantities_choose_the_loads():
    solid = np.where(LOADS < 1e-6, 1.0, 0.5)
    crossing = by_viscosity(
        make_curve(solid=solid), make_curve(area=LOADS * (LOADS / 9e-7) ** 0.5, solid=solid)
    )
    mixed = ordering(conditions=viscosities(2) | {"solid_load_fraction_max": 0.9})
    full_film = ordering(conditions=viscosities(2) | {"solid_load_fraction_max": 0.03})
    assert judged(mixed, crossing).holds
    short = judged(full_film, crossing)
    assert not short.holds and short.computed == "not reached, by 0.47"


def test_ordering_against_a_reference_on_the_same_axis():
    claim = make_claim(
        "ordering",
        size=0.02,
        relative=True,
        quantity="total_contact_area",
        direction="decreasing",
        conditions={"particle_diameter_nm": [100, 500]},
        reference={"particle_diameter_nm": 0},
    )
    areas = {0: 1.0, 100: 0.9, 500: 0.5}
    wrong = areas | {500: 1.1}
    for factors, holds in ((areas, True), (wrong, False)):

        def curve(condition, factors=factors):
            return make_curve(area=factors[round(condition.particle_diameter * 1e9)] * LOADS)

        assert judged(claim, curve).holds is holds


def coincidence(**fields):
    return make_claim(
        "coincidence",
        size=0.05,
        quantity="particle_contact_area_ratio",
        conditions={"viscosity_cSt": [10, 20]},
        reference={"viscosity_cSt": 0},
        **fields,
    )


def test_coincidence_with_a_reference():
    near, far = make_curve(ratio=0.52), make_curve(ratio=0.6)
    assert judged(coincidence(), by_viscosity(make_curve(), near, near)).holds
    verdict = judged(coincidence(), by_viscosity(make_curve(), near, far))
    assert not verdict.holds and verdict.deviation == pytest.approx(0.1)


def test_coincidence_over_another_abscissa():
    def curve(condition):
        film = 2e-4 * 10 ** (-0.1 * DECADES / (1.0 + condition.viscosity * 1e5))
        return make_curve(film=film, ratio=film / 2e-4)

    assert judged(coincidence(against="film_thickness"), curve).holds
    assert not judged(coincidence(), curve).holds


# --- trends and absence ---

COURSES = {
    "increasing": DECADES,
    "decreasing": 3.0 - DECADES,
    "constant": 0.0 * DECADES,
    "rising_then_falling": DECADES * (3.0 - DECADES),
    "falling_then_rising": 3.0 - DECADES * (3.0 - DECADES),
}


@pytest.mark.parametrize("direction", COURSES)
@pytest.mark.parametrize("shown", COURSES)
def test_trend_along_load(direction, shown):
    claim = make_claim(
        "trend",
        size=0.01,
        quantity="particle_contact_area_ratio",
        along="load",
        direction=direction,
    )
    verdict = judged(claim, make_curve(ratio=0.2 + 0.2 * COURSES[shown]))
    assert verdict.holds is (direction == shown)


@pytest.mark.parametrize(
    ("direction", "loads", "holds"),
    [
        ("increasing", (1e-6, 1.001e-6, 2e-6), True),  # a flat step is a step of a rise
        ("increasing", (1e-6, 3e-6, 2e-6), False),
        ("increasing", (1e-6, 1e-6, 1e-6), False),
        ("decreasing", (3e-6, 2e-6, 1e-6), True),
        ("decreasing", (1e-6, 2e-6, 3e-6), False),
        ("increasing_at_each_step", (1e-6, 1.2e-6, 1.4e-6), True),
        ("increasing_at_each_step", (1e-6, 1e-6, 1.4e-6), False),
        ("constant", (1e-6, 1.04e-6, 1.02e-6), True),
        ("constant", (1e-6, 1.2e-6, 1e-6), False),
    ],
)
def test_trend_along_curves(direction, loads, holds):
    claim = make_claim(
        "trend",
        size=0.05,
        relative=True,
        quantity="turning_point_load",
        along="curves",
        direction=direction,
        conditions=viscosities(3),
    )
    point = by_viscosity(*(TurningPoint(load, 0.2, 1.0, 0.1) for load in loads))
    assert judged(claim, turning_point=point).holds is holds


def test_trend_of_a_change_from_a_reference():
    claim = make_claim(
        "trend",
        size=0.02,
        quantity="turning_point_load",
        along="curves",
        direction="increasing",
        conditions={"roughness_nm": [100, 300], "particle_density_per_m2": 5.0e11},
        reference={"particle_density_per_m2": 1.0e10},
    )

    def point(condition):
        sparse = condition.particle_density < 1e11
        return TurningPoint(1e-6 if sparse else 10 * condition.roughness, 0.2, 1.0, 0.1)

    assert judged(claim, turning_point=point).computed == "0, 2"
    assert judged(claim, turning_point=point).holds


def turning_point_claims():
    fields = {"size": 0.01, "quantity": "particle_contact_area_ratio"}
    present = make_claim("trend", along="load", direction="rising_then_falling", **fields)
    return present, make_claim("absence", **fields)


def test_absence_of_a_turning_point():
    present, absent = turning_point_claims()
    bump = make_curve(ratio=0.2 + 0.1 * DECADES * (3.0 - DECADES))
    slope = make_curve(ratio=0.9 - 0.2 * DECADES)
    assert judged(present, bump).holds and not judged(absent, bump).holds
    assert judged(absent, slope).holds and not judged(present, slope).holds


def test_distance_from_a_turning_point_falls_on_the_way_to_it():
    present, _ = turning_point_claims()
    # odds of the ratio from steeply falling over gently falling to rising at first
    odds = [-slope * DECADES - 0.5 * DECADES**2 for slope in (20, 10, 5, 2, 1, 0, -1, -2)]
    scores = [judged(present, make_curve(ratio=1 / (1 + np.exp(-x)))).score for x in odds]
    assert scores == sorted(scores, reverse=True) and scores[0] > scores[3] > scores[5]


# --- sequences ---


def sequence(published, kind="regime_sequence", **fields):
    return make_claim(kind, size=0.02, published=published, **fields)


FALLING = make_curve(solid=np.clip(1.2 - 0.5 * DECADES, 0.0, 1.0))


def test_regime_sequence():
    assert judged(sequence(["boundary", "mixed", "full_film"]), FALLING).holds
    verdict = judged(sequence(["boundary", "mixed"]), FALLING)
    assert not verdict.holds and verdict.computed == "boundary > mixed > full_film"
    assert not judged(sequence(["mixed", "full_film"]), FALLING).holds
    assert not judged(sequence(["full_film", "mixed", "boundary"]), FALLING).holds
    assert judged(sequence(["boundary"]), make_curve(solid=1.0)).holds
    assert not judged(sequence(["boundary"]), make_curve(solid=0.5)).holds


def test_mode_sequence():
    falling = make_curve(ratio=np.clip(1.2 - 0.5 * DECADES, 0.0, 1.0))
    modes = ["particle_surface", "hybrid", "surface_surface"]
    assert judged(sequence(modes, "mode_sequence"), falling).holds
    assert not judged(sequence(modes[:2], "mode_sequence"), falling).holds
    assert not judged(sequence(modes, "mode_sequence"), make_curve(ratio=0.99)).holds


def test_sequence_of_regime_and_mode_together():
    steps = [
        "boundary particle_surface",
        "boundary hybrid",
        "mixed hybrid",
        "mixed surface_surface",
    ]
    both = make_curve(
        ratio=np.interp(DECADES, [0, 1, 2, 3], [1, 1, 0.02, 0.01]),
        solid=np.interp(DECADES, [0, 1.5, 3], [1, 1, 0.1]),
    )
    assert judged(sequence(steps), both).holds
    assert not judged(sequence([steps[i] for i in (0, 2, 1, 3)]), both).holds


def test_last_step_may_lie_beyond_the_loads():
    ending_mixed = make_curve(solid=np.linspace(1.0, 0.2, LOADS.size))
    steps = ["boundary", "mixed", "full_film"]
    assert not judged(sequence(steps), ending_mixed).holds
    assert judged(sequence(steps, open_end=True), ending_mixed).holds
    assert judged(sequence(steps, open_end=True), FALLING).holds


def test_each_state_must_be_met():
    steps = ["boundary", "mixed", "full_film"]
    almost = make_curve(solid=np.linspace(1.0, 0.031, LOADS.size))
    assert not judged(sequence(steps), almost).holds
    assert judged(sequence(steps, open_end=True), almost).holds


def test_a_kink_is_no_gradual_departure():
    claim = make_claim(
        *("reach", 0.1),
        quantity="departure_sharpness",
        extreme="minimum",
        published=0.8,
        conditions={"viscosity_cSt": 10},
        reference={"viscosity_cSt": 0},
    )
    dry = make_curve(film=2e-4 * 10 ** (-0.2 * DECADES))
    kink = make_curve(film=2e-4 * 10 ** (-0.2 * np.minimum(DECADES, 1.5)))
    bend = make_curve(film=2e-4 * 10 ** (-0.2 * (DECADES - np.logaddexp(0, 4 * DECADES - 6) / 4)))
    assert judged(claim, by_viscosity(dry, kink)).value == pytest.approx(1.0, abs=0.01)
    assert not judged(claim, by_viscosity(dry, kink)).holds
    assert judged(claim, by_viscosity(dry, bend)).holds


def test_step_with_alternatives():
    never_particles = ["hybrid or surface_surface"]
    bump = 0.05 * DECADES * (3.0 - DECADES)
    assert judged(sequence(never_particles, "mode_sequence"), make_curve(ratio=bump)).holds
    assert not judged(sequence(never_particles, "mode_sequence"), make_curve(ratio=0.99)).holds


# --- scores ---


def test_score_of_a_value_is_continuous_and_grows_with_the_distance():
    claim = make_claim("value", quantity="turning_point_load", published=1e-5, relative=True)
    loads = 1e-5 * np.geomspace(0.01, 100.0, 4001)
    scores = np.array(
        [
            judged(claim, turning_point=lambda _, load=load: TurningPoint(load, 0.2, 1, 0.1)).score
            for load in loads
        ]
    )
    assert scores.min() == pytest.approx(0.0, abs=1e-9)
    assert np.abs(np.diff(scores)).max() < 0.03
    assert np.all(np.diff(scores[:2001]) <= 0.0) and np.all(np.diff(scores[2000:]) >= 0.0)


@pytest.mark.parametrize("kind", ["ordering", "coincidence", "absence", "mode_sequence", "level"])
def test_scores_are_continuous(kind):
    # from 0 to 1 each claim goes from right to wrong
    ratio = 0.3 + 0.05 * DECADES
    claim, curve = {
        "ordering": (
            ordering(conditions=viscosities(2)),
            lambda x: by_viscosity(make_curve(), make_curve(area=LOADS * (1.1 - 0.2 * x))),
        ),
        "coincidence": (
            coincidence(),
            lambda x: by_viscosity(*(make_curve(ratio=ratio + s * x) for s in (0, 0.1, 0.2))),
        ),
        "absence": (
            turning_point_claims()[1],
            lambda x: make_curve(ratio=ratio - 0.05 * x * DECADES**2),
        ),
        "mode_sequence": (
            sequence(["particle_surface", "hybrid"], "mode_sequence"),
            lambda x: make_curve(ratio=np.linspace(1.0 - 0.3 * x, 0.5, LOADS.size)),
        ),
        "level": (
            make_claim(
                "value",
                relative=True,
                quantity="load",
                published=5e-5,
                size=0.5,
                conditions={"solid_load_fraction": 0.9},
            ),
            lambda x: make_curve(solid=1.0 - 0.15 * (1.0 - x) * LOADS / LOADS[-1]),
        ),
    }[kind]
    scores = np.array([judged(claim, curve(x)).score for x in np.linspace(0.0, 1.0, 1001)])
    assert scores[0] < 1.0 < scores[-1]
    assert np.abs(np.diff(scores)).max() < 0.1


def test_unsolved_points_are_no_evidence():
    half = make_curve(solid=0.5, solved=LOADS < 1e-5)
    reference = {"viscosity_cSt": 0}
    everywhere = [
        make_claim("value", quantity="solid_load_fraction", extreme="minimum", published=0.5),
        make_claim("span", quantity="film_thickness", published=[1e-4, 2e-4], relative=True),
        make_claim("coincidence", quantity="solid_load_fraction", reference=reference),
        ordering(reference=reference),
        make_claim("trend", quantity="film_thickness", along="load", direction="decreasing"),
        make_claim("absence", quantity="particle_contact_area_ratio"),
        sequence(["mixed"]),
        sequence(["hybrid"], "mode_sequence"),
    ]
    for claim in everywhere:
        verdict = judged(claim, half)
        assert verdict.score == checks.MISSING_SCORE and not verdict.holds, claim.kind
    solved_part = make_claim(
        "value",
        quantity="solid_load_fraction",
        extreme="minimum",
        published=0.5,
        conditions={"load_max": 5e-6},
    )
    assert judged(solved_part, half).holds


def test_what_is_said_of_a_turning_point_fails_where_it_does_not_stand_out():
    claim = make_claim("value", quantity="turning_point_load", published=1e-5, relative=True)
    points = [TurningPoint(1e-5, 0.2, 1.0, height) for height in (0.1, 0.02, 0.019, 0.001, 0.0)]
    verdicts = [judged(claim, turning_point=lambda _, point=point: point) for point in points]
    assert [verdict.holds for verdict in verdicts] == [True, True, False, False, False]
    scores = [verdict.score for verdict in verdicts]
    assert scores == sorted(scores) and scores[2] < 1.2 and scores[4] == checks.MISSING_SCORE
    assert verdicts[2].computed == "1e-05; stands out by 0.019"


# --- conditions ---


def test_conditions_are_si_and_run_together():
    claim = make_claim(
        "trend",
        conditions={
            "viscosity_cSt": 120,
            "particle_diameter_nm": [100, 300],
            "roughness_nm": [100, 300],
            "particle_density_per_m2": 1.0e11,
        },
        reference={"viscosity_cSt": 0},
    )
    assert claim.curves == ((1.2e-4, 1e-7, 1e-7, 1e11), (1.2e-4, 3e-7, 3e-7, 1e11))
    assert claim.references == ((0.0, 1e-7, 1e-7, 1e11), (0.0, 3e-7, 3e-7, 1e11))


# --- the paper's claims ---


@pytest.fixture(scope="module")
def paper():
    return claims.load_claims(CONFIG)


def world(condition):
    """A made-up interface that answers for any condition."""
    film = 1.0 + 1e4 * condition.viscosity
    solid = np.clip(1.1 - 1e3 * condition.viscosity * DECADES, 1e-3, 1.0)
    bump = np.exp(-((DECADES - film) ** 2)) * condition.particle_diameter / 1e-6
    return make_curve(LOADS * (1.0 - 0.5 * bump), bump, solid, 2e-4 * film * 2 ** (-DECADES))


def made_up_evidence():
    point = TurningPoint(1e-5, 0.2, 0.5, 0.1)
    return Synthetic(world, lambda condition: point, lambda roughness: (0.8, 1.3))


def test_paper_has_its_statements(paper):
    assert len(paper) >= 70 and all(claim.all_figures for claim in paper)
    assert {claim.kind for claim in paper} == set(checks.CHECKS)
    assert max(Counter(claim.id for claim in paper).values()) == 1
    assert all(claim.statement.endswith(".") and claim.reason for claim in paper)


@pytest.mark.parametrize(
    ("place", "figures"),
    [
        ("Figure 3A, section 3.3", {3}),
        ("Figures 4B and 4C, section 3.3", {4}),
        ("Figures 4 to 7, section 3.3", {4, 5, 6, 7}),
        ("Figures 9 and 10, section 3.3", {9, 10}),
        ("Figure 5B and the discussion of Figure 12C, section 3.3", {5, 12}),
    ],
)
def test_figures_of_a_statement(place, figures):
    claim = make_claim("value")
    assert replace(claim, place=place).all_figures == figures
    assert replace(claim, place="Conclusion 5", figures=[9, 10]).all_figures == {9, 10}


def test_the_numbers_that_were_kept_back_are_statements(paper):
    published = {claim.id: claim.published for claim in paper}
    drops = [
        published[f"fig04c-area-decrease-at-{share}-percent-{viscosity}cst"]
        for share in (90, 50)
        for viscosity in (90, 120)
    ]
    assert drops == [-0.149, -0.21, -0.537, -0.65]
    ends = [published[f"fig13b-turning-point-load-{end}"] for end in ("from", "to")]
    assert ends == [1.5e-5, 3.0e-5]


def test_one_width_makes_a_turning_point_visible(paper):
    for claim in paper:
        if claim.kind == "absence" or claim.direction == "rising_then_falling":
            assert claim.tolerance == PROMINENCE, claim.id


def test_contradictions_are_mutual(paper):
    links = {claim.id: claim.contradicts for claim in paper}
    assert all(name in links[other] for name, others in links.items() for other in others)


def test_every_claim_can_be_judged_and_names_what_it_needs(paper):
    for claim in paper:
        evidence = made_up_evidence()
        verdict = judge(claim, evidence)
        assert 0.0 <= verdict.score <= checks.MISSING_SCORE, claim.id
        assert verdict.holds is bool(verdict.tested and verdict.score <= 1.0) and verdict.computed
        needed = claims.referenced_conditions([claim])
        assert all(evidence.asked[method] <= needed[method] for method in needed), claim.id
        if "not reached" not in verdict.computed:
            assert evidence.asked == needed, claim.id


# --- strictness ---

GOOD = {
    "id": "some-claim",
    "place": "Figure 3A",
    "statement": "The solid bears all load.",
    "quote": "$L_s$ is 100% under all dimensionless normal loads",
    "kind": "value",
    "quantity": "solid_load_fraction",
    "extreme": "minimum",
    "published": 1.0,
    "conditions": {
        "viscosity_cSt": 0,
        "particle_diameter_nm": [0, 500],
        "roughness_nm": 300,
        "particle_density_per_m2": 1.0e11,
    },
    "tolerance": {"absolute": 0.02, "reason": "a line's width"},
}


def load(tmp_path, *entries):
    path = tmp_path / "claims.yaml"
    each = [yaml.safe_dump([entry]) for entry in entries]  # together they would share anchors
    path.write_text("".join(each), encoding="utf-8")
    return claims.load_claims(path)


@pytest.mark.parametrize(
    ("change", "key"),
    [
        ({"kind": "guess"}, "kind"),
        ({"colour": "red"}, "colour"),
        ({"place": None}, "place"),
        ({"quote": None}, "quote"),
        ({"published": "1e0"}, "published"),
        ({"published": None}, "published"),
        ({"role": "validation"}, "role"),
        ({"quantity": "friction"}, "quantity"),
        ({"extreme": None}, "extreme"),
        ({"extreme": "middle"}, "extreme"),
        ({"direction": "increasing"}, "direction"),
        ({"reference": {"speed": 1}}, "speed"),
        ({"conditions": {"roughness_nm": 300}}, "viscosity_cSt"),
        ({"conditions": GOOD["conditions"] | {"load_mim": 1e-6}}, "load_mim"),
        ({"conditions": GOOD["conditions"] | {"particle_density_per_m2": "1e11"}}, "density"),
        ({"conditions": GOOD["conditions"] | {"roughness_nm": [1, 2, 3]}}, "conditions"),
        ({"tolerance": {"absolute": 0.1}}, "reason"),
        ({"tolerance": {"reason": "none"}}, "absolute"),
        ({"tolerance": {"relative": 1.5, "reason": "wide"}}, "relative"),
        ({"kind": "regime_sequence", "published": ["wet"], "quantity": None}, "extreme"),
        ({"contradicts": ["nobody"]}, "nobody"),
    ],
)
def test_bad_claim_is_refused_in_one_line(tmp_path, change, key):
    entry = {name: value for name, value in (GOOD | change).items() if value is not None}
    with pytest.raises(ValueError) as error:
        load(tmp_path, entry)
    message = str(error.value)
    assert "claims.yaml: some-claim: " in message and key in message and "\n" not in message


def test_ids_are_unique_and_contradictions_mutual(tmp_path):
    with pytest.raises(ValueError, match="some-claim"):
        load(tmp_path, GOOD, GOOD)
    other = GOOD | {"id": "other-claim", "contradicts": ["some-claim"]}
    with pytest.raises(ValueError, match=r"other-claim: contradicts\[0\] is 'some-claim'"):
        load(tmp_path, GOOD, other)
    both = GOOD | {"contradicts": ["other-claim"]}, other
    with pytest.raises(ValueError, match="stands aside"):
        load(tmp_path, *both)
    (_, second) = load(tmp_path, both[0], other | {"aside": "the first one names the curve"})
    assert second.aside
    with pytest.raises(ValueError, match="contradicts"):
        load(tmp_path, GOOD | {"aside": "of nothing"})
