"""What a test rig needs: measurements, surfaces, oils and debris.

``compare`` sets measurements beside the model, ``fit`` calibrates inputs to them, ``friction`` and
``contact_resistance`` estimate what is measured.  ``surface`` has the roughness and the summits of measured
topographies, ``oil_viscosity`` and ``oil_grade`` the viscosity of oils, ``cleanliness`` and ``debris_density``
the particles per area of a film.
"""

from thirdbody.lazy import lazy_names

__all__, __getattr__ = lazy_names(__name__, __file__)


def __dir__() -> list[str]:
    """All names, imported or not."""
    return __all__
