"""The equations of the paper: loads, areas and film thickness at a point.

Uses numpy, scipy.special and ``thirdbody.messages`` alone.  Start with ``parameters``, the inputs and the words for what
the paper leaves open, then read ``asperity`` and ``summits`` (F_ss, A_ss),
``particles`` (Eqs. 4 to 6) and ``film`` (Eqs. 7 and 8).  ``contact`` combines the solids at a given
separation, and ``regimes`` classifies the state of an interface.  Loads far below 1e-308 are
kept as ``logarithms``; ``floats`` has the limits of float64, and ``bounds`` those of the inputs.
"""
