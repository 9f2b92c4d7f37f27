"""Quantities that compare whole curves: the load at which two curves part or cross, and the
sharpness of the departure."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from chenhorng.sampling import TINY, first_fall, logarithm
from thirdbody.core.regimes import BOUNDARY_LIMIT

if TYPE_CHECKING:
    from chenhorng.claims.claim import Claim
    from chenhorng.claims.evidence import Evidence

BEND = 0.1  # decrease of the slope at a visible bend of a curve [1]


def crossings(load: NDArray, areas: NDArray) -> NDArray:
    """Loads F_t* [1] above which A_t* increases from each curve to the next; shape (curves -
    1,)."""
    gaps = np.diff(logarithm(areas), axis=0)
    return np.array([first_fall(load[::-1], gap[::-1]) for gap in gaps])


def bend_load(load: NDArray, slope: NDArray, reference: NDArray) -> float:
    """The load F_t* [1] at which the ``slope`` of A_t* has fallen by ``BEND`` below the slope of
    the reference.
    """
    return first_fall(load, BEND - (reference - slope))


def reversal_load(claim: "Claim", evidence: "Evidence") -> list[float]:
    """Load F_t* [1] above which A_t* increases from curve to curve, in the order of the claim."""
    return [np.max(crossings(*claim.table(evidence, claim.curves, "total_contact_area")))]


def bend_loads(claim: "Claim", evidence: "Evidence") -> list[float]:
    """Loads F_t* [1] at which the slope of A_t* has fallen by ``BEND`` below the slope of the
    reference."""
    slope = "total_contact_area_slope"
    pairs = claim.pairs(evidence)
    return [bend_load(curve["load"], curve[slope], other[slope]) for other, curve in pairs]


def mixed_loads(claim: "Claim", evidence: "Evidence") -> list[float]:
    """Loads F_t* [1] at which mixed lubrication begins."""
    curves = [evidence.curves[condition] for condition in claim.curves]
    excess = [logarithm(curve["solid_load_fraction"] / BOUNDARY_LIMIT) for curve in curves]
    return [first_fall(curve["load"], above) for curve, above in zip(curves, excess)]


def departure_sharpness(claim: "Claim", evidence: "Evidence") -> list[float]:
    """Sharpness of the departure of H_c from the reference [1]; 1 at a kink.

    The ratio of both H_c has a slope on logarithmic axes.  The sharpness is the largest change of
    this slope within a tenth of a decade, divided by the largest slope.
    """
    sharpness = []
    for dry, wet in claim.pairs(evidence):
        log_load = np.log(wet["load"])
        slope = np.diff(logarithm(wet["film_thickness"] / dry["film_thickness"])) / np.diff(
            log_load
        )
        middle = 0.5 * (log_load[1:] + log_load[:-1])
        later = np.interp(middle + 0.1 * np.log(10.0), middle, slope)
        sharpness.append(np.max(later - slope) / np.maximum(np.max(slope), TINY))
    return sharpness


LOADS_BETWEEN_CURVES = {
    "total_contact_area_reversal_load": reversal_load,
    "bend_load": bend_loads,
    "bend_load_over_mixed_load": lambda claim, evidence: np.divide(
        bend_loads(claim, evidence), mixed_loads(claim, evidence)
    ),
}
BETWEEN_CURVES = LOADS_BETWEEN_CURVES | {"departure_sharpness": departure_sharpness}
