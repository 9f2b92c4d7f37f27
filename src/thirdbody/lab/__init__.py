"""Laboratory data: oils, topographies, and measurements compared with the model.

``oil`` converts codes of standards to conditions of the model, ``topography`` a measured surface to
its summits; ``comparison`` compares a file of measurements with the model, and ``estimates`` has
the friction and contact resistance for it.
"""
