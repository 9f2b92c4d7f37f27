"""The balance of forces (Eqs. 1, 2 and 4) at many points on one surface, in machine code.

``solve_points`` takes a *block* of ``WIDTH`` points at a time and leads them through the stages, as
long as points are left that need a further step.  To follow the equations, read ``stages``.
"""

from __future__ import annotations

import numpy as np

from thirdbody.solver.compiled.layout import (
    GIVEN,
    REMAINDER,
    RESULTS,
    SEPARATION,
    WIDTH,
)
from thirdbody.solver.compiled.machine_code import stage
from thirdbody.solver.compiled.stages import (
    add_moment_remainders,
    bound_particle_errors,
    film_bears,
    film_holds,
    find_moments,
    keep_film,
    move_areas,
    move_loads,
    particles_bear,
    particles_touch,
    start,
    stop_before_contact,
    summits_bear,
    summits_touch,
    take_step,
)

STEPS = 16  # of Halley's method at most; who needs more is left to a slower way


def solve_points(model, columns, has_particles, has_film, film_is_known, wants_areas, block, found):
    """Solve points and put their results in ``found``.

    Halley's method on the logarithm of the load F_s + F_f that the interface bears at d, which falls
    with d.  It starts at the largest of the separations at which summits, particles or film alone
    would bear F_t.  The results after the last step are read off Taylor series about the separation
    before it.  A film of known thickness keeps the surfaces apart unless solids alone stand farther
    apart under F_t: then it bears nothing.

    Parameters
    ----------
    model : Model
        What the points share.
    columns : array, shape (GIVEN, points)
        What is given of each point; rows on particles or film are not read where there are none.
    has_particles, has_film, film_is_known, wants_areas : bool
        Whether there are particles, a film whose thickness depends on the share of the load that it
        bears, one of known thickness, and whether results that are areas are asked for.
    block : numpy.void
        Room to work in, from ``make_block``, in numbers of the type of ``columns``.
    found : array of float64, shape (RESULTS, points)
        Where the results go; their bound is nan where no solution is found.
    """
    total = np.uintp(found.shape[1])
    for first in range(np.uintp(0), total, np.uintp(WIDTH)):
        # unsigned, as all that counts points: such an index cannot mean one from the end
        count = min(np.uintp(WIDTH), total - first)
        _take(block, count, columns, first)
        start(block, count, model, has_particles, has_film, film_is_known)
        for step in range(STEPS):
            summits_bear(block, count, model)
            if wants_areas:
                summits_touch(block, count, model)
            if has_particles:
                find_moments(block, count, model)
                particles_touch(block, count, model.particles)
                particles_bear(block, count, model)
                bound_particle_errors(block, count, model)
            if has_film:
                film_bears(block, count, model)
            if film_is_known:
                film_holds(block, count)
            take_step(block, count, model)
            if has_particles:
                add_moment_remainders(block, count, model)
            if film_is_known:
                keep_film(block, count, model)
            if has_particles:
                stop_before_contact(block, count, model)
            move_loads(block, count, model.limits)
            if wants_areas:
                move_areas(block, count, model)
            if step == 0:
                for row in range(RESULTS):  # all of them, which are in the order of ``found``
                    for k in range(count):
                        found[row, first + k] = block.results[row, k]
            else:
                _store_finished(block, count, model.limits, found)
            count = _keep_unfinished(block, count, model.limits)
            if count == 0:
                break


@stage
def _take(block, count, columns, first):
    """Take ``count`` points into the block, from column ``first`` on."""
    for row in range(GIVEN):
        for k in range(count):
            block.given[row, k] = columns[row, first + k]
    for k in range(count):
        block.places[k] = first + k


@stage
def _store_finished(block, count, limits, found):
    """Store the results of the points that need no further step."""
    for k in range(count):
        if block.work[REMAINDER, k] <= limits.allowed:
            for row in range(RESULTS):
                found[row, block.places[k]] = block.results[row, k]


@stage
def _keep_unfinished(block, count, limits):
    """Move the points that need a further step to the front; returns how many there are."""
    given, work, places = block.given, block.work, block.places
    kept, zero = np.uintp(0), work.dtype.type(0)
    for k in range(count):
        if not work[REMAINDER, k] <= limits.allowed and work[SEPARATION, k] > zero:
            for row in range(GIVEN):
                given[row, kept] = given[row, k]
            work[SEPARATION, kept] = work[SEPARATION, k]
            places[kept] = places[k]
            kept += np.uintp(1)
    return kept
