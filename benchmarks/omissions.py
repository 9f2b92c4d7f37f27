"""What it saves that nothing is computed which a scene does not require."""

from __future__ import annotations

from functools import partial

from benchmarks.classes import HEAVIEST, random_conditions
from benchmarks.measuring import MICROSECONDS, least_seconds
from thirdbody.model.parameters import Parameters
from thirdbody.solver.plan import COMPILED
from thirdbody.solver.solve import solve

# what is left out: the class of points that remains
BODIES = {
    "nothing": HEAVIEST,
    "film": HEAVIEST._replace(medium="dry"),
    "particles": HEAVIEST._replace(bodies="two_body"),
    "film and particles": HEAVIEST._replace(medium="dry", bodies="two_body"),
}
# what is left out: the variables that remain
VARIABLES = {
    "all variables but L_s": ("solid_load_fraction",),
    "all variables but A_t*": ("total_contact_area",),
}


def omission_rows(parameters: Parameters, budget) -> list[dict]:
    """Rows of the table ``omissions``: time of a point where something is left out, and its share
    of the time of a point with everything; ``budget`` as in ``config/accuracy.yaml``."""
    settings = budget["omissions"]
    count = settings["points"]

    def solving(given, **wanted):
        asked = {"parameters": parameters, "rtol": settings["rtol"], "way": COMPILED}
        return partial(solve, **given, **wanted, **asked)

    runs = {
        name: solving(random_conditions(kind, count, parameters)) for name, kind in BODIES.items()
    }
    runs |= {
        name: solving(random_conditions(HEAVIEST, count, parameters), variables=wanted)
        for name, wanted in VARIABLES.items()
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
