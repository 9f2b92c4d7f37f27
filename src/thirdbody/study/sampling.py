"""Which inputs explain the paper's statements about equally well, drawn with how well they do.

The objective of a calibration is taken as a negative log-likelihood, and sets of inputs are drawn
with the probability density exp(-objective) by affine-invariant ensemble sampling.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from emcee import EnsembleSampler
from emcee.moves import DEMove, DESnookerMove
from numpy.typing import NDArray

from thirdbody.study.calibration import Objective, Reading, acceptable, spread_out

# Walkers start from sets whose objective is at most this far above the best, for each unknown.
START_ABOVE_BEST = 1.0
FORGOTTEN = 4  # of so many steps the first one: walkers start among what is about as good


def posterior_sample(
    reading: Reading,
    objective: Objective,
    evaluations: NDArray[np.float64],
    budget: Mapping[str, int],
    seed: int,
    report: Callable[[str], object] = print,
) -> NDArray[np.float64]:
    """Draw sets of inputs with a density of exp(-objective).

    Parameters
    ----------
    reading : Reading
        Its unknowns are drawn.
    objective : Objective
        What ``objective.found(reading, positions)`` names as the objective counts.
    evaluations : array, shape (evaluations, unknowns + 1)
        What ``thirdbody.study.calibration.search`` found: walkers start from the best of them.
    budget : mapping
        How many ``walkers`` make how many ``steps``; the first quarter of the steps is forgotten.
    seed : int
        Of the random numbers: the same seed gives the same result.
    report : callable
        Is given a line of text from time to time.

    Returns
    -------
    array, shape (steps - steps // 4 times walkers, unknowns + 1)
        Positions [1], and in the last column the objective there [1].

    References
    ----------
    Goodman & Weare (2010), doi:10.2140/camcos.2010.5.65; Foreman-Mackey et al. (2013),
    doi:10.1086/670067.
    """
    walkers, steps, unknowns = budget["walkers"], budget["steps"], len(reading.unknowns)

    def log_density(positions):
        if (positions < 0.0).any() or (positions > 1.0).any():
            return -np.inf
        return -objective.found(reading, positions).objective

    sampler = EnsembleSampler(
        walkers, unknowns, log_density, moves=[(DEMove(), 0.8), (DESnookerMove(), 0.2)]
    )
    start = _first_walkers(evaluations, walkers, np.random.default_rng(seed))
    sampler.random_state = np.random.RandomState(seed).get_state()
    for step, _ in enumerate(sampler.sample(start, iterations=steps), 1):
        if step % 20 == 0:
            report(f"{reading.name} seed {seed}: {step} of {steps} steps of {walkers} walkers")
    kept = dict(discard=steps // FORGOTTEN, flat=True)
    return np.column_stack([sampler.get_chain(**kept), -sampler.get_log_prob(**kept)])


def _first_walkers(evaluations, walkers, rng):
    """Sets from which walkers start, far from each other among the best."""
    unknowns = evaluations.shape[1] - 1
    good = acceptable(evaluations, START_ABOVE_BEST * unknowns)
    chosen = spread_out(good, walkers)[:, :-1]
    again = rng.integers(len(chosen), size=walkers - len(chosen))
    places = np.concatenate([chosen, chosen[again]])
    return np.clip(places + 1e-3 * rng.normal(size=places.shape), 1e-6, 1.0 - 1e-6)
