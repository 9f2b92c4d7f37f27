"""Custody: a record of what each product was when it was made, by which damage is found later.

The record of ``results/figures/fig03.svg`` is ``results/.custody/figures/fig03.svg.sha256``, one
line that ``sha256sum --check`` reads.  A run with a name has records of its own, in
``results/NAME/.custody/``.  `thirdbody.data.files.whole` writes a record with its product.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path
from typing import IO

from thirdbody.run.places import CUSTODY, PRODUCTS

SUFFIX = ".sha256"


def record_of(product: str | Path) -> Path:
    """Name of the record of a file in ``results/``: in the nearest folder of records above it."""
    folders = Path(product).relative_to(PRODUCTS).parents
    homes = (PRODUCTS / folder for folder in folders)
    home = next((home for home in homes if (home / CUSTODY).is_dir()), PRODUCTS)
    return home / CUSTODY / f"{Path(product).relative_to(home)}{SUFFIX}"


def record_text(product: str | Path, content: IO[bytes]) -> str:
    """The line that says that ``product`` has this ``content``."""
    return f"{hashlib.file_digest(content, 'sha256').hexdigest()}  {product}\n"


def damaged_products(folder: Path = PRODUCTS) -> list[str]:
    """Products of a run that are there and are not what their records say, or cannot be read; sorted.

    ``folder`` is that of the run's products.  A product without a record is not among them, nor one
    that was deleted.
    """
    records = folder / CUSTODY
    names = (str(path.relative_to(records)) for path in records.rglob(f"*{SUFFIX}"))
    recorded = sorted(str(folder / name.removesuffix(SUFFIX)) for name in names)
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
                f"{product} is not known to be whole: {record_of(product)} does not say that it "
                f"was made as it is; remake it: snakemake -c2 --force {product}"
            )


def _is_as_made(product: str | Path) -> bool:
    """Whether ``product`` can be read and is what its record says."""
    try:
        with open(product, "rb") as content:
            made = record_text(product, content)
        return record_of(product).read_text(encoding="utf-8", errors="replace") == made
    except OSError:
        return False
