"""The library against the oracle in extended precision (``tests/oracle``), over the whole
domain."""

import warnings
from collections.abc import Iterator, Mapping
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from tests.oracle.comparison import BEYOND_BOUND, PLACES, Compared, Drawn, compare, draw_points
from tests.oracle.extended import Oracle, why_not


def oracle_rows(settings: Mapping[str, Any], threads: int = 1) -> list[dict[str, Any]]:
    """Rows of the table ``oracle``, of as many points as ``config/accuracy.yaml`` says.

    There are none where the oracle cannot run.
    """
    if why_not() is not None:
        print(f"nothing is compared in extended precision: {why_not()}")
        return []
    rows = []
    with TemporaryDirectory() as folder, warnings.catch_warnings(action="ignore"):
        oracle = Oracle(folder, threads)
        for place in PLACES:
            surfaces, points, seed = (settings[name] for name in ("surfaces", "points", "seed"))
            drawn = draw_points(oracle, surfaces, points, seed, place)
            rows += [{"place": place} | row for row in _counted(drawn, compare(drawn, oracle))]
    return rows


def _counted(drawn: Drawn, compared: Compared) -> Iterator[dict[str, Any]]:
    """A row for each ``rtol``."""
    rtols = drawn.per_point(drawn.rtols)
    beyond, wrong = np.zeros(rtols.shape, bool), np.zeros(rtols.shape, bool)
    for name, places in compared.problems.items():
        (beyond if name.endswith(BEYOND_BOUND) else wrong)[places] = True
    good = compared.known & compared.good
    largest = np.max([np.where(good, each, 0.0) for each in compared.error.values()], axis=0)
    for rtol in np.unique(rtols):
        here = rtols == rtol
        yield {
            "rtol": float(rtol),
            "points": int(here.sum()),
            "without_values": int((here & ~compared.known).sum()),
            "not_converged": int((here & compared.known & ~compared.good).sum()),
            "beyond_bound": int((here & beyond).sum()),
            "wrong": int((here & wrong).sum()),
            "largest_error": float(largest[here].max()),
        }
