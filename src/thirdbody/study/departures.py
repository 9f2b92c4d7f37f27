"""What carries the agreement with the paper: verdicts with departures from its print taken back.

The calibrated inputs depart from the words of the paper, and from the simplest values, in several places.
Each departure is taken back alone.  The baseline has all inputs as the text words them; and inputs drawn at
random from their usual ranges show what no search at all gives.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy.stats.qmc import LatinHypercube

from thirdbody.study.calibration import Interpretation
from thirdbody.study.choice import printed_numbers
from thirdbody.study.evidence import QUICK_EFFORT
from thirdbody.study.judge import Judge, count_once


def departure_rows(judge: Judge, settings: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Rows of the table ``departures``: the inputs of ``judge`` as they are, with each of the ``departures`` of
    ``settings`` (the content of ``config/calibration.yaml``) taken back, and the worst and the best of
    random inputs."""
    rows = [_row(judge, settings, {"name": "as it is", "inputs": {}})]
    rows += [_row(judge, settings, departure) for departure in settings["departures"]]
    counts = sorted(
        count_once(judge.claims, judge(inputs, QUICK_EFFORT)) for inputs in random_inputs(settings)
    )
    for word, (holds, judged) in (("least", counts[0]), ("most", counts[-1])):
        name = f"usual inputs at random, the {word} of {len(counts)} sets"
        rows.append({"departure": name, "inputs": "", "holds": holds, "judged": judged})
        rows[-1] |= {"headline": None, "median_deviation": None, "mean_deviation": None}
    return rows


def _row(judge, settings, departure):
    """The counts and deviations with the inputs of one departure changed."""
    verdicts = judge(departure["inputs"])
    holds, judged = count_once(judge.claims, verdicts)
    deviations = printed_numbers(judge.claims, verdicts, settings["headline"])["deviation"].abs()
    return {
        "departure": departure["name"],
        "inputs": ", ".join(f"{name} = {value}" for name, value in departure["inputs"].items()),
        "holds": holds,
        "judged": judged,
        "headline": sum(verdicts[name].holds for name in settings["headline"]),
        "median_deviation": deviations.median(),
        "mean_deviation": deviations.mean(),
    }


def random_inputs(settings: Mapping[str, Any]) -> list[dict[str, float]]:
    """Sets of the unknowns, SI, spread evenly over their usual ranges by a Latin hypercube."""
    names = settings["interpretations"] | {"random": {"fixed": {}}}
    unknowns = Interpretation.of("random", settings | {"interpretations": names}).unknowns
    usual = [[unknown.position(end) for end in unknown.usual] for unknown in unknowns]
    low, high = np.transpose(usual)
    count, seed = settings["random_sets"], settings["seeds"][0]
    places = LatinHypercube(len(unknowns), rng=np.random.default_rng(seed)).random(count)
    return [
        {unknown.name: unknown.value(place) for unknown, place in zip(unknowns, row, strict=True)}
        for row in low + (high - low) * places
    ]
