"""What a test rig needs: measurements, surfaces, oils and debris.

``compare`` sets measurements beside the model, ``fit`` calibrates inputs to them, ``friction`` and
``contact_resistance`` estimate what is measured.  ``surface`` has the roughness and the summits of measured
topographies, ``oil_viscosity`` and ``oil_grade`` the viscosity of oils, ``cleanliness`` and ``debris_density``
the particles per area of a film.
"""

from thirdbody.lab.comparison import compare, plot_comparison
from thirdbody.lab.debris import cleanliness, debris_density
from thirdbody.lab.estimates import contact_resistance, friction
from thirdbody.lab.fitting import fit
from thirdbody.lab.oil import oil_grade, oil_viscosity
from thirdbody.lab.roughness import equivalent_roughness
from thirdbody.lab.topography import surface, surface_parameters

__all__ = [
    "cleanliness",
    "compare",
    "contact_resistance",
    "debris_density",
    "equivalent_roughness",
    "fit",
    "friction",
    "oil_grade",
    "oil_viscosity",
    "plot_comparison",
    "surface",
    "surface_parameters",
]
