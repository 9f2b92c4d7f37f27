"""Features of curves over the load: the load at which the particle fraction of the contact area turns
(the TPCA of the paper), the diameters for which it does, and the loads at which the lubrication regime
or contact mode changes.  Start with ``turning_point.turning_points``.
"""
