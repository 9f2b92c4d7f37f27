"""Processor time of `thirdbody.find` for many queries, along each of the five axes.

    python -m benchmarks.measure_find [--queries 100000]

Queries are drawn at random from the paper's ranges.  Each axis is searched twice, and the second time
counts: the first one loads what a process loads once.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

import thirdbody as tb
from thirdbody.answers.units import ENGINEERING

RANGES = {
    "load_N": (1.0, 50.0),
    "viscosity_cSt": (20.0, 150.0),
    "particle_diameter_nm": (100.0, 1000.0),
    "roughness_nm": (100.0, 500.0),
    "particle_density_per_m2": (5e10, 2e11),
}
WHERE = "solid_load_fraction", 0.9


def measured(along: str, queries: int) -> tuple[float, int]:
    """Processor time [s] of a search along an axis, and how many crossings it finds."""
    random = np.random.default_rng(0)
    given = {name: random.uniform(*ends, queries) for name, ends in RANGES.items()}
    del given[along]
    parameters = tb.load_parameters()
    for _ in range(2):
        start = time.process_time()
        found = tb.find(*WHERE, along, parameters=parameters, **given)
        taken = time.process_time() - start
    return taken, found.value.size


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--queries", type=int, default=100_000)
    queries = parser.parse_args().queries
    for key in ENGINEERING.values():
        taken, crossings = measured(key, queries)
        print(f"{key:24} {queries} queries, {crossings} crossings: {taken:.2f} s", flush=True)
