"""Laboratory data: oils, debris, topographies, and measurements beside the model.

``oil`` and ``debris`` convert codes of standards and data sheets to conditions of the model, ``topography``
and ``roughness`` measured surfaces.  ``comparison`` compares measurements with the model, ``fitting``
calibrates inputs to them, and ``estimates`` has friction and contact resistance for both.
"""
