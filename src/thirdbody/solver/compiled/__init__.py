"""Many points on one surface in machine code; an optional extra.

Imports ``thirdbody.model`` and numba.
"""
