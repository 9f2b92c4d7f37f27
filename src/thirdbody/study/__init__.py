"""Which statements of the paper the model reproduces, and for which inputs.

``claims`` holds the paper's statements as data, ``checks`` judges one of them on curves that
``evidence`` solves.  ``calibration``, ``search`` and ``results`` find the inputs that the paper does
not print.  ``verdicts`` and ``page`` make tables and pages; ``band``, ``sensitivity``
and ``sobol`` compute how results depend on the inputs.  Begin with ``claims``, then ``checks.judge``.
"""

from thirdbody.extras import require

require("study", "cma", "emcee", "jinja2", "pandas", "tabulate")
