"""What laboratories measure: oils, cleanliness codes, topographies, and data beside the model's curves.

``oil`` and ``cleanliness`` turn the codes of standards into the model's conditions, ``topography`` a measured
surface into its summits; ``comparison`` puts a file of measurements beside the model, and ``estimates`` has
the friction and the contact resistance that it computes for that.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
