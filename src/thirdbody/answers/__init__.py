"""Answers to engineering questions about an interface, in engineering units.

``find`` has the searches along an axis, ``bearing`` derives inputs from ball, speed, oil and
materials.  Start with ``interface.Interface``.  Imports ``thirdbody.data`` and the packages below.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
