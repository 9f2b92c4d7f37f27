"""The paper's equations and nothing else: what a load, an area or a film's thickness is at a point.

Imports numpy, scipy.special and no other package of the library.  Begin with ``parameters``, the inputs,
and ``interpretations``, what the paper leaves open; then ``asperity`` (F_ss, A_ss), ``particles`` (Eqs. 4
to 6) and ``film`` (Eqs. 7 and 8).  ``contact`` puts the solids together at a given separation, and
``regimes`` names the states of an interface.
"""
