"""Solved points as data that last: scenes, datasets, files and tables.

``conditions`` and ``quantities`` name every axis and variable; ``dataset`` makes a dataset of a configured
figure or a grid, held inside as one of ``plain``; ``netcdf`` and ``streaming`` write its file; ``extraction``,
``tables`` and ``readable`` are about what is found in it.  Begin with ``dataset.grid``.  It imports
``thirdbody.curves``, ``thirdbody.configuration`` and what is below them.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
