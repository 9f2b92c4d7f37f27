"""What a process of few points takes, and what one of many takes first: compilation has its price."""

from __future__ import annotations

import os
import subprocess
import sys
from tempfile import TemporaryDirectory

from benchmarks.measuring import wall_seconds
from thirdbody.solver.solve import COMPILATION_WORTH

PROGRAM = """
import sys
import numpy as np
from thirdbody.configuration.inputs import load_parameters
from thirdbody.solver.solve import solve
solve(np.geomspace(1e-7, 1e-5, int(sys.argv[1])), 9e-5, 5e-7, 3e-7, 1e11, load_parameters())
"""


def start_rows() -> list[dict]:
    """Rows of the table ``starts``: time on the clock of processes that solve once."""
    with TemporaryDirectory() as kept:
        return [
            _row("no compilation", COMPILATION_WORTH - 1, kept),
            _row("compilation", COMPILATION_WORTH, kept),
            _row("compiled before", COMPILATION_WORTH, kept),
        ]


def _row(what, points, kept):
    command = [sys.executable, "-c", PROGRAM, str(points)]
    environment = os.environ | {"NUMBA_CACHE_DIR": kept}
    seconds = wall_seconds(lambda: subprocess.run(command, env=environment, check=True))
    return {"what": what, "points": points, "seconds": seconds}
