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
    return (
        f"x_a = {1e9 * diameter:.4g} nm stands for particles of {1e9 * mean:.4g} nm on average and at most "
        f"{1e9 * largest:.4g} nm, which carry load at separations d below {1e9 * layer.reach[0]:.4g} nm"
    )
