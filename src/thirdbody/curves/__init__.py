"""What a curve over the load holds beside its points: turning points, their windows, transitions.

This package finds at which load the fraction of the particles in the contact area turns
(``turning_point``; the paper's TPCA), for which diameters it does so (``windows``), and at which
loads one lubrication regime or contact mode passes into the next (``transitions``).  It may import
``thirdbody.solver`` and ``thirdbody.model``.  Begin with ``turning_point.turning_points``.
"""
