"""Features of curves over the load: turning points, their windows, and transitions.

This package finds the load at which the particle fraction of the contact area turns
(``turning_point``; the TPCA of the paper), the diameters for which it does (``windows``), and the
loads at which the lubrication regime or contact mode changes (``transitions``).  It may import
``thirdbody.solver`` and ``thirdbody.model``.  Start with ``turning_point.turning_points``.
"""
