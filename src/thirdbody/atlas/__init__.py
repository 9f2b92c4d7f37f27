"""The whole space of conditions, solved for the default inputs and each member of the ensemble.

``surfaces`` finds what is on one surface, ``chunk`` writes some surfaces to a file, ``catalogue`` opens
all files as one dataset, and ``charts`` reads the design charts off it.  Begin with
``catalogue.open_atlas``.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4", "dask")
