"""Interpretations of what the paper leaves open, each as an object.

Five places of the paper have several interpretations.  ``INTERPRETATIONS`` maps the words of the
configuration to them; size distributions are classes, whose objects hold their ratios.  Only this
module uses these words; all others use the objects in ``Parameters.interpretation``.

To add an interpretation, add an object to ``INTERPRETATIONS`` and a word to ``config/inputs.yaml``,
and implement it in the independent codes: ``verification/plain_model.py``,
``tests/oracle/contact.c`` and ``tests/oracle/in_mpmath.py``.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.bounds import LEAST_SPREAD

# --- third-body particles ---
# ASSUME: X_min is 0, and X_max ``truncation`` deviations above the mean: Eqs. 4 and 5 print no values.


@dataclass(frozen=True)
class SizeLaw:
    """Coefficients of one interpretation of phi_a: m, S [m], c_1 [m2]; c_2, c_3 and alpha of the
    smallest size.  ``thirdbody.model.particles`` defines them.
    """

    mean: NDArray
    spread: NDArray
    square: NDArray
    constant: float
    linear: float
    smallest: float


@dataclass(frozen=True)
class Uncentred:
    """Size distribution phi_a of Eqs. 4-6, Eq. 6 as printed: m = 0, S = sigma_a; X_min = 0.

    Mean and spread are ratios to x_a, ``gap_ratio`` is one to sigma; not every distribution uses all.
    """

    mean_ratio: float
    spread_ratio: float
    gap_ratio: float

    def law(self, diameter: NDArray, roughness: ArrayLike) -> SizeLaw:
        """Coefficients of the integrals in Eqs. 4 and 5.

        For x_a [m] and sigma [m], a scalar or of its shape; array fields have the shape of x_a.
        """
        spread = self.spread_ratio * diameter
        return SizeLaw(
            mean=np.zeros_like(spread),
            spread=spread,
            square=spread**2,
            constant=0.0,
            linear=1.0,
            smallest=0.0,
        )

    def sizes(self, diameter: ArrayLike) -> tuple[ArrayLike, ArrayLike]:
        """Mean and standard deviation [m] of the normal size distribution, for x_a [m]."""
        return 0.0, self.spread_ratio * diameter

    @property
    def can_be_equal(self) -> bool:
        """Whether all particles may have one size, because the gaps they meet vary."""
        return False


class Centred(Uncentred):
    """N(m, sigma_a^2) about the mean diameter, as the text describes x_a; sizes from X_min = 0."""

    def law(self, diameter, roughness):
        mean, spread = self.mean_ratio, self.spread_ratio
        square = mean**2 + spread**2
        return SizeLaw(
            mean=mean * diameter,
            spread=spread * diameter,
            square=square * diameter**2,
            constant=2.0 * mean * spread / square,
            linear=spread**2 / square,
            smallest=-mean / spread,
        )

    def sizes(self, diameter):
        return self.mean_ratio * diameter, self.spread_ratio * diameter


class GapConvolved(Centred):
    """Particles of all sizes meet the local gap, whose variance adds to that of the sizes."""

    def law(self, diameter, roughness):
        return SizeLaw(
            mean=self.mean_ratio * diameter,
            spread=np.hypot(self.spread_ratio * diameter, self.gap_ratio * roughness),
            square=(1.0 + self.spread_ratio**2) * diameter**2,
            constant=0.0,
            linear=0.0,
            smallest=-np.inf,
        )

    @property
    def can_be_equal(self):
        return self.gap_ratio >= LEAST_SPREAD


@dataclass(frozen=True)
class ParticlePlane:
    """Plane from which the separation at the particles is measured: the summit plane, d = h - y_s,
    as the paper has one d in both integrals; or the mean plane, h = R_x H_c."""

    is_summit_plane: bool

    def height(self, summit_offset: ArrayLike) -> ArrayLike:
        """Height of that plane above the mean plane [m], for a ``summit_offset`` y_s [m]."""
        return summit_offset if self.is_summit_plane else 0.0 * summit_offset


@dataclass(frozen=True)
class ElasticLimits:
    """Particles that deform elastically in Eqs. 4 and 5: sizes between d and d + ``side`` h_e.

    ``side`` is -1 as printed, and 1 if particles pressed by less than h_e are elastic.
    """

    side: float

    @property
    def beyond(self) -> float:
        """Largest separation at which particles carry load, less their size, in h_e [1]."""
        return max(-self.side, 0.0)

    def weights(self, elastic_factor: float) -> tuple[float, float]:
        """Weights in A_sa of the sizes above d, and of those above d + ``side`` h_e, for an elastic
        factor [1]; see ``thirdbody.model.particles``."""
        weights = elastic_factor, 1.0 - elastic_factor
        return weights if self.side > 0.0 else weights[::-1]


@dataclass(frozen=True)
class CoverageLimits:
    """Particles that reduce the summit load in Eq. 4: if ``contacting``, those in contact at the
    separation d, as in Eq. 5; otherwise all from X_min to X_max, as printed."""

    contacting: bool


# --- film ---
# ASSUME: the film fills h, the separation of the mean planes; the paper combines both without saying how.


@dataclass(frozen=True)
class FilmLoad:
    """The load F in the load parameter of the film, W = F/(E_ss R_x^2) (Eq. 8).

    If W ``depends_on_shares``, F is the load F_f carried by the fluid: solids and film share the
    load.  Otherwise it is F_t, as printed: the film thickness is known in advance, and the solids
    carry all the load where it is below their dry separation.
    """

    depends_on_shares: bool

    def log_fraction(self, log_fluid_fraction: ArrayLike) -> ArrayLike:
        """ln(F/F_t) [1] of the load F in W, where ln L_f [1] is ``log_fluid_fraction``."""
        return log_fluid_fraction if self.depends_on_shares else 0.0

    def total_load(self, solid_load: ArrayLike, film_load: ArrayLike) -> ArrayLike:
        """F_t* [1] at a separation where solids carry ``solid_load`` [1], and a film of that
        thickness has the load ``film_load`` F* [1] in W."""
        combine = np.add if self.depends_on_shares else np.maximum
        return combine(solid_load, film_load)


# --- all of them ---

INTERPRETATIONS = {
    "size_distribution": {
        "uncentred": Uncentred,
        "centred": Centred,
        "gap_convolved": GapConvolved,
    },
    "particle_plane": {"surface": ParticlePlane(False), "summit": ParticlePlane(True)},
    "elastic_limits": {"printed": ElasticLimits(-1.0), "physical": ElasticLimits(1.0)},
    "coverage_limits": {"printed": CoverageLimits(False), "contacting": CoverageLimits(True)},
    "film_load": {"fluid": FilmLoad(True), "total": FilmLoad(False)},
}


def chosen_interpretations(words: Mapping[str, object], **size_ratios: float) -> SimpleNamespace:
    """The interpretations selected by the ``words``, each by a name in ``INTERPRETATIONS``; sizes are
    distributed with the ``size_ratios``, the fields of ``Uncentred``.

    Raises ``ValueError`` with the name, its word and the allowed words.
    """
    chosen = {}
    for name, known in INTERPRETATIONS.items():
        word = words[name]
        if word not in list(known):  # a list, as the word may be unhashable
            allowed = ", ".join(map(str, known))
            raise ValueError(f"{name} is {word!r}; allowed: {allowed}")
        chosen[name] = known[word]
    chosen["size_distribution"] = chosen["size_distribution"](**size_ratios)
    return SimpleNamespace(**chosen)
