"""Answers to engineering questions about an interface, in engineering units.

``find`` finds where a variable crosses a level along any of the five axes, ``changes`` where
regimes and modes change, and ``turning`` where the contact area turns.  ``bearing`` derives inputs
from ball, speed, oil and materials; ``ensemble`` gives the calibrated ensemble behind each range.
Start with ``interface.Interface``.  It imports ``thirdbody.data`` and the packages below.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
