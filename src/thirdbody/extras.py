"""A one-line error that says what to install if an optional dependency is missing.

The equations and the solver import only numpy and scipy.  A package that needs more calls
``require`` in its ``__init__``, so that importing any of its modules raises the same error.
"""

from importlib.util import find_spec


def require(extra: str, *modules: str) -> None:
    """Raise ``ModuleNotFoundError``, in one line with the pip command, if a module of an ``extra``
    of ``pyproject.toml`` is not installed; imports none of them."""
    missing = [name for name in modules if find_spec(name) is None]
    if missing:
        message = f'needs {", ".join(missing)}: pip install "thirdbody[{extra}]"'
        raise ModuleNotFoundError(f"this part of thirdbody {message}", name=missing[0])
