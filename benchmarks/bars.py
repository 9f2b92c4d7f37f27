"""What the solver is to achieve, beside what was measured in the same run.

Each such demand is called a *bar*.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from benchmarks.classes import HEAVIEST
from benchmarks.omissions import FLUID, TOTAL
from benchmarks.points import CLASS
from benchmarks.starts import AUTOMATIC
from benchmarks.surfaces import READY

USUAL_RTOL, LOOSE_RTOL = 1e-9, 1e-3


@dataclass(frozen=True)
class Bar:
    """A demand on a measured number.

    Attributes
    ----------
    what : str
        What is measured, and in which unit.
    limit : float
        What it is to be, in that unit.
    least : bool
        Whether it is to be at least so much; if not, at most.
    """

    what: str
    limit: float
    least: bool

    def row(self, value: float | None) -> dict[str, Any]:
        """Row of the table ``bars`` for a measured ``value`` in the unit of the bar, None if there is
        none.

        Examples
        --------
        >>> Bar("seconds to prepare a surface", 0.2, least=False).row(0.1)["verdict"]
        'holds'
        """
        if value is None:
            verdict = "not measured"
        else:
            holds = value >= self.limit if self.least else value <= self.limit
            verdict = "holds" if holds else "fails"
        return {
            "what": self.what,
            "sense": "at least" if self.least else "at most",
            "bar": self.limit,
            "measured": value,
            "verdict": verdict,
        }


BARS = {
    "baseline": Bar("quad and brentq over the library at 1e-9, heaviest class", 8000.0, True),
    "loose": Bar("quad and brentq over the library at 1e-3, heaviest class", 16000.0, True),
    "trade": Bar("time at 1e-9 over that at 1e-3, heaviest class", 2.0, True),
    "setup": Bar("seconds to prepare a surface", 0.2, False),
    "processes": Bar("speed of several processes over one", 1.8, True),
    "threads": Bar("speed of several threads over one", 1.8, True),
    "surfaces": Bar("time on many surfaces over that on one, in any order", 3.0, False),
    "streaming": Bar("streaming over 1.5 solving + writing", 1.0, False),
    "memory": Bar("MB resident while streaming", 1000.0, False),
    "flat": Bar("largest cost of a point over the smallest, few to many points", 1.2, False),
    "call": Bar("microseconds of a call that solves one point", 100.0, False),
    "loaded": Bar("time of such a call over that before the loop is loaded", 0.1, False),
    "film_load": Bar("time with film_load total over that with fluid, heaviest class", 1.1, False),
    "starts": Bar("time to an answer over that of the best way, few to many points", 1.2, False),
    "errors": Bar("largest error over the error asked for", 1.0, False),
    "extremes": Bar("extremes with a wrong answer", 0.0, False),
    "oracle": Bar("points of all readings that are wrong or beyond their bound", 0.0, False),
}


def bar_rows(tables: Mapping[str, Sequence[Mapping[str, Any]]]) -> list[dict[str, Any]]:
    """Compare what was measured with all bars.

    Parameters
    ----------
    tables : mapping
        Rows of the tables ``errors``, ``extremes``, ``times``, ``omissions``, ``scaling``,
        ``surfaces``, ``starts``, ``streaming`` and ``oracle``, by these names.

    Returns
    -------
    list of dict
        Rows of the table ``bars``.
    """
    measured = {
        **_of_times(tables["times"]),
        **_of_scaling(tables["scaling"]),
        "film_load": _over_fluid(tables["omissions"]),
        "surfaces": max(row["ratio"] for row in tables["surfaces"] if row["tables"] == READY),
        **_of_streaming(tables["streaming"]),
        "starts": max(
            row["over_best"] or 0.0 for row in tables["starts"] if row["way"] == AUTOMATIC
        ),
        "errors": max(
            row["largest_error"] / row["rtol"]
            for row in tables["errors"]
            if row["method"] == "library"
        ),
        "extremes": sum(row["verdict"].startswith("wrong") for row in tables["extremes"]),
        "oracle": _at_fault(tables["oracle"]),
    }
    return [bar.row(measured[name]) for name, bar in BARS.items()]


def _of_times(rows):
    cost = {
        (row["method"], row["rtol"]): row["microseconds_per_point"]
        for row in rows
        if tuple(row[name] for name in CLASS) == HEAVIEST
    }
    return {
        "baseline": cost["nested_roots", None] / cost["library", USUAL_RTOL],
        "loose": cost["nested_roots", None] / cost["library", LOOSE_RTOL],
        "trade": cost["library", USUAL_RTOL] / cost["library", LOOSE_RTOL],
        "setup": max(row["setup_seconds"] or 0.0 for row in rows),
    }


def _of_scaling(rows):
    calls = {
        row["axis"]: row["microseconds_per_point"] for row in rows if row["axis"].endswith("calls")
    }
    return {
        "call": calls["calls"],
        "loaded": calls["calls"] / calls["first_calls"],
        "flat": max(row["ratio"] for row in rows if row["axis"] == "points"),
        "processes": max(row["ratio"] for row in rows if row["axis"] == "processes"),
        "threads": max(row["ratio"] for row in rows if row["axis"] == "threads"),
    }


def _over_fluid(rows):
    cost = {row["left_out"]: row["microseconds_per_point"] for row in rows}
    return cost[TOTAL] / cost[FLUID]


def _at_fault(rows):
    return sum(row["beyond_bound"] + row["wrong"] for row in rows) if rows else None


def _of_streaming(rows):
    seconds = {row["what"]: row["seconds"] for row in rows}
    allowed = 1.5 * seconds["solving"] + seconds["writing"]
    memory = next(row["resident_memory_MB"] for row in rows if row["what"] == "streaming")
    return {"streaming": seconds["streaming"] / allowed, "memory": memory}
