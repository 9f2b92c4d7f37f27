"""The paper's statements, and the unprinted inputs as an inverse problem.

Imports ``thirdbody.data`` and below.
"""

from thirdbody.extras import require

require("study", "SALib", "tabulate")
