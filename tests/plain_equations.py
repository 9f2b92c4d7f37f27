"""The plain equations of ``verification/plain_model.py`` at many points, for tests of the
library."""

import json
import math
from functools import lru_cache
from pathlib import Path

import numpy as np

from benchmarks.baselines import load_plain_model

plain = load_plain_model(Path(__file__).parents[1] / "verification" / "plain_model.py")


class PlainEquations:
    """Eqs. 4, 5 and 7 from the numbers of ``model_parameters`` alone, one point after the other.

    Loads are over A_n E_ss, areas over A_n.  All points lie on one ``roughness`` [m], whose place
    in the attribute's lists is ``index``; each has a ``diameter`` [m] and a ``density`` [m-2] of
    its own.  Separations d [m] have the shape of the points, or any where there is but one point.
    """

    def __init__(self, attribute, index, roughness, diameter, density):
        self.model = json.loads(attribute)
        surface = [self.model[key][index] for key in ("eta_s", "R", "sigma_s", "y_s")]
        unknown = math.nan, math.nan  # load and viscosity, which these equations do not have
        self.bare = plain.Point(*unknown, 0.0, roughness, 0.0, *surface)
        particles = zip(np.ravel(diameter), np.ravel(density), strict=True)
        self.points = [self.bare._replace(diameter=x, density=n) for x, n in particles]
        self._state = lru_cache(maxsize=None)(self._state_of)

    def _state_of(self, d, index):
        return plain.state(d, self.model, self.points[index])

    def _at(self, function, d):
        """``function``(d, index) at all points."""
        return np.vectorize(function, otypes=[float])(d, np.arange(len(self.points)))

    def solid_load(self, d):
        """F_s* (Eqs. 2 and 4)."""
        return self._at(lambda *at: math.exp(self._state(*at).log_solid_load), d)

    def areas(self, d):
        """A_t*, A_sa,t* and A_ss,t* (Eqs. 5 and 10)."""
        names = "total_area", "particle_ratio", "summit_ratio"
        return [
            self._at(lambda *at, name=name: getattr(self._state(*at), name), d) for name in names
        ]

    def coverage(self):
        """Share of the interface that Eq. 4 takes from the summits, at all points."""
        return np.array([plain.load_coverage(self.model, point) for point in self.points])

    def film(self, load, viscosity):
        """H_c and its roughness term where the film bears ``load`` F_f* (Eq. 7)."""

        def terms(load, viscosity):
            point = self.bare._replace(viscosity=viscosity)
            return plain.film_terms(math.log(load), self.model, point)

        smooth, rough = np.vectorize(terms, otypes=[float, float])(load, viscosity)
        return smooth * (1.0 + rough), rough

    @property
    def largest(self):
        """X_max [m], of each point."""
        return np.array([plain.sizes(self.model, point)[2] for point in self.points])
