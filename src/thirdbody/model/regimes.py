"""Names for the state of an interface: lubrication regime and contact mode (sections 3.1, 3.2)."""

from __future__ import annotations

import numpy as np

BOUNDARY_LIMIT = 0.90
FULL_FILM_LIMIT = 0.03
PARTICLE_LIMIT = 0.95
SURFACE_LIMIT = 0.05

LUBRICATION_REGIMES = ("boundary", "mixed", "full_film")
CONTACT_MODES = ("two_body", "surface_surface", "hybrid", "particle_surface")
SOLUTION_STATUSES = ("converged", "outside_film_formula", "coverage_exceeded", "not_converged")


def lubrication_regime(solid_load_fraction):
    """Index into ``LUBRICATION_REGIMES``: boundary above 0.90, full film below 0.03 (section 3.1).

    ``solid_load_fraction`` L_s [1], any shape; result int8 of that shape.
    """
    fraction = np.asarray(solid_load_fraction)
    return _between(fraction < FULL_FILM_LIMIT, fraction > BOUNDARY_LIMIT, 1)


def contact_mode(particle_contact_area_ratio, has_particles):
    """Index into ``CONTACT_MODES`` (section 3.2): particle-surface above 0.95, surface below 0.05.

    ``particle_contact_area_ratio`` A_sa,t* [1] and the mask ``has_particles`` broadcast; an
    interface without particles is two-body.  Result int8.
    """
    ratio = np.asarray(particle_contact_area_ratio)
    return has_particles * _between(ratio > PARTICLE_LIMIT, ratio < SURFACE_LIMIT, 2)


def _between(above, below, index):
    """``index``, or the next where ``above`` or the one before where ``below``, as int8."""
    return np.int8(index) + np.asarray(above, np.int8) - np.asarray(below, np.int8)
