"""The names of a package, imported on first use, so that importing the package is quick.

``lazy_loader.attach_stub`` does the same; it would be one more package to install for a few lines.
"""

import re
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any


def lazy_names(package: str, file: str) -> tuple[list[str], Callable[[str], Any]]:
    """The names of a ``package``, and its ``__getattr__``.

    The stub beside its ``file`` lists the module of each name, also for editors and type checkers.
    """
    stub = Path(file).with_suffix(".pyi").read_text(encoding="utf-8")
    modules = {name: module for module, name in re.findall(r"from (\S+) import (\w+) as", stub)}

    def attribute(name: str) -> Any:
        if name not in modules:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value = getattr(import_module(modules[name]), name)
        setattr(sys.modules[package], name, value)  # so that this is not called again
        return value

    return [*modules], attribute
