"""``cleanliness``: particles per area of a film, from the ISO 4406 code of the oil in it."""

from __future__ import annotations

import re

from thirdbody.answers.answer import Answer, Row, few_particles
from thirdbody.conditions import check_number, check_numbers, checked_parameters
from thirdbody.messages import format_value
from thirdbody.model.parameters import Parameters

SIZES = 4, 6, 14  # um(c), the sizes counted in a code
# ISO 4406:2021, Table 1: most particles per mL for scale numbers 0 to 9, times 1000 for each 10 more
MOST_PER_ML = (0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.3, 2.5, 5.0)
LARGEST = 28
CODE = re.compile(r"(?:ISO)? *" + "/".join([r" *(\d\d?|[-*]) *"] * len(SIZES)))
USUAL = {"gap_nm": (1.0, 1e5, "nm")}


def cleanliness(
    code: str, *, gap_nm: float, parameters: Parameters | None = None, enrichment: float = 1.0
) -> Answer:
    """Particles per area in a film of oil with an ISO 4406 code: the count in the volume of the film.

    The answer has for each size the least and the most particles per m2 of the code's class.  The
    code counts particles of more than 4, 6 and 14 um(c) in one millilitre.  Smaller ones, such as
    those of the paper (20 to 1000 nm), are not counted; there are more of them.  Entrainment of
    particles into the contact, exclusion of large ones, and wear debris are not considered.  Raises
    ``ValueError`` for an invalid code, and numbers that are not positive.

    Parameters
    ----------
    code : str
        ISO 4406 code, such as "18/16/13"; "-" or "*" means not counted.
    gap_nm : float
        Thickness of the film, or separation of the surfaces [nm].
    parameters : Parameters, optional
        Inputs of the model, of which A_n is used, by default the published ones.
    enrichment : float
        Ratio of the particle concentration in the contact to that in the sample.

    Examples
    --------
    >>> import thirdbody as tb
    >>> print(tb.cleanliness("18/16/13", gap_nm=1000).notes[0])
    0.0089 particles above 4 um in A_n = 3.57e-06 m2: most contacts have none
    """
    parameters = checked_parameters(parameters)
    check_number("enrichment", enrichment)
    check_numbers({"gap_nm": gap_nm}, USUAL)
    rows, notes = [], []
    for size, number in zip(SIZES, _scale_numbers(code), strict=True):
        if number is None:
            continue
        for end, per_ml in (("least", _most(number - 1)), ("most", _most(number))):
            density = 1e6 * per_ml * enrichment * 1e-9 * gap_nm  # per m3, times a height in m
            text = f"particles of more than {size} um(c), {end} of the class"
            rows.append(Row(f"{end}_above_{size}_um", text, density, "m-2"))
        notes += few_particles(density, parameters.apparent_area, f"particles above {size} um")
    notes.append("particles below 4 um, which ISO 4406 does not count, are more")
    title = f"ISO {code} in a film of {gap_nm:g} nm"
    return Answer(title, tuple(rows), tuple(notes), bool(rows))


def _scale_numbers(code):
    """The three numbers of a code, None for sizes not counted."""
    found = CODE.fullmatch(code) if isinstance(code, str) else None
    texts = found.groups() if found else ()
    numbers = [int(text) if text.isdecimal() else None for text in texts]
    known = [number for number in numbers if number is not None]
    if not found or known != sorted(known, reverse=True) or max(known, default=0) > LARGEST:
        allowed = (
            f"three numbers up to {LARGEST}, none above that of smaller particles, as 18/16/13"
        )
        raise ValueError(f"code is {format_value(code)}; allowed: {allowed}, or - for one")
    return numbers


def _most(number):
    """Most particles per mL of a scale number."""
    return 0.0 if number < 0 else MOST_PER_ML[number % 10] * 1000.0 ** (number // 10)
