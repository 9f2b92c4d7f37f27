"""The balance of forces, solved for any number of points.

Imports ``thirdbody.model``.
"""
