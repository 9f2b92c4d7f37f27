"""The solids as functions of the separation d, interpolated to three digits or more.

For given surfaces and particles, F_ss, A_ss and A_sa depend only on d (Eqs. 2-6).  They are
evaluated at a few hundred separations and interpolated by cubic Hermite polynomials.  The error is
estimated midway between the separations.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import scipy  # scipy.interpolate is loaded on first use: many jobs do not need it
from numpy.typing import NDArray

from thirdbody.core.contact import Contact
from thirdbody.core.logarithms import WithSlope
from thirdbody.core.parameters import Parameters

STEP = 0.06  # of asinh(d/sigma) between separations
# samples between the smallest (0) and the largest particle (1), denser near the largest
SIZES = np.concatenate([np.linspace(0.0, 1.0, 40), 1.0 - np.geomspace(1e-7, 0.02, 14)])
SMALLEST = -6.0  # (size - mean)/spread below which particles are negligible
KINK_GAP = 1e-12  # relative distance of separations from a kink, on both sides
SAFETY = 2.0  # factor on the error midway between two separations
SUMMIT_ERROR = 1e-7  # relative error of the load and area of summits


class TabulatedSolids(NamedTuple):
    """Loads and areas at separations d as in ``SolidState``, with bounds on relative errors [1].

    ``load_error`` is that of F_s, ``area_error`` that of areas and their ratios.
    """

    log_summit_load: WithSlope
    particle_area: WithSlope
    log_summit_area: WithSlope
    load_error: NDArray
    area_error: NDArray


class SolidTable:
    """The solids for a single roughness, particle size and density, over ``separations`` d [m].

    ``powers``, of shape (4, separations - 1, 8), are coefficients of the cubic polynomials between
    the separations.
    """

    def __init__(self, separations: NDArray, powers: NDArray):
        self.separations = separations
        self.ends = separations[0], separations[-1]
        powers = np.ascontiguousarray(powers)
        self._polynomials = scipy.interpolate.PPoly.construct_fast(powers, separations)

    def __call__(self, separation: NDArray) -> TabulatedSolids:
        """The solids at ``separation`` [m], or at the nearest end of the table."""
        columns = np.moveaxis(self._polynomials(np.clip(separation, *self.ends)), -1, 0)
        values, slopes, (load_error, area_error) = columns[:3], columns[3:6], columns[6:]
        load, particle_area, summit_area = map(WithSlope, values, slopes)
        return TabulatedSolids(load, particle_area, summit_area, load_error, area_error)


def solid_tables(
    diameter: NDArray,
    roughness: NDArray,
    density: NDArray,
    low: NDArray,
    high: NDArray,
    parameters: Parameters,
) -> Iterator[SolidTable]:
    """Yield tables of many solids, from separation ``low`` to ``high`` [m].

    ``diameter`` x_a [m], ``roughness`` sigma [m] and ``density`` eta_a [m-2] are 1-D.  All solids
    have particles, or none has.
    """
    every = Contact.of(diameter, roughness, density, parameters, SUMMIT_ERROR)
    separations = [
        _separations(first, last, sigma, every.particles, which)
        for which, (first, last, sigma) in enumerate(zip(low, high, roughness, strict=True))
    ]
    stops = np.cumsum([grid.size for grid in separations])
    which = np.repeat(np.arange(diameter.size), np.diff(stops, prepend=0))
    d = np.concatenate(separations)
    # the cells between the last separation of a solid and the first of the next are not used
    cells = _Cells(d=d, parts=_parts(every.take(which), d))
    true = _parts(every.take(which[:-1]), cells.centre).value
    powers = cells.powers(_errors(cells.middle, true, parameters.particle_pressure))
    for grid, stop in zip(separations, stops, strict=True):
        yield SolidTable(separations=grid, powers=powers[:, stop - grid.size : stop - 1])


def _separations(low, high, roughness, particles, which):
    """Separations [m] from ``low`` to ``high``, denser over the particle sizes.

    Every kink has a separation close to it on both sides.
    """
    first, last = np.arcsinh(np.array([low, high]) / roughness)
    steps = int(np.ceil((last - first) / STEP)) + 1
    separations = [roughness * np.sinh(np.linspace(first, last, steps + 1)), [low, high]]
    if particles is not None:
        one = particles.take(which)
        mean, spread, depth = one.centre, one.spread, one.scaled_depth
        smallest, largest = particles.moment.smallest, particles.moment.largest
        for shift in (0.0, -depth):
            least = max(smallest, SMALLEST)
            separations.append(mean + spread * (least + SIZES * (largest - least) - shift))
            for kink in (smallest, largest):
                beside = KINK_GAP * (mean + spread * (abs(kink) + abs(shift)))
                separations.append(mean + spread * (kink - shift) + beside * np.array([-1.0, 1.0]))
    return np.unique(np.clip(np.concatenate(separations), low, high))


def _parts(contact: Contact, d):
    """ln F_ss, A_sa and ln A_ss of the summits beside the particles, shape (separations, 3).

    Their order is that of ``TabulatedSolids``.  They are nan where particles cover everything.
    """
    state = contact.at(d, with_areas=True)
    parts = state.log_summit_load, state.particle_area, state.log_summit_area
    value, slope = (np.stack(each, axis=1) for each in zip(*parts, strict=True))
    if contact.particles is not None:
        covered = contact.particles.covers_all
        value[covered] = slope[covered] = np.nan
    return WithSlope(value=value, slope=slope)


class _Cells(NamedTuple):
    """Cubic Hermite polynomials of ``parts`` between increasing separations ``d`` [m]."""

    d: NDArray
    parts: WithSlope

    @property
    def width(self):
        """Width of each cell [m], a column."""
        return np.diff(self.d)[:, np.newaxis]

    @property
    def centre(self):
        """Separations [m] in the middle of the cells."""
        return self.d[:-1] + 0.5 * self.width[:, 0]

    @property
    def middle(self):
        """Values of the polynomials in the middle of the cells."""
        value, slope = self.parts
        return 0.5 * (value[:-1] + value[1:]) - 0.125 * self.width * np.diff(slope, axis=0)

    def powers(self, errors):
        """Coefficients of values, slopes and the constant ``errors``; the third power is first."""
        value, slope = self.parts
        width, rise = self.width, np.diff(value, axis=0)
        steepness = slope[:-1] + slope[1:] - 2.0 * rise / width
        cubic = steepness / width**2
        square = (rise / width - slope[:-1] - steepness) / width
        nothing, exactly = np.zeros_like(cubic), np.zeros_like(errors)
        columns = (
            [cubic, nothing, exactly],
            [square, 3.0 * cubic, exactly],
            [slope[:-1], 2.0 * square, exactly],
            [value[:-1], slope[:-1], errors],
        )
        return np.stack([np.concatenate(each, axis=1) for each in columns])


def _errors(interpolated, true, pressure):
    """Bounds on the relative errors of F_s, and of areas and their ratios: shape (cells, 2).

    They compare the values ``interpolated`` and ``true`` midway between separations.  Both have the
    form of ``_parts``.
    """
    log_summits, area, log_summit_area = interpolated.T
    true_log_summits, true_area, true_log_summit_area = true.T
    summits, particles = np.exp(true_log_summits), pressure * true_area
    load = summits * np.expm1(log_summits - true_log_summits) + pressure * (area - true_area)
    solids = summits + particles
    load_error = np.where(solids > 0.0, np.abs(load) / solids, 0.0)
    area_error = np.where(true_area > 0.0, np.abs(area / true_area - 1.0), 0.0)
    area_error += np.abs(log_summit_area - true_log_summit_area)
    errors = SAFETY * np.stack([load_error, area_error], axis=1) + SUMMIT_ERROR
    return np.where(np.isfinite(errors), errors, np.inf)
