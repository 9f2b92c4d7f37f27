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
0.246 of the load is carried by solids

``solve`` also takes arrays.  ``grid`` returns a dataset over five axes, ``plot`` draws it, and
``stream`` writes datasets larger than memory.  ``find``, ``transitions``, ``turning_point`` and
``turning_window`` search along an axis and return tables.  The equations and the force balance are
in ``thirdbody.core``, which imports only numpy and scipy.
"""

import lazy_loader

# The stub beside this file has the public names.  They are imported on first use.
_attribute, _, _names = lazy_loader.attach_stub(__name__, __file__)
__all__ = ["__version__", *_names]


def __getattr__(name: str):
    """A public name, or the version."""
    if name == "__version__":
        from thirdbody.version import current

        return current().text
    return _attribute(name)


def __dir__() -> list[str]:
    """All public names, imported or not."""
    return sorted(__all__)
