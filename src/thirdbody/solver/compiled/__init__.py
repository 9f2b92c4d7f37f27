"""Many points at once in machine code, which numba compiles; an optional extra.

Imports ``thirdbody.model``.
"""

from thirdbody.extras import require

require("compiled", "numba")
