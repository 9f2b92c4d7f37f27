"""The force balance, solved for any number of points.

Imports ``thirdbody.model`` and ``thirdbody.conditions``.  Start with ``solve``, the public
function; its ``solve_arrays`` solves points of one kind together.  ``brackets`` finds separations on
both sides of the root, ``balance`` converges to it, and ``solution`` derives the variables.
``points`` evaluates the forces (Eq. 1), ``summits`` the summits, ``several`` finds the largest of
several roots.  ``sweep`` solves grids to three digits, with the solids from ``solid_tables``.
"""
