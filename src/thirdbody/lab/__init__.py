"""What a test rig needs: measurements, surfaces, oils and debris.

``compare`` sets measurements beside the model, ``fit`` calibrates inputs to them, ``friction`` and
``contact_resistance`` estimate what is measured.  ``surface`` has the roughness and the summits of measured
topographies, ``oil_viscosity`` and ``oil_grade`` the viscosity of oils, ``cleanliness`` and ``debris_density``
the particles per area of a film.
"""

from importlib import import_module

_MODULES = {
    "cleanliness": "debris",
    "compare": "comparison",
    "contact_resistance": "estimates",
    "debris_density": "debris",
    "equivalent_roughness": "roughness",
    "fit": "fitting",
    "friction": "estimates",
    "oil_grade": "oil",
    "oil_viscosity": "oil",
    "plot_comparison": "comparison",
    "surface": "topography",
    "surface_parameters": "topography",
}
__all__ = [*_MODULES]


def __getattr__(name: str):
    """Import a name on first use: pandas and SciPy's optimizers are slow to import."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_MODULES[name]}"), name)


def __dir__() -> list[str]:
    """All names, imported or not."""
    return __all__
