"""What a test rig needs: measurements, surfaces, oils and debris.

``compare`` sets measurements beside the model, ``fit`` calibrates inputs to them, ``friction`` and
``contact_resistance`` estimate what is measured.  ``surface`` has the roughness and the summits of measured
topographies, ``oil_viscosity`` and ``oil_grade`` the viscosity of oils, ``cleanliness`` and ``debris_density``
the particles per area of a film.
"""

import re
from importlib import import_module
from pathlib import Path
from typing import Any

# The module of each name, as listed for editors and type checkers
_STUB = Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")
_MODULES = {name: module for module, name in re.findall(r"from (\S+) import (\w+) as", _STUB)}
__all__ = [*_MODULES]


def __getattr__(name: str) -> Any:
    """Import a name on first use: pandas and SciPy's optimizers are slow to import."""
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_MODULES[name]), name)


def __dir__() -> list[str]:
    """All names, imported or not."""
    return __all__
