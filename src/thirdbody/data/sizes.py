"""What x_a stands for: the sizes of the particles behind the paper's mean diameter."""

from __future__ import annotations

from statistics import NormalDist
from typing import NamedTuple

from thirdbody.model.parameters import Parameters


class Sizes(NamedTuple):
    """Mean and largest diameter of particles, and the widest gap in which one carries load [m]."""

    mean: float
    largest: float
    widest_gap: float

    @classmethod
    def of(cls, diameter: float, parameters: Parameters) -> Sizes:
        """The sizes for ``diameter`` x_a [m]: a normal distribution from 0 to X_max (Eq. 6).

        Examples
        --------
        >>> import thirdbody as tb
        >>> sizes = Sizes.of(500e-9, tb.load_parameters())
        >>> f"{sizes.mean:.3g} {sizes.largest:.3g} {sizes.widest_gap:.3g}"
        '1.19e-07 4.5e-07 1.63e-06'
        """
        mean, spread = parameters.interpretation.size_distribution.sizes(diameter, parameters)
        largest = mean + parameters.truncation * spread
        if spread:
            normal = NormalDist(mean, spread)
            part = normal.cdf(largest) - normal.cdf(0.0)
            mean += spread**2 * (normal.pdf(0.0) - normal.pdf(largest)) / part
        beyond = parameters.interpretation.elastic_limits.beyond
        elastic = beyond * parameters.elastic_depth_ratio * diameter
        return cls(mean, largest, largest + elastic)


def sizes_note(diameter: float, parameters: Parameters) -> str:
    """A sentence on the particles that ``diameter`` x_a [m] stands for."""
    mean, largest, gap = (f"{1e9 * each:.4g}" for each in Sizes.of(diameter, parameters))
    return (
        f"x_a = {1e9 * diameter:.4g} nm stands for particles of {mean} nm on average and at most "
        f"{largest} nm, which carry load in gaps of up to {gap} nm"
    )
