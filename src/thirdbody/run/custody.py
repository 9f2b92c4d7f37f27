"""Custody: a record of what each product was when it was made, by which damage is found later.

The record of ``results/figures/fig03.svg`` is ``results/.custody/figures/fig03.svg.sha256``, one
line that ``sha256sum --check`` reads.  `thirdbody.data.files.whole` writes it with the product.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path
from typing import IO

PRODUCTS = Path("results")
RECORDS = PRODUCTS / ".custody"
SUFFIX = ".sha256"


def record_of(product: str | Path) -> Path:
    """Name of the record of a file in ``results/``."""
    return RECORDS / f"{Path(product).relative_to(PRODUCTS)}{SUFFIX}"


def record_text(product: str | Path, content: IO[bytes]) -> str:
    """The line that says that ``product`` has this ``content``."""
    return f"{hashlib.file_digest(content, 'sha256').hexdigest()}  {product}\n"


def damaged_products() -> list[str]:
    """Products that are there and are not what their records say, or cannot be read; sorted.

    A product without a record is not among them, nor one that was deleted.
    """
    names = (str(path.relative_to(RECORDS)) for path in RECORDS.rglob(f"*{SUFFIX}"))
    recorded = sorted(str(PRODUCTS / name.removesuffix(SUFFIX)) for name in names)
    return [each for each in recorded if os.path.lexists(each) and not _is_as_made(each)]


def require_recorded(products: Iterable[str | Path]) -> None:
    """Require that every one of ``products`` is there and is what its record says.

    Raises
    ------
    ValueError
        Naming one that is not, or has no record, and the command that makes it again.
    """
    for product in products:
        if not _is_as_made(product):
            raise ValueError(
                f"{product} is not known to be whole: no record in {RECORDS}/ says that it was "
                f"made as it is; remake it: snakemake -c2 --force {product}"
            )


def _is_as_made(product: str | Path) -> bool:
    """Whether ``product`` can be read and is what its record says."""
    try:
        with open(product, "rb") as content:
            made = record_text(product, content)
        return record_of(product).read_text(encoding="utf-8", errors="replace") == made
    except OSError:
        return False
