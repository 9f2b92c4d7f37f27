"""What the model says of the paper: which of its statements hold, and for which inputs.

This room knows the paper's statements as data (``claims``), how far one is from holding
(``checks``) on curves that are solved for it (``evidence``), how the inputs that the paper does not
print are found (``calibration``, ``sampling``, ``posterior``), what becomes of every statement under them
(``verdicts``, ``verdict_text``), and how far results depend on them (``band``,
``sensitivity``, ``sobol``).  It may import ``thirdbody.data`` and what is below.  Begin with
``claims``, then ``checks.judge``.
"""

from thirdbody.extras import require

require("study", "SALib", "cma", "emcee", "tabulate")
