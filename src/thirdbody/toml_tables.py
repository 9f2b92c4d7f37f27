"""Tables and texts of a module, in a TOML file beside it."""

import tomllib
from pathlib import Path
from typing import Any


def toml_beside(module: str) -> dict[str, Any]:
    """The content of the TOML file with the name of a ``module``, given by its ``__file__``."""
    return tomllib.loads(Path(module).with_suffix(".toml").read_text(encoding="utf-8"))
