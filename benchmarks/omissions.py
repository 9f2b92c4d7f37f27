"""Time that is saved because nothing is computed which is not asked for, and what either reading of
the film's load takes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from benchmarks.classes import HEAVIEST, random_conditions
from benchmarks.measuring import MICROSECONDS, least_seconds
from thirdbody.model.parameters import Parameters
from thirdbody.solver.plan import COMPILED
from thirdbody.solver.solve import solve

# What is left out, and the class of points that is solved then.
BODIES = {
    "nothing": HEAVIEST,
    "film": HEAVIEST._replace(medium="dry"),
    "particles": HEAVIEST._replace(bodies="two_body"),
    "film and particles": HEAVIEST._replace(medium="dry", bodies="two_body"),
}
# What is left out, and the variables that are asked for then.
VARIABLES = {
    "all variables but L_s": ("solid_load_fraction",),
    "all variables but A_t*": ("total_contact_area",),
}
# With everything, under each reading of the load in Eq. 8.
FILM_LOADS = {f"nothing, film_load {name}": name for name in ("fluid", "total")}
FLUID, TOTAL = FILM_LOADS


def omission_rows(parameters: Parameters, budget: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Measure the time of a point with everything, where something is left out, and by either reading
    of the film's load.

    Parameters
    ----------
    parameters : Parameters
        Inputs of the model.
    budget : mapping
        Content of ``config/accuracy.yaml``: ``omissions`` and ``rounds`` are used.

    Returns
    -------
    list of dict
        Rows of the table ``omissions``.
    """
    settings = budget["omissions"]
    count = settings["points"]

    def solving(given, **changed):
        asked = {"parameters": parameters, "rtol": settings["rtol"], "way": COMPILED}
        return partial(solve, **given, **asked | changed)

    runs = {
        name: solving(random_conditions(kind, count, parameters)) for name, kind in BODIES.items()
    }
    runs |= {
        name: solving(random_conditions(HEAVIEST, count, parameters), variables=wanted)
        for name, wanted in VARIABLES.items()
    }
    runs |= {
        name: solving(
            random_conditions(HEAVIEST, count, parameters),
            parameters=replace(parameters, film_load=film_load),
        )
        for name, film_load in FILM_LOADS.items()
    }
    times = least_seconds(runs, budget["rounds"])
    return [
        {
            "left_out": name,
            "points": count,
            "rtol": settings["rtol"],
            "microseconds_per_point": MICROSECONDS * time / count,
            "share": time / times["nothing"],
        }
        for name, time in times.items()
    ]
