"""The balance of forces, solved for any number of points.

Imports ``thirdbody.model``; only ``compiled`` needs numba.  Begin with ``solve``, the public function;
``plan`` chooses how points are solved, ``balance`` states what is solved, ``surfaces`` says what it
is read from, and ``solution`` what is known afterwards.
"""
