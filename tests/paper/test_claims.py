"""The paper's statements as data, and the checks that judge them, on synthetic evidence."""

from collections import Counter
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import yaml

from chenhorng.claims import claims
from chenhorng.claims.claim import CONDITION_KEYS, MISSING_SCORE
from chenhorng.claims.evidence import FULL_EFFORT, curve_of
from chenhorng.claims.kinds import KINDS
from thirdbody.core.turning_points import PROMINENCE, TurningPoints
from thirdbody.files import read_yaml

CONFIG = Path(__file__).parents[2] / "config" / "claims.yaml"
LOADS = np.geomspace(1e-7, 1e-4, 61)
DECADES = np.log10(LOADS / LOADS[0])  # 0 to 3


def make_curve(area=LOADS, ratio=0.5, solid=1.0, film=None, solved=True):
    """A curve over ``LOADS``; single numbers hold at every load."""
    film = 2e-4 * 10 ** (-0.1 * DECADES) if film is None else film
    given = dict(total_contact_area=area, particle_contact_area_ratio=ratio)
    given |= dict(solid_load_fraction=solid, film_thickness=film)
    given = {name: np.where(solved, each, np.nan) + 0.0 * LOADS for name, each in given.items()}
    return curve_of(given | {"load": LOADS, "normal_load": LOADS * 8e5})


def make_claim(kind, quantity="", published=None, size=0.1, relative=False, given=None, **fields):
    """A claim on a dry curve of 300 nm particles and roughness, unless ``given`` conditions
    differ."""
    usual = dict.fromkeys(CONDITION_KEYS, 0) | {"particle_diameter_nm": 300, "roughness_nm": 300}
    fields |= {"quantity": quantity} if quantity else {}
    fields |= {} if published is None else {"published": published}
    fields |= {"id": "id", "place": "Figure 4A", "statement": "words", "quote": "", "kind": kind}
    fields |= {"tolerance": size, "tolerance_kind": "relative" if relative else "absolute"}
    return KINDS[kind](**fields, conditions=usual | (given or {}), reason="reason")


def least(published, size=0.1, kind="value", **fields):
    """A claim on the least L_s of curves."""
    return make_claim(kind, "solid_load_fraction", published, size, extreme="minimum", **fields)


class Answers:
    """What a function gives, by the condition."""

    def __init__(self, function):
        self.function = function

    def __getitem__(self, condition):
        return self.function(condition)


def judged(claim, curve=None, turning_point=None, window=None):
    """Verdict on a claim; ``curve`` is a curve, or a function of the condition."""
    answer = curve if callable(curve) else lambda condition: curve
    names = "curves", "turning_points", "windows"
    answers = map(Answers, (answer, turning_point, window))
    evidence = dict(zip(names, answers, strict=True))
    return claim.verdict(SimpleNamespace(**evidence, effort=FULL_EFFORT))


def by_viscosity(*curves):
    """Curves for 0, 10, 20, ... cSt."""
    return lambda condition: curves[round(condition.viscosity * 1e5)]


def viscosities(count):
    return {"viscosity_cSt": [10 * index for index in range(count)]}


def falling_to(end, begin=1.0):
    """A curve whose L_s falls evenly."""
    return make_curve(solid=np.linspace(begin, end, LOADS.size))


def turning(load, height=0.1):
    """A turning point at a load, which stands out by ``height``."""
    return TurningPoints(load, 0.0, 0.2, 0.3, 1e-7, height)


def at_load(load, height=0.1):
    return {"turning_point": lambda condition: turning(load, height)}


def bending(at, solid=1.0):
    """A curve whose slope on logarithmic axes falls from 1 to 0.5 at the load ``at``."""
    return make_curve(1e-3 * np.where(at > LOADS, LOADS, np.sqrt(at * LOADS)), solid=solid)


STRAIGHT = make_curve(area=1e-3 * LOADS)
DRY = {"viscosity_cSt": 0}
WET = {"viscosity_cSt": 10}
AGAINST_DRY = {"given": WET, "reference": DRY}


def test_value_compares_the_extreme_of_a_curve():
    right, wrong = (judged(least(0.9, 0.05), falling_to(end)) for end in (0.92, 0.70))
    assert right.holds and right.value == pytest.approx(0.92)
    assert right.deviation == pytest.approx(0.02) and right.score == pytest.approx(0.4)
    assert not wrong.holds and wrong.score == pytest.approx(1.0 + np.log(4.0))


def test_a_number_that_stands_for_words_is_not_said_to_be_printed():
    curve = make_curve(solid=0.9)
    printed, meant = least(0.8), least(0.8, stands_for="gradually")
    assert judged(printed, curve).finding.endswith("0.8 is printed.")
    assert judged(meant, curve).finding.endswith('0.8 is taken for "gradually".')
    assert printed.printed_numbers and not meant.printed_numbers


def test_numbers_of_several_curves_stand_behind_the_names_of_their_curves():
    curves = make_curve(), make_curve(solid=0.95), make_curve(solid=0.9500001), make_curve()
    found = judged(least(1.0, 0.1, given=viscosities(4)), by_viscosity(*curves)).finding
    assert found == "The least L_s is: dry 1, 10 cSt to 20 cSt 0.95, 30 cSt 1; 1 is printed."
    same = judged(least(1.0, 0.1, given=viscosities(4)), by_viscosity(*4 * [make_curve()])).finding
    assert same == "The least L_s is 1; 1 is printed."
    sizes = {"particle_diameter_nm": [100, 300], "roughness_nm": [100, 300]}
    pair = least(1.0, given=sizes)
    assert pair.curve_names == ["σ = 100 nm", "σ = 300 nm"]
    crossed = least(1.0, given=viscosities(2) | {"roughness_nm": [300, 300]})
    assert crossed.curve_names == ["dry", "10 cSt"]


@pytest.mark.parametrize(
    ("published", "tolerance", "kind", "computed", "offset"),
    [
        (0.2, 0.02, "absolute", 0.21, 0.5),
        (-0.149, 0.02, "absolute", -0.169, -1.0),
        (1e-5, 2.0, "factor", 2e-5, 1.0),
        (1e-5, 2.0, "factor", 0.5e-5, -1.0),
        (2.0, 0.1, "relative", 1.8, -1.0),
        (2.0, 0.1, "relative", 2.42, 2.0),
    ],
)
def test_an_offset_is_the_signed_distance_in_tolerances(
    published, tolerance, kind, computed, offset
):
    claim = replace(least(published, tolerance), tolerance_kind=kind)
    assert claim.offsets(np.array([computed])) == pytest.approx([offset])
    assert claim.against_published(computed, "").distance == pytest.approx(abs(offset))


def test_value_of_several_curves_is_that_of_the_worst():
    curves = make_curve(), make_curve(solid=0.95), make_curve(solid=0.99)
    verdict = judged(least(1.0, 0.02, given=viscosities(3)), by_viscosity(*curves))
    assert verdict.value == pytest.approx(0.95) and not verdict.holds
    assert verdict.computed == "1, 0.95, 0.99"
    assert verdict.score == pytest.approx(1.0 + np.log(2.5))


@pytest.mark.parametrize(
    ("quantity", "value"),
    [("load", 1e-5), ("ratio", 0.2), ("solid_load_fraction", 0.3), ("solid_load", 3e-6)],
)
def test_turning_point_quantities(quantity, value):
    claim = make_claim("value", f"turning_point_{quantity}", value, relative=True)
    assert judged(claim, **at_load(1e-5)).score == pytest.approx(0, abs=1e-9)


def test_a_factor_is_the_same_tolerance_on_both_sides():
    claim = make_claim("value", "turning_point_load", 1e-5, size=1.41)
    claim = replace(claim, tolerance_kind="factor")
    for load, distance in ((1.41e-5, 1.0), (1e-5 / 1.41, 1.0), (1.41**0.5 * 1e-5, 0.5)):
        assert judged(claim, **at_load(load)).distance == pytest.approx(distance)
    assert claim.interval(2.0) == pytest.approx((2.0 / 1.41, 2.82))
    assert judged(claim, **at_load(1.4e-5)).holds and not judged(claim, **at_load(1.42e-5)).holds


def test_of_any_curve_the_one_that_agrees_must_have_a_turning_point():
    claim = make_claim("value", "turning_point_load", 1e-5, relative=True, given=viscosities(2))
    claim = replace(claim, any_curve=True)
    for heights, holds in (((0.1, 0.0), True), ((0.0, 0.1), False)):
        points = dict(zip(claim.curves, map(turning, (1e-5, 2e-5), heights)))
        assert judged(claim, turning_point=points.__getitem__).holds is holds


def test_load_where_a_quantity_falls_to_a_level():
    solid, level = 10 ** (-0.3 * DECADES), {"solid_load_fraction": 10**-0.3}
    claim = make_claim("value", "load", 1e-6, 1e-6, relative=True, given=level)
    assert judged(claim, make_curve(solid=solid)).holds
    assert judged(claim, make_curve(solid=solid**0.5)).value == pytest.approx(1e-5)


def test_load_outside_the_range_is_continued_and_shown_as_such():
    claim = make_claim("value", "load", 1e-4, given={"solid_load_fraction": 0.9})
    never, always = judged(claim, falling_to(0.91)), judged(claim, falling_to(0.1, begin=0.8))
    assert never.computed == "> 1e-4" and LOADS[-1] < never.value < 3e-4
    assert always.computed == "< 1e-7" and always.value == LOADS[0]
    assert judged(claim, make_curve()).value == pytest.approx(1e-3, rel=0.15)


def test_value_against_a_reference_is_a_relative_change():
    at = {"given": WET | {"load": 1e-6}, "reference": DRY}
    claim = make_claim("value", "total_contact_area", -0.2, 0.01, **at)
    curves = by_viscosity(make_curve(), make_curve(area=0.8 * LOADS))
    assert judged(claim, curves).value == pytest.approx(-0.2)
    assert not judged(claim, make_curve()).holds


def test_reversal_load():
    quantity = "total_contact_area_reversal_load"
    claim = make_claim("value", quantity, 1e-5, relative=True, given=viscosities(2))
    crossing = make_curve(area=1e-3 * LOADS * (LOADS / 1e-5) ** 0.2)
    assert judged(claim, by_viscosity(STRAIGHT, crossing)).value == pytest.approx(1e-5)
    against = judged(claim, by_viscosity(crossing, STRAIGHT))
    assert not against.holds and against.computed == "> 1e-4"


def test_bend_load_is_where_the_slope_leaves_that_of_the_reference():
    claim = make_claim("value", "bend_load", 1e-5, 0.15, relative=True, **AGAINST_DRY)
    for at, holds in ((1e-5, True), (3e-6, False), (3e-5, False)):
        assert judged(claim, by_viscosity(STRAIGHT, bending(at))).holds is holds
    # a bend that the reference has too is none
    both = judged(claim, by_viscosity(bending(1e-5), bending(1e-5)))
    assert both.computed == "> 1e-4" and not both.holds


def test_bend_load_over_that_at_which_mixed_lubrication_begins():
    claim = make_claim("value", "bend_load_over_mixed_load", 1.0, 0.3, relative=True, **AGAINST_DRY)
    same, early, never = (
        judged(claim, by_viscosity(STRAIGHT, bending(1e-5, np.where(mixed > LOADS, 1.0, 0.8))))
        for mixed in (1e-5, 4e-6, 1.0)
    )
    assert same.holds
    assert not early.holds and early.value == pytest.approx(2.5, rel=0.3)
    assert not never.tested and not never.holds


def test_reach_holds_where_a_number_is_passed():
    for end, holds in ((0.1, True), (0.5, True), (0.51, True), (0.53, False)):
        verdict = judged(least(0.5, 0.02, "reach"), falling_to(end))
        assert verdict.holds is holds and verdict.value == pytest.approx(end)
    highest = make_claim("reach", "particle_contact_area_ratio", 0.9, 0.02, extreme="maximum")
    assert judged(highest, make_curve(ratio=0.95)).holds
    assert not judged(highest, make_curve(ratio=0.85)).holds


def test_window_compares_both_ends_on_each_surface():
    claim = make_claim("window", "", [0.8, 1.3], 0.05, given={"roughness_nm": [100, 500]})
    assert judged(claim, window=lambda roughness: (0.82, 1.27)).holds
    one_off = judged(claim, window=lambda roughness: (0.8, 1.3 if roughness < 2e-7 else 1.5))
    assert not one_off.holds and one_off.deviation == pytest.approx(0.2)
    assert one_off.score == pytest.approx(1.0 + np.log(4.0))
    assert judged(claim, window=lambda roughness: (np.nan, np.nan)).score == MISSING_SCORE


def test_a_span_has_the_published_ends():
    """A curve that passes both numbers and goes on misses its end by how far it goes."""
    claim = make_claim("span", "film_thickness", [1e-4, 2e-4], 0.01, relative=True)
    exact, long, short = (
        judged(claim, make_curve(film=thickest * ratio ** (-DECADES / 3)))
        for thickest, ratio in ((2e-4, 2.0), (4e-4, 4.0), (1.9e-4, 1.9))
    )
    assert exact.holds and exact.computed == "1e-4 to 2e-4"
    assert not long.holds and long.value == pytest.approx(4e-4)
    assert not short.holds and short.value == pytest.approx(1.9e-4)


def loads_of_mixing(*loads):
    """Verdict that curves are mixed from ever larger loads, where they are from these."""
    given = viscosities(len(loads)) | {"solid_load_fraction": 0.9}
    claim = make_claim(
        "trend", "load", relative=True, given=given, along="curves", direction="increasing"
    )
    curves = (make_curve(solid=1.0 - 0.1 * LOADS / load) for load in loads)
    return judged(claim, by_viscosity(*curves))


def test_the_order_of_loads_beyond_the_last_is_tested_where_it_is_known():
    verdict = loads_of_mixing(1e-6, 1e-5, 2e-4)
    assert verdict.tested and verdict.holds and verdict.computed.endswith("> 1e-4")
    wrong = loads_of_mixing(1e-6, 2e-4, 1e-5)
    assert wrong.tested and not wrong.holds
    for loads in ((1e-6, 2e-4, 3e-4), (1e-6, 3e-4, 2e-4)):
        verdict = loads_of_mixing(*loads)
        assert not verdict.tested and not verdict.holds


def test_a_load_beyond_the_last_fails_where_the_last_is_too_large_already():
    for load, tested in ((1e-5, True), (5e-5, True), (9e-5, False)):
        claim = make_claim("value", "load", load, 0.3, True, {"solid_load_fraction": 0.9})
        verdict = judged(claim, make_curve(solid=1.0 - 0.1 * LOADS / 1.2e-4))
        assert verdict.tested is tested and not verdict.holds


@pytest.mark.parametrize(
    ("limit", "words"),
    [
        ({"load": 1e-5}, "F_t* = 1e-5"),
        ({"load_max": 1e-5}, "F_t* at most 1e-5"),
        ({"load_max_N": 2.4}, "F_t at most 2.4 N"),
        ({"solid_load_fraction": 0.9}, "L_s = 0.9"),
        ({"solid_load_fraction_min": 0.03}, "L_s at least 0.03"),
        ({"total_contact_area_slope_max": 0.5}, "the slope of A_t* at most 0.5"),
    ],
)
def test_conditions_on_the_loads_are_written_with_symbols(limit, words):
    assert least(1.0, given=limit).curves_text.endswith(f"; {words}")


def test_a_condition_that_no_load_meets_is_not_tested():
    given = {"solid_load_fraction_max": 0.5}
    claim = make_claim("value", "particle_contact_area_ratio", 0.5, given=given, extreme="minimum")
    assert judged(claim, make_curve(ratio=0.5, solid=0.4)).holds
    verdict = judged(claim, make_curve(ratio=0.5, solid=0.6))
    assert not verdict.tested and not verdict.holds and verdict.score > 1.0
    drawn = judged(replace(claim, must_be_reached=True), make_curve(ratio=0.5, solid=0.6))
    assert drawn.tested and not drawn.holds
    assert drawn.finding == (
        "No load of the paper has L_s at most 0.5, though the paper draws one; "
        "the nearest misses this by 0.1."
    )


def ordering(direction="increasing", given=None, **fields):
    given = given or viscosities(3)
    fields |= {"relative": True, "given": given, "direction": direction}
    return make_claim("ordering", "total_contact_area", None, 0.02, **fields)


def test_ordering_of_curves():
    rising = [make_curve(area=factor * LOADS) for factor in (1.0, 1.2, 1.5)]
    assert judged(ordering(), by_viscosity(*rising)).holds
    assert not judged(ordering(), by_viscosity(*rising[::-1])).holds
    assert judged(ordering("decreasing"), by_viscosity(*rising[::-1])).holds
    assert not judged(ordering(), by_viscosity(rising[0], *rising[:0:-1])).holds
    identical = judged(ordering(), make_curve())
    assert not identical.holds and identical.score == pytest.approx(1.0 + np.log(2.0))


def test_the_distance_in_an_order_is_said_to_be_that_of_the_two_nearest_curves():
    curves = by_viscosity(*(make_curve(area=factor * LOADS) for factor in (1.0, 1.2, 1.5)))
    assert judged(ordering(), curves).finding == (
        "A_t*: in this order, the two nearest apart by up to 20 %."
    )
    two = judged(ordering(given=viscosities(2)), curves)
    assert two.finding == "A_t*: in this order, apart by up to 20 %."


def test_bounds_on_other_quantities_choose_the_loads():
    solid = np.where(LOADS < 1e-6, 1.0, 0.5)
    other = make_curve(area=LOADS * (LOADS / 9e-7) ** 0.5, solid=solid)
    crossing = by_viscosity(make_curve(solid=solid), other)
    mixed, short = (
        judged(ordering(given=viscosities(2) | {"solid_load_fraction_max": most}), crossing)
        for most in (0.9, 0.03)
    )
    assert mixed.holds
    assert not short.holds and short.computed == "not reached, by 0.47"


@pytest.mark.parametrize(("thickest", "holds"), [(0.5, True), (1.1, False)])
def test_ordering_against_a_reference_on_the_same_axis(thickest, holds):
    curves = by_viscosity(*(make_curve(area=factor * LOADS) for factor in (1.0, 0.9, thickest)))
    claim = ordering("decreasing", {"viscosity_cSt": [10, 20]}, reference=DRY)
    assert judged(claim, curves).holds is holds


def coincidence(**fields):
    fields |= {"given": {"viscosity_cSt": [10, 20]}, "reference": DRY}
    return make_claim("coincidence", "particle_contact_area_ratio", None, 0.05, **fields)


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


COURSES = {
    "increasing": DECADES,
    "decreasing": 3.0 - DECADES,
    "constant": 0.0 * DECADES,
    "rising_then_falling": DECADES * (3.0 - DECADES),
    "falling_then_rising": 3.0 - DECADES * (3.0 - DECADES),
}


def along_load(direction):
    given = {"along": "load", "direction": direction}
    return make_claim("trend", "particle_contact_area_ratio", None, 0.01, **given)


ABSENT = make_claim("absence", "particle_contact_area_ratio", None, 0.01)


@pytest.mark.parametrize("direction", COURSES)
@pytest.mark.parametrize("shown", COURSES)
def test_trend_along_load(direction, shown):
    curve = make_curve(ratio=0.2 + 0.2 * COURSES[shown])
    assert judged(along_load(direction), curve).holds is (direction == shown)
    assert judged(ABSENT, curve).holds is (shown != "rising_then_falling")


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
    fields = {"given": viscosities(3), "along": "curves", "direction": direction}
    claim = make_claim("trend", "turning_point_load", None, 0.05, relative=True, **fields)
    point = by_viscosity(*(turning(load) for load in loads))
    assert judged(claim, turning_point=point).holds is holds


def test_trend_of_a_change_from_a_reference():
    dense = {"roughness_nm": [100, 300], "particle_density_per_m2": 5.0e11}
    fields = {"given": dense, "reference": {"particle_density_per_m2": 1.0e10}}
    fields |= {"along": "curves", "direction": "increasing"}
    claim = make_claim("trend", "turning_point_load", None, 0.02, **fields)

    def point(condition):
        sparse = condition.particle_density < 1e11
        return turning(1e-6 if sparse else 10 * condition.roughness)

    verdict = judged(claim, turning_point=point)
    assert verdict.computed == "0, 2" and verdict.holds


def regimes(*published, **fields):
    return make_claim("regime_sequence", "", published, 0.02, **fields)


def modes(*published):
    return make_claim("mode_sequence", "", published, 0.02)


ALL_REGIMES = "boundary", "mixed", "full_film"
ALL_MODES = "particle_surface", "hybrid", "surface_surface"
BOTH = "boundary particle_surface", "boundary hybrid", "mixed hybrid", "mixed surface_surface"
CLIPPED = np.clip(1.2 - 0.5 * DECADES, 0.0, 1.0)
FALLING = make_curve(solid=CLIPPED)
IN_BOTH = make_curve(
    ratio=np.interp(DECADES, [0, 1, 2, 3], [1, 1, 0.02, 0.01]),
    solid=np.interp(DECADES, [0, 1.5, 3], [1, 1, 0.1]),
)


@pytest.mark.parametrize(
    ("claim", "curve", "holds"),
    [
        (regimes(*ALL_REGIMES), FALLING, True),
        (regimes("boundary", "mixed"), FALLING, False),
        (regimes("mixed", "full_film"), FALLING, False),
        (regimes(*ALL_REGIMES[::-1]), FALLING, False),
        (regimes("boundary"), make_curve(), True),
        (modes(*ALL_MODES), make_curve(ratio=CLIPPED), True),
        (modes(*ALL_MODES[:2]), make_curve(ratio=CLIPPED), False),
        (modes(*ALL_MODES), make_curve(ratio=0.99), False),
        (regimes(*BOTH), IN_BOTH, True),
        (regimes(*(BOTH[index] for index in (0, 2, 1, 3))), IN_BOTH, False),
        # the last step may lie beyond the loads where that is said
        (regimes(*ALL_REGIMES), falling_to(0.2), False),
        (regimes(*ALL_REGIMES, open_end=True), falling_to(0.2), True),
        (regimes(*ALL_REGIMES, open_end=True), FALLING, True),
        # a step with alternatives
        (modes("hybrid or surface_surface"), make_curve(ratio=0.05 * DECADES), True),
        (modes("hybrid or surface_surface"), make_curve(ratio=0.99), False),
    ],
)
def test_sequences(claim, curve, holds):
    verdict = judged(claim, curve)
    assert verdict.holds is holds
    if curve is FALLING:
        assert verdict.computed == "boundary > mixed > full_film"


def test_one_of_several_curves_may_be_enough():
    for claim, curve in ((least(0.9, 0.02), falling_to(0.9)), (regimes(*ALL_REGIMES), FALLING)):
        several = replace(claim, conditions=claim.conditions | viscosities(2))
        curves = by_viscosity(make_curve(), curve)
        assert not judged(several, curves).holds
        assert judged(replace(several, any_curve=True), curves).holds


def test_a_kink_is_no_gradual_departure():
    fields = {"extreme": "minimum"} | AGAINST_DRY
    claim = make_claim("reach", "departure_sharpness", 0.8, **fields)
    decades = np.minimum(DECADES, 1.5), DECADES - np.logaddexp(0, 4 * DECADES - 6) / 4
    dry, kink, bend = (make_curve(film=2e-4 * 10 ** (-0.2 * x)) for x in (DECADES, *decades))
    sharp = judged(claim, by_viscosity(dry, kink))
    assert sharp.value == pytest.approx(1.0, abs=0.01) and not sharp.holds
    assert judged(claim, by_viscosity(dry, bend)).holds


def test_score_of_a_value_is_continuous_and_grows_with_the_distance():
    claim = make_claim("value", "turning_point_load", 1e-5, relative=True)
    loads = 1e-5 * np.geomspace(0.01, 100.0, 4001)
    verdicts = [judged(claim, **at_load(load)) for load in loads]
    scores = np.array([verdict.score for verdict in verdicts])
    assert np.array_equal([verdict.holds for verdict in verdicts], np.abs(loads / 1e-5 - 1) <= 0.1)
    assert scores.min() == pytest.approx(0.0, abs=1e-9)
    assert np.abs(np.diff(scores)).max() < 0.03
    assert np.all(np.diff(scores[:2001]) <= 0.0) and np.all(np.diff(scores[2000:]) >= 0.0)


# a claim, and curves that go from right to wrong as x goes from 0 to 1
RATIO = 0.3 + 0.05 * DECADES
WORSENING = {
    "ordering": (
        ordering(given=viscosities(2)),
        lambda x: by_viscosity(make_curve(), make_curve(area=LOADS * (1.1 - 0.2 * x))),
    ),
    "coincidence": (
        coincidence(),
        lambda x: by_viscosity(*(make_curve(ratio=RATIO + s * x) for s in (0, 0.1, 0.2))),
    ),
    "absence": (ABSENT, lambda x: make_curve(ratio=RATIO - 0.05 * x * DECADES**2)),
    "mode_sequence": (
        modes("particle_surface", "hybrid"),
        lambda x: make_curve(ratio=np.linspace(1.0 - 0.3 * x, 0.5, LOADS.size)),
    ),
    "level": (
        make_claim("value", "load", 5e-5, 0.5, relative=True, given={"solid_load_fraction": 0.9}),
        lambda x: make_curve(solid=1.0 - 0.15 * (1.0 - x) * LOADS / LOADS[-1]),
    ),
}


@pytest.mark.parametrize("kind", WORSENING)
def test_scores_are_continuous(kind):
    claim, curve = WORSENING[kind]
    scores = np.array([judged(claim, curve(x)).score for x in np.linspace(0.0, 1.0, 1001)])
    assert scores[0] < 1.0 < scores[-1]
    assert np.abs(np.diff(scores)).max() < 0.1


def test_unsolved_points_are_no_evidence():
    half = make_curve(solid=0.5, solved=LOADS < 1e-5)
    film = {"along": "load", "direction": "decreasing"}
    everywhere = [
        least(0.5),
        make_claim("span", "film_thickness", [1e-4, 2e-4], relative=True),
        make_claim("coincidence", "solid_load_fraction", reference=DRY),
        ordering(reference=DRY),
        make_claim("trend", "film_thickness", **film),
        *(ABSENT, regimes("mixed"), modes("hybrid")),
    ]
    for claim in everywhere:
        verdict = judged(claim, half)
        assert verdict.score == MISSING_SCORE and not verdict.holds, claim.kind
    assert judged(least(0.5, given={"load_max": 5e-6}), half).holds


def test_what_is_said_of_a_turning_point_fails_where_it_does_not_stand_out():
    claim = make_claim("value", "turning_point_load", 1e-5, relative=True)
    verdicts = [judged(claim, **at_load(1e-5, high)) for high in (0.1, 0.02, 0.019, 0.001, 0.0)]
    assert [verdict.holds for verdict in verdicts] == [True, True, False, False, False]
    scores = [verdict.score for verdict in verdicts]
    assert scores == sorted(scores) and scores[2] < 1.2 and scores[4] == MISSING_SCORE
    assert verdicts[2].computed == "1e-5; stands out by 0.019"


def test_conditions_are_si_and_run_together():
    given = dict(zip(CONDITION_KEYS, (120, [100, 300], [100, 300], 1.0e11), strict=True))
    claim = make_claim("coincidence", "film_thickness", given=given, reference=DRY)
    assert claim.curves == ((1.2e-4, 1e-7, 1e-7, 1e11), (1.2e-4, 3e-7, 3e-7, 1e11))
    assert claim.references == ((0.0, 1e-7, 1e-7, 1e11), (0.0, 3e-7, 3e-7, 1e11))


@pytest.fixture(scope="module")
def paper():
    return claims.load_claims(CONFIG)


def test_paper_has_its_statements(paper):
    assert len(paper) >= 70 and all(claim.all_figures for claim in paper)
    assert {claim.kind for claim in paper} == set(KINDS)
    assert max(Counter(claim.id for claim in paper).values()) == 1
    assert all(claim.statement.endswith(".") and claim.reason for claim in paper)


REQUIRED = {
    "value": ("quantity", "published"),
    "reach": ("quantity", "published", "extreme"),
    "span": ("quantity", "published"),
    "window": ("published",),
    "ordering": ("quantity", "direction"),
    "coincidence": ("quantity", "reference"),
    "trend": ("quantity", "direction", "along"),
    "absence": ("quantity",),
    "regime_sequence": ("published",),
    "mode_sequence": ("published",),
}


@pytest.mark.parametrize("kind", REQUIRED)
def test_a_statement_has_the_fields_of_its_kind_and_no_others(kind, tmp_path):
    entry = next(entry for entry in read_yaml(CONFIG, list) if entry["kind"] == kind)
    wrong = [{key: entry[key] for key in entry if key != name} for name in REQUIRED[kind]]
    if kind == "ordering":  # of one curve
        wrong.append({key: entry[key] for key in entry if key != "reference"})
        wrong[-1]["conditions"] = dict.fromkeys(entry["conditions"], 1.0)
    for number, other in enumerate([*wrong, entry | {"level": 1.0}]):
        path = tmp_path / f"{number}.yaml"
        path.write_text(yaml.safe_dump([other]))
        with pytest.raises(ValueError, match=entry["id"]):
            claims.load_claims(path)


def test_figures_of_a_statement():
    for place, figures in (
        ("Figures 4B and 4C, section 3.3", {4}),
        ("Figures 4 to 7, section 3.3", {4, 5, 6, 7}),
        ("Figure 5B and the discussion of Figure 12C, section 3.3", {5, 12}),
        ("Conclusion 5", set()),
    ):
        claim = replace(least(0.5), place=place)
        assert claim.all_figures == figures
        assert replace(claim, figures=[9, 10]).all_figures == figures | {9, 10}


def test_one_width_makes_a_turning_point_visible(paper):
    for claim in paper:
        if claim.kind == "absence" or claim.direction == "rising_then_falling":
            assert claim.tolerance == PROMINENCE, claim.id


def test_printed_loads_of_turning_points_are_fine_where_dry_and_half_a_step_where_lubricated(paper):
    loads = [each for each in paper if each.quantity == "turning_point_load" and each.published]
    assert len(loads) == 6
    for claim in loads:
        is_dry = not np.any(claim.conditions["viscosity_cSt"])
        expected = ("relative", 0.05) if is_dry else ("factor", 1.41)
        assert (claim.tolerance_kind, claim.tolerance) == expected, claim.id


def test_what_no_inputs_can_meet_follows_from_the_papers_own_numbers(paper):
    numbers = {claim.id: claim.published for claim in paper}
    (claim,) = (each for each in paper if each.limit)
    load = numbers["fig11a-turning-point-load-at-120cst"]
    solid = numbers["fig11b-solid-share-at-turning-point"]
    # five times as many particles at the same separation carry five times as much
    most = load * (5.0 * solid + 1.0 - solid)
    assert f"at most {1e5 * most:.2f}e-5" in claim.limit
    assert most < claim.published == 3.0e-5


LEFT_OUT = object()
WINDOW = {"kind": "window", "published": [0.8, 1.2], "quantity": LEFT_OUT, "extreme": LEFT_OUT}
ORDER = {"kind": "ordering", "published": LEFT_OUT, "extreme": LEFT_OUT, "direction": "increasing"}
TREND = {"kind": "trend", "published": LEFT_OUT, "direction": "increasing", "along": "load"}
STATES = {"kind": "mode_sequence", "quantity": LEFT_OUT, "extreme": LEFT_OUT}
BAD_STATEMENTS = [  # the fields that differ from a good statement, and what the line says
    # fields of all kinds
    ({"id": LEFT_OUT}, ": 1: id: "),
    ({"kind": LEFT_OUT}, "kind: "),
    ({"kind": "opinion"}, "kind is 'opinion'; allowed: value, reach, span, "),
    ({"quote": LEFT_OUT}, "quote: "),
    ({"statement": 5}, "statement is 5; "),
    ({"level": 1.0}, "level is 1.0; "),
    ({"figures": ["4"]}, "figures.0 is '4'; "),
    ({"must_be_reached": "yes"}, "must_be_reached is 'yes'; "),
    ({"aside": "why"}, "aside without contradicts; allowed: "),
    # the tolerance
    ({"tolerance": LEFT_OUT}, "tolerance: "),
    ({"tolerance": 0.1}, "tolerance is 0.1; "),
    ({"tolerance": {"absolute": 0.1}}, "tolerance.reason: "),
    ({"tolerance": {"reason": "why"}}, "allowed: one of absolute, relative and factor"),
    ({"tolerance": {"absolute": 1.0, "factor": 2.0, "reason": "why"}}, "allowed: one of absolute"),
    ({"tolerance": {"share": 1.0, "reason": "why"}}, "tolerance.share is 1.0; "),
    ({"tolerance": {"absolute": "1", "reason": "why"}}, "tolerance.absolute is '1'; "),
    ({"tolerance": {"absolute": 0.0, "reason": "why"}}, "the absolute tolerance is 0; allowed: "),
    ({"tolerance": {"relative": 1.5, "reason": "why"}}, "the relative tolerance is 1.5; allowed: "),
    ({"tolerance": {"factor": 0.5, "reason": "why"}}, "the factor tolerance is 0.5; allowed: "),
    # the conditions
    ({"conditions": [1]}, "conditions"),
    ({"conditions": {"roughness_nm": LEFT_OUT}}, "conditions have no roughness_nm; allowed: "),
    ({"conditions": {"viscosity_cSt": -1}}, "conditions: viscosity_cSt.0 is -1; "),
    (
        {"conditions": {"viscosity_cSt": 0.05}},
        "viscosity_cSt.0 is 0.05; allowed: 0, or 0.3 or more",
    ),
    ({"conditions": {"roughness_nm": "300"}}, "conditions: roughness_nm.0 is '300'; "),
    ({"conditions": {"roughness_nm": []}}, "conditions: roughness_nm is []; "),
    ({"conditions": {"roughness": 300}}, "conditions: 'roughness' is no condition; allowed: "),
    ({"conditions": {"load": float("nan")}}, "conditions: load is nan; "),
    ({"conditions": {"load_max_N": 1e9}}, "conditions: load_max_N is 1000000000.0; "),
    ({"conditions": {"load": 1e-5, "solid_load": 1e-6}}, "load and solid_load have a level; "),
    (
        {"conditions": {"viscosity_cSt": [0, 9, 90], "roughness_nm": [100, 300]}},
        "conditions: lists of [2, 3] values; allowed: lists of one length",
    ),
    ({"reference": {"viscosity": 0}}, "reference: viscosity is 0.0; "),
    ({"reference": {"viscosity_cSt": [0]}}, "reference.viscosity_cSt is [0]; "),
    # one number of each curve
    ({"published": LEFT_OUT}, "published: "),
    ({"published": "1"}, "published is '1'; "),
    ({"published": float("inf")}, "published is inf; "),
    ({"quantity": "friction"}, "quantity is 'friction'; allowed: load, solid_load, "),
    ({"extreme": "mean"}, "extreme is 'mean'; "),
    ({"extreme": LEFT_OUT}, "solid_load_fraction of a whole curve; allowed: a condition with"),
    ({"kind": "reach", "extreme": LEFT_OUT}, "extreme: "),
    ({"quantity": "bend_load"}, "bend_load without reference; allowed: "),
    ({"any_curve": 1}, "any_curve is 1; "),
    # other kinds
    (WINDOW | {"published": [1.0]}, "published is [1.0]; "),
    (WINDOW | {"conditions": {"roughness_nm": LEFT_OUT}}, "no roughness_nm; allowed: roughness_nm"),
    (ORDER, "an order of one curve; allowed: two or more, or a reference"),
    (ORDER | {"direction": "constant"}, "direction is 'constant'; "),
    (ORDER | {"quantity": "window_low"}, "quantity is 'window_low'; allowed: load, "),
    (TREND | {"direction": "up"}, "direction is 'up'; allowed: increasing, decreasing, "),
    (TREND | {"along": "time"}, "along is 'time'; "),
    (TREND | {"along": "curves"}, "a trend along one curve; allowed: two curves or more"),
    (TREND | {"quantity": "turning_point_load"}, "turning_point_load along the load; allowed: "),
    (STATES | {"published": []}, "published is []; "),
    (STATES | {"published": ["dry"]}, "published.0 is 'dry'; allowed: boundary, mixed, "),
    (STATES | {"published": ["hybrid or"]}, "published.0 is 'hybrid or'; allowed: "),
]


def statement(changes):
    """An entry of the statements: a good one, with ``changes``."""
    entry = {"id": "least", "place": "Figure 4A", "statement": "words", "quote": "words"}
    entry |= {"kind": "value", "quantity": "solid_load_fraction", "published": 0.5}
    entry |= {"extreme": "minimum", "tolerance": {"absolute": 0.1, "reason": "digits"}}
    conditions = dict.fromkeys(CONDITION_KEYS, 0) | {"roughness_nm": 300}
    conditions["particle_diameter_nm"] = 300
    if isinstance(changes.get("conditions", {}), dict):
        changes = changes | {"conditions": present(conditions | changes.get("conditions", {}))}
    return present(entry | changes)


def present(mapping):
    return {key: value for key, value in mapping.items() if value is not LEFT_OUT}


def loaded(folder, *entries):
    path = folder / "mine.yaml"
    path.write_text(yaml.safe_dump([*entries]))
    return claims.load_claims(path)


@pytest.mark.parametrize(("changes", "expected"), BAD_STATEMENTS)
def test_a_bad_statement_is_refused_in_one_line_that_names_it(changes, expected, tmp_path):
    assert [claim.published for claim in loaded(tmp_path, statement({}))] == [0.5]
    with pytest.raises(ValueError) as refused:
        loaded(tmp_path, statement(changes))
    message = str(refused.value)
    assert message.startswith(f"{tmp_path / 'mine.yaml'}: ")
    assert expected in message and ("'least'" in message or "id" in changes)
    assert "\n" not in message and len(message) < 600


def test_two_statements_with_one_id_are_refused(tmp_path):
    with pytest.raises(ValueError, match="'least': another statement has this id"):
        loaded(tmp_path, statement({}), statement({"published": 0.6}))


def test_what_is_no_statement_is_refused(tmp_path):
    with pytest.raises(ValueError, match="mine.yaml: 2: "):
        loaded(tmp_path, statement({}), "word")
