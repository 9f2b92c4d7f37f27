"""What cannot be: where inputs or printed numbers are beyond what surfaces or digits allow."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from chenhorng.claims.paper_tables import rounding
from thirdbody.bearings import hertz_contact
from thirdbody.core.film import load_of_film
from thirdbody.core.parameters import Parameters

# A surface with Gaussian heights, the same in all directions, has alpha = m_0 m_4/m_2^2 of at least
# 3/2 (Nayak 1971, J. Lubr. Technol. 93:398). Its summits have the density m_4/(6 pi sqrt(3) m_2)
# and the mean curvature 8/3 sqrt(m_4/pi), so that alpha = 768 pi (eta_s R sigma)^2.
LEAST_ALPHA, ALPHA_OF_SUMMITS = 1.5, 768.0 * math.pi
NEWTONS = 1.0, 10.0, 80.0  # at which the nominal area is compared
POSSIBLE, IMPOSSIBLE = "possible", "impossible"


def nayak_alpha(summit_parameter: float) -> float:
    """Nayak's alpha [1] of an isotropic Gaussian surface with a ``summit_parameter`` eta_s R sigma
    [1]; below 1.5 there is no such surface."""
    return ALPHA_OF_SUMMITS * summit_parameter**2


def limit_rows(
    inputs: Parameters,
    digits: Mapping[str, Any],
    speed: tuple[float, int],
    roughness_nm: tuple[float, float],
) -> list[dict[str, Any]]:
    """Rows of the table ``limits``.

    ``digits`` is the content of ``config/printed_digits.yaml``, ``speed`` the printed U at the high
    end of Table 2 and its digits, ``roughness_nm`` the ends of the roughness in Table 2.
    """
    return [
        *_summits(inputs, np.linspace(*roughness_nm, 5)),
        *_nominal_area(inputs),
        *_film_loads(inputs, digits["film_thicknesses"], speed),
    ]


def _summits(inputs, roughness_nm):
    """Nayak's alpha on each surface, and the scatter of its summits."""
    for sigma in roughness_nm:
        surface = inputs.surface(1e-9 * sigma)
        eta_r_sigma = surface.summit_density * surface.summit_radius * surface.roughness
        alpha = nayak_alpha(float(eta_r_sigma))
        yield _row(
            f"σ = {sigma:g} nm",
            "α of Nayak",
            alpha,
            low=LEAST_ALPHA,
            verdict=POSSIBLE if alpha >= LEAST_ALPHA else IMPOSSIBLE,
            remark=f"η_s R σ is {eta_r_sigma:.3g}; at least "
            f"{math.sqrt(LEAST_ALPHA / ALPHA_OF_SUMMITS):.3g}",
        )
    ratio = inputs.summit_deviation_ratio
    yield _row(
        "any roughness",
        "σ_s/σ",
        ratio,
        high=1.0,
        verdict=POSSIBLE if ratio <= 1.0 else IMPOSSIBLE,
        remark="summits scatter less than the surface that they belong to",
    )


def _nominal_area(inputs):
    """A_n over the area in which the smooth ball would touch."""
    for newtons in NEWTONS:
        area, _ = hertz_contact(newtons, inputs)
        ratio = float(inputs.apparent_area / area)
        remark = f"the ball by Hertz has {1e6 * area:.3g} mm²"
        yield _row(f"F_t = {newtons:g} N", "A_n over the area of Hertz", ratio, remark=remark)


def _film_loads(inputs, thicknesses, speed):
    """The load in W of each printed film thickness, for all U that are rounded to the printed
    one."""
    printed, digits = speed
    least, most = (end / printed for end in rounding(printed, digits))
    for each in thicknesses:
        of_thickness = rounding(each["printed"], each["digits"])
        middle, low, high = (
            _newtons(inputs, each, each["printed"], factor) for factor in (1.0, least, most)
        )
        both = [
            _newtons(inputs, each, thickness, factor)
            for thickness, factor in zip(reversed(of_thickness), (least, most), strict=True)
        ]
        yield _row(
            f"{each['place']}, {each['viscosity_cSt']:g} cSt, H_c = {each['printed']:g}",
            "load in W [N]",
            middle,
            low=low,
            high=high,
            remark=f"{both[0]:.3g} to {both[1]:.3g} N with the digits of H_c as well",
        )


def _newtons(inputs, printed, thickness, factor):
    """The load [N] whose film has a ``thickness`` H_c, with U times ``factor``."""
    changed = replace(inputs, speed_per_viscosity=inputs.speed_per_viscosity * factor)
    load, _ = load_of_film(
        np.array([thickness * inputs.ball_radius]),
        np.array([1e-6 * printed["viscosity_cSt"]]),
        1e-9 * printed["roughness_nm"],
        changed,
    )
    return float(load[0]) * inputs.newtons_per_load


def _row(condition, quantity, value, low=None, high=None, verdict="", remark=""):
    return {
        "condition": condition,
        "quantity": quantity,
        "value": value,
        "low": low,
        "high": high,
        "verdict": verdict,
        "remark": remark,
    }
