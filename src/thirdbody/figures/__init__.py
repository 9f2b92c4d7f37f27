"""The figures, drawn from datasets and tables: nothing is solved or judged here.

``registry`` lists the figures of the paper; ``claims``, ``fronts``, ``sensitivity`` and ``charts`` show
the reproduction.  Each figure is a function of data that returns a ``Drawing``: the
figure of matplotlib, with what its panels show as data.  ``drawing.save`` writes the files, and
``captions.caption`` returns the caption.  Begin with ``registry``.
"""

from thirdbody.extras import require

require("figures", "matplotlib")
