"""What a test rig needs: measurements, surfaces, oils and debris.

``compare`` sets measurements beside the model, ``fit`` calibrates inputs to them, ``friction`` and
``contact_resistance`` estimate what is measured.  ``surface`` has the roughness and the summits of measured
topographies, ``oil_viscosity`` and ``oil_grade`` the viscosity of oils, ``cleanliness`` and ``debris_density``
the particles per area of a film.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
