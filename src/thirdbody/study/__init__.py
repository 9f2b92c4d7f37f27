"""Which statements of the paper the model reproduces, and with which inputs.

``claims`` has the statements of the paper as data; ``checks`` evaluates them on curves solved by
``evidence``.  ``calibration``, ``search`` and ``results`` find the unprinted inputs.  ``verdicts``
makes tables and pages; ``band`` and ``sensitivity`` compute the dependence of results on the inputs.
Start with ``claims``, then ``checks.judge``.
"""

from thirdbody.extras import require

require("study", "cma", "emcee", "jinja2", "pandas", "tabulate")
