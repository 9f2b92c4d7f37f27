"""Answers to the questions that an engineer asks of an interface, in the units that one has at hand.

This room knows how conditions are given in SI or in engineering units (``units``), where a variable
has a level along any of the five axes (``find``) and where regimes and modes change (``changes``),
where the contact area turns (``turning``), which inputs follow from a ball, a speed, an oil and two
materials (``bearing``), and how far the calibrated ensemble spreads each number (``ensemble``).  It
may import ``thirdbody.data`` and what is below.  Begin with ``interface.Interface``.
"""

from thirdbody.extras import require

require("data", "xarray", "netCDF4", "yaml", "jsonschema", "tabulate")
