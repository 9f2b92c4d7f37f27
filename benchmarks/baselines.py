"""A plain solver of the model, beside which the library is measured.

``NestedRoots`` goes point by point, with the equations of ``verification/plain_model.py``:
integrals by ``scipy.integrate.quad``, roots by ``brentq``.
"""

import importlib.util
import json
import math
from os import PathLike
from types import ModuleType, SimpleNamespace

import numpy as np
from numpy.typing import ArrayLike

import thirdbody as tb
from benchmarks.points import VARIABLES
from thirdbody.netcdf import model_attribute
from thirdbody.variables import DIMENSIONS


def load_plain_model(path: str | PathLike) -> ModuleType:
    """Import ``verification/plain_model.py``, which belongs to no package."""
    specification = importlib.util.spec_from_file_location("plain_model", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def _model(parameters, roughness):
    """Inputs of the model by their keys in datasets, for a surface of this roughness."""
    model = json.loads(model_attribute(parameters, [roughness]))
    return {name: value[0] if isinstance(value, list) else value for name, value in model.items()}


class NestedRoots:
    """The plain equations of ``verification/plain_model.py``, one point after the other."""

    def __init__(self, plain: ModuleType, parameters: tb.Parameters):
        self.plain = plain
        self.parameters = parameters

    def solve(self, **conditions: ArrayLike) -> SimpleNamespace:
        """``VARIABLES`` of points, shape (n,), nan where there is no solution; arguments as of
        ``thirdbody.solve``, one-dimensional."""
        columns = np.broadcast_arrays(*(conditions[name] for name in DIMENSIONS))
        solved = [self._solve_one(*map(float, point)) for point in zip(*columns, strict=True)]
        return SimpleNamespace(**dict(zip(VARIABLES, np.array(solved).T, strict=True)))

    def _solve_one(self, *conditions):
        model = _model(self.parameters, conditions[3])
        summits = (model[name] for name in ("eta_s", "R", "sigma_s", "y_s"))
        found = self.plain.solve(model, self.plain.Point(*conditions, *summits))
        if found.state is None:
            return [math.nan] * len(VARIABLES)
        areas = found.state.total_area, found.state.particle_ratio, found.state.summit_ratio
        film = found.separation / model["R_x"]
        return [*areas, found.solid_fraction, found.fluid_fraction, found.separation, film]
