"""Answers to the questions that an engineer asks of an interface, in engineering units.

``find`` finds where a variable has a level along any of the five axes, ``changes`` where regimes and
modes change, ``turning`` where the contact area turns; ``bearing`` derives inputs from a ball, a speed, an
oil and two materials; ``ensemble`` says how far the calibrated ensemble spreads each number.  Begin with
``interface.Interface``.  It imports ``thirdbody.data`` and what is below.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
