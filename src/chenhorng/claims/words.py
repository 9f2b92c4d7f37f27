"""The words of verdicts, and the sentences on results beside the statements of the paper."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from thirdbody.variables import QUANTITIES

# verdicts
HOLDS, FAILS, NOT_TESTED = "holds", "fails", "not tested"
CONTRADICTED = "contradicted by the paper itself"
# the colour of each verdict in bars, figures and pages, on white and on dark paper
COLOURS = {HOLDS: "#0072B2", FAILS: "#D55E00", CONTRADICTED: "#E69F00", NOT_TESTED: "#999999"}
# quantities as the subject of a sentence: the symbol, or other words if they are clearer
NAMES = {name: quantity.symbol for name, quantity in QUANTITIES.items()} | {
    "total_contact_area_slope": "the slope of A_t*",
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
    "bend_load_over_mixed_load": "Over the load at which mixed lubrication begins "
    "that of the bend is",
    "departure_sharpness": "The sharpness of the departure is",
    "window_low": "Turning points begin at x_a/sigma of",
    "window_high": "Turning points end at x_a/sigma of",
}
EXTREMES = {"minimum": "the least ", "maximum": "the largest "}


def counted_once(outcomes: Iterable[tuple[str, str]]) -> tuple[int, int]:
    """Numbers of names that hold and are tested, from names and verdicts; a name that repeats
    holds if all that is tested under it does."""
    held: dict[str, bool] = {}
    for name, verdict in outcomes:
        if verdict in (HOLDS, FAILS):
            held[name] = held.get(name, True) and verdict == HOLDS
    return sum(held.values()), len(held)


def listed(texts: Sequence[str]) -> str:
    """The different ``texts`` as a list in a sentence."""
    *others, last = dict.fromkeys(texts)
    return f"{', '.join(others)} and {last}" if others else last


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
    return BEGINNINGS.get(quantity) or f"{EXTREMES.get(extreme, '')}{NAMES[quantity]} is"


def size(gap: float, is_relative: bool) -> str:
    """A ``gap`` between curves as text; a gap of logarithms is in per cent or a factor."""
    if not is_relative:
        return f"{gap:.3g}"
    factor = np.exp(gap)
    return f"a factor of {factor:.3g}" if factor > 2.0 else f"{100.0 * (factor - 1.0):.3g} %"


def passed(states: Sequence[str]) -> str:
    """The ``states`` in the order in which a curve passes them."""
    return ", then ".join(state.replace("_", "-") for state in states)
