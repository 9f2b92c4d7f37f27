"""Which inputs explain the paper's statements about equally well, drawn with how well they do.

The objective of a calibration is taken as a negative log-likelihood, and sets of inputs are drawn
with the probability density exp(-objective) by an ensemble of walkers.  At first these learn from each
other where to step; then most steps go anywhere that walkers have been before, however far, to a place
that is good as far as the places evaluated before tell.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from itertools import pairwise

import numpy as np
from emcee import EnsembleSampler, State
from emcee.moves import DEMove, DESnookerMove, MHMove
from numpy.typing import NDArray
from scipy.interpolate import RBFInterpolator
from scipy.stats import gaussian_kde

from thirdbody.study.calibration import Objective, Reading, acceptable, spread_out

# Walkers start from sets whose objective is at most this far above the best, for each unknown.
START_ABOVE_BEST = 1.0
ROUNDS = 16  # equal parts of the steps; after each, walkers look back at what they have drawn
FORGOTTEN = 4  # rounds that are not kept
# Power of the density that these draw: they come farther, so that the thin ends of it are known.
WARM = 0.7
INDEPENDENT = 0.8  # share of the steps that go anywhere, once walkers have drawn enough
ENOUGH = 10  # different sets, for each unknown
GUESSES = 40  # steps by guessed objectives for one whose objective is evaluated
KERNELS = 2000  # drawn places from which guessed steps set out, at most
REMEMBERED = 6000  # evaluated places that make a guess, at most
SMOOTHING = 0.1  # of guesses, as RBFInterpolator counts it


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
        What ``objective.found(reading, positions)`` names as the objective counts;
        ``objective.value(reading, positions, ends)`` tells it from ends that are guessed.
    evaluations : array, shape (evaluations, unknowns + 1)
        What ``thirdbody.study.search.search`` found: walkers start from the best of them.
    budget : mapping
        How many ``walkers`` make how many ``steps``, of which the first quarter is forgotten.
    seed : int
        Of the random numbers: the same seed gives the same result.
    report : callable
        Is given a line of text from time to time.

    Returns
    -------
    array, shape ((steps - steps // 4) * walkers, unknowns + 1)
        Positions [1], and in the last column the objective there [1].

    References
    ----------
    Foreman-Mackey et al. (2013), doi:10.1086/670067; ter Braak & Vrugt (2008),
    doi:10.1007/s11222-008-9104-9; Tierney (1994), doi:10.1214/aos/1176325750, for independent steps;
    Christen & Fox (2005), doi:10.1198/106186005X76983, for steps that are guessed before.
    """
    walkers, steps, unknowns = budget["walkers"], budget["steps"], len(reading.unknowns)
    known = []

    def log_density(positions, power):
        if _is_outside(positions):
            return -np.inf
        found = objective.found(reading, positions)
        known.append(np.concatenate([positions, found.ends.ravel()]))
        return -power * found.objective

    first = _first_walkers(evaluations, walkers, np.random.default_rng(seed))
    state = State(first, random_state=np.random.RandomState(seed).get_state())
    rows, drawn = [], []
    ends = np.linspace(0, steps, ROUNDS + 1).astype(int)
    for number, (begin, end) in enumerate(pairwise(ends)):
        moves = _moves(np.reshape(drawn, (-1, unknowns)), known, partial(objective.value, reading))
        power = 1.0 if number >= FORGOTTEN else WARM
        sampler = EnsembleSampler(walkers, unknowns, log_density, moves=moves, args=[power])
        state = State(state.coords, random_state=state.random_state)
        walk = sampler.sample(state, iterations=end - begin)
        for step, state in enumerate(walk, begin + 1):
            drawn.append(state.coords.copy())
            if number >= FORGOTTEN:
                rows.append(np.column_stack([state.coords, -state.log_prob]))
            if step % 20 == 0:
                report(f"{reading.name} seed {seed}: {step} of {steps} steps of {walkers} walkers")
    return np.concatenate(rows)


def _is_outside(positions):
    """Whether positions, shape (..., unknowns), lie outside of the unit cube: shape (...)."""
    return ((positions < 0.0) | (positions > 1.0)).any(axis=-1)


def _moves(drawn, known, value):
    """How walkers step, with the share of the steps: from where they are, by what parts two others; or,
    where enough was ``drawn``, to any place of its density, by many steps whose objective is guessed
    from the ``known`` places, of which the last is evaluated.  Whether that one is taken depends on the
    error of the guesses, which so have no part in what is drawn, but in how often walkers stay."""
    near = [(DEMove(), 0.8), (DESnookerMove(), 0.2)]
    if len(np.unique(drawn, axis=0)) < ENOUGH * drawn.shape[1]:
        return near
    density = gaussian_kde(_thinned(drawn, KERNELS).T)
    guess = _guess(_thinned(known, REMEMBERED), drawn, value)

    def anywhere(places, random):
        here, guessed = places, guess(places)
        advantage = guessed - density.logpdf(here.T)
        for _ in range(GUESSES):
            there = density.resample(len(places), seed=random).T
            gain = guess(there) - density.logpdf(there.T)
            goes = np.log(random.random_sample(len(places))) < gain - advantage
            here, advantage = np.where(goes[:, None], there, here), np.where(goes, gain, advantage)
        return here, guessed - guess(here)

    near = [(move, share * (1.0 - INDEPENDENT)) for move, share in near]
    return [*near, (MHMove(anywhere), INDEPENDENT)]


def _thinned(rows, most):
    """At most so many of the rows, evenly taken."""
    chosen = np.linspace(0, len(rows) - 1, min(most, len(rows))).astype(int)
    return np.asarray(rows)[chosen]


def _guess(known, drawn, value):
    """A guess of the logarithm of the density at places, shape (n, unknowns), from the scores of
    statements at ``known`` ones, where distances count as what was ``drawn`` scatters.  Scores change
    smoothly where the objective, their ``value``, has steps."""
    unknowns = drawn.shape[1]
    scales = np.linalg.cholesky(np.linalg.inv(np.cov(drawn.T)))
    ends = RBFInterpolator(
        known[:, :unknowns] @ scales, known[:, unknowns:], kernel="cubic", smoothing=SMOOTHING
    )

    def guess(places):
        guessed = ends(places @ scales).reshape(len(places), -1, 2)
        objectives = np.array(list(map(value, places, guessed)))
        return np.where(_is_outside(places), -np.inf, -objectives)

    return guess


def _first_walkers(evaluations, walkers, rng):
    """Sets from which walkers start, far from each other among the best."""
    unknowns = evaluations.shape[1] - 1
    good = acceptable(evaluations, START_ABOVE_BEST * unknowns)
    chosen = spread_out(good, walkers)[:, :-1]
    again = rng.integers(len(chosen), size=walkers - len(chosen))
    places = np.concatenate([chosen, chosen[again]])
    return np.clip(places + 1e-3 * rng.normal(size=places.shape), 1e-6, 1.0 - 1e-6)
