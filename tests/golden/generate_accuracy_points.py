"""Points on which the accuracy of the library is measured: writes `accuracy_points.csv` beside this file.

Rows and columns are those of `solutions.csv`, solved by `solved.py`, but for the first three columns, the
class of the row: `medium` (dry, lubricated), `bodies` (two_body, three_body) and `span` (usual, extremes). Each of the
eight classes has POINTS rows. The usual span is that of the published tables; the extremes leave it in all conditions,
and the inputs of the model are at or beyond their bounds. Rows of one surface share all inputs, so that they can be
solved as one array.

    python -m tests.golden.generate_accuracy_points             # writes accuracy_points.csv
"""

import csv
import itertools
import math
import random
import sys
import time
from pathlib import Path

from mpmath import mp

from tests.golden import solved as model
from tests.golden.generate_solutions import (
    PUBLISHED,
    UNPUBLISHED,
    surface,
    text,
)

PRODUCT = Path(__file__).with_name("accuracy_points.csv")
CLASS = ("medium", "bodies", "span")
COLUMNS = (
    *CLASS,
    *model.INTERPRETATIONS,
    *model.COORDINATES,
    *model.PARAMETERS,
    *model.OUTPUTS,
    "status",
)
SEED = 20241
POINTS = 64  # rows of a class
DIGITS = 28  # working precision: five or more are lost in the Gaussian tails
AS_PRINTED = dict(
    surface_offset=1, elastic_limits="printed", coverage_limits="printed", film_load="fluid"
)

USUAL_SURFACES = [
    (phi_a, roughness, {})
    for phi_a in UNPUBLISHED
    for roughness in (100e-9, 200e-9, 300e-9, 400e-9, 500e-9)
]
# phi_a, roughness, and what differs from the published and unpublished inputs
EXTREME_SURFACES = [
    ("uncentred", 1e-9, {}),
    ("uncentred", 10e-9, {}),
    ("uncentred", 1e-6, {}),
    ("uncentred", 10e-6, {}),
    ("uncentred", 300e-9, dict(H_s1=1e12, H_s2=1e12)),  # purely elastic
    ("uncentred", 300e-9, dict(H_s1=1e6, H_s2=1e6)),  # purely plastic
    ("centred", 300e-9, dict(H_s1=3e9, H_s2=7e9, E_sa=200e9)),
    ("uncentred", 300e-9, dict(E_ss=1e8, E_sa=1e13, H_s1=1e6, H_s2=2e7)),
    ("uncentred", 300e-9, dict(omega_ratio=1.0, k=1.0)),
    ("uncentred", 300e-9, dict(omega_ratio=1e4, k=0.1)),
    ("uncentred", 300e-9, dict(omega_ratio=1.0 + 1e-9)),
    ("uncentred", 300e-9, dict(kappa=0.1)),
    ("uncentred", 300e-9, dict(kappa=10.0)),
    ("uncentred", 300e-9, dict(truncation=0.5)),
    ("centred", 300e-9, dict(truncation=0.5)),
    ("centred", 300e-9, dict(truncation=10.0)),
    ("gap_convolved", 300e-9, dict(truncation=10.0)),
    ("centred", 300e-9, dict(sigma_a_ratio=0.01, mean_ratio=1.0)),  # nearly equal particles
    (
        "uncentred",
        300e-9,
        dict(beta=(0.0195, 0.0)),
    ),  # summits far above the mean plane: d/sigma_s below -3
    ("uncentred", 300e-9, dict(beta=(5.0, 0.0), surface_offset=0)),
    ("uncentred", 300e-9, dict(h_e_ratio=0.5, elastic_limits="physical")),
    ("centred", 300e-9, dict(h_e_ratio=0.0, coverage_limits="contacting")),
    ("uncentred", 300e-9, dict(film_load="total")),
    ("gap_convolved", 50e-9, dict(coverage_limits="contacting", film_load="total")),
]
# conditions: ranges of load [N], viscosity [m2/s], particle diameter [m], coverage [1]
USUAL = dict(
    normal_load=(0.04, 80.0),
    viscosity=(10e-6, 150e-6),
    particle_diameter=(50e-9, 1e-6),
    particle_density=(1e10, 5e12),
)
EXTREMES = dict(
    load=(1e-12, 1e-1),
    viscosity=(1e-9, 1e-2),
    particle_diameter=(1e-12, 1e-4),
    coverage=(1e-9, 0.899),
)


def logarithmic(rng, ends):
    """A number between `ends`, its logarithm evenly spread."""
    return math.exp(rng.uniform(*map(math.log, ends)))


def inputs_of(phi_a, roughness, changes):
    """All numbers and interpretations of a surface, without the conditions of a point."""
    row = (
        PUBLISHED
        | AS_PRINTED
        | {"phi_a": phi_a, "h_e_ratio": 0.0111}
        | UNPUBLISHED[phi_a]
        | changes
    )
    (beta, m), (R, n) = row.pop("beta"), row.pop("R")
    scale = roughness / 300e-9
    return (
        row
        | {"roughness": roughness}
        | surface(beta * scale**m, R * scale**n, roughness, row["surface_offset"])
    )


def draw(medium, bodies, span, place, rng):
    """A candidate row on one of the surfaces of the span."""
    surfaces, ends = (USUAL_SURFACES, USUAL) if span == "usual" else (EXTREME_SURFACES, EXTREMES)
    row = inputs_of(*surfaces[place % len(surfaces)]) | dict(
        medium=medium, bodies=bodies, span=span
    )
    drawn = {name: logarithmic(rng, range_) for name, range_ in ends.items()}
    row["load"] = (
        drawn["load"] if "load" in drawn else drawn["normal_load"] / (row["A_n"] * row["E_ss"])
    )
    row["viscosity"] = drawn["viscosity"] if medium == "lubricated" else 0.0
    three_body = bodies == "three_body"
    row["particle_diameter"] = drawn["particle_diameter"] if three_body else 0.0
    if "coverage" in drawn:
        a_particle = row["participation"] * row["particle_diameter"] ** 2
        drawn["particle_density"] = drawn["coverage"] / a_particle if three_body else 0.0
    return row | {"particle_density": drawn["particle_density"]}


def solve_slot(slot):
    """Cells of the first candidate of a class, numbered, that has a solution."""
    (medium, bodies, span), number = slot
    rng = random.Random(f"{SEED} {medium} {bodies} {span} {number}")
    for _ in range(1000):
        try:
            row = model.solve_contact(draw(medium, bodies, span, number, rng))
        except model.Meaningless:
            continue
        return [text(row[column]) for column in COLUMNS]
    raise ArithmeticError(f"no solvable point in {slot}")


def generate():
    """Solve all classes and write the product."""
    mp.dps = DIGITS
    classes = itertools.product(
        ("dry", "lubricated"), ("two_body", "three_body"), ("usual", "extremes")
    )
    slots = list(itertools.product(classes, range(POINTS)))
    start, rows = time.monotonic(), []
    for slot in slots:
        rows.append(solve_slot(slot))
        if len(rows) % 16 == 0:
            print(
                f"{len(rows)}/{len(slots)} rows, {time.monotonic() - start:.0f} s",
                file=sys.stderr,
                flush=True,
            )
    with PRODUCT.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(rows)


if __name__ == "__main__":
    generate()
