"""The figures, drawn from datasets and tables; nothing is solved or evaluated here.

``curves`` draws the figures of the paper, listed in ``curves.toml``; ``claims``, ``fronts``,
``sensitivity`` and ``charts`` show the reproduction.  Each figure is a function of data that returns a
``Drawing``: the matplotlib figure, and the content of its panels as data.  Start with ``curves.toml``.
"""

from thirdbody.extras import require

require("figures", "matplotlib")
