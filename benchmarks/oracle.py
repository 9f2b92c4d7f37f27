"""How far the library is from an implementation in extended precision, over the whole domain and in
all readings: ``tests/oracle``, which is compiled when it is needed."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Mapping
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from tests.oracle.comparison import BEYOND_BOUND, PLACES, Compared, Drawn, compare, draw_points
from tests.oracle.extended import READINGS, Oracle, why_not
from thirdbody.solver.plan import WAYS

WORDS = {"size_distribution": "phi_a"} | {name: name for name in READINGS if name != "phi_a"}


def oracle_rows(settings: Mapping[str, Any], threads: int = 1) -> list[dict[str, Any]]:
    """Count points that are wrong or beyond their bound, by how they are drawn, way, rtol and reading.

    Parameters
    ----------
    settings : mapping
        ``oracle`` of ``config/accuracy.yaml``.
    threads : int
        Of the oracle.

    Returns
    -------
    list of dict
        Rows of the table ``oracle``; none where the oracle cannot run, and a line says why.
    """
    if why_not() is not None:
        print(f"nothing is compared in extended precision: {why_not()}")
        return []
    drawing = settings["surfaces"], settings["points"], settings["seed"]
    rows = []
    with TemporaryDirectory() as folder, warnings.catch_warnings():
        # of points that have no film or no load, and of those far beyond usual ones
        warnings.simplefilter("ignore")
        oracle = Oracle(folder, threads)
        for place in PLACES:
            drawn = draw_points(oracle, *drawing, place)
            for way in WAYS:
                common = {"place": place, "way": way}
                rows += [common | row for row in _counted(drawn, compare(drawn, oracle, way))]
    return rows


def _counted(drawn: Drawn, compared: Compared) -> Iterator[dict[str, Any]]:
    """A row for each ``rtol`` and combination of readings."""
    rtol = drawn.per_point(drawn.rtols)
    size = rtol.shape
    beyond, wrong = np.zeros(size, bool), np.zeros(size, bool)
    for name, places in compared.problems.items():
        (beyond if name.endswith(BEYOND_BOUND) else wrong)[places] = True
    good = compared.known & compared.good
    largest = np.max([np.where(good, each, 0.0) for each in compared.error.values()], axis=0)
    columns = [rtol, *(drawn.model[name] for name in WORDS.values())]
    kinds = list(zip(*(column.tolist() for column in columns), strict=True))
    places_of: dict[tuple, list[int]] = {}
    for index, kind in enumerate(kinds):
        places_of.setdefault(kind, []).append(index)
    for kind, places in places_of.items():
        yield dict(zip(("rtol", *WORDS), kind, strict=True)) | {
            "points": len(places),
            "without_values": int(np.count_nonzero(~compared.known[places])),
            "not_converged": int(np.count_nonzero((compared.known & ~compared.good)[places])),
            "beyond_bound": int(np.count_nonzero(beyond[places])),
            "wrong": int(np.count_nonzero(wrong[places])),
            "largest_error": float(largest[places].max()),
            "over_rtol": float(largest[places].max() / kind[0]),
        }
