"""The figures, drawn from datasets and tables: nothing is solved or judged here.

This room knows what each figure shows (``registry``: the paper's; ``claims``,
``sensitivity``, ``accuracy``: those about this reproduction) and how it is drawn (``curves``,
``schematics``, and ``sheet`` for what all share).  Each is a function of data that returns a
matplotlib figure; ``sheet.saving`` alone writes files.  It may import ``thirdbody.data`` and the
limits and names of regimes in ``thirdbody.model``.  Begin with ``registry``.
"""

from thirdbody.extras import require

require("figures", "matplotlib")
