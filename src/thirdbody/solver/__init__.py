"""The balance of forces, solved for any number of points.

Imports ``thirdbody.model``.  Begin with ``solve``, the public function; ``balance`` finds the
separation and certifies it, ``points`` states the forces, ``summits`` evaluates the summits, and
``solution`` says what is known afterwards.
"""
