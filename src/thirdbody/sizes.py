"""The sizes of the particles for a mean diameter x_a of the paper."""

from statistics import NormalDist

import numpy as np

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
    x_a, mean, largest, reach = (
        f"{1e9 * each:.4g}" for each in (diameter, mean, largest, layer.reach[0])
    )
    return (
        f"x_a = {x_a} nm stands for particles of {mean} nm on average and at most {largest} nm, "
        f"which carry load at separations d below {reach} nm"
    )
