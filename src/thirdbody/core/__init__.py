"""The model of the paper, solved: float64 arrays in SI units in, arrays out.

These modules need only numpy and scipy, and import nothing from the rest of the package.  The rest
checks conditions before it calls them.  ``parameters`` checks the inputs, and refuses a roughness
or particles outside the model.

Read ``solve`` first: it explains how a point is solved.

The equations:

- ``parameters``: the inputs, the words for interpretations that the paper leaves open, and the
  summits at a roughness.
- ``asperity``: a single summit, and a Gaussian population of summits, F_ss and A_ss (first half of
  Eq. 6).
- ``summits``: the same at many points, integrated or read from tables.
- ``particles``: loads and areas of the particles (Eqs. 4 to 6).
- ``film``: film thickness and its load (Eqs. 7 and 8).
- ``contact``: summits and particles at a separation together (Eqs. 2, 4 and 5).
- ``regimes``: lubrication regime, contact mode and status (sections 3.1 and 3.2).

Solved for the separation d:

- ``solve``: many points.
- ``balance``: Eq. 1, the forces at a separation.
- ``brackets`` and ``root``: separations around the root of Eq. 1, and Newton's method between them.
- ``state``: the variables of a solved point (Eqs. 3, 9 and 10), and the bound of their errors.
- ``sweep``: grids to three digits, interpolated over the separation, with ``solid_tables``.  It has
  its own solution of Eq. 1, for many loads and films on one surface.

Features of curves:

- ``turning_points`` and ``windows``: the load at which A_sa,t* turns (the TPCA), and the particle
  sizes with a turning point.
- ``transitions``: loads at which the regime or mode changes, between points of a curve.
- ``crossings``: where any variable crosses a level along any condition.

``names`` has the names of the variables.  ``logarithms``, ``interpolation`` and ``bracketing`` have
arithmetic that several modules use.
"""
