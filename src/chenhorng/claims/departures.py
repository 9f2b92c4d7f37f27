"""What carries the agreement with the paper: verdicts with departures from its print taken back.

The calibrated inputs depart from the words of the paper, and from the simplest values, in several
places. Each departure is taken back alone.  The baseline has all inputs as the text words them; and
inputs drawn at random from their usual ranges show what no search at all gives.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.stats.qmc import LatinHypercube

from chenhorng.calibration.calibration import Interpretation
from chenhorng.calibration.choice import printed_numbers
from chenhorng.claims.evidence import QUICK_EFFORT
from chenhorng.claims.judge import Judge, Verdicts, count_once, outcome
from thirdbody.core.parameters import Parameters
from thirdbody.core.particles import first_yield_depth

AT_FIRST_YIELD = "at_first_yield"  # a word for h_e/x_a in config/calibration.yaml


def read_departures(
    settings: Mapping[str, Any], parameters: Mapping[str, Any]
) -> list[dict[str, Any]]:
    """The ``departures`` of ``settings``, the content of ``config/calibration.yaml``: the ``name``
    of each and its ``inputs`` as values, SI, where the word ``at_first_yield`` is what follows from
    the ``parameters`` of the run."""
    known = {AT_FIRST_YIELD: first_yield_depth(Parameters(**parameters))}
    return [
        departure
        | {"inputs": {name: known.get(value, value) for name, value in departure["inputs"].items()}}
        for departure in settings["departures"]
    ]


def departure_words(
    judge: Judge, departures: Sequence[Mapping[str, Any]], found: Sequence[Verdicts]
) -> list[dict[str, Any]]:
    """Of each of the ``departures`` of ``read_departures`` its ``name``, its ``inputs`` and, by the
    id of a statement, the verdict ``found`` with it taken back, as a word."""
    return [
        dict(departure)
        | {"verdicts": {claim.id: outcome(claim, verdicts[claim.id]) for claim in judge.claims}}
        for departure, verdicts in zip(departures, found, strict=True)
    ]


def departure_rows(
    judge: Judge,
    settings: Mapping[str, Any],
    default: Verdicts,
    departures: Sequence[Mapping[str, Any]],
    found: Sequence[Verdicts],
) -> list[dict[str, Any]]:
    """Rows of the table ``departures``: the inputs of ``judge`` as they are, with the verdicts
    ``default``; those ``found`` with each of the ``departures`` of ``read_departures`` taken back;
    and the worst and the best of random inputs, which ``settings`` describe."""
    every = [{"name": "as it is", "inputs": {}}, *departures]
    rows = [_row(judge, settings, *each) for each in zip(every, [default, *found], strict=True)]
    counts = sorted(
        count_once(judge.claims, judge(inputs, QUICK_EFFORT)) for inputs in random_inputs(settings)
    )
    for word, (holds, judged) in (("least", counts[0]), ("most", counts[-1])):
        name = f"usual inputs at random, the {word} of {len(counts)} sets"
        rows.append({"departure": name, "inputs": "", "holds": holds, "judged": judged})
        unknown = "headline", "headline_statements", "median_deviation", "mean_deviation"
        rows[-1] |= dict.fromkeys(unknown)
    return rows


def _row(judge, settings, departure, verdicts):
    """The counts and deviations of the verdicts with the inputs of one departure changed."""
    holds, judged = count_once(judge.claims, verdicts)
    deviations = printed_numbers(judge.claims, verdicts, settings["headline"])["deviation"].abs()
    return {
        "departure": departure["name"],
        "inputs": ", ".join(
            f"{name} = {value if isinstance(value, str) else format(value, '.3g')}"
            for name, value in departure["inputs"].items()
        ),
        "holds": holds,
        "judged": judged,
        "headline": sum(verdicts[name].holds for name in settings["headline"]),
        "headline_statements": len(settings["headline"]),
        "median_deviation": deviations.median(),
        "mean_deviation": deviations.mean(),
    }


def random_inputs(settings: Mapping[str, Any]) -> list[dict[str, float]]:
    """Sets of the unknowns, SI, spread evenly over their usual ranges by a Latin hypercube."""
    names = settings["interpretations"] | {"random": {"fixed": {}}}
    unknowns = Interpretation.of("random", {**settings, "interpretations": names}).unknowns
    usual = [[unknown.position(end) for end in unknown.usual] for unknown in unknowns]
    low, high = np.transpose(usual)
    count, seed = settings["random_sets"], settings["seeds"][0]
    places = LatinHypercube(len(unknowns), rng=np.random.default_rng(seed)).random(count)
    return [
        {unknown.name: unknown.value(place) for unknown, place in zip(unknowns, row, strict=True)}
        for row in low + (high - low) * places
    ]
