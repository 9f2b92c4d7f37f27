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
from thirdbody.study.verdicts import Verdicts, fold_counts, predict, rank_interpretations

PRICED = 100  # number of best sets of a cost search that are evaluated again


def choose_default(
    judge: Judge, contents: Sequence[Mapping[str, Any]], settings: Mapping[str, Any]
) -> tuple[dict[str, Any], pd.DataFrame]:
    """What the calibrated file of the default has beside its own content, and all interpretations in the
    order of the rule, from the ``contents`` of their calibrated files."""
    by_name = {content["interpretation"]: content for content in contents}
    verdicts = {name: judge(content["inputs"]) for name, content in by_name.items()}
    predicted = {name: predict(judge, content) for name, content in by_name.items()}
    table = rank_interpretations(judge, contents, verdicts, predicted, settings)
    ranking = table["interpretation"].tolist()
    fractions = {
        name: [held / max(of, 1) for held, of in counts]
        for name, content in by_name.items()
        if (counts := fold_counts(judge.claims, content, predicted[name]))
    }
    members, labels = mixed_ensemble(
        [by_name[name] for name in ranking], fractions, settings["ensemble"]
    )
    chosen = {
        "interpretation": ranking[0],
        "fronts": price_fronts(judge, by_name[ranking[0]], verdicts[ranking[0]], settings),
        "ensemble": members,
        "ensemble_interpretations": labels,
    }
    return chosen, table


def price_fronts(
    judge: Judge, content: Mapping[str, Any], verdicts: Verdicts, settings: Mapping[str, Any]
) -> dict[str, list[list[float]]]:
    """The ``price_front`` of each headline number that the inputs of a calibrated file miss, by the id of its
    statement, from a search in which it has ``price_weight`` times its weight."""
    interpretation = Interpretation.of(content["interpretation"], settings)
    objective = Objective.of(judge.claims, settings, judge.base)
    names = *(unknown.name for unknown in interpretation.unknowns), *interpretation.opposites
    inputs = {name: content["inputs"][name] for name in names}
    start = interpretation.positions(inputs)
    fronts = {}
    for name, verdict in verdicts.items():
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
