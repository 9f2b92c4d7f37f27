"""One line that says what to install where an optional dependency is missing.

Numpy and scipy are enough for the equations and for solving them.  A room that needs more says so
in its ``__init__``, so that each of its modules, however imported, gives the same line.
"""

from __future__ import annotations

from importlib.util import find_spec


def require(extra: str, *modules: str) -> None:
    """Check that what an extra installs is there, without importing it.

    Parameters
    ----------
    extra : str
        Name of the extra in ``pyproject.toml``.
    *modules : str
        Names under which its packages are imported.

    Raises
    ------
    ModuleNotFoundError
        In one line that names the missing modules and how to install them.
    """
    missing = [name for name in modules if find_spec(name) is None]
    if missing:
        message = f'needs {", ".join(missing)}: pip install "thirdbody[{extra}]"'
        raise ModuleNotFoundError(f"this part of thirdbody {message}", name=missing[0])
