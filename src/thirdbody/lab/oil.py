"""Numbers from data sheets of oils: ``oil_viscosity`` at a temperature, and ``cleanliness``, the
particles per area of a film, from the ISO 4406 code."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from numbers import Integral
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from thirdbody.answers.answer import Answer, Row, few_particles
from thirdbody.conditions import checked_number, checked_numbers, common_index, numbers_in
from thirdbody.core.parameters import Parameters
from thirdbody.inputs import or_calibrated
from thirdbody.messages import format_value

if TYPE_CHECKING:
    import pandas as pd

# ISO 3448: kinematic viscosity at 40 C [cSt] of each grade, +-10 %
GRADES = {2: 2.2, 3: 3.2, 5: 4.6, 7: 6.8}
GRADES |= {grade: float(grade) for grade in (10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460)}
GRADES |= {grade: float(grade) for grade in (680, 1000, 1500, 2200, 3200)}
USUAL_INDEX = 95.0  # of the mineral oils in ISO 3448
LEAST, MOST = 2.0, 2e7  # cSt, where ASTM D341 is a line with the constant 0.7
GRADE = re.compile(r"(?:ISO[ -]*)?(?:VG[ -]*)?(\d+)", re.IGNORECASE)
COLDEST, HOTTEST = -70.0, 370.0  # C, of ASTM D341
ZERO = 273.15  # K
# ASTM D2270: rows of seven numbers, described in the file
INDEX = np.loadtxt(Path(__file__).with_suffix(".csv"), delimiter=",")
SIZES = 4, 6, 14  # um(c), the sizes counted in a code of ISO 4406:2021
CODE = re.compile(
    r"(?:ISO(?: *4406)?(?::\d{4})?:?)? *" + "/".join([r" *(\d\d?|[-*]) *"] * len(SIZES))
)
# its Table 1: most particles per mL for scale numbers 0 to 9, times 1000 for each 10 more
MOST_PER_ML = (0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.3, 2.5, 5.0)
LARGEST = 28
USUAL_GAP = {"gap_nm": (1.0, 1e5, "nm")}


def oil_viscosity(
    temperature_C: ArrayLike,
    *,
    grade: int | str | None = None,
    viscosity_index: float | None = None,
    points: Mapping[float, float] | None = None,
) -> NDArray | pd.Series:
    """Kinematic viscosity [cSt] of an oil at a temperature, from the Walther line through two points.

    log10 log10(nu + 0.7) = A - B log10 T, with nu in cSt and T in K (ASTM D341).  It is valid at
    ambient pressure, without shear thinning, ageing or fuel dilution.  Raises ``ValueError`` for an
    unknown grade or impossible index, a number of points other than two, and viscosities below 2 or
    above 2e7 cSt, where the line is not valid.

    Parameters
    ----------
    temperature_C : array_like
        Temperatures [C], or a quantity, from -70 to 370 C; the result has the same shape.  A column of
        pandas gives a column.
    grade : int or str, optional
        ISO viscosity grade, 46 or "ISO VG 46" (ISO 3448): the middle of its range at 40 C, which is +-10 %.
    viscosity_index : float, optional
        Of the oil of a grade, by default 95, that of mineral oils in ISO 3448; gives the second point,
        at 100 C (ASTM D2270, ISO 2909).
    points : mapping, optional
        Instead of these, two temperatures [C] with measured viscosities [cSt].

    Examples
    --------
    >>> import thirdbody as tb
    >>> tb.oil_viscosity([40, 80], grade=46, viscosity_index=100).round(1)
    array([46. , 11.1])
    >>> tb.oil_viscosity([70], points={40: 150, 100: 15}).round(1)
    array([38.5])
    """
    if common_index({"temperature_C": temperature_C}) is not None:
        oil = dict(grade=grade, viscosity_index=viscosity_index, points=points)
        viscosity = oil_viscosity(temperature_C.to_numpy(), **oil)
        return type(temperature_C)(viscosity, temperature_C.index, name="viscosity_cSt")
    temperature = numbers_in("temperature_C", temperature_C, "degC")
    given = f"temperature_C is {format_value(temperature)}"
    if not ((temperature >= COLDEST) & (temperature <= HOTTEST)).all():
        raise ValueError(f"{given}; allowed: {COLDEST:g} to {HOTTEST:g}")
    if (points is None) == (grade is None) or (grade is None and viscosity_index is not None):
        raise ValueError(
            f"grade is {format_value(grade)}, viscosity_index {format_value(viscosity_index)} and "
            f"points {format_value(points)}; allowed: a grade, also with its viscosity_index, or points"
        )
    if points is None:
        if isinstance(grade, str) and (named := GRADE.fullmatch(grade)):
            grade = int(named[1])
        if not isinstance(grade, Integral) or grade not in GRADES:
            allowed = ", ".join(map(str, GRADES))
            raise ValueError(f"grade is {format_value(grade)}; allowed: ISO VG {allowed}")
        index = USUAL_INDEX if viscosity_index is None else viscosity_index
        points = {40.0: GRADES[grade], 100.0: _at_100(GRADES[grade], index)}
    (cold, thick), (hot, thin) = _checked_points(points)
    slope = (_doubled(thick) - _doubled(thin)) / math.log10((hot + ZERO) / (cold + ZERO))
    doubled = _doubled(thick) - slope * np.log10((temperature + ZERO) / (cold + ZERO))
    with np.errstate(over="ignore"):
        viscosity = 10.0 ** (10.0**doubled) - 0.7
    outside = viscosity[~((viscosity >= LEAST) & (viscosity <= MOST))]
    if outside.size:
        raise ValueError(
            f"{given}, which gives {outside[0]:.3g} cSt; allowed: temperatures that give {LEAST:g} "
            f"to {MOST:g} cSt, where ASTM D341 is a line"
        )
    return viscosity


def _checked_points(points):
    """Two temperatures with their viscosities, the colder one first."""
    try:
        cold, hot = sorted(
            (
                float(numbers_in("points", each, "degC")),
                float(numbers_in("points", nu, "cSt")),
            )
            for each, nu in points.items()
        )
        fit = COLDEST <= cold[0] < hot[0] <= HOTTEST and LEAST <= hot[1] < cold[1] <= MOST
    except (AttributeError, TypeError, ValueError):
        fit = False
    if not fit:
        allowed = f"two temperatures [C], each with {LEAST:g} to {MOST:g} cSt"
        message = f"points is {format_value(points)}; allowed: {allowed}, less where it is hotter"
        raise ValueError(message)
    return cold, hot


def _doubled(viscosity):
    return math.log10(math.log10(viscosity + 0.7))


def viscosity_index_of(at_40: float, at_100: float) -> float:
    """Viscosity index of an oil with these viscosities [cSt] at 40 C and, from 2 on, at 100 C (ASTM D2270)."""
    *_, (_, a, b, c, d, e, f) = INDEX[INDEX[:, 0] <= at_100].tolist()
    low = (a * at_100 + b) * at_100 + c
    high = (d * at_100 + e) * at_100 + f
    if at_40 >= high:
        return 100.0 * (low - at_40) / (low - high)
    exponent = math.log10(high / at_40) / math.log10(at_100)
    return 100.0 + (10.0**exponent - 1.0) / 0.00715


def _at_100(at_40, index):
    """Viscosity at 100 C [cSt] of an oil with a viscosity index."""
    index = checked_number("viscosity_index", index, positive=False)
    try:
        return brentq(lambda at_100: viscosity_index_of(at_40, at_100) - index, LEAST, 0.9 * at_40)
    except ValueError:  # no root between the ends
        allowed = f"one that gives an oil of {at_40:g} cSt at 40 C 2 cSt or more at 100 C"
        raise ValueError(f"viscosity_index is {index:g}; allowed: {allowed}") from None


def cleanliness(
    code: str, *, gap_nm: float, parameters: Parameters | None = None, enrichment: float = 1.0
) -> Answer:
    """Particles per area in a film of oil with an ISO 4406 code: the count in the volume of the film.

    The answer has for each size the least and the most particles per m2 of the code's class.  The
    ``code``, such as "18/16/13", counts particles of more than 4, 6 and 14 um(c) in one millilitre; "-"
    or "*" means not counted.  Smaller ones, such as those of the paper (20 to 1000 nm), are never
    counted; there are more of them.  ``gap_nm`` is the thickness of the film, or the separation of the
    surfaces [nm]; ``enrichment`` the ratio of the concentration in the contact to that in the sample
    [1]; of ``parameters``, by default the calibrated ones, A_n is used.  Entrainment into the contact,
    exclusion of large particles, and wear debris are not considered.  Raises ``ValueError`` for an
    invalid code, and numbers that are not positive.

    >>> import thirdbody as tb
    >>> print(tb.cleanliness("18/16/13", gap_nm=1000).notes[0])
    0.014 particles above 4 um in A_n = 5.51e-06 m2: most contacts have none
    """
    parameters = or_calibrated(parameters)
    enrichment = checked_number("enrichment", enrichment)
    gap_nm = checked_numbers({"gap_nm": gap_nm}, USUAL_GAP)["gap_nm"]
    rows, notes = [], []
    numbers = _scale_numbers(code)
    for size, number in zip(SIZES, numbers):
        if number is not None:
            for end, scale_number in (("least", number - 1), ("most", number)):
                # per m3, times a height in m
                density = 1e6 * _most_per_ml(scale_number) * enrichment * 1e-9 * gap_nm
                text = f"particles of more than {size} um(c), {end} of the class"
                rows.append(Row(f"{end}_above_{size}_um", text, density, "m-2"))
            notes += few_particles(density, parameters.apparent_area, f"particles above {size} um")
    notes.append("particles below 4 um, which ISO 4406 does not count, are more")
    counted = "/".join("-" if number is None else str(number) for number in numbers)
    title = f"ISO {counted} in a film of {gap_nm:g} nm"
    return Answer(title, tuple(rows), tuple(notes), bool(rows))


def _scale_numbers(code):
    """The three numbers of a code, None for sizes not counted."""
    found = CODE.fullmatch(code) if isinstance(code, str) else None
    texts = found.groups() if found else ()
    numbers = [int(text) if text.isdecimal() else None for text in texts]
    known = [number for number in numbers if number is not None]
    if not found or known != sorted(known, reverse=True) or max(known, default=0) > LARGEST:
        allowed = f"three numbers up to {LARGEST}, none above that of smaller particles"
        message = f"code is {format_value(code)}; allowed: {allowed}"
        raise ValueError(f"{message}, as 18/16/13, or - for one")
    return numbers


def _most_per_ml(number):
    return 0.0 if number < 0 else MOST_PER_ML[number % 10] * 1000.0 ** (number // 10)
