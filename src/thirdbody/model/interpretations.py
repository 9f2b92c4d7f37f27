"""The interpretations: what the paper leaves open, each one as an object.

Six places of the paper can be interpreted in several ways.  Each place is a class here, a *kind* of
interpretation, and each interpretation is a subclass, which knows the word that the configuration has for
it and whatever the equations need to know of it.  This module alone knows these words: all others
ask the objects that ``Parameters.interpretation`` holds.

A new interpretation of a place is one subclass here, one word more in ``config/inputs.yaml``, and the same
interpretation in the independent implementations: ``verification/plain_model.py``,
``tests/oracle/contact.c`` and ``tests/oracle/in_mpmath.py``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, ClassVar, get_type_hints

import numpy as np
from numpy.typing import ArrayLike, NDArray

from thirdbody.model.bounds import LEAST_SPREAD

if TYPE_CHECKING:
    from thirdbody.model.parameters import Parameters

# McCool (1986): height of the summits' plane and loss of their variance, over 1/(eta_s R)
SUMMIT_PLANE = 0.045944
SUMMIT_VARIANCE = 3.717e-4


class Interpretation:
    """An interpretation of one place of the paper.

    A direct subclass is a kind of interpretation, and ``known`` are its interpretations by their words.  A subclass
    of a kind states its ``word``; the one object that there is of it has no state of its own.
    """

    known: ClassVar[dict[str | bool, Interpretation]]

    def __init_subclass__(cls, word: str | bool | None = None):
        super().__init_subclass__()
        if word is None:
            cls.known = {}
        else:
            cls.known[word] = cls()


# --- the summits of a rough surface ---


class SummitOffset(Interpretation):
    """Where the summits' mean plane lies, and how widely summits scatter about it."""

    def deviation_and_offset(
        self, roughness: ArrayLike, density: ArrayLike, radius: ArrayLike
    ) -> tuple[ArrayLike, ArrayLike]:
        """sigma_s and y_s [m] for sigma [m], eta_s [m-2] and R [m], scalars or of one shape.

        Raises ``ValueError`` if this leaves no variance to such summits.
        """
        raise NotImplementedError


class SummitsAboveTheMeanPlane(SummitOffset, word=True):
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


class SummitsAboveTheMeanPlaneAsRough(SummitOffset, word="as_rough"):
    """Summits lie above the mean plane and scatter as widely as the surface: one sigma for both."""

    def deviation_and_offset(self, roughness, density, radius):
        return roughness, SUMMIT_PLANE / (density * radius)


class SummitsAtTheMeanPlane(SummitOffset, word=False):
    """Summits scatter about the mean plane as widely as the surface itself."""

    def deviation_and_offset(self, roughness, density, radius):
        return roughness, 0.0 * roughness


# --- third particles ---


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


class SizeDistribution(Interpretation):
    """How the sizes of particles are distributed: phi_a of Eqs. 4-6."""

    def law(self, diameter: NDArray, roughness: ArrayLike, parameters: Parameters) -> SizeLaw:
        """Which sizes count in the integrals of Eqs. 4 and 5, and with what weight.

        For x_a [m] and sigma [m], a scalar or of its shape; fields of the law have that of x_a.
        """
        raise NotImplementedError

    def can_be_equal(self, parameters: Parameters) -> bool:
        """Whether particles may all have one size, as something else spreads the gaps they meet."""
        return False

    def sizes(self, diameter: ArrayLike, parameters: Parameters) -> tuple[ArrayLike, ArrayLike]:
        """Mean and spread [m] of the particles' own normal distribution, for x_a [m]."""
        return parameters.mean_ratio * diameter, parameters.spread_ratio * diameter


class Uncentred(SizeDistribution, word="uncentred"):
    """Eq. 6 as printed: m = 0, S = sigma_a; sizes from X_min = 0."""

    def law(self, diameter, roughness, parameters):
        spread = parameters.spread_ratio * diameter
        return SizeLaw(np.zeros_like(spread), spread, spread**2, 0.0, 1.0, 0.0)

    def sizes(self, diameter, parameters):
        return 0.0, parameters.spread_ratio * diameter


class Centred(SizeDistribution, word="centred"):
    """N(m, sigma_a^2) about the mean diameter, as the text speaks of x_a; sizes from X_min = 0."""

    def law(self, diameter, roughness, parameters):
        mean, spread = parameters.mean_ratio, parameters.spread_ratio
        square = mean**2 + spread**2
        return SizeLaw(
            mean * diameter,
            spread * diameter,
            square * diameter**2,
            2.0 * mean * spread / square,
            spread**2 / square,
            -mean / spread,
        )


class GapConvolved(SizeDistribution, word="gap_convolved"):
    """Particles of all sizes meet the local gap: its spread joins that of the sizes."""

    def law(self, diameter, roughness, parameters):
        mean = parameters.mean_ratio * diameter
        spread = np.hypot(parameters.spread_ratio * diameter, parameters.gap_ratio * roughness)
        square = (1.0 + parameters.spread_ratio**2) * diameter**2
        return SizeLaw(mean, spread, square, 0.0, 0.0, -np.inf)

    def can_be_equal(self, parameters):
        return parameters.gap_ratio >= LEAST_SPREAD


class ParticlePlane(Interpretation):
    """From which plane the separation is measured that particles meet."""

    def height(self, roughness: ArrayLike, parameters: Parameters) -> ArrayLike:
        """Height of that plane above the mean plane [m], of the shape of ``roughness`` sigma [m]."""
        raise NotImplementedError


class ParticlesBetweenMeanPlanes(ParticlePlane, word="surface"):
    """The mean plane of the surface: particles meet the separation h = R_x H_c of the film."""

    def height(self, roughness, parameters):
        return 0.0 * roughness


class ParticlesBetweenSummitPlanes(ParticlePlane, word="summit"):
    """The plane of the summits: particles meet the separation d = h - y_s that summits do, as the
    paper writes one d in the integrals over both."""

    def height(self, roughness, parameters):
        return parameters.surface(roughness).summit_offset


class ElasticLimits(Interpretation):
    """Which particles deform elastically in Eqs. 4 and 5: those between d and d + ``side`` h_e."""

    side: ClassVar[float]

    @property
    def beyond(self) -> float:
        """How much farther apart than their size particles carry load, in h_e [1]."""
        return max(-self.side, 0.0)

    def weights(self, elastic_factor: float) -> tuple[float, float]:
        """How much sizes above d count in A_sa, and those above d + ``side`` h_e, for an elastic factor
        [1]: see the head of ``thirdbody.model.particles``."""
        raise NotImplementedError


class ElasticBelowTheSeparation(ElasticLimits, word="printed"):
    """From d - h_e to d, as the integral is printed; plastic from d on."""

    side = -1.0

    def weights(self, elastic_factor):
        return 1.0 - elastic_factor, elastic_factor


class ElasticAboveTheSeparation(ElasticLimits, word="physical"):
    """From d to d + h_e: particles that are pressed by less than h_e; plastic from there on."""

    side = 1.0

    def weights(self, elastic_factor):
        return elastic_factor, 1.0 - elastic_factor


class CoverageLimits(Interpretation):
    """Which particles take room from the summits' load in Eq. 4: if ``contacting``, those that touch at
    the separation d, as in Eq. 5; if not, the same at every separation."""

    contacting: ClassVar[bool]


class CoverageOfAllSizes(CoverageLimits, word="printed"):
    """All particles from X_min to X_max, as the integral is printed."""

    contacting = False


class CoverageOfContacting(CoverageLimits, word="contacting"):
    """Those larger than d, as in Eq. 5."""

    contacting = True


# --- film ---


class FilmLoad(Interpretation):
    """Which load F stands in the film's load parameter W = F/(E_ss R_x^2) (Eq. 8).

    ``depends_on_shares`` says whether W is known only when L_f is.
    """

    depends_on_shares: ClassVar[bool]

    def log_fraction(self, log_fluid_fraction: ArrayLike) -> ArrayLike:
        """ln(F/F_t) [1] of the load F in W, where ln L_f [1] is ``log_fluid_fraction``."""
        raise NotImplementedError

    def total_load(self, solid_load: ArrayLike, film_load: ArrayLike) -> ArrayLike:
        """F_t* [1] that holds the surfaces at a separation where solids carry ``solid_load`` [1] and
        ``film_load`` is the load F* [1] in W under which the film is as thick."""
        raise NotImplementedError


class LoadOfTheFluid(FilmLoad, word="fluid"):
    """The load that the fluid carries, F_f: solids and film share the load."""

    depends_on_shares = True

    def log_fraction(self, log_fluid_fraction):
        return log_fluid_fraction

    def total_load(self, solid_load, film_load):
        return np.add(solid_load, film_load)


class TotalLoad(FilmLoad, word="total"):
    """The total load F_t, as Eq. 8 is printed: the film's thickness is known beforehand, and the
    solids carry everything where it is below their dry separation."""

    depends_on_shares = False

    def log_fraction(self, log_fluid_fraction):
        return 0.0

    def total_load(self, solid_load, film_load):
        return np.maximum(solid_load, film_load)


# --- all of them ---


@dataclass(frozen=True)
class Interpretations:
    """The interpretation chosen at each place; fields are named as those of ``Parameters`` that choose."""

    summit_offset: SummitOffset
    size_distribution: SizeDistribution
    particle_plane: ParticlePlane
    elastic_limits: ElasticLimits
    coverage_limits: CoverageLimits
    film_load: FilmLoad

    @classmethod
    def of(cls, parameters: Parameters) -> Interpretations:
        """The interpretations that the words in ``parameters`` mean.

        Raises ``ValueError`` that names the field, its word and the words that it may have.
        """
        return cls(**{name: _named(name, getattr(parameters, name)) for name in KINDS})


def _named(name, word):
    known = KINDS[name].known
    if word not in list(known):  # which a word that cannot be hashed is not either
        allowed = ", ".join(map(str, known))
        raise ValueError(f"{name} is {word!r}; allowed: {allowed}")
    return known[word]


KINDS: dict[str, type[Interpretation]] = {
    field.name: get_type_hints(Interpretations)[field.name] for field in fields(Interpretations)
}
