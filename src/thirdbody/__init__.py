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
0.251 of the load is carried by solids

``solve`` also takes arrays.  ``grid`` returns a dataset over five axes, ``plot`` draws it, and
``stream`` writes datasets larger than memory.  The equations are in ``thirdbody.model`` and the
force balance in ``thirdbody.solver``; both need only numpy and scipy.  The other packages name the
extra that they need.
"""

# the module of each public name; __init__.pyi repeats them for editors and type checkers
_MODULES = {
    "Interface": "answers.interface",
    "OutOfRangeWarning": "conditions",
    "Parameters": "model.parameters",
    "Solution": "solver.solution",
    "bearing": "answers.bearing",
    "cleanliness": "measured.oil",
    "compare": "measured.comparison",
    "find": "answers.find",
    "grid": "data.dataset",
    "load_parameters": "configuration.inputs",
    "oil_viscosity": "measured.oil",
    "open_atlas": "atlas.catalogue",
    "plot": "figures.plot",
    "solve": "solver.solve",
    "stream": "data.dataset",
    "surface": "measured.topography",
    "transitions": "answers.find",
    "turning_point": "answers.find",
    "turning_window": "answers.find",
}
__all__ = ["__version__", *_MODULES]


def __getattr__(name: str):
    """Import a public name on first use, so that importing the package is quick."""
    if name == "__version__":
        from importlib.metadata import version

        return version("thirdbody")
    if name not in _MODULES:
        raise AttributeError(f"module 'thirdbody' has no attribute {name!r}")
    from importlib import import_module

    found = getattr(import_module(f"thirdbody.{_MODULES[name]}"), name)
    globals()[name] = found  # cached, so that this function is not called again
    return found


def __dir__() -> list[str]:
    """All public names, imported or not."""
    return sorted(__all__)
