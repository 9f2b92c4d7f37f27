"""One line that says what to install where an optional dependency is missing.

Numpy and scipy are enough for the equations and for solving them.  A package that needs more says so
in its ``__init__``, so that each of its modules, however imported, gives the same line.
"""

from __future__ import annotations

from importlib.util import find_spec


def require(extra: str, *modules: str) -> None:
    """Raises ``ModuleNotFoundError``, in one line that says how to install them, unless the modules that
    an ``extra`` of ``pyproject.toml`` installs are there; imports none of them."""
    missing = [name for name in modules if find_spec(name) is None]
    if missing:
        message = f'needs {", ".join(missing)}: pip install "thirdbody[{extra}]"'
        raise ModuleNotFoundError(f"this part of thirdbody {message}", name=missing[0])
