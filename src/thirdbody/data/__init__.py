"""Solved points as lasting data: scenes, datasets, files and tables.

``conditions`` and ``quantities`` name all axes and variables; ``dataset`` builds the dataset of a
figure or a grid, internally a dataset of ``plain``; ``netcdf`` and ``streaming`` write files;
``extraction``, ``tables`` and ``readable`` make tables from them.  Start with ``dataset.grid``.  It
imports ``thirdbody.curves``, ``thirdbody.configuration`` and the packages below.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
