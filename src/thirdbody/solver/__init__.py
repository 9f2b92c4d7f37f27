"""The force balance, solved for any number of points.

Imports ``thirdbody.model``, ``thirdbody.arguments`` and small modules beside it.  Start with ``solve``, the public
function.  A number goes this way:

1. ``solve.solve_arrays`` solves points of one kind together.
2. ``brackets.bracket`` finds separations d on both sides of the root of Eq. 1.
3. ``balance.enclose`` narrows them by Newton's method, and checks the signs at both.
4. ``points.Points.forces`` evaluates Eq. 1 at a separation: loads of the film (``model.film``) and
   of the solids, ``model.contact.Contact.at`` (Eqs. 2, 4 and 5).
5. ``solution.describe`` derives the variables (Eqs. 3, 9 and 10) and the bound of their errors.

``summits`` integrates the summits or reads them from tables.  ``sweep`` solves grids to three digits,
with the solids from ``solid_tables``.
"""
