"""How often the range of the ensemble is right about what it has not seen.

A member of the ensemble was fitted without the statements of some figures.  Each printed number of
the headline is held against the range of the members that have not seen it.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd
from scipy.stats.qmc import LatinHypercube

from chenhorng.claims.claim import Claim
from chenhorng.claims.judge import Verdicts
from thirdbody.core.parameters import Parameters
from thirdbody.ensembles import Ensemble, range_over_members
from thirdbody.points import solve

DIGITS = 3  # of the ends of a range, as many as the paper prints at most
VARIABLES = "solid_load_fraction", "total_contact_area", "film_thickness"


def printed_and_ranges(
    claims: Iterable[Claim],
    numbers: pd.DataFrame,
    members: Sequence[Verdicts],
    unseen: Sequence[Sequence[int]],
) -> Iterator[dict[str, Any]]:
    """Rows of the table ``coverage``: each printed number with the range of the
    ``members`` that have not seen its figure, ends to ``DIGITS`` digits.

    ``numbers`` come from ``chenhorng.calibration.choice.printed_numbers``; ``unseen`` has the
    figures that each member was fitted without.
    """
    first_figures = {claim.id: min(claim.all_figures) for claim in claims}
    for id, rows in numbers.groupby("id", sort=False):
        blind = [
            verdicts[id].numbers
            for verdicts, figures in zip(members, unseen, strict=True)
            if first_figures[id] in figures
        ]
        for place, row in enumerate(rows.to_dict("records")):
            values = [member[min(place, len(member) - 1)] for member in blind]
            low, high = (float(f"{end:.{DIGITS}g}") for end in range_over_members(values))
            yield {
                **{key: row[key] for key in ("id", "place", "statement", "printed", "computed")},
                "low": low,
                "high": high,
                "members": len(blind),
                "inside": "yes" if low <= row["printed"] <= high else "no",
            }


def random_conditions(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Conditions spread evenly over the logarithms between the ends in ``settings``, the entry
    ``coverage`` of ``config/calibration.yaml``, by name."""
    ends = {name: ends for name, ends in settings.items() if name != "conditions"}
    low, high = np.log(np.transpose([*ends.values()]))
    places = LatinHypercube(len(ends), rng=np.random.default_rng(0)).random(settings["conditions"])
    return dict(zip(ends, np.exp(low + (high - low) * places).T, strict=True))


def sets_and_ranges(
    ensemble: Ensemble,
    sets: Mapping[str, Parameters],
    conditions: Mapping[str, Any],
) -> Iterator[dict[str, Any]]:
    """Rows of the table ``coverage_of_sets``: at how many of the ``conditions`` each of ``sets`` of
    inputs, by name, lies within the range of the ``ensemble``."""
    every = solve(parameters=ensemble, members=True, progress=False, **conditions)
    ranges = {name: range_over_members(every.variables[name]) for name in VARIABLES}
    widths = {
        name: float(np.nanmedian((high - low) / np.abs(0.5 * (high + low))))
        for name, (low, high) in ranges.items()
    }
    for set_name, inputs in sets.items():
        points = solve(parameters=inputs, progress=False, **conditions)
        for name, (low, high) in ranges.items():
            values = points.variables[name]
            known = np.isfinite(values)
            inside = (low <= values) & (values <= high)
            yield {
                "set": set_name,
                "variable": name,
                "inside": int(inside[known].sum()),
                "conditions": int(known.sum()),
                "relative_width": widths[name],
            }
