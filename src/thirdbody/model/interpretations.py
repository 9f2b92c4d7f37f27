"""Interpretations of what the paper leaves open, each as an object.

Three places of the paper have several interpretations.  ``INTERPRETATIONS`` maps the words of the
configuration to them.  Only this module uses these words; all others use the objects in
``Parameters.interpretation``.

To add an interpretation, add an object to ``INTERPRETATIONS`` and a word to ``config/inputs.yaml``,
and implement it in the independent codes: ``verification/plain_model.py``,
``tests/oracle/contact.c``, ``tests/oracle/in_mpmath.py`` and ``explorer/page/model.js``.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
from numpy.typing import ArrayLike

# --- third-body particles ---
# ASSUME: X_min is 0, and X_max ``truncation`` deviations above the mean: Eqs. 4 and 5 print no values.


@dataclass(frozen=True)
class SizeDistribution:
    """The normal distribution phi_a of the sizes in Eqs. 4-6: about 0, as Eq. 6 is printed; or, if it
    ``is_centred``, about a mean, as the text describes x_a."""

    is_centred: bool

    def mean(self, mean: ArrayLike) -> ArrayLike:
        """Mean of the normal distribution, where centred sizes have this ``mean``, in any unit."""
        return mean if self.is_centred else 0.0 * mean


@dataclass(frozen=True)
class ParticlePlane:
    """Plane from which the separation at the particles is measured: that of the summits,
    d - y_s, as the paper has one separation in both integrals; or that of the mean planes, d = R_x H_c."""

    is_summit_plane: bool

    def height(self, summit_offset: ArrayLike) -> ArrayLike:
        """Height of that plane above the mean plane [m], for a ``summit_offset`` y_s [m]."""
        return summit_offset if self.is_summit_plane else 0.0 * summit_offset


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
        "uncentred": SizeDistribution(is_centred=False),
        "centred": SizeDistribution(is_centred=True),
    },
    "particle_plane": {
        "surface": ParticlePlane(is_summit_plane=False),
        "summit": ParticlePlane(is_summit_plane=True),
    },
    "film_load": {
        "fluid": FilmLoad(depends_on_shares=True),
        "total": FilmLoad(depends_on_shares=False),
    },
}


def chosen_interpretations(words: Mapping[str, object]) -> SimpleNamespace:
    """The interpretations selected by the ``words``, each by a name in ``INTERPRETATIONS``.

    Raises ``ValueError`` with the name, its word and the allowed words.
    """
    for name, known in INTERPRETATIONS.items():
        if words[name] not in list(known):  # a list, as the word may be unhashable
            raise ValueError(f"{name} is {words[name]!r}; allowed: {', '.join(known)}")
    return SimpleNamespace(**{name: known[words[name]] for name, known in INTERPRETATIONS.items()})
