"""Particles per area of a film: ``cleanliness`` from the ISO 4406 code, ``debris_density`` from a mass."""

import re

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

from thirdbody.conditions import OIL_DENSITY, checked_number, common_index, numbers_in, warn_outside
from thirdbody.core.parameters import Parameters
from thirdbody.inputs import or_calibrated
from thirdbody.notes import few_notes

SIZES = 4, 6, 14  # um(c), the sizes counted in a code of ISO 4406:2021
# its Table 1: most particles per mL for scale numbers 0 to 9, times 1000 for each 10 more
MOST_PER_ML = (0.01, 0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1.3, 2.5, 5.0)
LARGEST = 28
STEEL_DENSITY = 7850.0  # kg m-3
USUAL = {"gap_nm": (1.0, 1e5, "nm"), "particle_diameter_nm": (1.0, 1e6, "nm")}


def cleanliness(
    code: str, *, gap_nm: float, enrichment: float = 1.0, parameters: Parameters | None = None
) -> pd.DataFrame:
    """Particles per area in a film of oil with an ISO 4406 code: the count in the volume of the film.

    Particles below 4 um, such as those of the paper (20 to 1000 nm), are not counted; there are more of them.
    Entrainment into the contact, exclusion of large particles, and wear debris are not considered.

    Parameters
    ----------
    code : str
        Such as "18/16/13", for particles of more than 4, 6 and 14 um(c) in one millilitre; "-" or "*" means
        not counted.
    gap_nm : float or quantity
        Thickness of the film, or separation of the surfaces [nm].
    enrichment : float
        Ratio of the concentration in the contact to that in the sample [1].
    parameters : Parameters, optional
        Inputs whose A_n the ``notes`` are for, by default the calibrated ones.

    Returns
    -------
    pandas.DataFrame
        A row for each counted size: ``size_um``, and the ``least_per_m2`` and ``most_per_m2`` particles of
        the class that are larger [m-2].  ``attrs["notes"]`` says where most contacts have no particle.

    Raises
    ------
    ValueError
        For a code of other than three numbers, or that counts more of the larger particles, and a gap or
        enrichment that is not positive.

    Examples
    --------
    >>> import thirdbody as tb
    >>> tb.lab.cleanliness("18/16/13", gap_nm=1000)
       size_um  least_per_m2  most_per_m2
    0        4        1300.0       2500.0
    1        6         320.0        640.0
    2       14          40.0         80.0
    """
    area = or_calibrated(parameters).apparent_area
    gap = checked_number("gap_nm", gap_nm, unit="nm")
    warn_outside({"gap_nm": gap}, USUAL)
    volume = 1e-9 * gap * checked_number("enrichment", enrichment)  # m3 of the sample per m2
    scale = re.split(r"[\s:]+", re.sub(r"\s*/\s*", "/", code.strip()))[-1].split("/")
    counted = {size: int(n) for size, n in zip(SIZES, scale) if n not in ("-", "*")}
    numbers = [*counted.values()]
    if (
        len(scale) != len(SIZES)
        or not numbers
        or numbers != sorted(numbers, reverse=True)
        or not 0 <= numbers[-1] <= numbers[0] <= LARGEST
    ):
        allowed = (
            f"three numbers from 0 to {LARGEST}, none above that of smaller particles, as 18/16/13"
        )
        raise ValueError(f"code is {code!r}; allowed: {allowed}")
    least, most = ([1e6 * volume * _most_per_ml(n - low) for n in numbers] for low in (1, 0))
    table = pd.DataFrame({"size_um": [*counted], "least_per_m2": least, "most_per_m2": most})
    table.attrs["notes"] = [
        note
        for size, density in zip(counted, most)
        for note in few_notes(density, area, f"particles above {size} um")
    ]
    return table


def _most_per_ml(number):
    return 0.0 if number < 0 else MOST_PER_ML[number % 10] * 1000.0 ** (number // 10)


def debris_density(
    *,
    gap_nm: ArrayLike,
    particle_diameter_nm: ArrayLike,
    mg_per_L: ArrayLike | None = None,
    ppm: ArrayLike | None = None,
    percent: ArrayLike | None = None,
    material_density_kg_per_m3: float = STEEL_DENSITY,
    oil_density_kg_per_m3: float = OIL_DENSITY,
    enrichment: float = 1.0,
    parameters: Parameters | None = None,
) -> pd.DataFrame:
    """Particles per area in a film of oil with a mass of debris: the count in the volume of the film.

    The particles are spheres of one diameter, eta_a = c h/(rho_p pi x_a^3/6), with the mass c per volume of
    oil.  Entrainment into the contact and exclusion of large particles are not considered.

    Parameters
    ----------
    gap_nm : array_like
        Thickness h of the film, or separation of the surfaces [nm].
    particle_diameter_nm : array_like
        Diameter x_a of the particles [nm].
    mg_per_L, ppm, percent : array_like
        One of them: the mass of particles per volume of oil [mg/L], or per mass of oil [ppm] or [%].
    material_density_kg_per_m3 : float or quantity
        Density rho_p of the particles' material [kg m-3], by default of steel.
    oil_density_kg_per_m3 : float or quantity
        Density of the oil [kg m-3], for ``ppm`` and ``percent``.
    enrichment : float
        Ratio of the concentration in the contact to that in the sample [1].
    parameters : Parameters, optional
        Inputs whose A_n the ``notes`` are for, by default the calibrated ones.

    Returns
    -------
    pandas.DataFrame
        A row for each element of the arguments, which broadcast, with the index of columns of pandas:
        ``gap_nm``, ``particle_diameter_nm``, ``mg_per_L``, ``particles_per_mL`` of the sample, and
        ``particle_density_per_m2``, as ``thirdbody.solve`` takes it.  ``attrs["notes"]`` has the volume of
        the film and the assumptions.

    Raises
    ------
    ValueError
        Unless one mass is given; for a negative mass, and for other numbers that are not positive.

    Examples
    --------
    >>> import thirdbody as tb
    >>> debris = tb.lab.debris_density(mg_per_L=100, particle_diameter_nm=500, gap_nm=1000)
    >>> debris["particle_density_per_m2"].round(-6).tolist()
    [195000000.0]
    >>> print(debris.attrs["notes"][0])
    a film of 1000 nm has 5.51e-12 m3 of oil on A_n = 5.51e-06 m2
    """
    area = or_calibrated(parameters).apparent_area
    material = checked_number(
        "material_density_kg_per_m3", material_density_kg_per_m3, unit="kg m-3"
    )
    oil = checked_number("oil_density_kg_per_m3", oil_density_kg_per_m3, unit="kg m-3")
    enrichment = checked_number("enrichment", enrichment)
    # in mg/L
    units = {
        "mg_per_L": ("mg/L", 1.0),
        "ppm": ("ppm", 1e-3 * oil),
        "percent": ("percent", 10.0 * oil),
    }
    masses = {"mg_per_L": mg_per_L, "ppm": ppm, "percent": percent}
    masses = {name: mass for name, mass in masses.items() if mass is not None}
    if len(masses) != 1:
        raise ValueError(f"masses are {masses}; allowed: one of {', '.join(units)}")
    (name, mass) = masses.popitem()
    sizes = {"gap_nm": gap_nm, "particle_diameter_nm": particle_diameter_nm}
    index = common_index({**sizes, name: mass})
    unit, scale = units[name]
    arrays = [numbers_in(key, value, "nm") for key, value in sizes.items()]
    gap, diameter, concentration = np.broadcast_arrays(
        *arrays, scale * numbers_in(name, mass, unit)
    )
    if not ((concentration >= 0.0) & (gap > 0.0) & (diameter > 0.0)).all():
        raise ValueError(f"{name} is {mass!r}, with {sizes}; allowed: positive numbers")
    warn_outside({"gap_nm": gap, "particle_diameter_nm": diameter}, USUAL)
    count = 1e-3 * concentration / (material * np.pi / 6.0 * (1e-9 * diameter) ** 3)  # per m3
    density = count * enrichment * 1e-9 * gap
    table = pd.DataFrame(
        {
            "gap_nm": gap.ravel(),
            "particle_diameter_nm": diameter.ravel(),
            "mg_per_L": concentration.ravel(),
            "particles_per_mL": 1e-6 * count.ravel(),
            "particle_density_per_m2": density.ravel(),
        },
        index,
    )
    films = " to ".join(f"{end:g}" for end in dict.fromkeys((gap.min(), gap.max())))
    volumes = " to ".join(
        f"{1e-9 * end * area:.3g}" for end in dict.fromkeys((gap.min(), gap.max()))
    )
    table.attrs["notes"] = [
        f"a film of {films} nm has {volumes} m3 of oil on A_n = {area:.3g} m2",
        f"particles are spheres of one diameter, of a material of {material:g} kg/m3; halving the diameter "
        "makes eight times as many",
        f"the concentration in the film is {enrichment:g} times that of the sample",
        *few_notes(density.min(), area),
    ]
    return table
