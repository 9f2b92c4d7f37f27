"""Balance of forces on the interface: Eqs. 1, 2 and 4, dry and lubricated.

All loads are dimensionless, F* = F/(A_n E_ss), and enter as logarithms, so that neither a tail of
the summits nor a vanishing share of the fluid loses digits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import log_expit

from thirdbody.model.asperity import SummitPopulation
from thirdbody.model.film import Film
from thirdbody.model.parameters import Parameters, Surface
from thirdbody.model.particles import FULL, ParticleLayer, log_bare_share, separation_bearing
from thirdbody.solver.roots import NOISE, decreasing_roots
from thirdbody.solver.tabulation import PiecewisePolynomial

LOGIT_LIMIT = 745.0  # a smaller L_f than exp(-LOGIT_LIMIT) is zero in float64
TINY = np.finfo(float).tiny
ROUNDED_GAP = np.finfo(float).eps  # relative error of a film's thickness in float64


@dataclass(frozen=True, eq=False)
class RoughSurface:
    """Summits of one roughness with the two functions of separation that stand for them.

    ``log_load`` and ``log_area`` map t = (d - y_s)/sigma_s to (value, slope): either those of a
    ``SummitPopulation`` or their tables, which are wrong by ``table_error`` at most.  ``sampled``
    are increasing values of ln F_ss*, and t there.
    """

    surface: Surface
    log_load: object
    log_area: object
    sampled: tuple
    table_error: float

    @property
    def roughness(self) -> float:
        """sigma [m]."""
        return self.surface.roughness

    @property
    def offset(self) -> float:
        """y_s [m]."""
        return self.surface.summit_offset

    @property
    def deviation(self) -> float:
        """sigma_s [m]."""
        return self.surface.summit_deviation

    def first_separation(self, log_load):
        """About the t [1] at which summits bear ``log_load`` ln F_t*."""
        return np.interp(log_load, *self.sampled)

    def take(self, chosen) -> RoughSurface:
        """This one, which all points share."""
        return self


@dataclass(frozen=True, eq=False)
class RoughSurfaces:
    """A rough surface for each point: that of ``members`` which ``which`` says, an index.

    Has what a ``RoughSurface`` has, as arrays over the points.  ``surface`` are the summits of all
    members; ``tables`` hold their two functions if they have tables, which are then of one size.
    """

    members: Sequence[RoughSurface]
    which: np.ndarray
    parameters: Parameters
    surface: Surface
    tables: Mapping[str, PiecewisePolynomial]

    @classmethod
    def of(cls, members: Sequence[RoughSurface], which, parameters: Parameters) -> RoughSurfaces:
        """The surfaces of points, out of ``members`` that all have tables or all have none."""
        columns = zip(*(vars(member.surface).values() for member in members), strict=True)
        names = ("log_load", "log_area") if members[0].table_error > 0.0 else ()
        tables = {
            name: PiecewisePolynomial.joined([getattr(member, name) for member in members])
            for name in names
        }
        return cls(members, which, parameters, Surface(*map(np.array, columns)), tables)

    def take(self, chosen) -> RoughSurfaces:
        """Those of the points that an index or mask ``chosen`` picks."""
        return replace(self, which=self.which[chosen])

    @property
    def roughness(self):
        """sigma [m]."""
        return self.surface.roughness[self.which]

    @property
    def offset(self):
        """y_s [m]."""
        return self.surface.summit_offset[self.which]

    @property
    def deviation(self):
        """sigma_s [m]."""
        return self.surface.summit_deviation[self.which]

    @property
    def table_error(self):
        """Bound on the error of both functions."""
        return np.array([member.table_error for member in self.members])[self.which]

    def log_load(self, t):
        """(value, slope) of ln F_ss* at ``t``."""
        return self._evaluated("log_load", t)

    def log_area(self, t):
        """(value, slope) of ln(A_ss/A_n) at ``t``."""
        return self._evaluated("log_area", t)

    def _evaluated(self, name, t):
        if not self.tables:
            return self._by_quadrature(name, t, self.which)
        position, inside = self.tables[name].located(t)
        if inside.all():
            return self.tables[name].interpolate(position, self.which)
        value, slope = np.empty((2, *t.shape))
        which = np.broadcast_to(self.which, t.shape)
        within = self.tables[name].interpolate(position[inside], which[inside])
        value[inside], slope[inside] = within
        beyond = self._by_quadrature(name, t[~inside], which[~inside])
        value[~inside], slope[~inside] = beyond
        return value, slope

    def _by_quadrature(self, name, t, which):
        surface = Surface(*(column[which] for column in vars(self.surface).values()))
        return getattr(SummitPopulation.of(surface, self.parameters), name)(t)

    def first_separation(self, log_load):
        """About the t [1] at which summits bear ``log_load`` ln F_t*."""
        found = np.empty_like(log_load)
        for index in np.unique(self.which):
            mine = self.which == index
            found[mine] = self.members[index].first_separation(log_load[mine])
        return found


@dataclass(frozen=True)
class Points:
    """Points on rough surfaces: logarithm of the load, all with or without particles and film."""

    rough: RoughSurface | RoughSurfaces
    parameters: Parameters
    log_load: np.ndarray  # ln F_t*
    particles: ParticleLayer | None
    film: Film | None

    def take(self, chosen) -> Points:
        """The points that an index or mask ``chosen`` picks."""
        return replace(
            self,
            rough=self.rough.take(chosen),
            log_load=self.log_load[chosen],
            particles=self.particles and self.particles.take(chosen),
            film=self.film and self.film.take(chosen),
        )

    def summit_separation(self, separation):
        """t [1] at ``separation`` d [m]."""
        return (separation - self.rough.offset) / self.rough.deviation

    def log_solid_load(self, separation):
        """ln F_s* at ``separation`` d [m], its slope and the steepest of its parts' [m-1] (Eqs. 2
        and 4); a part that is zero in float64 does not count."""
        value, slope = self.rough.log_load(self.summit_separation(separation))
        slope = slope / self.rough.deviation
        if self.particles is None:
            return value, slope, np.where(value > FULL, slope, 0.0)
        area, area_slope, *coverage = self.particles.contact(separation)
        log_bare, bare_slope = self.particles.log_bare_load(*coverage)
        value = value + log_bare
        log_particles = np.log(area) + np.log(self.particle_pressure)
        excess = value - log_particles
        odds = np.exp(-np.abs(excess))  # of the smaller load to the larger
        share = np.where(excess > 0.0, 1.0, odds) / (1.0 + odds)
        total = np.maximum(value, log_particles) + np.log1p(odds)
        particle_slope = np.where(area > TINY, area_slope / area, 0.0)
        slope = slope + bare_slope
        return (
            total,
            share * slope + (1.0 - share) * particle_slope,
            np.minimum(np.where(value > FULL, slope, 0.0), particle_slope),
        )

    @property
    def particle_pressure(self) -> float:
        """F_sa/(A_sa E_ss): particles press with the hardness of surface 1 (Eqs. 4 and 5)."""
        return self.parameters.hardness_surface_1 / self.parameters.elastic_modulus_surfaces

    def areas(self, separation, contact=None):
        """A_sa/A_n and ln(A_ss/A_n) beside the particles at ``separation`` d [m] (Eq. 5).

        ``contact`` is that of the particles there, if it is known.
        """
        log_summits, _ = self.rough.log_area(self.summit_separation(separation))
        if self.particles is None:
            return np.zeros_like(log_summits), log_summits
        area, _, *coverage = contact or self.particles.contact(separation)
        log_bare, _ = log_bare_share(*coverage)
        return area, log_summits + log_bare

    def odds_slope(self, separation):
        """Sign-true slope of A_sa/A_ss: dA_sa/dd - A_sa d ln A_ss/dd [m-1], finite where A_sa = 0."""
        _, summit_slope = self.rough.log_area(self.summit_separation(separation))
        area, area_slope, *coverage = self.particles.contact(separation)
        _, bare_slope = log_bare_share(*coverage)
        summit_slope = summit_slope / self.rough.deviation + bare_slope
        return np.where(area > 0.0, area_slope - area * summit_slope, -TINY)

    def film_separation(self, log_fluid_fraction):
        """d = R_x H_c [m] where the film bears the share L_f of the load, and dd/d ln L_f [m]."""
        thickness, slope = self.film.thickness(self.log_load_parameter(log_fluid_fraction))
        return self.parameters.ball_radius * thickness, self.parameters.ball_radius * slope

    def log_load_parameter(self, log_fluid_fraction):
        """ln W, W = F/(E_ss R_x^2), of the share L_f of the load (Eq. 8)."""
        area = self.parameters.apparent_area / self.parameters.ball_radius**2
        return self.log_load + log_fluid_fraction + np.log(area)


def first_separation(points: Points):
    """About the separation d [m] at which the solids alone bear the load.

    The larger of those that summits or particles alone would have: off by a factor of 2 in load.
    """
    rough = points.rough
    guess = rough.offset + rough.deviation * rough.first_separation(points.log_load)
    if points.particles is not None:
        area = np.exp(points.log_load) / points.particle_pressure
        guess = np.maximum(guess, separation_bearing(area, points.particles))
    return np.maximum(guess, 0.0)


@dataclass(frozen=True)
class Balance:
    """Where the forces of 1-D points balance.

    ``width`` [m] bounds the error that solving and rounding leave in the separation, ``error`` the
    relative one in any variable, and ``condition`` is how much a relative error of the solids'
    load is magnified there.
    """

    logit: np.ndarray  # ln(L_s/L_f) [1], infinite without a film
    separation: np.ndarray  # d [m], nan where nothing balances
    width: np.ndarray
    error: np.ndarray
    condition: np.ndarray


def dry_balance(points: Points, tolerance: float) -> Balance:
    """The solids alone bear the load: F_s(d) = F_t, no solution if d < 0.

    Solved for d/sigma; a load that the solids cannot bear at d = 0 has no solution.
    """

    def residual(x, some):
        scale = some.rough.roughness
        value, slope, steepest = some.log_solid_load(x * scale)
        gain = np.maximum(-steepest * scale, 1.0 / x)
        return value - some.log_load, slope * scale, gain, 0.0

    scale = points.rough.roughness
    guess = first_separation(points) / scale
    roots, width, error, condition = decreasing_roots(
        residual, guess, np.zeros_like(guess), 2.0 * guess + 10.0, tolerance, points
    )
    dry = np.full_like(roots, np.inf)
    return Balance(dry, scale * roots, scale * width, error, condition)


def shared_balance(points: Points, tolerance: float) -> Balance:
    """Film and solids share the load (Eqs. 1, 2, 7).

    The film bears the fluid load alone: d = R_x H_c(W(F_f)).  With y = ln(L_s/L_f), both L_f and
    d are explicit and ln(F_s(d)/F_t) - ln L_s falls with y, so the root is unique and no digits
    cancel however small L_s or L_f is.
    """

    def residual(y, some):
        odds = np.exp(-np.abs(y))
        less = -np.log1p(odds)  # ln of the larger share
        log_solid, log_fluid = less + np.minimum(y, 0.0), less - np.maximum(y, 0.0)
        separation, widening = some.film_separation(log_fluid)
        value, slope, steepest = some.log_solid_load(separation)
        larger = 1.0 / (1.0 + odds)
        solid = np.where(y > 0.0, larger, odds * larger)
        shares = y > -LOGIT_LIMIT  # else L_s is zero in float64
        gain = np.maximum(solid * steepest * widening, shares)
        return (
            value - some.log_load - log_solid,
            -solid * slope * widening - (1.0 - solid),
            gain,
            ROUNDED_GAP * (1.0 - steepest * separation),
        )

    guess = _first_logit(points)
    lower = 1.1 * np.minimum(guess, 0.0) - 50.0
    upper = np.full_like(guess, LOGIT_LIMIT)
    found = decreasing_roots(residual, guess, lower, upper, tolerance, points)
    logit, width, error, condition = found
    separation, widening = points.film_separation(log_expit(-logit))
    width = np.abs(widening) * width + ROUNDED_GAP * separation
    return Balance(logit, separation, width, error, condition)


def _first_logit(points: Points):
    """Logit of L_s at the larger of the separations that solids and film alone would have.

    From the film's load there where that is the smaller share, so that the separation stays on
    its side of the largest particle; else from the loads of both.
    """
    alone, _ = points.film_separation(0.0)
    separation = np.maximum(alone, first_separation(points))
    thickness = separation / points.parameters.ball_radius
    log_parameter = points.film.load_parameter(thickness, steps=2)
    log_fluid = np.minimum(log_parameter - points.log_load_parameter(0.0), 0.0)
    logit = np.log(-np.expm1(log_fluid)) - log_fluid
    wet = np.flatnonzero(~(logit > 0.0))
    some = points.take(wet)
    log_solid, *_ = some.log_solid_load(separation[wet])
    logit[wet] = log_solid - some.log_load - log_fluid[wet]
    return logit


def total_load_balance(points: Points, tolerance: float) -> Balance:
    """The printed reading of Eq. 8: the film's W is that of the total load, d = R_x H_c(W(F_t)).

    Where the film would be thinner than the dry separation, L_s would exceed 1: the solids then
    bear everything at the dry separation.
    """
    separation, _ = points.film_separation(0.0)
    log_solid, _, steepest = points.log_solid_load(separation)
    log_solid -= points.log_load
    boundary = ~(log_solid < 0.0)
    logit = log_solid - np.log(-np.expm1(np.minimum(log_solid, 0.0)))
    error = ROUNDED_GAP * (1.0 - steepest * separation)
    # L_f = 1 - L_s is what suffers most
    condition = np.maximum(np.exp(logit), 1.0)
    width = ROUNDED_GAP * separation
    found = Balance(logit, separation, width, error + NOISE * condition, condition)
    if boundary.any():
        dry = dry_balance(points.take(boundary), tolerance)
        for name, values in vars(dry).items():
            getattr(found, name)[boundary] = values
    return found


BALANCES = {"fluid": shared_balance, "total": total_load_balance}
