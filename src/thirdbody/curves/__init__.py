"""What curves over the load hold: turning points, their windows, transitions.

Imports ``thirdbody.solver`` and below.
"""
