"""Dry and lubricated three-body contact of rough surfaces, after Chen & Horng (2024)."""

__all__ = ["Parameters", "Solution", "grid", "load_parameters", "solve", "stream"]

_HOMES = {
    "Parameters": "model.parameters",
    "Solution": "solver.solution",
    "grid": "data.dataset",
    "load_parameters": "configuration.inputs",
    "solve": "solver.solve",
    "stream": "data.streaming",
}


def __getattr__(name):
    """Public names are imported when first used: an import of the package itself costs nothing."""
    if name not in _HOMES:
        raise AttributeError(f"module 'thirdbody' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"thirdbody.{_HOMES[name]}"), name)
