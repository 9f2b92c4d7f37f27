"""What an answer rests on, in sentences: the sizes of the particles, A_n, the speed and the range."""

from collections.abc import Sequence
from statistics import NormalDist

import numpy as np

from thirdbody.conditions import density_of_oil, entrainment_speed
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import ParticleLayer


def sizes_note(diameter: float, roughness: float, parameters: Parameters) -> str:
    """A sentence on the particles for ``diameter`` x_a on a ``roughness`` sigma [m]: the mean and
    largest of sizes that are normal from 0 to X_max (Eq. 6), and d below which they carry load."""
    mean, spread = parameters.sizes(diameter)
    largest = mean + parameters.truncation * spread
    normal = NormalDist(mean, spread)
    part = normal.cdf(largest) - normal.cdf(0.0)
    mean += spread**2 * (normal.pdf(0.0) - normal.pdf(largest)) / part
    layer = ParticleLayer.of(np.array([diameter]), roughness, np.ones(1), parameters)
    return (
        f"x_a = {1e9 * diameter:.4g} nm stands for particles of {1e9 * mean:.4g} nm on average and at most "
        f"{1e9 * largest:.4g} nm, which carry load at separations d below {1e9 * layer.reach[0]:.4g} nm"
    )


def few_notes(per_m2: float, area: float) -> list[str]:
    """A note if there is less than one particle in the nominal area A_n [m2]."""
    count = per_m2 * area
    note = f"{count:.2g} particles in A_n = {1e6 * area:.3g} mm2: most contacts have none"
    return [note] if 0.0 < count < 1.0 else []


def area_note(parameters: Parameters) -> str:
    """The area to which loads refer, in words."""
    return f"the nominal area A_n of the inputs is {1e6 * parameters.apparent_area:.3g} mm2"


def speed_note(parameters: Parameters) -> str:
    """The speed that the inputs stand for, in words."""
    density, speed = density_of_oil(parameters), entrainment_speed(parameters)
    return (
        f"with an oil of {density:.4g} kg/m3, U/nu is for an entrainment speed of {speed:.3g} m/s"
    )


def range_note(members: Sequence[Parameters]) -> str:
    """What a range is, once for an answer with ``members`` of the ensemble."""
    if not members:
        return "no range: these inputs have no ensemble"
    return f"ranges are 5 to 95 % over {len(members)} sets of inputs that explain the paper about equally well"
