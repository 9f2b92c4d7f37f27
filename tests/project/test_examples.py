"""The examples in docstrings, of the library and its benchmarks, say what really comes out."""

import doctest
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MODULES = [
    ".".join(path.relative_to(folder.parent).with_suffix("").parts)
    for folder in (ROOT / "src" / "thirdbody", ROOT / "benchmarks")
    for path in sorted(folder.rglob("*.py"))
    if ">>> " in path.read_text(encoding="utf-8")
]


@pytest.mark.parametrize("module", MODULES)
def test_examples_of(module):
    results = doctest.testmod(import_module(module))
    assert results.attempted and not results.failed
