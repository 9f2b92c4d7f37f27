"""Which statements of the paper the model reproduces, and with which inputs.

``claims`` reads the statements of the paper; ``claim`` and ``kinds`` check them on curves solved by
``evidence``, with ``sampling``, ``courses`` and ``between_curves``; ``judge`` does so for any inputs.
``calibration``, ``search``, ``results`` and ``choice`` find the unprinted inputs.  ``verdicts`` makes
tables and pages; ``band`` and ``sensitivity`` compute the dependence of results on the inputs.  Start
with ``claims``, then ``judge``.
"""

from thirdbody.extras import require

require("study", "cma", "emcee", "jinja2", "pandas", "tabulate")
