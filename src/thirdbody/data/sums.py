"""SHA-256 sums of the products of a run, as ``sha256sum --check`` reads them."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from os import PathLike
from pathlib import Path


def sums_text(products: Iterable[str | Path], folder: str | Path) -> str:
    """A line for each product: its sum, and its name as seen from ``folder``."""
    lines = (f"{digest(product)}  {Path(product).relative_to(folder)}\n" for product in products)
    return "".join(sorted(lines, key=lambda line: line.split("  ", 1)[1]))


def require_sums(path: str | Path) -> None:
    """Require that all products are what the file of ``sums_text`` in their folder says; ``ValueError``
    names one that is missing or differs, and the command that makes it again."""
    for line in Path(path).read_text(encoding="utf-8").splitlines():
        expected, name = line.split("  ", 1)
        product = Path(path).parent / name
        if not product.is_file() or digest(product) != expected:
            raise ValueError(
                f"{product} is not as it was made; remake it: snakemake -c2 --force {product}"
            )


def digest(path: str | PathLike, algorithm: str = "sha256") -> str:
    """The sum of a file, in hexadecimal digits."""
    with open(path, "rb") as content:
        return hashlib.file_digest(content, algorithm).hexdigest()
