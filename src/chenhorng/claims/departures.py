"""Verdicts with departures from the print taken back, which show what carries the agreement.

Several calibrated inputs depart from the words of the paper, or from the simplest values.  Each
departure is taken back alone.  The baseline has all inputs as the text words them.  Inputs drawn at
random from their usual ranges show the agreement without any search.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.stats.qmc import LatinHypercube

from chenhorng.calibration.calibration import Interpretation
from chenhorng.calibration.choice import printed_numbers
from chenhorng.claims.evidence import QUICK_EFFORT
from chenhorng.claims.judge import Judge, Verdicts, count_once, outcome


def departure_words(
    judge: Judge, settings: Mapping[str, Any], taken_back: Sequence[Verdicts]
) -> list[dict[str, Any]]:
    """The ``departures`` of ``settings``, the content of ``config/calibration.yaml``, with their
    verdicts.

    A departure has its ``name``, its ``inputs``, and ``verdicts``: the word of a verdict by the id
    of the statement.  ``taken_back`` are the verdicts with each departure taken back.
    """
    return [
        dict(departure)
        | {"verdicts": {claim.id: outcome(claim, verdicts[claim.id]) for claim in judge.claims}}
        for departure, verdicts in zip(settings["departures"], taken_back, strict=True)
    ]


def departure_rows(
    judge: Judge, settings: Mapping[str, Any], default: Verdicts, taken_back: Sequence[Verdicts]
) -> list[dict[str, Any]]:
    """Rows of the table ``departures``.

    The first row has the inputs of ``judge`` as they are, with the verdicts ``default``.  A row for
    each departure follows, with the verdicts ``taken_back``.  The last two rows are the worst and
    the best set of random inputs.
    """
    departures = [{"name": "as it is", "inputs": {}}, *settings["departures"]]
    rows = [
        _row(judge, settings, departure, verdicts)
        for departure, verdicts in zip(departures, [default, *taken_back], strict=True)
    ]
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
    """Counts and deviations of the ``verdicts`` with the inputs of a ``departure``."""
    holds, judged = count_once(judge.claims, verdicts)
    deviations = printed_numbers(judge.claims, verdicts, settings["headline"])["deviation"].abs()
    return {
        "departure": departure["name"],
        "inputs": ", ".join(f"{name} = {value}" for name, value in departure["inputs"].items()),
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
    points = LatinHypercube(len(unknowns), rng=np.random.default_rng(seed)).random(count)
    return [
        {
            unknown.name: unknown.value(position)
            for unknown, position in zip(unknowns, row, strict=True)
        }
        for row in low + (high - low) * points
    ]
