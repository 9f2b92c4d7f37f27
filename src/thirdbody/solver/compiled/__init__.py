"""Many points at once in machine code, which numba compiles; an optional extra.

Imports ``thirdbody.model`` and what ``thirdbody.solver`` makes of a surface.  Begin with
``stages``, the equations in the order in which they are evaluated; ``loop`` calls them, ``layout``
names the rows of numbers that they work on, and ``points`` is what the solver calls.
"""

from thirdbody.extras import require

require("compiled", "numba")
