"""The model in extended precision: compiles ``contact.c`` and hands arrays to it.

``Oracle(folder).solve(model, **conditions)`` finds the separation that balances the forces, in
x86's long double (64 bits, numpy.longdouble).  It needs a C compiler and an x86 processor;
``why_not()`` says in a line why it cannot run here, or gives None.
"""

from __future__ import annotations

import ctypes
import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

import numpy as np

SOURCE = Path(__file__).with_name("contact.c")
CONDITIONS = ("load", "viscosity", "particle_diameter", "roughness", "particle_density")
SURFACE = ("eta_s", "R", "sigma_s", "y_s")
NUMBERS = (  # in the order of ``Numbers`` in contact.c
    *CONDITIONS,
    *SURFACE,
    *("E_ss", "E_sa", "H_s1", "H_s2", "k", "omega_ratio"),
    *("R_x", "G", "V", "kappa", "U_per_viscosity", "A_n"),
    *("mean_ratio", "sigma_a_ratio", "truncation", "participation", "h_e_ratio"),
)
INTERPRETATIONS = {  # in the order of ``Interpretations`` in contact.c, the first name is 0
    "particle_plane": ("surface", "summit"),
    "film_load": ("fluid", "total"),
}
QUANTITIES = (  # in the order of ``Root`` in contact.c
    *("separation", "solid_load_fraction", "fluid_load_fraction", "total_contact_area"),
    *("particle_contact_area_ratio", "surface_contact_area_ratio", "film_thickness"),
)
CHUNK = 256  # points a thread takes at a time: some cost a hundred times as much as others


class Solved(NamedTuple):
    """What the oracle found at n points."""

    values: dict  # by quantity, longdoubles (n,), nan where no separation balances the forces
    exists: (
        np.ndarray
    )  # whether one does; not where particles would cover more than all of the surface


def why_not():
    """Why the oracle cannot run on this machine, in a line; None where it can."""
    if np.finfo(np.longdouble).nmant != 63:
        return "long double has no 64 bits on this processor"
    return None if compiler() else "there is no C compiler"


def compiler():
    """The C compiler that the environment names, or that is there."""
    return shutil.which(os.environ.get("CC", "cc")) or shutil.which("gcc") or shutil.which("clang")


class Oracle:
    """``contact.c``, compiled into ``folder``, to be run by so many ``threads``."""

    def __init__(self, folder, threads=2):
        library = Path(folder) / "contact.so"
        command = [compiler(), "-std=c11", "-O2", "-shared", "-fPIC", "-o", library, SOURCE, "-lm"]
        subprocess.run(command, check=True, capture_output=True, text=True)
        self._library = ctypes.CDLL(str(library))
        self._library.prepare()
        self._threads = threads

    def solve(self, model, **conditions):
        """The separation that balances the forces, at each of n points.

        ``model`` has the keys of the attribute ``model_parameters``, ``conditions`` are F_t* and
        the rest in SI units; all may be arrays, and broadcast.
        """
        numbers, interpretations = arrays_of({**model, **conditions})
        n = len(numbers)
        roots = np.full((n, len(QUANTITIES)), np.nan, np.longdouble)
        found = np.zeros(n, np.int32)

        def solve_some(start):
            here = slice(start, start + CHUNK)
            self._library.solve(
                ctypes.c_long(len(found[here])),
                address(numbers[here]),
                address(interpretations[here]),
                address(roots[here]),
                address(found[here]),
            )

        with ThreadPoolExecutor(self._threads) as pool:
            list(pool.map(solve_some, range(0, n, CHUNK)))
        return Solved(dict(zip(QUANTITIES, roots.T, strict=True)), found > 0)

    def evaluate(self, model, separation, **conditions):
        """F_s*, A_ss* (were there no particles), A_sa* and F_f* at given separations h [m]."""
        numbers, interpretations = arrays_of(
            {**model, **conditions, "load": 1.0}, np.size(separation)
        )
        separation = np.broadcast_to(np.longdouble(separation), len(numbers)).copy()
        forces = np.empty((len(numbers), 4), np.longdouble)
        self._library.evaluate(
            ctypes.c_long(len(numbers)),
            *map(address, (numbers, interpretations, separation, forces)),
        )
        return forces.T


def arrays_of(given, at_least=1):
    """Numbers (n, 26) and interpretations (n, 2) in the order that ``contact.c`` wants."""
    given = {"particle_plane": "surface", **given}
    columns = np.broadcast_arrays(
        *(np.ravel(np.asarray(given[name], np.float64)) for name in NUMBERS),
        *(np.ravel(indices(given[name], names)) for name, names in INTERPRETATIONS.items()),
        np.empty(at_least),
    )
    numbers = np.stack(columns[: len(NUMBERS)], axis=1)
    interpretations = np.stack(columns[len(NUMBERS) : -1], axis=1).astype(np.int32)
    return np.ascontiguousarray(numbers), np.ascontiguousarray(interpretations)


def indices(given, names):
    """Where each of ``given`` stands among ``names``."""
    return np.vectorize(names.index, otypes=[np.int32])(given)


def address(array):
    return ctypes.c_void_p(array.ctypes.data)
