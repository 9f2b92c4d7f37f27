"""The interpretations: what the paper leaves open, each one as an object.

Six places of the paper can be interpreted in several ways.  ``INTERPRETATIONS`` has them by the words
that the configuration has for them.  This module alone knows these words: all others ask the objects
that ``Parameters.interpretation`` holds.

A new interpretation of a place is one object more in ``INTERPRETATIONS``, one word more in
``config/inputs.yaml``, and the same interpretation in the independent implementations:
``verification/plain_model.py``, ``tests/oracle/contact.c`` and ``tests/oracle/in_mpmath.py``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import SimpleNamespace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.bounds import LEAST_SPREAD

if TYPE_CHECKING:
    from thirdbody.model.parameters import Parameters

# ASSUME: summits have their own plane, which is not in the paper.  McCool (1986): its height and the loss
# of variance, over 1/(eta_s R)
SUMMIT_PLANE = 0.045944
SUMMIT_VARIANCE = 3.717e-4


# --- the summits of a rough surface ---


class SummitsAtTheMeanPlane:
    """Summits scatter about the mean plane as widely as the surface itself."""

    def deviation_and_offset(
        self, roughness: ArrayLike, density: ArrayLike, radius: ArrayLike
    ) -> tuple[ArrayLike, ArrayLike]:
        """sigma_s and y_s [m] for sigma [m], eta_s [m-2] and R [m], scalars or of one shape.

        Raises ``ValueError`` if this leaves no variance to such summits.
        """
        return roughness, 0.0 * roughness


class SummitsAboveTheMeanPlaneAsRough(SummitsAtTheMeanPlane):
    """Summits lie above the mean plane and scatter as widely as the surface: one sigma for both."""

    def deviation_and_offset(self, roughness, density, radius):
        return roughness, SUMMIT_PLANE / (density * radius)


class SummitsAboveTheMeanPlane(SummitsAtTheMeanPlane):
    """Summits lie above the mean plane and scatter less than the surface (McCool 1986)."""

    def deviation_and_offset(self, roughness, density, radius):
        curvature_length = 1.0 / (density * radius)
        variance = roughness**2 - SUMMIT_VARIANCE * curvature_length**2
        if not np.all(variance > 0.0):
            bad = np.argmin(variance > 0.0)
            parameter, sigma = (np.ravel(x)[bad] for x in (roughness / curvature_length, roughness))
            raise ValueError(
                f"summit_parameter is {parameter:.4g} at roughness "
                f"{sigma:g} m; allowed: above {math.sqrt(SUMMIT_VARIANCE):.5f}, where summits "
                "keep a variance"
            )
        return np.sqrt(variance), SUMMIT_PLANE * curvature_length


# --- third particles ---
# ASSUME: X_min is 0, and X_max ``truncation`` deviations above the mean: Eqs. 4 and 5 print no values.


@dataclass(frozen=True)
class SizeLaw:
    """One interpretation of phi_a as numbers: m, S [m], c_1 [m2]; c_2, c_3 and alpha of the smallest size.

    Their meaning is said at the head of ``thirdbody.model.particles``.
    """

    mean: NDArray
    spread: NDArray
    square: NDArray
    constant: float
    linear: float
    smallest: float


class Uncentred:
    """How the sizes of particles are distributed, phi_a of Eqs. 4-6.  Eq. 6 as printed: m = 0,
    S = sigma_a; sizes from X_min = 0."""

    def law(self, diameter: NDArray, roughness: ArrayLike, parameters: Parameters) -> SizeLaw:
        """Which sizes count in the integrals of Eqs. 4 and 5, and with what weight.

        For x_a [m] and sigma [m], a scalar or of its shape; fields of the law have that of x_a.
        """
        spread = parameters.spread_ratio * diameter
        return SizeLaw(np.zeros_like(spread), spread, spread**2, 0.0, 1.0, 0.0)

    def sizes(self, diameter: ArrayLike, parameters: Parameters) -> tuple[ArrayLike, ArrayLike]:
        """Mean and spread [m] of the particles' own normal distribution, for x_a [m]."""
        return 0.0, parameters.spread_ratio * diameter

    def can_be_equal(self, parameters: Parameters) -> bool:
        """Whether particles may all have one size, as something else spreads the gaps they meet."""
        return False


class Centred(Uncentred):
    """N(m, sigma_a^2) about the mean diameter, as the text speaks of x_a; sizes from X_min = 0."""

    def law(self, diameter, roughness, parameters):
        mean, spread = parameters.mean_ratio, parameters.spread_ratio
        square = mean**2 + spread**2
        constant, linear = 2.0 * mean * spread / square, spread**2 / square
        moments = mean * diameter, spread * diameter, square * diameter**2
        return SizeLaw(*moments, constant, linear, -mean / spread)

    def sizes(self, diameter, parameters):
        return parameters.mean_ratio * diameter, parameters.spread_ratio * diameter


class GapConvolved(Centred):
    """Particles of all sizes meet the local gap: its spread joins that of the sizes."""

    def law(self, diameter, roughness, parameters):
        mean = parameters.mean_ratio * diameter
        spread = np.hypot(parameters.spread_ratio * diameter, parameters.gap_ratio * roughness)
        square = (1.0 + parameters.spread_ratio**2) * diameter**2
        return SizeLaw(mean, spread, square, 0.0, 0.0, -np.inf)

    def can_be_equal(self, parameters):
        return parameters.gap_ratio >= LEAST_SPREAD


@dataclass(frozen=True)
class ParticlePlane:
    """From which plane the separation is measured that particles meet: that of the summits,
    d = h - y_s, as the paper writes one d in the integrals over both; or the mean plane, h = R_x H_c."""

    is_that_of_summits: bool

    def height(self, roughness: ArrayLike, parameters: Parameters) -> ArrayLike:
        """Height of that plane above the mean plane [m], of the shape of ``roughness`` sigma [m]."""
        if self.is_that_of_summits:
            return parameters.surface(roughness).summit_offset
        return 0.0 * roughness


@dataclass(frozen=True)
class ElasticLimits:
    """Which particles deform elastically in Eqs. 4 and 5: those between d and d + ``side`` h_e.

    -1 as the integral is printed; 1 for particles that are pressed by less than h_e.  Larger
    particles are plastic.
    """

    side: float

    @property
    def beyond(self) -> float:
        """How much farther apart than their size particles carry load, in h_e [1]."""
        return max(-self.side, 0.0)

    def weights(self, elastic_factor: float) -> tuple[float, float]:
        """How much sizes above d count in A_sa, and those above d + ``side`` h_e, for an elastic factor
        [1]: see the head of ``thirdbody.model.particles``."""
        weights = elastic_factor, 1.0 - elastic_factor
        return weights if self.side > 0.0 else weights[::-1]


@dataclass(frozen=True)
class CoverageLimits:
    """Which particles take room from the summits' load in Eq. 4: if ``contacting``, those that touch at
    the separation d, as in Eq. 5; if not, all from X_min to X_max, as the integral is printed."""

    contacting: bool


# --- film ---
# ASSUME: the film fills h, the separation of the mean planes; the paper combines both without saying how.


@dataclass(frozen=True)
class FilmLoad:
    """Which load F stands in the film's load parameter W = F/(E_ss R_x^2) (Eq. 8).

    If W ``depends_on_shares`` it is the load that the fluid carries, F_f: solids and film share the
    load.  Else it is F_t, as Eq. 8 is printed: the film's thickness is known beforehand, and the
    solids carry everything where it is below their dry separation.
    """

    depends_on_shares: bool

    def log_fraction(self, log_fluid_fraction: ArrayLike) -> ArrayLike:
        """ln(F/F_t) [1] of the load F in W, where ln L_f [1] is ``log_fluid_fraction``."""
        return log_fluid_fraction if self.depends_on_shares else 0.0

    def total_load(self, solid_load: ArrayLike, film_load: ArrayLike) -> ArrayLike:
        """F_t* [1] that holds the surfaces at a separation where solids carry ``solid_load`` [1] and
        ``film_load`` is the load F* [1] in W under which the film is as thick."""
        joined = np.add if self.depends_on_shares else np.maximum
        return joined(solid_load, film_load)


# --- all of them ---

INTERPRETATIONS = {
    "summit_offset": {
        True: SummitsAboveTheMeanPlane(),
        "as_rough": SummitsAboveTheMeanPlaneAsRough(),
        False: SummitsAtTheMeanPlane(),
    },
    "size_distribution": {
        "uncentred": Uncentred(),
        "centred": Centred(),
        "gap_convolved": GapConvolved(),
    },
    "particle_plane": {"surface": ParticlePlane(False), "summit": ParticlePlane(True)},
    "elastic_limits": {"printed": ElasticLimits(-1.0), "physical": ElasticLimits(1.0)},
    "coverage_limits": {"printed": CoverageLimits(False), "contacting": CoverageLimits(True)},
    "film_load": {"fluid": FilmLoad(True), "total": FilmLoad(False)},
}


def chosen_interpretations(parameters: Parameters) -> SimpleNamespace:
    """The interpretation of each place that the words in ``parameters`` mean, by the names of
    ``INTERPRETATIONS``.

    Raises ``ValueError`` that names the field, its word and the words that it may have.
    """
    chosen = {}
    for name, known in INTERPRETATIONS.items():
        word = getattr(parameters, name)
        if word not in list(known):  # which a word that cannot be hashed is not either
            allowed = ", ".join(map(str, known))
            raise ValueError(f"{name} is {word!r}; allowed: {allowed}")
        chosen[name] = known[word]
    return SimpleNamespace(**chosen)
