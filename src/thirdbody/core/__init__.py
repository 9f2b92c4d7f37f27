"""The model of the paper, solved: float64 arrays in SI units in, arrays out.

Needs numpy and scipy alone, and imports nothing from the rest of the package, which checks
conditions before they come here; ``parameters`` checks the inputs, and refuses a roughness or
particles that they cannot have.

Read ``solve`` first: it says how a point is solved.

The equations:

- ``parameters``: the inputs, and the words for what the paper leaves open; summits at a roughness.
- ``asperity``: one summit, and a Gaussian population of summits, F_ss and A_ss (first half of Eq.
  6).
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
- ``sweep``: grids to three digits, interpolated over the separation, with ``solid_tables``; it
  solves Eq. 1 again, for
  many loads and films on one surface.

What curves have:

- ``turning_points`` and ``windows``: the load at which A_sa,t* turns (the TPCA), and the sizes for
  which it does.
- ``transitions``: loads at which the regime or mode changes, between points of a curve.
- ``crossings``: where any variable crosses a level along any condition.

``names`` has the names of the variables; ``logarithms``, ``interpolation`` and ``bracketing`` have
the arithmetic that several of these use.
"""
