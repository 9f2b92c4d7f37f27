"""The full space of conditions, solved for the default inputs and each member of the ensemble.

``surfaces`` solves one surface, ``chunk`` writes some surfaces to a file, and ``catalogue`` opens
all files as one dataset and reads the design charts.  Start with ``catalogue.open_atlas``.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4", "dask")
