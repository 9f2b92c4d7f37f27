"""Dry and lubricated three-body contact of rough surfaces, after Chen & Horng (2024).

Solve one point with the calibrated inputs, in SI units (loads are dimensionless):

>>> import thirdbody as tb
>>> point = tb.solve(
...     load=1e-5,
...     viscosity=120e-6,
...     particle_diameter=300e-9,
...     roughness=300e-9,
...     particle_density=1e11,
...     parameters=tb.load_parameters(),
... )
>>> print(f"{point.solid_load_fraction:.3f} of the load is carried by solids")
0.250 of the load is carried by solids

``solve`` also takes arrays.  ``grid`` returns a dataset over five axes, ``plot`` draws it, and
``stream`` writes datasets larger than memory.  ``find``, ``transitions``, ``turning_point`` and
``turning_window`` search along an axis and return tables.  ``lab`` has what a test rig needs.  The equations
and the force balance are in ``thirdbody.core``, which needs only numpy and scipy.
"""

import re
from pathlib import Path

# The module of each public name, as listed for editors and type checkers.  ``lazy_loader.attach_stub`` reads such a
# list too; it is not used, as it would be one more package to install for two lines.
_STUB = Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")
_MODULES = {name: module for module, name in re.findall(r"from (\S+) import (\w+) as", _STUB)}
__all__ = ["__version__", *_MODULES]


def __getattr__(name: str):
    """Import a public name on first use, so that importing the package is quick."""
    if name == "__version__":
        from thirdbody.version import current

        return current().text
    if name not in _MODULES:
        raise AttributeError(f"module 'thirdbody' has no attribute {name!r}")
    from importlib import import_module

    if _MODULES[name] == __name__:
        return import_module(f"{__name__}.{name}")
    public = getattr(import_module(_MODULES[name]), name)
    globals()[name] = public  # cached, so that this function is not called again
    return public


def __dir__() -> list[str]:
    """All public names, imported or not."""
    return sorted(__all__)
