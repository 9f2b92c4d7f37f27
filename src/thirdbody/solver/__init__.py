"""The balance of forces, solved for any number of points.

Imports ``thirdbody.model`` and ``thirdbody.conditions``.  Begin with ``solve``, the public function: its
``solve_arrays`` takes points of one kind together, ``balance`` brackets and encloses the separation,
and ``solution`` describes it.  ``points`` states the forces, ``summits`` evaluates the summits,
``several`` finds the largest of several separations, and ``sweep`` solves grids to three digits.
"""
