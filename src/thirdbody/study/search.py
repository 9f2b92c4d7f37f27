"""Search for the inputs that explain most of the paper, and samples of those that explain about as much."""

from collections.abc import Callable, Mapping
from typing import Any

import cma
import numpy as np
from emcee import EnsembleSampler, State
from emcee.moves import DEMove, DESnookerMove
from numpy.typing import NDArray
from scipy.stats.qmc import LatinHypercube

from thirdbody.study.calibration import Interpretation

FIRST_STEP = 0.05  # standard deviation of the first steps of a search, in the unit cube
SAME_HEIGHT = 0.03  # a search has converged when objectives differ by no more [1]
START_ABOVE_BEST = 1.0  # walkers start from sets up to this above the best, per unknown
# Steps by the difference of two walkers; full-length steps move between valleys.
MOVES = ((DEMove(), 0.7), (DEMove(gamma0=1.0), 0.2), (DESnookerMove(), 0.1))


def scatter(interpretation: Interpretation, budget: Mapping[str, Any]) -> NDArray:
    """Points that fill the unit cube of the unknowns, shape (scattered, unknowns); every second one has
    summits of at least ``budget["elastic_radius"]``."""
    unknowns = interpretation.unknowns
    places = LatinHypercube(len(unknowns), rng=np.random.default_rng(0)).random(budget["scattered"])
    for column, unknown in enumerate(unknowns):
        if unknown.name == "summit_radius":
            least = unknown.position(budget["elastic_radius"])
            places[::2, column] = least + (1.0 - least) * places[::2, column]
    return places


def search(
    interpretation: Interpretation,
    objective: Callable[[Interpretation, NDArray], float],
    start: NDArray,
    budget: Mapping[str, Any],
    seed: int,
) -> NDArray:
    """Search the unknowns, at least two, for the least objective, by a CMA evolution strategy with a quadratic
    surrogate (Hansen 2019, doi:10.1145/3321707.3321842): all positions with the objective [1] in the last
    column."""
    rows = []

    def function(positions):
        value = objective(interpretation, positions)
        rows.append([*positions, value])
        return value

    options = {
        "bounds": [0.0, 1.0],
        "maxfevals": budget["evaluations"] * len(interpretation.unknowns),
        "tolfun": SAME_HEIGHT,
        "tolfunhist": SAME_HEIGHT,
        "seed": seed,
        "verbose": -9,
    }
    cma.fmin_lq_surr(function, start, FIRST_STEP, options)
    least = min(row[-1] for row in rows)
    print(f"{interpretation.name} seed {seed}: {len(rows)} evaluations, least {least:.3f}")
    return np.array(rows)


def posterior_sample(
    interpretation: Interpretation,
    objective: Callable[[Interpretation, NDArray], float],
    evaluations: NDArray,
    budget: Mapping[str, int],
    seed: int,
) -> NDArray:
    """Sample sets of inputs with the density exp(-objective) by walkers that start from the best of a
    search: rows as from ``search``, without the first quarter of the steps (Foreman-Mackey et al. 2013,
    doi:10.1086/670067; ter Braak & Vrugt 2008, doi:10.1007/s11222-008-9104-9)."""

    def log_density(positions):
        if ((positions < 0.0) | (positions > 1.0)).any():
            return -np.inf
        return -objective(interpretation, positions)

    walkers, steps, unknowns = budget["walkers"], budget["steps"], len(interpretation.unknowns)
    random = np.random.RandomState(seed)
    ordered = evaluations[np.argsort(evaluations[:, -1], kind="stable")]
    good = ordered[ordered[:, -1] <= ordered[0, -1] + START_ABOVE_BEST * unknowns, :-1]
    chosen = good[np.linspace(0, len(good) - 1, walkers).astype(int)]
    start = np.clip(chosen + 1e-3 * random.normal(size=chosen.shape), 1e-6, 1.0 - 1e-6)
    sampler = EnsembleSampler(walkers, unknowns, log_density, moves=MOVES)
    sampler.run_mcmc(State(start, random_state=random.get_state()), steps)
    dropped = steps // 4
    places = sampler.get_chain(discard=dropped, flat=True)
    return np.column_stack([places, -sampler.get_log_prob(discard=dropped, flat=True)])
