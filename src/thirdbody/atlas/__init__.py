"""The whole space of conditions, solved for the default inputs and each member of the ensemble.

This room knows which grid is solved (``grid``), what is found on all points of a surface
(``surfaces``), how a share of the surfaces becomes a file (``chunk``) and all files one dataset
(``catalogue``), what is drawn from it (``charts``), and the table that is interpolated in real time
(``lookup``, made by ``smallest``).  It may import ``thirdbody.answers`` and what is below.  Begin with
``catalogue.open_atlas``.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4")
