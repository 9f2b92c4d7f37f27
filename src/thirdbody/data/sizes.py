"""What x_a stands for: the sizes of the particles behind the paper's mean diameter."""

from __future__ import annotations

from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from thirdbody.model.parameters import Parameters
from thirdbody.model.particles import ParticleLayer


class Sizes(NamedTuple):
    """Mean and largest diameter of particles, and the separation d below which one carries load [m]."""

    mean: float
    largest: float
    reach: float

    @classmethod
    def of(cls, diameter: float, roughness: float, parameters: Parameters) -> Sizes:
        """The sizes for ``diameter`` x_a and ``roughness`` sigma [m]: normal from 0 to X_max (Eq. 6).

        Examples
        --------
        >>> import thirdbody as tb
        >>> sizes = Sizes.of(500e-9, 300e-9, tb.load_parameters())
        >>> f"{sizes.mean:.3g} {sizes.largest:.3g} {sizes.reach:.3g}"
        '1.19e-07 4.5e-07 1.93e-06'
        """
        mean, spread = parameters.interpretation.size_distribution.sizes(diameter, parameters)
        largest = mean + parameters.truncation * spread
        if spread:
            normal = NormalDist(mean, spread)
            part = normal.cdf(largest) - normal.cdf(0.0)
            mean += spread**2 * (normal.pdf(0.0) - normal.pdf(largest)) / part
        layer = ParticleLayer.of(np.array([diameter]), roughness, np.ones(1), parameters)
        return cls(mean, largest, float(layer.reach[0]))


def sizes_note(diameter: float, roughness: float, parameters: Parameters) -> str:
    """A sentence on the particles that ``diameter`` x_a stands for on a ``roughness`` sigma [m]."""
    sizes = Sizes.of(diameter, roughness, parameters)
    mean, largest, reach = (f"{1e9 * each:.4g}" for each in sizes)
    return (
        f"x_a = {1e9 * diameter:.4g} nm stands for particles of {mean} nm on average and at most "
        f"{largest} nm, which carry load at separations d below {reach} nm"
    )
