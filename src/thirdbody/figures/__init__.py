"""The figures, drawn from datasets and tables; nothing is solved or evaluated here.

``registry`` has the figures of the paper; ``claims``, ``fronts``, ``sensitivity`` and ``charts``
show the reproduction.  Each figure is a function of data that returns a ``Drawing``: the matplotlib
figure, and the content of its panels as data.  ``drawing.save`` writes the files, and
``captions.caption`` returns the caption.  Start with ``registry``.
"""

from thirdbody.extras import require

require("figures", "matplotlib")
