"""A point in SI and engineering units, and both methods by which the summits under points are
evaluated, chosen for tests.
"""

from contextlib import contextmanager
from importlib import import_module

POINT = {
    "load": 1e-5,
    "viscosity": 90e-6,
    "particle_diameter": 500e-9,
    "roughness": 300e-9,
    "particle_density": 1e11,
}
ENGINEERING = {
    "load_N": 10.0,
    "viscosity_cSt": 90.0,
    "particle_diameter_nm": 500.0,
    "roughness_nm": 300.0,
    "particle_density_per_m2": 1e11,
}
# points on one roughness that repay a piece of a table
METHODS = {"tables": 0.0, "quadrature": 1e12}


@contextmanager
def solved_by(method):
    """Context in which points are solved by ``method`` first, however few or many they are."""
    module = import_module("thirdbody.core.solve")
    usual, module.TABLE_WORTH = module.TABLE_WORTH, METHODS[method]
    try:
        yield
    finally:
        module.TABLE_WORTH = usual
