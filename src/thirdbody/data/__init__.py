"""Solved points as lasting data: scenes, datasets, files and tables.

``conditions`` and ``quantities`` name all axes and variables; ``dataset`` builds the dataset of a
figure or a grid, ``netcdf`` has its files; ``extraction`` and ``tables`` make tables.
Start with ``dataset.grid``.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
