"""Solved points as data that last: scenes, datasets, files and tables.

This room knows how each condition and each variable is called and in which unit it is written
(``conditions``, ``quantities``), how a configured scene becomes a dataset (``scene``, ``dataset``, ``plain``),
how a dataset becomes a file and is read again (``netcdf``, ``streaming``), and what is extracted
from it (``extraction``, ``tables``).  It may import ``thirdbody.curves`` and what is below.  Begin
with ``dataset.grid``.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
