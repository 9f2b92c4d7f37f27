"""The words of verdicts, and the sentences on results beside the statements of the paper."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from itertools import groupby
from typing import Any

import numpy as np

from chenhorng.places import part_of_paper
from thirdbody.symbols import short
from thirdbody.variables import QUANTITIES

DIGITS = 3  # of computed numbers

# verdicts
HOLDS, FAILS, NOT_TESTED = "holds", "fails", "not tested"
CONTRADICTED = "contradicted by the paper itself"
# the colour of each verdict in bars, figures and pages, on white and on dark paper
COLOURS = {HOLDS: "#0072B2", FAILS: "#D55E00", CONTRADICTED: "#E69F00", NOT_TESTED: "#C4C4C4"}
SEVERAL = {HOLDS: "hold", FAILS: "fail"}  # of several statements
# quantities as the subject of a sentence: the symbol, or other words if they are clearer
NAMES = {name: quantity.symbol for name, quantity in QUANTITIES.items()} | {
    "total_contact_area_slope": "the slope of A_t*",
    "load": "F_t*",
    "solid_load": "L_s F_t*",
    "real_contact_pressure": "L_s F_t*/A_t*",
    "turning_point_ratio": "A_sa,t* at the turning point",
    "turning_point_solid_load_fraction": "L_s at the turning point",
    "turning_point_solid_load": "L_s F_t* at the turning point",
    "turning_point_load": "F_TPCA*",
}
# the beginning of a sentence on other quantities
BEGINNINGS = {
    "turning_point_load": "The turning point is at",
    "bend_load": "The slope falls at",
    "total_contact_area_reversal_load": "The order reverses at",
    "bend_load_over_mixed_load": (
        "The load of the bend over that at which mixed lubrication begins is"
    ),
    "departure_sharpness": "The sharpness of the departure is",
    "window_low": "Turning points begin at x_a/sigma of",
    "window_high": "Turning points end at x_a/sigma of",
}
BOUNDS = {"min": "at least", "max": "at most"}
EXTREMES = {"minimum": "the least ", "maximum": "the largest "}


def counted_once(outcomes: Iterable[tuple[str, str]]) -> tuple[int, int]:
    """Numbers of names that hold and are tested, from names and verdicts; a name that repeats
    holds if all that is tested under it does."""
    held: dict[str, bool] = {}
    for name, verdict in outcomes:
        if verdict in (HOLDS, FAILS):
            held[name] = held.get(name, True) and verdict == HOLDS
    return sum(held.values()), len(held)


def counts_by_part(rows: Iterable[Mapping[str, Any]]) -> dict[str, Counter[str]]:
    """How many statements of each part of the paper have each verdict, from rows with ``place``
    and ``verdict``."""
    counts: dict[str, Counter[str]] = {}
    for row in rows:
        counts.setdefault(part_of_paper(row["place"]), Counter())[row["verdict"]] += 1
    return counts


def counted(counts: Mapping[str, float]) -> str:
    """Numbers of statements by their verdict in words: 8 hold, 1 fails."""
    return ", ".join(
        f"{counts[verdict]:g} {verdict if counts[verdict] == 1 else SEVERAL.get(verdict, verdict)}"
        for verdict in COLOURS
        if counts[verdict]
    )


def counts_sentence(rows: Sequence[Mapping[str, Any]]) -> str:
    """How many statements, from rows of the table ``claims``, have each verdict, repeats included,
    and how many are left without repeats."""
    counts = Counter(row["verdict"] for row in rows)
    _, once = counted_once((row["cluster"] or row["id"], row["verdict"]) for row in rows)
    return (
        f"With repeats the paper makes {len(rows)} statements: {counted(counts)}. "
        f"The {counts[HOLDS] + counts[FAILS]} that hold or fail are {once} without repeats."
    )


def sentence(text: str, *others: str) -> str:
    """A sentence of all parts that are not empty."""
    parts = filter(None, (text[0].upper() + text[1:], *others))
    return f"{'; '.join(parts)}."


def beginning(quantity: str, extreme: str, limits: Mapping[str, float], is_change: bool) -> str:
    """The beginning of a sentence whose object is a number; ``limits`` have the level of a quantity
    that determines a load.
    """
    if is_change:
        return f"{NAMES[quantity]} changes by"
    if quantity == "load":
        return (
            " and ".join(f"{NAMES[name]} falls to {level:g}" for name, level in limits.items())
            + " at"
        )
    if quantity in BEGINNINGS:
        return BEGINNINGS[quantity]
    name = NAMES[quantity]
    return f"{EXTREMES[extreme]}{name.removeprefix('the ')} is" if extreme else f"{name} is"


def bound(key: str, value: float) -> str:
    """A condition on the loads in words, from its key and value: L_s at most 0.9."""
    if key == "load_max_N":
        return f"F_t at most {value:g} N"
    quantity, _, end = key.rpartition("_")
    if end in BOUNDS:
        return f"{NAMES[quantity]} {BOUNDS[end]} {number(value)}"
    return f"{NAMES[key]} = {number(value)}"


def number(value: float, digits: int = DIGITS) -> str:
    """A ``value`` with some ``digits``: 0.208, 3.41e-6."""
    text = f"{value:.{digits}g}"
    if 0.0 < abs(value) < 1e-3 and "e" not in text:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        text = f"{float(mantissa):g}e{exponent}"
    return short(text)


def size(gap: float, is_relative: bool) -> str:
    """A ``gap`` between curves as text; a gap of logarithms is in per cent or a factor."""
    if not is_relative:
        return number(gap)
    factor = np.exp(gap)
    return (
        f"a factor of {number(factor)}" if factor > 2.0 else f"{number(100.0 * (factor - 1.0))} %"
    )


def named(
    names: Sequence[str], texts: Sequence[str], after_name: str = " ", between: str = ", "
) -> str:
    """The ``texts`` of curves, behind the name of each curve or of the first and the last curve
    with the same text; one text if all are equal."""
    if len({*texts}) == 1:
        return texts[0]
    parts = []
    for text, group in groupby(zip(names, texts, strict=True), key=lambda pair: pair[1]):
        ends = [name for name, _ in group]
        parts.append(f"{' to '.join(dict.fromkeys((ends[0], ends[-1])))}{after_name}{text}")
    return between.join(parts)


def passed(states: Sequence[str], open_end: bool = False) -> str:
    """The ``states`` in the order in which a curve passes them; with an ``open_end`` the last may
    lie beyond the loads."""
    *others, last = [state.replace("_", "-") for state in states]
    last = f"{last} (or beyond the loads)" if open_end else last
    return ", then ".join((*others, last))


def source(published: str, stands_for: str) -> str:
    """Where a ``published`` number comes from: the print, or words that it stands for."""
    return f'{published} is taken for "{stands_for}"' if stands_for else f"{published} is printed"
