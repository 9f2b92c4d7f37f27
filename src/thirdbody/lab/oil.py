"""Viscosities of oils from data sheets: ``oil_viscosity`` at a temperature, and ``oil_grade``, the reverse."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from thirdbody.conditions import checked_number, common_index, numbers_in

if TYPE_CHECKING:
    import pandas as pd

# ISO 3448: kinematic viscosity at 40 C [cSt] of each grade, +-10 %
GRADES = {2: 2.2, 3: 3.2, 5: 4.6, 7: 6.8}
GRADES |= {grade: float(grade) for grade in (10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460)}
GRADES |= {grade: float(grade) for grade in (680, 1000, 1500, 2200, 3200)}
USUAL_INDEX = 95.0  # of the mineral oils in ISO 3448
LEAST, MOST = 2.0, 2e7  # cSt, where ASTM D341 is a line with the constant 0.7
COLDEST, HOTTEST = -70.0, 370.0  # C, of ASTM D341
ZERO = 273.15  # K
# ASTM D2270: rows of seven numbers, described in the file
INDEX = np.loadtxt(Path(__file__).with_suffix(".csv"), delimiter=",")


def oil_viscosity(
    temperature_C: ArrayLike,
    *,
    grade: int | str | None = None,
    viscosity_index: float | None = None,
    points: Mapping[float, float] | None = None,
) -> NDArray | pd.Series:
    """Kinematic viscosity [cSt] of an oil at a temperature, from the Walther line through two points.

    log10 log10(nu + 0.7) = A - B log10 T, with nu in cSt and T in K (ASTM D341).  It is valid at ambient
    pressure, without shear thinning, ageing or fuel dilution.

    Parameters
    ----------
    temperature_C : array_like
        Temperatures [C], or a quantity, from -70 to 370 C.
    grade : int or str, optional
        ISO viscosity grade, 46 or "ISO VG 46" (ISO 3448): the middle of its range at 40 C, which is +-10 %.
    viscosity_index : float, optional
        Of the oil of a grade, by default 95, that of mineral oils in ISO 3448; it gives the second point, at
        100 C (ASTM D2270, ISO 2909).
    points : mapping, optional
        Instead of these, two temperatures [C] with measured viscosities [cSt].

    Returns
    -------
    array or pandas.Series
        Of the shape of the temperatures; a column of pandas gives a column.

    Raises
    ------
    ValueError
        For a grade and points together, points whose viscosity does not fall with temperature, a temperature
        outside -70 to 370 C, and viscosities below 2 or above 2e7 cSt, where the line is not valid.
    KeyError
        For a grade that ISO 3448 does not have.

    Examples
    --------
    >>> import thirdbody as tb
    >>> tb.lab.oil_viscosity([40, 80], grade=46, viscosity_index=100).round(1)
    array([46. , 11.1])
    >>> tb.lab.oil_viscosity([70], points={40: 150, 100: 15}).round(1)
    array([38.5])
    """
    temperature = numbers_in("temperature_C", temperature_C, "degC")
    allowed = (temperature >= COLDEST) & (temperature <= HOTTEST)
    if not allowed.all():
        message = f"temperature_C is {temperature[~allowed][0]:g}"
        raise ValueError(f"{message}; allowed: {COLDEST:g} to {HOTTEST:g}")
    if (points is None) == (grade is None) or (grade is None and viscosity_index is not None):
        message = f"grade is {grade!r}, viscosity_index {viscosity_index!r} and points {points!r}"
        raise ValueError(f"{message}; allowed: a grade, also with its viscosity_index, or points")
    if points is None:
        at_40 = GRADES[int(re.sub(r"(?i)iso|vg|[ -]", "", str(grade)))]
        index = USUAL_INDEX if viscosity_index is None else viscosity_index
        points = {40.0: at_40, 100.0: _at_100(at_40, index)}
    (cold, thick), (hot, thin) = sorted(
        (float(numbers_in("points", at, "degC")), float(numbers_in("points", nu, "cSt")))
        for at, nu in points.items()
    )
    slope = (_doubled(thick) - _doubled(thin)) / math.log10((hot + ZERO) / (cold + ZERO))
    doubled = _doubled(thick) - slope * np.log10((temperature + ZERO) / (cold + ZERO))
    with np.errstate(over="ignore"):
        viscosity = 10.0 ** (10.0**doubled) - 0.7
    line = np.append(viscosity, (thick, thin))
    if not (slope > 0.0 and (line >= LEAST).all() and (line <= MOST).all()):
        raise ValueError(
            f"viscosities are {line.min():.3g} to {line.max():.3g} cSt; allowed: {LEAST:g} to {MOST:g} cSt, "
            "less where it is hotter: there ASTM D341 is a line"
        )
    rows = common_index({"temperature_C": temperature_C})
    if rows is None:
        return viscosity
    import pandas as pd  # slow to import

    return pd.Series(viscosity, rows, name="viscosity_cSt")


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
    """Viscosity at 100 C [cSt] of an oil with a viscosity index; ``ValueError`` if it is below 2 cSt."""
    index = checked_number("viscosity_index", index, positive=False)
    return brentq(lambda at_100: viscosity_index_of(at_40, at_100) - index, LEAST, 0.9 * at_40)


def oil_grade(
    viscosity_cSt: float, temperature_C: float, *, viscosity_index: float = USUAL_INDEX
) -> pd.DataFrame:
    """ISO viscosity grades that have about a viscosity at a temperature: the reverse of ``oil_viscosity``.

    Parameters
    ----------
    viscosity_cSt : float or quantity
        Kinematic viscosity that is needed [cSt].
    temperature_C : float or quantity
        Temperature of the oil [C], at which it is needed.
    viscosity_index : float
        Of the oils.

    Returns
    -------
    pandas.DataFrame
        Rows for the last grade that is too thin, the least grade that is enough, and the next one, if there
        are such: ``grade`` (ISO VG); ``viscosity_cSt``, at this temperature, of the middle of the grade,
        which is +-10 % at 40 C; ``is_least_enough``.

    Raises
    ------
    ValueError
        For a viscosity that is not positive, and a temperature at which ``oil_viscosity`` refuses all grades.

    Examples
    --------
    >>> import thirdbody as tb
    >>> tb.lab.oil_grade(73.5, 75).round(1)
       grade  viscosity_cSt  is_least_enough
    0    320           56.4            False
    1    460           74.5             True
    2    680          100.5            False
    """
    import pandas as pd

    needed = checked_number("viscosity_cSt", viscosity_cSt, unit="cSt")
    rows = []
    for grade in GRADES:
        try:
            viscosity = oil_viscosity(temperature_C, grade=grade, viscosity_index=viscosity_index)
            rows.append((grade, float(viscosity)))
        except ValueError:  # too thin for ASTM D341
            continue
    if not rows:
        oil = f"temperature_C {temperature_C!r} and viscosity_index {viscosity_index!r}"
        raise ValueError(f"no grade has {LEAST:g} to {MOST:g} cSt at {oil}")
    table = pd.DataFrame(rows, columns=["grade", "viscosity_cSt"])
    enough = int((table["viscosity_cSt"] < needed).sum())
    table["is_least_enough"] = table.index == enough
    return table.iloc[max(enough - 1, 0) : enough + 2].reset_index(drop=True)
