"""The default interpretation, chosen by the rule, what the headline numbers that it misses would cost, and the
ensemble over the interpretations that predict about as much."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from thirdbody.study.calibration import Interpretation, Objective
from thirdbody.study.judge import Judge
from thirdbody.study.results import rounded
from thirdbody.study.search import search
from thirdbody.study.verdicts import Candidate, rank_interpretations

PRICED = 100  # number of best sets of a cost search that are evaluated again


def choose_default(
    judge: Judge, contents: Sequence[Mapping[str, Any]], settings: Mapping[str, Any]
) -> tuple[dict[str, Any], pd.DataFrame]:
    """What the calibrated file of the default has beside its own content, and all interpretations in the
    order of the rule, from the ``contents`` of their calibrated files."""
    candidates = {each["interpretation"]: Candidate.of(judge, each) for each in contents}
    table = rank_interpretations(judge, candidates.values(), settings)
    ranking = [candidates[name] for name in table["interpretation"]]
    fractions = {
        each.name: [held / max(of, 1) for held, of in each.fold_counts]
        for each in ranking
        if each.folds
    }
    members, labels = mixed_ensemble(
        [each.content for each in ranking], fractions, settings["ensemble"]
    )
    best = ranking[0]
    chosen = {
        "interpretation": best.name,
        "fronts": price_fronts(judge, best, settings),
        "ensemble": members,
        "ensemble_interpretations": labels,
    }
    return chosen, table


def price_fronts(
    judge: Judge, best: Candidate, settings: Mapping[str, Any]
) -> dict[str, list[list[float]]]:
    """The ``price_front`` of each headline number that the ``best`` interpretation misses, by the id of its
    statement, from a search in which it has ``price_weight`` times its weight."""
    interpretation = Interpretation.of(best.name, settings)
    objective = Objective.of(judge.claims, settings, judge.base)
    names = [unknown.name for unknown in interpretation.unknowns]
    inputs = {name: best.content["inputs"][name] for name in names}
    start = interpretation.positions(inputs)
    fronts = {}
    for name, verdict in best.verdicts.items():
        if name not in settings["headline"] or verdict.holds:
            continue
        emphasis = np.where(objective.repeating(name), settings["price_weight"], 1.0)
        raised = replace(objective, weights=objective.weights * emphasis)
        rows = search(interpretation, raised, start, settings["budget"], settings["seeds"][0])
        fronts[name] = price_front(interpretation, objective, name, rows, inputs)
    return fronts


def price_front(
    interpretation: Interpretation,
    objective: Objective,
    name: str,
    rows: NDArray,
    inputs: Mapping[str, float],
) -> list[list[float]]:
    """Pareto front of the score of the statement ``name`` and the objective without it and its repetitions,
    from the published ``inputs`` and ``rows`` of a search with a higher weight of this statement."""
    place = [claim.id for claim in objective.claims].index(name)
    own = objective.repeating(name)
    best = rows[np.argsort(rows[:, -1], kind="stable")[:PRICED]]
    points = set()
    for some in (dict(inputs), *(interpretation.values(row[:-1]) for row in best)):
        scores = objective.scores(interpretation, some)
        others = objective.value(interpretation.penalty(some), np.where(own, 0.0, scores))
        points.add((rounded(scores[place]), rounded(others)))
    front, least = [], np.inf
    for score, others in sorted(points):
        if others < least:
            front.append([score, others])
            least = others
    return front


def mixed_ensemble(
    contents: Sequence[Mapping[str, Any]], fractions: Mapping[str, Sequence[float]], size: int
) -> tuple[list[dict[str, Any]], list[str]]:
    """The inputs of an ensemble of ``size`` members, SI, and the interpretation of each, from calibrated
    files, the default first.  An interpretation has members in proportion to its mean predicted fraction,
    if that is at most one standard deviation (of the default's) below that of the default."""
    means = {name: float(np.mean(each)) for name, each in fractions.items()}
    first = contents[0]["interpretation"]
    least = means[first] - float(np.std(fractions[first]))
    taken = [each for each in contents if means.get(each["interpretation"], -np.inf) >= least]
    weights = np.array([means[each["interpretation"]] for each in taken])
    ends = np.round(np.cumsum(weights) / weights.sum() * size).astype(int)
    members, labels = [], []
    for content, count in zip(taken, np.diff(ends, prepend=0), strict=True):
        sets = content["ensemble"]
        places = np.linspace(0, len(sets) - 1, count).round().astype(int)
        members += [{**content["inputs"], **sets[place]} for place in places]
        labels += [content["interpretation"]] * int(count)
    return members, labels
