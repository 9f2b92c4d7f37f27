"""Figures of any dataset of solved points: panels, curves, axes, and marks that follow from the
data.

Datasets and tables are drawn; nothing is solved here.  Figures are a ``Drawing``: the matplotlib
figure, with the content of its panels as data.  Start with ``plot.py``; ``chenhorng.figures`` draws
the figures of the paper with it.
"""

from thirdbody.extras import require

require("plot", "matplotlib")
