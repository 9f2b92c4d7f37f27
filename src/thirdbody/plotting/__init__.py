"""Figures of any dataset of solved points: panels, curves, axes, and marks that follow from the
data.

Datasets and tables are drawn; nothing is solved here.  Figures are a ``Drawing``: the matplotlib
figure, with the content of its panels as data.  Start with ``plot.py``; ``chenhorng.figures`` draws
the figures of the paper with it.
"""

from importlib.util import find_spec


def require(extra: str, *modules: str) -> None:
    """Raise ``ModuleNotFoundError``, in one line with the pip command, if a module of an ``extra``
    of ``pyproject.toml`` is not installed; imports none of them."""
    missing = [name for name in modules if find_spec(name) is None]
    if missing:
        message = f'needs {", ".join(missing)}: pip install "thirdbody[{extra}]"'
        raise ModuleNotFoundError(f"this part of thirdbody {message}", name=missing[0])


require("plot", "matplotlib")
