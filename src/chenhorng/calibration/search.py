"""Search for the inputs that explain most of the paper, and samples of inputs that explain about as
much.

The objective has many narrow valleys.  A search therefore starts from scattered sets of inputs.
Least squares descend to the nearest valleys, first with a loss that also has a slope far from a
statement.  The search then hops from the deepest valley to valleys nearby.  At last an evolution
strategy follows the best valley.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import cma
import numpy as np
from emcee import EnsembleSampler, State
from emcee.moves import DEMove, DESnookerMove
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.stats.qmc import LatinHypercube

from chenhorng.calibration.calibration import SLOPE_OF_LOSS, Interpretation, Objective

DIFFERENCES = 0.01, 0.004  # steps of the slopes in both rounds of a descent, in the unit cube
# iterations of least squares: from every start, in both rounds from the best, and after a hop
SCREENING, DESCENT, HOPPING = 6, (20, 20), (8, 10)
HOP = 0.1  # standard deviation of a hop, in the unit cube
# standard deviations of the first steps of both evolutions, in the unit cube
FIRST_STEPS = 0.03, 0.01
SAME_HEIGHT = 0.03  # largest difference of objectives in a converged search [1]
START_SCATTER = 5e-3  # standard deviation of the starts of walkers, in the unit cube
# Walkers step by the difference of two other walkers.  Full-length steps move between valleys.
MOVES = ((DEMove(), 0.7), (DEMove(gamma0=1.0), 0.2), (DESnookerMove(), 0.1))


def scatter(interpretation: Interpretation, budget: Mapping[str, Any]) -> NDArray:
    """Positions that fill the unit cube of the unknowns, shape (scattered, unknowns).  Every second
    row has a summit radius of at least ``budget["elastic_radius"]``."""
    unknowns = interpretation.unknowns
    cube = LatinHypercube(len(unknowns), rng=np.random.default_rng(0))
    positions = cube.random(budget["scattered"])
    for column, unknown in enumerate(unknowns):
        if unknown.name == "summit_radius":
            least = unknown.position(budget["elastic_radius"])
            positions[::2, column] = least + (1.0 - least) * positions[::2, column]
    return positions


def nearby_starts(interpretation: Interpretation, other: Interpretation, rows: NDArray) -> NDArray:
    """The start of a search at the best inputs of the ``other`` interpretation, shape (1,
    unknowns).  ``rows`` are the positions and objectives of the other."""
    known = other.fixed | other.values(best_of(rows)[:-1])
    return interpretation.positions(known)[None]


def scattered_starts(
    objective: Objective,
    every: Objective,
    rows: NDArray,
    settings: Mapping[str, Any],
    seeds: Sequence[int],
) -> NDArray:
    """The starts of ``seeds`` among scattered positions, shape (starts, unknowns): the best for
    ``objective``.

    ``rows`` are the scattered positions and the scores of all statements, in the order of
    ``every``.  Each seed of the ``settings`` has starts of its own.
    """
    positions, scores = np.split(rows, [-len(every.claims)], axis=1)
    ranking = rank_starts(objective, objective.take(every, scores))
    among, most = settings["seeds"], settings["budget"]["starts"]
    ranks = [ranking[among.index(seed) :: len(among)][:most] for seed in seeds]
    return positions[np.concatenate(ranks)]


def find_inputs(
    interpretation: Interpretation,
    objective: Objective,
    starts: NDArray,
    budget: Mapping[str, Any],
    hops: int,
    seed: int,
) -> NDArray:
    """Search the unknowns for the least objective from several ``starts``, shape (starts,
    unknowns).  Returns all positions, with the objective [1] in the last column.

    Least squares descend from every start.  With more than ``budget["descents"]`` starts, a short
    descent chooses the best of them first.  Further descents begin at ``hops`` random steps away
    from the best so far.  Two evolutions follow from the best of all.
    """
    rows, most = [], budget["iterations"]
    descent, hopping = (np.minimum(rounds, most).tolist() for rounds in (DESCENT, HOPPING))
    if len(starts) > budget["descents"]:
        how = min(SCREENING, most), _wide_loss, DIFFERENCES[0]
        rows = [descend(interpretation, objective, start, *how) for start in starts]
        ends = sorted(map(best_of, rows), key=lambda row: row[-1])
        starts = np.array([end[:-1] for end in ends[: budget["descents"]]])
    for start in starts:
        rows.append(descend_twice(interpretation, objective, start, descent))
    random = np.random.default_rng(seed)
    for _ in range(hops):
        best = best_of(np.vstack(rows))[:-1]
        start = np.clip(best + HOP * random.normal(size=best.size), 0.0, 1.0)
        rows.append(descend_twice(interpretation, objective, start, hopping))
    for step in FIRST_STEPS:
        best = best_of(np.vstack(rows))[:-1]
        rows.append(search(interpretation, objective, best, budget, seed, step))
    return np.vstack(rows)


def descend_twice(interpretation, objective, start, iterations):
    """Least squares with the wide loss, then with the loss of the objective: rows as from
    ``descend``."""
    first = descend(interpretation, objective, start, iterations[0], _wide_loss, DIFFERENCES[0])
    best = best_of(first)[:-1]
    second = descend(interpretation, objective, best, iterations[1], _loss, DIFFERENCES[1])
    return np.vstack([first, second])


def best_of(rows: NDArray) -> NDArray:
    """The row of positions and objective with the least objective."""
    return rows[rows[:, -1].argmin()]


def rank_starts(objective: Objective, scores: NDArray) -> NDArray:
    """The indices of sets of inputs, the best first, from their ``scores``, shape (sets,
    statements)."""
    return np.argsort(_wide_loss(scores**2)[0] @ objective.weights, kind="stable")


def descend(
    interpretation: Interpretation,
    objective: Objective,
    start: NDArray,
    iterations: int,
    loss_of: Callable[[NDArray], NDArray],
    difference: float,
) -> NDArray:
    """Least squares of the scores from ``start``: all positions, with the objective [1] in the last
    column.  ``loss_of`` returns the loss and its first two derivatives over the squared scores."""
    rows = []

    def scores(positions):
        inputs = interpretation.values(positions)
        values = objective.scores(interpretation, inputs)
        rows.append([*positions, objective.value(interpretation.penalty(inputs), values)])
        return values

    edge = 1e-6  # least squares starts inside its bounds
    least_squares(
        scores,
        np.clip(start, edge, 1.0 - edge),
        bounds=(0.0, 1.0),
        loss=lambda squares: objective.weights * loss_of(squares),
        diff_step=difference,
        x_scale=0.1,
        ftol=1e-4,
        max_nfev=iterations,
    )
    return np.array(rows)


def _wide_loss(squares):
    """The wide loss sqrt(1 + s^2) - 1, with a slope near and far, and its derivatives over s^2."""
    root = np.sqrt(1.0 + squares)
    return np.stack([root - 1.0, 0.5 / root, -0.25 / root**3])


def _loss(squares):
    """The loss of the objective, s^4/(1 + s^4) + 0.1 s, and its derivatives over s^2."""
    squares = np.maximum(squares, 1e-12)
    fourth, score = squares**2, np.sqrt(squares)
    return np.stack(
        [
            fourth / (1.0 + fourth) + SLOPE_OF_LOSS * score,
            2.0 * squares / (1.0 + fourth) ** 2 + 0.5 * SLOPE_OF_LOSS / score,
            (2.0 - 6.0 * fourth) / (1.0 + fourth) ** 3 - 0.25 * SLOPE_OF_LOSS / score**3,
        ]
    )


def search(
    interpretation: Interpretation,
    objective: Callable[[Interpretation, NDArray], float],
    start: NDArray,
    budget: Mapping[str, Any],
    seed: int,
    first_step: float = FIRST_STEPS[0],
) -> NDArray:
    """Search the unknowns, at least two, for the least objective.  Returns all positions, with the
    objective [1] in the last column.

    The search is a CMA evolution strategy with a quadratic surrogate (Hansen 2019,
    doi:10.1145/3321707.3321842).
    """
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
    cma.fmin_lq_surr(function, start, first_step, options)
    least = min(row[-1] for row in rows)
    print(f"{interpretation.name} seed {seed}: {len(rows)} evaluations, least {least:.3f}")
    return np.array(rows)


def posterior_sample(
    interpretation: Interpretation,
    objective: Callable[[Interpretation, NDArray], float],
    starts: NDArray,
    steps: int,
    seed: int,
) -> NDArray:
    """Sample sets of inputs with the density exp(-objective): rows as from ``search``.

    Walkers start from the positions ``starts``, shape (walkers, unknowns).  The first quarter of
    their ``steps`` is dropped (Foreman-Mackey et al. 2013, doi:10.1086/670067; ter Braak & Vrugt
    2008, doi:10.1007/s11222-008-9104-9).
    """

    def log_density(positions):
        if ((positions < 0.0) | (positions > 1.0)).any():
            return -np.inf
        return -objective(interpretation, positions)

    random = np.random.RandomState(seed)
    start = np.clip(starts + START_SCATTER * random.normal(size=starts.shape), 1e-6, 1.0 - 1e-6)
    sampler = EnsembleSampler(*starts.shape, log_density, moves=MOVES)
    sampler.run_mcmc(State(start, random_state=random.get_state()), steps)
    dropped = steps // 4
    positions = sampler.get_chain(discard=dropped, flat=True)
    return np.column_stack([positions, -sampler.get_log_prob(discard=dropped, flat=True)])
